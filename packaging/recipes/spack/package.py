# SPDX-License-Identifier: GPL-3.0-or-later
# Not published: nothing in spack's own repository is made from this.
import os

from spack.package import *


class Ashimpact(CMakePackage):
    """Fly-ash impact: from XRD to the critical velocity."""

    manual_download = True  # the source archive of `./dev release`, in the folder where spack is called
    url = f"file://{os.getcwd()}/ashimpact-1.0.0.tar.gz"

    license("GPL-3.0-or-later")
    version("1.0.0")

    variant("sweep", default=True, description="Build sweeps, which need MPI and HDF5")

    depends_on("c", type="build")
    depends_on("cxx", type="build")
    depends_on("cmake@3.25:", type="build")
    depends_on("ninja", type="build")
    depends_on("pkgconfig", type="build")
    for library in (
        "boost cli11 eigen fast-float fmt gsl highway minizip nettle nlohmann-json pugixml spdlog tbb valijson zlib-api"
    ).split():
        depends_on(library)
    depends_on("mpi", when="+sweep")
    depends_on("hdf5", when="+sweep")

    generator("ninja")

    def cmake_args(self):
        return [
            self.define("BUILD_TESTING", False),
            self.define("ASHIMPACT_PYTHON", False),
            self.define_from_variant("ASHIMPACT_SWEEP", "sweep"),
        ]
