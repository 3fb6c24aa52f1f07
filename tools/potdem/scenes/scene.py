# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""A scene: a folder with in.<scene>, scene.yaml, reference logs and perhaps plot.py."""

import functools
import importlib.util
from pathlib import Path

import yaml

from potdem import logs
from potdem.paths import BUILD, EXAMPLES

OUTPUT = BUILD / "examples"


class SceneError(Exception):
    """a scene or variant that does not exist, or a scene.yaml that lacks something"""


def load(program):
    """a Python file as a module, once for each path"""
    return _load(Path(program).resolve())


@functools.cache
def _load(program):
    spec = importlib.util.spec_from_file_location(f"{program.stem}_of_{program.parent.name}", program)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def beside(file, name):
    """the module `name`.py in the folder of a file: how the programs of a scene find each other"""
    return load(Path(file).with_name(f"{name}.py"))


def names():
    return sorted(path.parent.name for path in EXAMPLES.glob("*/scene.yaml"))


class Scene:
    def __init__(self, name):
        if name not in names():
            raise SceneError(f"no scene '{name}'; there are: {', '.join(names())}")
        self.name, self.folder = name, EXAMPLES / name
        settings = yaml.safe_load((self.folder / "scene.yaml").read_text(encoding="utf-8"))
        try:
            self.title, self.rules = settings["title"], settings["reference"]
        except KeyError as key:
            raise SceneError(f"{self.folder / 'scene.yaml'} lacks {key}") from None
        # a scene without variants is one variant without a name
        self.variants = settings.get("variants") or {"": {}}
        self.default_variants = settings.get("default_variants") or list(self.variants)[:1]
        # what examples/run all runs: the claims may need more than a newcomer's first run
        self.all_variants = settings.get("all_variants") or self.default_variants

    def variant(self, name):
        if name not in self.variants:
            raise SceneError(f"scene {self.name} has no variant '{name}'; there are: {', '.join(self.variants)}")
        return Variant(self, name, self.variants[name] or {})

    @property
    def script(self):
        return f"in.{self.name}"

    @property
    def claims(self):
        return self._program("claims.py")

    @property
    def plot(self):
        return self._program("plot.py")

    def _program(self, name):
        path = self.folder / name
        return path if path.exists() else None

class Variant:
    def __init__(self, scene, name, settings):
        self.scene, self.name = scene, name
        self.variables = settings.get("vars") or {}
        self.label = f"{scene.name}.{name}" if name else scene.name

    def output(self, nprocs):
        return OUTPUT / self.scene.name / f"{self.name or 'default'}.np{nprocs}"

    def log_name(self, version, nprocs):
        return f"log.{version}.{self.label}.g++.{nprocs}"

    def reference(self, version, nprocs):
        """the reference log for this LAMMPS version and number of ranks, or the nearest there is"""
        for wanted in (self.log_name(version, nprocs), self.log_name("*", nprocs), self.log_name(version, 1),
                       self.log_name("*", 1)):
            found = sorted(self.scene.folder.glob(wanted.replace("[", "[[]")))
            if found:
                return found[-1]
        raise SceneError(f"no reference log {self.log_name(version, nprocs)} in {self.scene.folder}")


def version_of(log):
    return logs.version(logs.read(log))


def seconds_of(log):
    """run time of the run that wrote a log, at least one second"""
    return max(1, logs.wall_seconds(logs.read(log)) or 1)
