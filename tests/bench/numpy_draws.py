#!/usr/bin/python3
"""1,000 draws of the teapot into NumPy arrays beside the same loop in C++, in turns.
Use: numpy_draws.py BUILD [DRAWS]   (BUILD has been configured with GLIBRA_BENCH and GLIBRA_PYTHON)"""
import pathlib
import statistics
import subprocess
import sys
import time

SOURCE = pathlib.Path(__file__).resolve().parents[2]
BUILD = pathlib.Path(sys.argv[1])
DRAWS = int(sys.argv[2]) if len(sys.argv) > 2 else 1000

sys.path.insert(0, str(BUILD / "python"))
import glibra  # noqa: E402

scene = glibra.Scene(SOURCE / "glib/start/teapot.glib")


def python_loop():
    for i in range(-20, DRAWS):
        if i == 0:
            begin = time.perf_counter()
        scene.uShininess = 1 + (i + 100) % 100
        scene.draw(320, 240)
    return (time.perf_counter() - begin) / DRAWS


def cpp_loop():
    ran = subprocess.run([BUILD / "tests/bench/glibra_draws", "--loop", SOURCE, str(DRAWS)], check=True, capture_output=True)
    return float(ran.stdout)


times = [(python_loop(), cpp_loop()) for _ in range(5)]
print(f"Python {1e3 * statistics.median(a for a, _ in times):.2f} ms, C++ {1e3 * statistics.median(b for _, b in times):.2f} ms, "
      f"ratio {statistics.median(a / b for a, b in times):.3f}")
