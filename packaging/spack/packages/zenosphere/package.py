# A recipe for Spack, to be used with a checkout (docs/installation.md).
from spack.package import *


class Zenosphere(CMakePackage):
    """Event-driven inelastic hard spheres, and whether they collapse."""

    license("MIT")
    version("main")  # the sources that `spack develop` names

    variant("mpi", default=True, description="Hand out the runs of a sweep with MPI")
    variant("python", default=True, description="The Python module and the figures")

    depends_on("c", type="build")
    depends_on("cxx", type="build")
    depends_on("cmake@3.25:", type="build")
    depends_on("ninja", type="build")
    depends_on("pkgconfig", type="build")
    depends_on("boost@1.74:")
    depends_on("cli11@2:")
    depends_on("flint@3:")  # holds Arb
    depends_on("fmt@9:")
    depends_on("gmp")
    depends_on("hdf5@1.10.8:~mpi+hl")
    depends_on("mpfr")
    depends_on("nlohmann-json@3.11:")
    depends_on("sqlite@3.24:")
    depends_on("tomlplusplus@3.2:")
    depends_on("mpi", when="+mpi")
    with when("+python"):
        extends("python@3.11:")
        depends_on("py-pybind11@2.10:", type="build")
        depends_on("py-numpy", type=("build", "run"))
        depends_on("py-h5py", type="run")
        depends_on("py-matplotlib", type="run")

    generator("ninja")

    def cmake_args(self):
        return [
            self.define("BUILD_TESTING", False),
            self.define("ZENOSPHERE_PAGE", False),  # npm would fetch what it bundles
            self.define_from_variant("ZENOSPHERE_MPI", "mpi"),
            self.define_from_variant("ZENOSPHERE_PYTHON", "python"),
        ]
