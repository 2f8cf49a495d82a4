"""Turning points by the certified map beside integrators: seconds, and how many digits of the amplitudes are right.

x'' + x + (1/10) x'|x'|^(alpha - 1) = 0 from rest at 1.  The integrators get the best treatment: heyoka stops at each
zero of v and turns the sign of the law by hand (a plain |v| costs it digits without a warning), SciPy has an event and
mpmath starts afresh at each turning point.  At a turning point of alpha = 3/2 the motion has no Taylor series: heyoka
cannot start there and is said to have failed.  None of them knows its own error: the last column is measured, ours
proved.
"""

from math import isfinite
from typing import Any

import mpmath

from asymptotics.law import Law
from asymptotics.numbers.decimal_context import workdps
from asymptotics.turning.choose import turning_points
from benchmarks.peers import ask
from benchmarks.table import Table, best_time, seconds_text

PEERS = ("heyoka", "scipy", "mpmath")
DIGITS, FULL = 30, 1000
LAWS = {"2": 2, "3": 3, "3/2": 1.5}

HEYOKA = """
import heyoka, numpy
fp = {"double": float, "80 bits": numpy.longdouble}[kind]
x, v = heyoka.make_vars("x", "v")
sign = heyoka.par[0]
speed = -sign * v
power = speed**2 if alpha == 2 else speed * speed**2 if alpha == 3 else speed * heyoka.sqrt(speed)
class Turn:
    def __call__(self, ta, _):
        found.append(ta.state[0])
        ta.pars[0] = -ta.pars[0]
        return True
    def __deepcopy__(self, memo):
        return self
def integrate():
    found.clear()
    event = heyoka.t_event(v, fp_type=fp, callback=Turn())
    motion = [(x, v), (v, -x + sign * (fp(1) / fp(10)) * power)]
    ta = heyoka.taylor_adaptive(motion, [fp(1), fp(0)], fp_type=fp, pars=[fp(-1)], t_events=[event])
    start = process_time()  # the compiled integrator is reused by its users: compiling is not timed
    while len(found) <= count:
        outcome = ta.step()[0]
        if "err" in str(outcome):
            raise SystemExit(1)
    return process_time() - start
found = []
seconds = min(integrate() for _ in range(3))
answer = {"seconds": seconds, "values": [str(abs(f)) for f in found[1:]]}
"""
SCIPY = """
from scipy.integrate import solve_ivp
def event(t, y):
    return y[1]
event.terminal = False
def integrate():
    found, x, t = [], 1.0, 0.0
    sign = 1.0
    while len(found) < count:
        right = lambda t, y: (y[1], -y[0] + sign * 0.1 * max(0.0, -sign * y[1]) ** alpha)
        step = solve_ivp(right, (0, 4), (x, 0.0), method="DOP853", rtol=2.3e-14, atol=1e-15, events=event)
        x = [y[0] for s, y in zip(step.t_events[0], step.y_events[0]) if s > 1][0]
        x = float(x); found.append(repr(abs(x))); sign = -sign
    return found
seconds, found = best(integrate, 1)
answer = {"seconds": seconds, "values": found}
"""
MPMATH = """
import mpmath
mpmath.mp.dps = digits
def swing(p):
    f = mpmath.odefun(lambda t, y: [y[1], -y[0] + mpmath.mpf(1) / 10 * abs(y[1]) ** alpha], 0, [p, mpmath.mpf(0)])
    t = mpmath.findroot(lambda t: f(t)[1], 3.2)
    return -f(t)[0]
def integrate():
    found = [mpmath.mpf(1)]
    for _ in range(count):
        found.append(swing(found[-1]))
    return found[1:]
seconds, found = best(integrate, 1)
answer = {"seconds": seconds * of / count, "values": [mpmath.nstr(p, digits) for p in found]}
"""


def certified(alpha: str, count: int) -> list[str]:
    """|x_1|, ..., |x_count|, all digits proved."""
    found = turning_points(Law({alpha: "1/10"}), count, DIGITS, start=1)
    return [point.x.lstrip("-") for point in found.points]


def right_digits(values: list[str], truth: list[str]) -> float:
    """-log10 of the worst relative error.

    >>> right_digits(["1.001"], ["1.000"])
    3.0
    """
    with workdps(2 * DIGITS):
        errors = [abs(mpmath.mpf(a) / mpmath.mpf(b) - 1) for a, b in zip(values, truth)]
        worst = max(errors)
        return float(DIGITS if worst == 0 else -mpmath.log10(worst))


def run(size: int = 1000) -> Table:
    """``size`` turning points of three laws: seconds, ratio to the certified map, digits right at the worst point."""
    rows: list[tuple[str, ...]] = []
    for alpha, number in LAWS.items():
        truth = certified(alpha, size)
        first = best_time(lambda alpha=alpha: certified(alpha, size), 1)
        rows.append((f"alpha = {alpha}, certified", seconds_text(first), "1.0", f"{DIGITS} (proved)"))
        exact = {"count": 2 if size >= FULL else 1, "of": size, "digits": DIGITS}
        peers: dict[str, tuple[str, dict[str, Any]]] = {
            "heyoka, double": (HEYOKA, {"count": size, "kind": "double"}),
            "heyoka, 80 bits": (HEYOKA, {"count": size, "kind": "80 bits"}),
            "SciPy DOP853": (SCIPY, {"count": size}),
            f"mpmath.odefun, {DIGITS} digits": (MPMATH, exact),
        }
        for name, (code, arguments) in peers.items():
            answer = ask(code, alpha=number, **arguments)
            rows.append(_row(f"alpha = {alpha}, {name}", answer, first, truth))
    title = f"{size} turning points, epsilon = 1/10 (mpmath: scaled up from two, or one)"
    return Table(title, ("what", "seconds", "ratio", "digits right"), tuple(rows))


def _row(label: str, answer: dict[str, Any], first: float, truth: list[str]) -> tuple[str, ...]:
    seconds, values = answer["seconds"], answer.get("values")
    if not isinstance(seconds, float) or not isfinite(seconds) or not isinstance(values, list):
        return (label, seconds_text(seconds if isinstance(seconds, float) else None), "-", "-")
    return (label, seconds_text(seconds), f"{seconds / first:.2g}", f"{right_digits(values, truth):.1f}")
