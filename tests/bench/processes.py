"""Times whole processes in pairs: the two processes alternate in one run."""
import os
import statistics
import subprocess
import time
from typing import NamedTuple

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
BUILD = os.environ.get("GLIBRA_BENCH_BUILD", os.path.join(ROOT, "build", "bench"))
GLIBRA = os.path.join(BUILD, "glibra")
TOOLS = os.path.join(BUILD, "tests", "bench")
FLOOR = os.path.join(TOOLS, "glibra_floor")


class Cost(NamedTuple):
    """The cost of one run: seconds by the clock, seconds of all processors, and peak memory in MiB."""
    wall: float
    processor: float
    memory: float = 0


def measure(command, environment=None):
    """The cost of one process, which must succeed."""
    start = time.perf_counter()
    with subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
                          env=dict(os.environ, **(environment or {}))) as process:
        _, status, usage = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
    wall = time.perf_counter() - start
    if process.returncode != 0:
        raise subprocess.CalledProcessError(process.returncode, command)
    return Cost(wall, usage.ru_utime + usage.ru_stime, usage.ru_maxrss / 1024)


def pairs(first, second, runs):
    """Calls both in turn; the costs of each, without those of the first pair, which warms caches."""
    values = [(first(), second()) for _ in range(runs + 1)][1:]
    return [a for a, _ in values], [b for _, b in values]


def ratios(over, under):
    return [a / b for a, b in zip(over, under)]


def spread(values):
    """Minimum, median, maximum."""
    return min(values), statistics.median(values), max(values)
