# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

"""Recipe for Spack: spack repo add packaging/spack, then spack dev-build potdem@0.9.0 in the folder of the sources."""

from spack.package import *


class Potdem(CMakePackage):
    """Potential-based discrete elements for LAMMPS: bonds that break, and grains."""

    license("GPL-2.0-only")

    version("0.9.0")

    variant("images", default=True, description="dump image with PNG and JPEG, dump movie with FFmpeg")

    resource(name="lammps", git="https://github.com/lammps/lammps.git", tag="patch_4Feb2025", placement="lammps")

    depends_on("cxx", type="build")
    depends_on("cmake@3.21:", type="build")
    depends_on("ninja", type="build")
    depends_on("mpi")
    depends_on("voropp")
    depends_on("jpeg", when="+images")
    depends_on("libpng", when="+images")
    depends_on("ffmpeg", when="+images", type="run")
    depends_on("python@3.9:", type=("build", "run"))
    depends_on("py-numpy", type="run")
    depends_on("py-scipy", type="run")
    depends_on("py-matplotlib", type="run")
    depends_on("py-pyyaml", type="run")

    generator("ninja")
    build_targets = ["lmp", "potdemplugin"]

    def cmake_args(self):
        return [
            self.define("LAMMPS_SOURCE_DIR", join_path(self.stage.source_path, "lammps")),
            self.define_from_variant("WITH_JPEG", "images"),
            self.define_from_variant("WITH_PNG", "images"),
        ]

    def install(self, spec, prefix):
        cmake("--install", self.build_directory, "--component", "potdem", "--prefix", prefix)
