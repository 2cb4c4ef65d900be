"""Builds the compiled part of the package and the program with CMake; the rest is in pyproject.toml.

CMake's build folder is `build`, or what the environment variable ZENOSPHERE_BUILD names: what is
built there already is not built again.
"""

import os
import re
import shutil
import subprocess
import sys
import sysconfig
from pathlib import Path

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext

CHECKOUT = Path(__file__).resolve().parent
CORE = "_core" + sysconfig.get_config_var("EXT_SUFFIX")


class BuildWithCMake(build_ext):
    def build_extension(self, extension):
        folder = CHECKOUT / os.environ.get("ZENOSPHERE_BUILD", "build")
        if not (folder / "CMakeCache.txt").exists():
            self._configure(folder)
        subprocess.run(["cmake", "--build", folder, "--target", "zenosphere_module", "zenosphere"],
                       check=True)
        built = folder / "python" / "zenosphere" / CORE
        if not built.exists():
            raise SystemExit(f"{built}: is not there ({folder} builds for another Python); set"
                             " ZENOSPHERE_BUILD to a folder that is not there yet")
        target = Path(self.get_ext_fullpath(extension.name))
        target.parent.mkdir(parents=True, exist_ok=True)
        shutil.copy2(built, target)
        program = target.parent / "bin" / "zenosphere"  # which the command `zenosphere` starts
        program.parent.mkdir(exist_ok=True)
        shutil.copy2(folder / "zenosphere", program)
        shutil.copy2(CHECKOUT / "CITATION.cff", target.parent)

    @staticmethod
    def _configure(folder):
        subprocess.run(["cmake", "-S", CHECKOUT, "-B", folder, "-G", "Ninja",
                        "-DCMAKE_BUILD_TYPE=Release", "-DBUILD_TESTING=OFF",
                        f"-DPython_EXECUTABLE={sys.executable}"], check=True)


def version():
    return re.search(r"^version: (.+)$", (CHECKOUT / "CITATION.cff").read_text(), re.M)[1]


(CHECKOUT / "build" / "pip").mkdir(parents=True, exist_ok=True)
setup(version=version(), ext_modules=[Extension("zenosphere._core", sources=[])],
      cmdclass={"build_ext": BuildWithCMake})
