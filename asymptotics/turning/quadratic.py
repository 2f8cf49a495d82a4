"""Certified tables of turning points for alpha = 2: amplitudes and times, from any starting index.

>>> from asymptotics.numbers import parse_real
>>> table = quadratic_turning_points(parse_real("1", "--epsilon"), count=3, digits=20, times=True)
>>> for point in table.points:
...     print(point.n, point.x, point.tau)
0 1.0000000000000000000 0
1 -0.41071968606103944670 3.3809710603589252128
2 0.26356838641759692059 6.5808870083860533294
>>> quadratic_turning_points(parse_real("1", "--epsilon"), count=1, digits=20, start=10**9).points[0].x
'7.4999999933950386713e-10'
"""

from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from fractions import Fraction
from itertools import islice
from math import ceil, log2
from typing import Any

from flint import arb, ctx

from asymptotics.costs import map_seconds, require_affordable
from asymptotics.errors import InputError, LimitError
from asymptotics.numbers.decimals import BITS_PER_DIGIT, MAX_BITS, bits_for, decimal_of_ball
from asymptotics.numbers.exact import ExactReal, require_integer
from asymptotics.numbers.precision import at_growing_precision
from asymptotics.turning.quadratic_abel import quadratic_abel
from asymptotics.turning.quadratic_duration import duration, node_count
from asymptotics.turning.quadratic_map import amplitudes, next_amplitude

MAX_COUNT, MAX_DIGITS, MAX_START = 100_000, 10_000, 10**30
MAX_JUMP_DIGITS = 1_000  # the exact coefficients of the Abel function cost about digits^4
MAX_SECONDS = 600
_DIRECT = 20_000  # up to this index it is cheaper to iterate than to set up the Abel function
_SMALLEST, _LARGEST = Fraction(1, 10**12), Fraction(10**12)

Progress = Callable[[int], None]


@dataclass(frozen=True)
class TurningPoint:
    """The n-th turning point: x in units of x0 with its sign, tau = omega_0 t since n = 0 (None if not asked for)."""

    n: int
    x: str
    tau: str | None


@dataclass(frozen=True)
class TurningPoints:
    """Consecutive turning points; all digits are correctly rounded if ``certified``.

    ``first``: for a start in motion, amplitude and time of turning point 0, in units of x0 and of 1/omega_0; then x is
    in units of that amplitude, and tau counts from there.
    """

    alpha: str
    epsilon: str
    digits: int
    points: tuple[TurningPoint, ...]
    method: str
    certified: bool = True
    ended: dict[str, Any] | None = None
    first: dict[str, str] | None = None
    notes: tuple[str, ...] = field(default=(), compare=False)

    def to_dict(self) -> dict[str, Any]:
        """The table as the JSON of the command line."""
        points = [{"n": p.n, "x": p.x, "tau": p.tau} for p in self.points]
        return {
            "alpha": self.alpha,
            "epsilon": self.epsilon,
            "digits": self.digits,
            "points": points,
            "ended": self.ended,
            "certified": self.certified,
            "method": self.method,
            **({} if self.first is None else {"first": self.first}),
        }

    def _repr_latex_(self) -> str:
        timed = any(p.tau is not None for p in self.points)
        rows = r" \\ ".join(f"{p.n} & {p.x}" + ("" if p.tau is None else f" & {p.tau}") for p in self.points)
        head, columns = (r"n & x_n & \tau_n", "rll") if timed else ("n & x_n", "rl")
        return rf"$\begin{{array}}{{{columns}}} {head} \\ {rows} \end{{array}}$"


def quadratic_turning_points(
    epsilon: ExactReal,
    count: int,
    digits: int = 30,
    *,
    start: int = 0,
    times: bool = False,
    progress: Progress = lambda done: None,
) -> TurningPoints:
    """Turning points n = start ... start + count - 1 for X'' + X + epsilon X'|X'| = 0, X(0) = 1, X'(0) = 0.

    ``epsilon`` = b x0 / m is Smith's u_0.  ``progress`` is called with the number of points finished.
    Raises InputError for an epsilon outside [10^-12, 10^12], LimitError for more work than the stated limits.
    """
    _check(epsilon, count, digits, start, times)
    bits = bits_for(digits, 48) + 2 * (start + count).bit_length() + _magnitude(epsilon)

    def attempt(bits: int) -> TurningPoints | None:
        points = _decimals(islice(_balls(epsilon, start, times), count), times, digits, progress)
        method = "iterated map" if start <= _DIRECT else "Abel function"
        method = f"{method}, balls of {bits} bits"
        return None if points is None else TurningPoints("2", str(epsilon), digits, points, method)

    return at_growing_precision(attempt, digits, bits, max_bits=MAX_BITS)


def _balls(epsilon: ExactReal, start: int, times: bool) -> Iterator[tuple[int, arb, arb]]:
    """Yield (n, p_n / p_0, tau_n) from n = start on; tau is 0 throughout unless it is asked for."""
    p0 = 2 * epsilon.ball()
    n, p, tau = (0, p0, arb(0)) if start <= _DIRECT else _jump(p0, start, times)
    while True:
        if n >= start:
            yield n, p / p0, tau
        q = next_amplitude(p)
        if times:
            tau += duration(p, q)
        n, p = n + 1, q


def _jump(p0: arb, start: int, times: bool) -> tuple[int, arb, arb]:
    """The turning point ``start`` through the Abel function, from a certified head of the orbit."""
    digits = int(ctx.prec / BITS_PER_DIGIT)
    head = list(islice(amplitudes(p0), min(7 * digits + 200, start)))
    abel = quadratic_abel(terms=12 + digits * 2 // 9)
    p = 2 * abel.advance(head[-1] / 2, start - len(head) + 1)
    if not times:
        return start, p, arb(0)
    tau = sum((duration(a, b) for a, b in zip(head, head[1:])), arb(0))
    return start, p, tau + abel.time_between(head[-1] / 2, p / 2)


def _decimals(
    balls: Iterator[tuple[int, arb, arb]], times: bool, digits: int, progress: Progress
) -> tuple[TurningPoint, ...] | None:
    """The points in decimals, or None as soon as one cannot be rounded."""
    points = []
    for n, ratio, tau in balls:
        x = decimal_of_ball(-ratio if n % 2 else ratio, digits)
        t = decimal_of_ball(tau, digits)
        if x is None or t is None:
            return None
        points.append(TurningPoint(n, x, t if times else None))
        progress(len(points))
    return tuple(points)


def _magnitude(epsilon: ExactReal) -> int:
    """|log2 epsilon|, rounded up: the bits that small amplitudes and long first half-swings cost."""
    with ctx.workprec(53):
        return ceil(abs(log2(float(epsilon.ball().mid())))) + 1


def quadratic_serves(epsilon: ExactReal) -> bool:
    """Whether the strength is in the range of the Lambert W map's tables."""
    return not (epsilon < _SMALLEST or epsilon > _LARGEST)


def require_counts(count: int, digits: int, start: int) -> None:
    """InputError unless count, digits and start are integers in range: the same for every law."""
    require_integer(count, "count", 1, MAX_COUNT)
    require_integer(digits, "digits", 1, MAX_DIGITS)
    require_integer(start, "start", 0, MAX_START)


def _check(epsilon: ExactReal, count: int, digits: int, start: int, times: bool) -> None:
    if not quadratic_serves(epsilon):
        raise InputError("epsilon", f"{epsilon} is out of range", "a real number from 1e-12 to 1e12")
    require_counts(count, digits, start)
    if start > _DIRECT and digits > MAX_JUMP_DIGITS:
        reason = f"{digits} digits are too many for a start beyond {_DIRECT}"
        raise LimitError("digits", reason, f"at most {MAX_JUMP_DIGITS} digits there")
    seconds = estimated_seconds(epsilon, count, digits, start, times)
    work = f"{count} points with {digits} digits"
    require_affordable(seconds, MAX_SECONDS, "count", work, ": fewer points, fewer digits or no times")


def estimated_seconds(epsilon: ExactReal, count: int, digits: int, start: int, times: bool) -> float:
    """The expected running time."""
    steps = count + (start if start <= _DIRECT else 7 * digits + 200)
    with ctx.workprec(53):
        first = node_count(2 * float(epsilon.ball().mid()) + 1, bits_for(digits)) if times else 0
    return map_seconds(steps, digits, first, times=times)
