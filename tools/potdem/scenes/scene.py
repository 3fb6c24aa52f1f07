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
DRAW = ".draw"


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
            raise SceneError(f"no scene '{name}'; there are: {', '.join(names())}. Nor is it a script or a folder with one")
        self.name, self.folder = name, EXAMPLES / name
        settings = yaml.safe_load((self.folder / "scene.yaml").read_text(encoding="utf-8"))
        try:
            self.title, self.rules = settings["title"], settings["reference"]
        except KeyError as key:
            raise SceneError(f"{self.folder / 'scene.yaml'} lacks {key}") from None
        # a scene without variants is one variant without a name
        self.variants = settings.get("variants") or {"": {}}
        self.default_variants = settings.get("default_variants") or list(self.variants)[:1]
        # {number of a claim: what was tried of what the thesis does not state}
        self.readings = {str(number): text for number, text in (settings.get("readings") or {}).items()}
        # what examples/run all runs: the claims may need more than a newcomer's first run
        self.all_variants = settings.get("all_variants") or self.default_variants
        # of random numbers, the script's variable seed: how many examples/run all runs of a variant that says nothing else
        self.draws = settings.get("draws", 1)

    def variant(self, name, draw=1):
        """the name may end in the draw: i-3.draw2"""
        name, numbered, number = name.partition(DRAW)
        if name not in self.variants or numbered and not number.isdecimal():
            raise SceneError(f"scene {self.name} has no variant '{name}{numbered}{number}'; there are: {', '.join(self.variants)}")
        return Variant(self, name, self.variants[name] or {}, int(number or draw))

    def runs(self):
        """what examples/run all runs: all_variants, each with all of its draws"""
        return [self.variant(name, draw) for name in self.all_variants for draw in range(1, self.variant(name).draws + 1)]

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
    def __init__(self, scene, name, settings, draw):
        self.scene, self.name, self.draw = scene, name, draw
        self.draws = settings.get("draws", scene.draws)
        self.variables = dict(settings.get("vars") or {})
        self.suffix = ""
        if draw > 1:
            self.variables["seed"], self.suffix = draw, f"{DRAW}{draw}"
        self.label = (f"{scene.name}.{name}" if name else scene.name) + self.suffix

    @property
    def has_reference(self):
        """the other draws are there for the spread of what is measured"""
        return self.draw == 1

    def output(self, nprocs):
        return OUTPUT / self.scene.name / f"{self.name or 'default'}{self.suffix}.np{nprocs}"

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
