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
    """Seconds per draw: by the clock, of all processors together."""
    for i in range(-20, DRAWS):
        if i == 0:
            begin = time.perf_counter(), time.process_time()
        scene.uShininess = 1 + (i + 100) % 100
        scene.draw(320, 240)
    return (time.perf_counter() - begin[0]) / DRAWS, (time.process_time() - begin[1]) / DRAWS


def cpp_loop():
    ran = subprocess.run([BUILD / "tests/bench/glibra_draws", "--loop", SOURCE, str(DRAWS)], check=True, capture_output=True)
    return tuple(map(float, ran.stdout.split()))


times = [(python_loop(), cpp_loop()) for _ in range(5)]
for which, name in enumerate(("by the clock", "of processor time")):
    pairs = [(python[which], cpp[which]) for python, cpp in times]
    print(f"{name}: Python {1e3 * statistics.median(a for a, _ in pairs):.2f} ms, "
          f"C++ {1e3 * statistics.median(b for _, b in pairs):.2f} ms, ratio {statistics.median(a / b for a, b in pairs):.3f}")
