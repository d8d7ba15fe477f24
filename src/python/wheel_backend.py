"""What pip calls to build the wheel: setuptools with the setup.py of this folder."""
import os
import pathlib

os.chdir(pathlib.Path(__file__).resolve().parent)

from setuptools.build_meta import *  # noqa: E402,F403
