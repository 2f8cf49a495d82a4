"""What a process costs before it has done anything: processor time and peak memory of starting, importing, answering.

Counted in bare interpreters as well; SymPy and SciPy stand beside, since a tool built on them pays at least that.

``moment`` and ``expand`` write their closed forms without SymPy (``numbers.gamma_sums``), whose import alone takes
longer than either; an irrational or a symbolic exponent still loads it.
"""

import json
import subprocess
import sys

from benchmarks.table import Table

MEASURE = """
import json, resource, subprocess, sys
command = json.loads(sys.argv[1])
def used():
    children = resource.getrusage(resource.RUSAGE_CHILDREN)
    return children.ru_utime + children.ru_stime
times = []
for _ in range(int(sys.argv[2])):
    start = used()
    subprocess.run(command, check=True, stdout=subprocess.DEVNULL)
    times.append(used() - start)
print(json.dumps([min(times), resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss / 1024]))
"""
ASYMPTOTICS = ("-m", "asymptotics.shell.main")
COMMANDS = {
    "bare interpreter": ("-c", "pass"),
    "import asymptotics": ("-c", "import asymptotics"),
    "import sympy": ("-c", "import sympy"),
    "import scipy.integrate": ("-c", "import scipy.integrate"),
    "asymptotics --version": (*ASYMPTOTICS, "--version"),
    "asymptotics moment --p 5/2": (*ASYMPTOTICS, "moment", "--p", "5/2"),
    "asymptotics expand --alpha 3/2 --order 4": (*ASYMPTOTICS, "expand", "--alpha", "3/2", "--order", "4"),
    "asymptotics expand --alpha sqrt(2)": (*ASYMPTOTICS, "expand", "--alpha", "sqrt(2)"),
}
POINTS = (*ASYMPTOTICS, *["turning-points", "--alpha", "2", "--epsilon", "1/10", "--digits", "20", "--count"])


def run(size: int = 5) -> Table:
    """The best of ``size`` runs of each command; 2000 ``size`` turning points."""
    count = str(2000 * size)
    commands = {**COMMANDS, f"asymptotics turning-points --alpha 2, {count} points": (*POINTS, count)}
    rows: list[tuple[str, ...]] = []
    first = 0.0
    for name, arguments in commands.items():
        measure = [sys.executable, "-c", MEASURE, json.dumps([sys.executable, *arguments]), str(size)]
        done = subprocess.run(measure, capture_output=True, text=True, check=True)
        seconds, megabytes = json.loads(done.stdout)
        first = first or seconds
        rows.append((name, f"{seconds:.3f}", f"{seconds / first:.1f}", f"{megabytes:.0f}"))
    return Table("Start-up and memory", ("what", "seconds", "times the bare one", "peak MB"), tuple(rows))
