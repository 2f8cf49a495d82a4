"""Multiple scales, whole processes: the hierarchy of this package beside plain SymPy and oscilate.

What is asked of all: x'|x'| to some order.  Right is Omega_2 = -1/6 and p_3 = 2/(135 pi) in the turning-point gauge.  A
peer that has no such gauge needs the Fourier series of |sin| sin, which has no end; what it says stands in its row.
"""

import json
import subprocess
import sys
from math import nan
from pathlib import Path
from time import process_time

import numpy as np

from benchmarks.peers import ask
from benchmarks.table import Table, with_ratios

PEERS = ("oscilate", "asymptotic")
ROOT = Path(__file__).parents[1]
MEASURE = """
import json, os, subprocess, sys
done = subprocess.run(json.loads(sys.argv[1]), capture_output=True, text=True)
used = os.times()
print(json.dumps([used.children_user + used.children_system, done.returncode]))
"""
COMMANDS = {
    "x'|x'|, order 8": ["--alpha", "2", "--order", "8"],
    "x' and x'|x'|, order 5": ["--law", "1", "--law", "2", "--order", "5"],
    "symbolic alpha, order 2": ["--alpha", "symbolic", "--order", "2"],
}
SOLUTIONS = {
    "solution of x'|x'|, order 3, with its proved bound": ["--alpha", "2", "--epsilon", "1/10", "--order", "3"],
    "solution of x'|x'|, order 12, with its proved bound": ["--alpha", "2", "--epsilon", "1/10", "--order", "12"],
    "solution of a symbolic alpha, order 12": ["--alpha", "symbolic", "--order", "12"],
}
BY_HAND = "import derivations.multiple_scales_quadratic"
OSCILATE = """
start = process_time()
from sympy import Abs, Function, symbols
from oscilate import MMS
omega0, b, eps = symbols("omega0 b epsilon", positive=True)
t = symbols("t")
x = Function("x", real=True)(t)
law = x.diff(t, 2) + omega0**2 * x + b * x.diff(t) * Abs(x.diff(t))
try:
    system = MMS.Dynamical_system(t, x, law, omega0)
    _, scaled = MMS.scale_parameters((b,), (1,), eps)
    MMS.Multiple_scales_oscillator(system, eps, {order}, omega0, scaled).apply_MMS(orders_polar=0)
    said = "an answer"
except Exception as error:
    said = type(error).__name__
answer = {{"seconds": process_time() - start, "said": said}}
"""
ASYMPTOTIC = """
start = process_time()
from sympy import Abs, Function, symbols
from asymptotic.multiple_scales import multiple_scales
t, eps = symbols("t epsilon", positive=True)
x = Function("x")
v = x(t).diff(t)
found = multiple_scales(v.diff(t) + x(t) + eps * {law}, x(t), eps, order=2)
stops = f"stops at order {{found.unresolved_order}}, no phase"
said = "complete" if found.complete else stops if found.slow_flow else "empty"
answer = {{"seconds": process_time() - start, "said": said}}
"""


def process(command: list[str]) -> float:
    """Processor time of one process, its start included; nan if it fails."""
    line = [sys.executable, "-c", MEASURE, json.dumps(command)]
    seconds, code = json.loads(subprocess.run(line, capture_output=True, text=True, check=True, cwd=ROOT).stdout)
    return nan if code else float(seconds)


def evaluation(points: int) -> float:
    """x(tau) of order 3 at many times, after the formulas are made."""
    import asymptotics as asy  # noqa: PLC0415 (the other rows are processes of their own)

    x = asy.solution("2", order=3).functions()[2]
    times = np.linspace(0, 1000, points)
    x(times[:10], 0.1)
    start = process_time()
    x(times, 0.1)
    return process_time() - start


def run(size: int = 3) -> Table:
    """The first ``size`` commands, solutions and evaluation at 10^6 times (10^4 below size 3), SymPy, and the peers."""
    program = [sys.executable, "-m", "asymptotics", "multiple-scales"]
    rows = [(name, process([*program, *line])) for name, line in list(COMMANDS.items())[:size]]
    if size > 2:
        rows += [(name, process([*program[:-1], "solution", *line])) for name, line in SOLUTIONS.items()]
    points = 10**6 if size > 2 else 10**4
    rows.append((f"x(tau) of order 3 at {points} times", evaluation(points)))
    found: list[tuple[str, float | None]] = [*rows]
    if size > 2:
        found.append(("x'|x'|, order 4, SymPy by hand", process([sys.executable, "-c", BY_HAND])))
    peer = ask(OSCILATE.format(order=min(size, 2)))
    found.append((f"x'|x'|, order {min(size, 2)}, oscilate: {peer.get('said', 'no answer')}", peer["seconds"]))
    for name, law in list({"x'^3": "v**3", "x'|x'|": "v * Abs(v)"}.items())[: max(1, size - 1)]:
        peer = ask(ASYMPTOTIC.format(law=law))
        found.append((f"{name}, order 2, asymptotic: {peer.get('said', 'no answer')}", peer["seconds"]))
    return Table("Multiple scales, whole processes", ("what", "seconds", "of the first"), tuple(with_ratios(found)))
