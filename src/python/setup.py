"""The wheel of glibra: `pip wheel .` in this folder builds the module with CMake, and beside it the module for picture formats.
Needs what the library needs, and pybind11. GLIBRA_BUILD may name a build folder of CMake that has been configured with
GLIBRA_PYTHON; otherwise a new one is made and removed. Nothing is written into the repository. tools/package-python puts this
file into the root of a source distribution."""
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE if (HERE / "CMakeLists.txt").exists() else HERE.parents[1]
PACKAGE = (ROOT / "src/python/glibra").relative_to(HERE) if HERE == ROOT else "glibra"


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
            subprocess.check_call(["cmake", "--build", folder, "--target", "glibra_python", "glibra_openimageio"])
            built, = pathlib.Path(folder, "python", "glibra").glob("_core*.so")
            shutil.copy(built, target)
            # Where the library looks: in `glibra` beside the module.
            formats = target.parent / "glibra" / "glibra_openimageio.so"
            formats.parent.mkdir(exist_ok=True)
            shutil.copy(pathlib.Path(folder, formats.name), formats)


with tempfile.TemporaryDirectory() as work:
    setup(
        name="glibra",
        version=re.search(r"^project\(glibra VERSION ([0-9.]+)", (ROOT / "CMakeLists.txt").read_text(), re.MULTILINE)[1],
        description="Renders GLIB shader scenes to NumPy arrays",
        long_description=(ROOT / "docs/python.md").read_text(),
        long_description_content_type="text/markdown",
        license="MIT",
        python_requires=">=3.9",
        install_requires=["numpy"],
        packages=["glibra"],
        package_dir={"glibra": str(PACKAGE)},
        package_data={"glibra": ["*.pyi", "py.typed"]},
        ext_modules=[Extension("glibra._core", [])],
        cmdclass={"build_ext": CMakeBuild},
        entry_points={"pytest11": ["glibra = glibra.pytest_plugin"]},
        options={"build": {"build_base": work}, "egg_info": {"egg_base": work}},
    )
