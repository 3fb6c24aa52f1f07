# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""What is installed runs where it has been moved, with an empty environment, and keeps no path of the machine that built it."""

import os
import re
import shutil
import subprocess
import tarfile

import pytest
from conftest import PLAIN

from potdem import logs, scripts

pytestmark = pytest.mark.built_in

VARIANT = "i-3"    # of beam-impact


def output_of(*command, folder=None):
    """what a command says that is started with nothing in its environment but a plain PATH, in which Open MPI looks for its
    daemon; it must end well"""
    done = subprocess.run(["env", "-i", "PATH=/usr/bin:/bin", *map(str, command)], cwd=folder, text=True, check=False,
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    assert done.returncode == 0, done.stdout[-3000:]
    return done.stdout


@pytest.fixture(scope="module")
def settings(build):
    """{name: value} of CMake's cache"""
    cache = build / "CMakeCache.txt"
    if not cache.exists():
        pytest.skip("needs a build folder of CMake")
    return dict(re.findall(r"^(\w+):\w+=(.*)$", cache.read_text(), re.MULTILINE))


@pytest.fixture(scope="module")
def installed(build, settings, tmp_path_factory):
    """the folder with everything, LAMMPS's own files too, moved"""
    assert settings["CMAKE_PROJECT_NAME"] == "POTDEM"
    folder = tmp_path_factory.mktemp("installed")
    subprocess.run(["cmake", "--install", build, "--prefix", folder / "first"], check=True, stdout=subprocess.DEVNULL)
    yield (folder / "first").rename(folder / "moved here")
    shutil.rmtree(folder)    # 100 MB


@pytest.fixture(scope="module")
def unpacked(build, settings, tmp_path_factory):
    """cpack's archive, unpacked; pages say how it is called"""
    folder = tmp_path_factory.mktemp("archive")
    subprocess.run(["cpack", "--config", build / "CPackConfig.cmake", "-B", folder / "made"], check=True, cwd=folder,
                   stdout=subprocess.DEVNULL)
    (archive,) = (folder / "made").glob("*.tar.gz")
    assert re.fullmatch(r"potdem-\d+\.\d+\.\d+-Linux-\w+\.tar\.gz", archive.name)
    with tarfile.open(archive) as tar:
        tar.extractall(folder, filter="data") if hasattr(tarfile, "data_filter") else tar.extractall(folder)
    return folder / archive.name.removesuffix(".tar.gz")


def test_lmp_starts_from_the_moved_folder_and_has_the_styles(root, installed):
    text = output_of(installed / "bin" / "lmp", "-h").split()
    assert [name for _, name in scripts.registered_styles(root) if name.islower() and name not in text] == []
    for program in ("bin/lmp", "lib/liblammps.so.0"):
        (path,) = re.findall(r"\(RUNPATH\).*\[(.*)\]", output_of("readelf", "-d", installed / program))
        assert path == "$ORIGIN/../lib"


def test_no_path_of_the_building_machine_is_left(root, build, settings, unpacked):
    """in programs and scripts, all that is installed of this package"""
    paths = [str(path).encode() for path in (root, build, settings["POTDEM_LAMMPS_DIR"])]
    files = [file for file in unpacked.rglob("*") if file.is_file()]
    assert {"lmp", "potdem-env", "liblammps.so.0", "potdemplugin.so", "potdemstyles.so"} <= {file.name for file in files}
    assert [(file.name, path) for file in files for path in paths if path in file.read_bytes()] == []


def test_an_error_still_names_its_place_in_the_source(installed, tmp_path):
    (tmp_path / "in.wrong").write_text("units si\nbond_style nothing\n")
    done = subprocess.run([installed / "bin" / "lmp", "-in", "in.wrong", "-log", "none"], cwd=tmp_path, text=True, check=False,
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    assert re.search(r"ERROR: .*\(src/\w+\.cpp:\d+\)", done.stdout), done.stdout


def test_plugin_materials_and_pages_are_where_the_page_says(root, installed, unpacked):
    page = (root / "docs" / "install.md").read_text(encoding="utf-8")
    for folder in (installed, unpacked):
        for place, name in (("lib/lammps/plugins", "potdemplugin.so"), ("lib/lammps/plugins", "potdemstyles.so"),
                            ("share/lammps/potentials", "common.potdem"), ("share/potdem", "docs/index.md"),
                            ("share/potdem", "examples/beam-impact/scene.yaml")):
            assert f"`{place}`" in page and (folder / place / name).is_file(), (folder, place, name)
    assert (installed / "include" / "lammps" / "library.h").exists() and not (unpacked / "include").exists()


@pytest.mark.parametrize("lmp, plugins", [(None, False), (PLAIN, True)], ids=["installed", "plugin in another LAMMPS"])
def test_beam_impact_comes_to_its_reference(unpacked, tmp_path, lmp, plugins):
    """the archive's own Python runs and compares; POTDEM_LMP: a LAMMPS without our styles, which finds the plugin by its path"""
    other = ["env", f"POTDEM_LMP={lmp}", f"LAMMPS_PLUGIN_PATH={unpacked}/lib/lammps/plugins"] if plugins else []
    text = output_of(unpacked / "bin" / "potdem-env", *other, "python3", "-m", "potdem.scenes.run_scene", "beam-impact", VARIANT,
                     folder=tmp_path)
    assert re.search(r"^[1-9]\d* checks passed, 0 failed$", text, re.MULTILINE), text[-3000:]
    (log,) = re.findall(r"^log: +(.*)$", text, re.MULTILINE)
    assert ("plugins from" in logs.read(log)) == plugins
    assert str(tmp_path) in log


def test_the_shell_learns_where_everything_is(installed, tmp_path):
    """the line for a profile, in any shell; a material by its file's name, and LAMMPS from Python"""
    (tmp_path / "in.material").write_text('units si\npotdem_material common.potdem steel density rho\nprint "RHO $(v_rho)"\n')
    for shell in ("sh", "bash"):
        text = output_of(shell, "-c", f'eval "$("{installed}/bin/potdem-env")"; lmp -in in.material -log none; '
                         'python3 -c "import lammps, potdem; print(\'FROM\', potdem.__file__); '
                         'lammps.lammps(cmdargs=[\'-log\', \'none\'])"',
                         folder=tmp_path)
        assert "RHO 7" in text and f"FROM {installed}/share/potdem/tools/potdem" in text and text.count("LAMMPS (") == 2, text


def test_lines_of_the_page_for_users_are_those_tested(root):
    page = (root / "docs" / "install.md").read_text(encoding="utf-8")
    for line in ("cmake --install build --prefix ~/potdem", "cd build && cpack", 'eval "$(~/potdem/bin/potdem-env)"',
                 "~/potdem/bin/potdem-env python3 -m potdem.scenes.run_scene beam-impact", "cmake --build build --target potdemplugin"):
        assert line in page.splitlines()


# --- the plugin from sources alone ------------------------------------------------------------------------

def symbols(*options, files):
    """{name} that nm says"""
    text = subprocess.run(["nm", *options, *files], text=True, check=True, stdout=subprocess.PIPE).stdout
    return set(re.findall(r"^\S* *[A-Za-z] (\S+)$", text, re.MULTILINE))


def test_plugin_compiles_nothing_of_lammps(root, build):
    if not (build / "build.ninja").exists():
        pytest.skip("needs a build by Ninja")
    lines = subprocess.run(["ninja", "-t", "commands", "potdemplugin"], cwd=build, text=True, check=True, stdout=subprocess.PIPE).stdout
    compiled = re.findall(r" -c (\S+)$", lines, re.MULTILINE)
    # CMake writes the sources of the pair styles, one for each law
    assert len(compiled) > 40 and all(re.match(rf"{root}/src/|\S+/potdem/pair_potdem_\w+\.cpp$", name) for name in compiled)


def test_plugin_needs_of_lammps_its_core_and_bpm(build, settings):
    """functions of OPENMP may be missing as long as nobody calls them: such are bound when they are called"""
    if not (build / "build.ninja").exists():
        pytest.skip("needs a build by Ninja")
    plugin = build / "potdemstyles.so"
    needed = {name for name in symbols("-D", "--undefined-only", files=[plugin]) if "LAMMPS_NS" in name}
    tree = f"{settings['POTDEM_LAMMPS_DIR']}/src"
    objects = list((build / "lammps").rglob("*.cpp.o"))
    core = [file for file in objects if re.search(rf"{tree}/(BPM/)?\w+\.cpp\.o$", str(file))]
    omp = [file for file in objects if f"{tree}/OPENMP/" in str(file)]
    assert len(core) > 200 and omp
    missing = needed - symbols("--defined-only", files=core)
    assert missing and missing <= symbols("--defined-only", files=omp)
    relocations = subprocess.run(["readelf", "-rW", plugin], text=True, check=True, stdout=subprocess.PIPE).stdout
    when = {name: set(re.findall(rf"(R_\w+) .* {name} \+", relocations)) for name in missing}
    assert all(kinds and all(kind.endswith("_JUMP_SLOT") for kind in kinds) for kinds in when.values()), when
    assert "NOW" not in re.sub(r".*\bNEEDED\b.*", "", subprocess.run(["readelf", "-d", plugin], text=True, check=True,
                                                                     stdout=subprocess.PIPE).stdout)


# --- into the user's own build ----------------------------------------------------------------------------

def configure_users_lammps(root, settings, tree, folder, *options):
    """how LAMMPS's own project in a tree is configured with our file"""
    page = (root / "docs" / "install.md").read_text(encoding="utf-8")
    (line,) = re.findall(r"^cmake -S /path/to/lammps/cmake .*$", page, re.MULTILINE)
    words = line.replace("/path/to/lammps", str(tree)).replace("/path/to/potdem", str(root)).split()
    words[words.index("build")] = str(folder)
    return subprocess.run([*words, "-G", "Ninja", *options], text=True, check=False, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                          env={**os.environ, "CXX": settings["CMAKE_CXX_COMPILER"]})


def test_users_lammps_takes_the_package_along(root, settings, tmp_path):
    """without OPENMP, so that the variants for it must stay out; one source of LAMMPS reads the table of styles"""
    done = configure_users_lammps(root, settings, settings["POTDEM_LAMMPS_DIR"], tmp_path / "build", "-DBUILD_SHARED_LIBS=on",
                                  *(f"-D{name}={settings[name]}" for name in ("Python_EXECUTABLE", "Python3_EXECUTABLE")
                                    if name in settings))
    assert done.returncode == 0, done.stdout[-3000:]
    listed = subprocess.run(["ninja", "-t", "commands", "lmp"], cwd=tmp_path / "build", text=True, check=True,
                            stdout=subprocess.PIPE).stdout
    ours = {name for name in re.findall(r" -c (\S+)$", listed, re.MULTILINE) if name.startswith(f"{root}/src/")}
    assert ours == {str(path) for path in (root / "src").rglob("*.cpp") if "_omp" not in path.stem and not path.stem.startswith("plugin")}
    (line,) = [text for text in listed.splitlines() if text.endswith("/src/modify.cpp")]
    reading = re.sub(r"-o \S+ -c", "-fsyntax-only", re.sub(r"-MD -MT \S+ -MF \S+", "", line))
    read = subprocess.run(reading, shell=True, text=True, check=False, cwd=tmp_path / "build", stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT)
    assert read.returncode == 0 and "error" not in read.stdout, read.stdout[-3000:]
    styles = (tmp_path / "build" / "styles" / "style_fix.h").read_text()
    assert '#include "potdem_styles.h"' in styles and "fix_omp.h" not in styles


@pytest.mark.parametrize("option, told", [("-DPKG_BPM=off", "POTDEM needs LAMMPS's package BPM: add -D PKG_BPM=on"),
                                          ("-DBUILD_MPI=off", "POTDEM needs MPI, not LAMMPS's stand-in for it: add -D BUILD_MPI=on")])
def test_users_lammps_that_lacks_something_is_told(root, settings, tmp_path, option, told):
    (tmp_path / "cmake").mkdir()
    (tmp_path / "cmake" / "CMakeLists.txt").write_text("cmake_minimum_required(VERSION 3.16)\nproject(lammps CXX)\n")
    done = configure_users_lammps(root, settings, tmp_path, tmp_path / "build", option)
    assert done.returncode != 0
    assert told in " ".join(done.stdout.split())
