"""Whole processes, timed in pairs: what is measured and what it is measured against, in turn, in one run."""
import os
import statistics
import subprocess
import time

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
BUILD = os.environ.get("GLIBRA_BENCH_BUILD", os.path.join(ROOT, "build", "bench"))
GLIBRA = os.path.join(BUILD, "glibra")
TOOLS = os.path.join(BUILD, "tests", "bench")
FLOOR = os.path.join(TOOLS, "glibra_floor")


def wall(command, environment=None, folder=None):
    """Seconds of one process, which must succeed."""
    start = time.perf_counter()
    subprocess.run(command, check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, cwd=folder,
                   env=dict(os.environ, **(environment or {})))
    return time.perf_counter() - start


def wall_and_memory(command):
    """Seconds and the most memory of one process, in MiB."""
    start = time.perf_counter()
    with subprocess.Popen(command, stdout=subprocess.DEVNULL) as process:
        _, status, usage = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
    if process.returncode != 0:
        raise subprocess.CalledProcessError(process.returncode, command)
    return time.perf_counter() - start, usage.ru_maxrss / 1024


def pairs(first, second, runs):
    """Calls both in turn; the values of each, without those of the first pair, which warms caches."""
    values = [(first(), second()) for _ in range(runs + 1)][1:]
    return [a for a, _ in values], [b for _, b in values]


def ratios(over, under):
    return [a / b for a, b in zip(over, under)]


def spread(values):
    """Minimum, median, maximum."""
    return min(values), statistics.median(values), max(values)
