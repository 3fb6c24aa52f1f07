# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""Every law and contact can be called on a device: nvcc compiles unittest/device/every_law.cu, and where there is a device it
compares what that finds with what the host finds."""

import shutil
import subprocess

import pytest

pytestmark = pytest.mark.built_in


@pytest.fixture(scope="module")
def program(root, tmp_path_factory):
    nvcc = shutil.which("nvcc")
    if not nvcc:
        pytest.skip("no nvcc on this machine")
    made = tmp_path_factory.mktemp("device") / "every_law"
    done = subprocess.run([nvcc, "-std=c++17", "--expt-relaxed-constexpr", "-Werror", "all-warnings", "-arch=sm_90",
                           f"-I{root / 'src'}", "-o", made, root / "unittest" / "device" / "every_law.cu"], text=True,
                          check=False, stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    assert done.returncode == 0, done.stdout[-3000:]
    return made


def test_every_law_compiles_for_a_device(program):
    assert program.exists()


def test_a_device_finds_what_the_host_finds(program):
    """to rounding: a device may fuse a product and a sum"""
    done = subprocess.run([program], text=True, check=False, stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    if done.returncode == 2:
        pytest.skip(f"no device to run it on: {done.stdout.strip().splitlines()[-1]}")
    assert done.returncode == 0, done.stdout
