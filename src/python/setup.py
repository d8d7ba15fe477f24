"""The wheel of glibra: `pip wheel .` in this folder builds the module with CMake. Needs what the library needs, and pybind11.
GLIBRA_BUILD may name a build folder of CMake that has been configured with GLIBRA_PYTHON; otherwise a new one is made and
removed. Nothing is written into the repository."""
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext

ROOT = pathlib.Path(__file__).resolve().parents[2]


class CMakeBuild(build_ext):
    def build_extension(self, ext):
        target = pathlib.Path(self.get_ext_fullpath(ext.name))
        target.parent.mkdir(parents=True, exist_ok=True)
        with tempfile.TemporaryDirectory() as made:
            folder = os.environ.get("GLIBRA_BUILD", made)
            if folder == made:
                subprocess.check_call(
                    ["cmake", "-S", str(ROOT), "-B", folder, "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release", "-DGLIBRA_PYTHON=ON",
                     "-DGLIBRA_WINDOW=OFF", "-DGLIBRA_BENCH_PROGRAM=OFF", "-DGLIBRA_TESTS=OFF", "-DCMAKE_UNITY_BUILD=ON",
                     "-DCMAKE_UNITY_BUILD_BATCH_SIZE=8", f"-DPython3_EXECUTABLE={sys.executable}"])
            subprocess.check_call(["cmake", "--build", folder, "--target", "glibra_python"])
            built, = pathlib.Path(folder, "python", "glibra").glob("_core*.so")
            shutil.copy(built, target)


with tempfile.TemporaryDirectory() as work:
    setup(
        name="glibra",
        version=re.search(r"^project\(glibra VERSION ([0-9.]+)", (ROOT / "CMakeLists.txt").read_text(), re.MULTILINE)[1],
        description="Renders GLIB shader scenes to NumPy arrays",
        license="MIT",
        python_requires=">=3.9",
        install_requires=["numpy"],
        packages=["glibra"],
        package_data={"glibra": ["*.pyi", "py.typed"]},
        ext_modules=[Extension("glibra._core", [])],
        cmdclass={"build_ext": CMakeBuild},
        entry_points={"pytest11": ["glibra = glibra.pytest_plugin"]},
        options={"build": {"build_base": work}, "egg_info": {"egg_base": work}},
    )
