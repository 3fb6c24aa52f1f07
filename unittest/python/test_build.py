# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""Getting LAMMPS, building with it, and the plugin."""

import json
import re
import shutil
import subprocess
import tarfile
from concurrent.futures import ThreadPoolExecutor

import pytest
from conftest import PLAIN

from potdem import running, scripts

pytestmark = pytest.mark.built_in

PACKAGES = ("MOLECULE", "BPM", "PLUGIN", "OPENMP")
NOWHERE = "file:///no/such/place"


def styles(root):
    """(kind, name) of each style in the registration table"""
    return scripts.registered_styles(root)


def plugin_list(run):
    return set(re.findall(r"^ *\d+: (\w+) style plugin (\S+)$", run.stdout, re.MULTILINE))


def configure(root, folder, *settings):
    """configures the project in a new folder, with a compiler check as short as can be"""
    return subprocess.run(["cmake", "-G", "Ninja", "-S", root, "-B", folder, *settings], text=True, check=False,
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT)


def one_line(text):
    return " ".join(text.split())


def fake_tree(folder, version):
    for package in PACKAGES:
        (folder / "src" / package).mkdir(parents=True)
    (folder / "cmake").mkdir()
    (folder / "cmake" / "CMakeLists.txt").write_text('message(FATAL_ERROR "as far as a fake tree goes")\n')
    (folder / "src" / "version.h").write_text(f'#define LAMMPS_VERSION "{version}"\n')
    return folder


def fake_archive(folder, version):
    archive = folder / "lammps.tar.gz"
    with tarfile.open(archive, "w:gz") as tar:
        tar.add(fake_tree(folder / "tree", version), "lammps-release")
    return archive


def test_styles_are_compiled_in(root, run_lammps):
    help_text = run_lammps("info styles pair styles bond styles fix styles compute styles command styles region\n").stdout
    public = [name for _, name in styles(root) if name.islower()]
    assert public and [name for name in public if name not in help_text.split()] == []


def test_plugin_registers_every_style_of_the_table(root, build, run_lammps):
    run = run_lammps(f"plugin load {build}/potdemplugin.so\nplugin list\n")
    assert plugin_list(run) == set(styles(root))


def test_plugin_is_found_by_path(root, build, run_lammps, monkeypatch):
    monkeypatch.setenv("LAMMPS_PLUGIN_PATH", str(build))
    assert plugin_list(run_lammps("plugin list\n")) == set(styles(root))


def test_plugin_and_built_in_styles_give_the_same_numbers(root, build, run_lammps):
    """a breaking beam, 0.01 s: same sources and compiler options, so every digit"""
    scene = root / "examples" / "beam-impact" / "in.beam-impact"
    script = f"variable speed index 5\nvariable time index 0.01\nvariable picture index no\ninclude {scene}\n"
    built_in = run_lammps(script)
    plugin = run_lammps(f"plugin load {build}/potdemplugin.so\n{script}")
    assert "Overriding built-in bond style potdem/truss" in one_line(plugin.stdout)
    assert built_in.thermo["v_broken"][-1] > 0
    for column, values in built_in.thermo.items():
        assert (plugin.thermo[column] == values).all(), column


def plain_lammps(script, folder):
    """the Run of a script in a LAMMPS that has none of our styles"""
    return running.run(script, {}, folder, name="plain", lmp=PLAIN)


def test_the_plain_lammps_has_no_style_of_ours(root, tmp_path):
    """or the tests through the plugin would not be about the plugin"""
    text = plain_lammps("info styles all\n", tmp_path).stdout
    assert "bpm/spring" in text
    assert [name for _, name in styles(root) if name in text] == []


def test_plugin_in_a_lammps_without_the_styles(root, build, tmp_path):
    """the ledger is a fix that a compute makes, and takes away again when LAMMPS ends, after its plugins have gone"""
    script = f"plugin load {build}/potdemplugin.so\nplugin list\n" + scripts.box(8) + \
        "region body block 0 3 0 3 0 3 units box\n" + scripts.crystal(region="body") + scripts.elastic() + """
potdem_bonds all 1 1.42
fix move all nve
compute books all potdem/energy
thermo_style custom step c_books
timestep 1e-4
run 10
"""
    done = plain_lammps(script, tmp_path)
    assert plugin_list(done) == set(styles(root))
    assert "ERROR" not in done.stdout and done.ended_well, done.stdout[-2000:]


def test_plugin_for_another_version_is_refused(build, run_lammps):
    run = run_lammps(f"plugin load {build}/unittest/potdemplugin_wrongversion.so\nplugin list\n")
    host = re.search(r"LAMMPS \((\d+ \w+ \d+)", run.stdout).group(1)
    text = one_line(run.stdout)
    assert "compiled for LAMMPS version 1 Jan 1970" in text
    assert f"this LAMMPS is version {host}" in text
    assert "-D LAMMPS_SOURCE_DIR=" in text
    assert plugin_list(run) == set()


def test_plugin_without_its_styles_says_what_is_missing(build, run_lammps, tmp_path):
    (tmp_path / "potdemplugin.so").write_bytes((build / "potdemplugin.so").read_bytes())
    run = run_lammps("plugin load ./potdemplugin.so\nplugin list\n")
    assert "potdemstyles.so must lie beside the plugin" in one_line(run.stdout)
    assert plugin_list(run) == set()


def test_plugin_built_with_a_given_source_tree_and_without_warnings(root, build, run_lammps, tmp_path):
    tree = re.search(r"^POTDEM_LAMMPS_DIR:INTERNAL=(.*)$", (build / "CMakeCache.txt").read_text(), re.MULTILINE)
    other = tmp_path / "build"
    configured = configure(root, other, f"-DLAMMPS_SOURCE_DIR={tree.group(1)}", "-DCMAKE_BUILD_TYPE=Debug",
                           "-DCMAKE_CXX_FLAGS_DEBUG=-O0 -Werror")
    assert configured.returncode == 0, configured.stdout[-3000:]
    built = subprocess.run(["cmake", "--build", other, "--target", "potdemplugin"], text=True, check=False,
                           stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    assert built.returncode == 0, built.stdout[-3000:]
    assert plugin_list(run_lammps(f"plugin load {other}/potdemplugin.so\nplugin list\n")) == set(styles(root))


@pytest.mark.parametrize("version, problem", [(None, "is not a LAMMPS source tree"),
                                              ("29 Aug 2024", "holds LAMMPS 29 Aug 2024, POTDEM needs 4 Feb 2025")])
def test_a_wrong_source_tree_is_refused(root, tmp_path, version, problem):
    tree = fake_tree(tmp_path / "tree", version) if version else tmp_path
    configured = configure(root, tmp_path / "build", f"-DLAMMPS_SOURCE_DIR={tree}")
    assert configured.returncode != 0
    assert problem in one_line(configured.stdout)
    assert "-D LAMMPS_SOURCE_DIR=" in configured.stdout


def fetch(root, tmp_path, upstream, mirror):
    """configures with an empty cache; returns its output and where the tree should be"""
    cache = tmp_path / "cache"
    configured = configure(root, tmp_path / "build", "-DLAMMPS_SOURCE_DIR=", f"-DPOTDEM_CACHE_DIR={cache}",
                           f"-DPOTDEM_UPSTREAM_URL={upstream}", f"-DPOTDEM_MIRRORS={mirror}")
    return one_line(configured.stdout), cache / "lammps-4Feb2025"


def test_unreachable_sources_name_the_remedy(root, tmp_path):
    text, tree = fetch(root, tmp_path, NOWHERE, NOWHERE)
    assert "could not be fetched" in text and "upstream:" in text and "package mirror:" in text
    assert "cmake --preset default -D LAMMPS_SOURCE_DIR=/path/to/lammps" in text
    assert not tree.exists()


def test_upstream_archive_is_unpacked(root, tmp_path):
    text, tree = fetch(root, tmp_path, fake_archive(tmp_path, "4 Feb 2025").as_uri(), NOWHERE)
    assert (tree / "src" / "version.h").exists() and "as far as a fake tree goes" in text
    assert not (tree.parent / "fetching").exists()


def test_upstream_archive_of_another_version_is_refused(root, tmp_path):
    text, tree = fetch(root, tmp_path, fake_archive(tmp_path, "4 Jul 2026").as_uri(), NOWHERE)
    assert "the archive holds LAMMPS 4Jul2026, not 4Feb2025" in text
    assert not tree.exists()


def test_mirror_archive_with_a_wrong_checksum_is_refused(root, tmp_path):
    debian_file = re.search(r"POTDEM_DEBIAN_FILE (\S+)\)", (root / "cmake" / "LAMMPSFetch.cmake").read_text())
    place = tmp_path / "mirror" / debian_file.group(1)
    place.parent.mkdir(parents=True)
    fake_archive(tmp_path, "4 Feb 2025").rename(place)
    text, tree = fetch(root, tmp_path, NOWHERE, (tmp_path / "mirror").as_uri())
    assert "wrong checksum" in text
    assert not tree.exists()


# --- another compiler -------------------------------------------------------------------------------------

def commands(root, build):
    """{source of this package: (folder, how it is compiled)}; the first command of each"""
    listed = subprocess.run(["ninja", "-C", build, "-t", "compdb"], text=True, check=True, stdout=subprocess.PIPE).stdout
    ours = {}
    for entry in json.loads(listed[listed.index("["):]):
        if entry["file"].startswith(f"{root / 'src'}/") and entry["file"].endswith(".cpp"):
            ours.setdefault(entry["file"], (entry["directory"], entry["command"]))
    return ours


def test_clang_has_no_warnings(root, build):
    """what the build compiles, with the build's options, read by another compiler"""
    clang = shutil.which("clang++")
    if not clang or not (build / "build.ninja").exists():
        pytest.skip("needs clang++ and a build by Ninja")

    def complaints(command):
        folder, text = command
        options = text.split(" -D", 1)[1].split(" -MD ")[0]
        done = subprocess.run(f"{clang} -D{options} -fsyntax-only {text.split()[-1]}", shell=True, cwd=folder, text=True, check=False,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
        assert "-Wextra" in options
        return re.findall(r"^.*(?:warning|error): .*", done.stdout, re.MULTILINE)

    ours = commands(root, build)
    assert len(ours) >= len(list((root / "src" / "lammps").rglob("*/*.cpp")))
    with ThreadPoolExecutor(2) as workers:
        found = {line for lines in workers.map(complaints, ours.values()) for line in lines}
    assert sorted(found) == []


VECTORS = """#include "core/contact/contact_batch.h"
#include "core/laws/law_list.h"
using namespace POTDEM;
void find(ContactBatch<{law}::Kernel, {rate}, {friction}, true, 16> &batch, const PairLaws<{law}::Kernel, {rate}, {friction}> &laws)
{{
  batch.find_avx2(laws, 1.0, 1.0);
  batch.find_avx512(laws, 1.0, 1.0);
}}
"""


@pytest.mark.parametrize("law, rate, friction", [("Hertz", "Elastic", "Sliding"), ("Hertz", "Viscous", "TangentialSpring"),
                                                 ("Hertz", "Restitution", "Mindlin"), ("Hertz", "Restitution", "Rolls<Mindlin>"),
                                                 ("Dmt", "Restitution", "Rolls<Mindlin>")])
def test_batches_of_contacts_become_vector_instructions(root, tmp_path, law, rate, friction):
    """a branch in a law would end that without a word: what GCC says of the loop over the lanes"""
    gcc = shutil.which("g++")
    made = subprocess.run([gcc or "g++", "-dumpmachine"], text=True, check=False, stdout=subprocess.PIPE) if gcc else None
    if not made or not made.stdout.startswith("x86_64"):
        pytest.skip("needs g++ for x86-64")
    (options,) = re.findall(r"set\(POTDEM_FLOATING_POINT (.*)\)", (root / "cmake" / "POTDEMSources.cmake").read_text())
    source = tmp_path / "batch.cpp"
    source.write_text(VECTORS.format(law=law, rate=rate, friction=friction))
    done = subprocess.run([gcc, "-std=c++17", "-O3", *options.split(), f"-I{root / 'src'}", "-S", "-o", tmp_path / "batch.s",
                           "-fopt-info-vec-optimized", source], text=True, check=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    for size in (32, 64):
        assert re.search(rf"contact_batch\.h.*loop vectorized using {size} byte vectors", done.stdout), done.stdout
