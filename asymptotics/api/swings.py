"""Turning points of a law (in units of x0) or of an oscillator (in metres and seconds).

>>> osc = Oscillator({2: "1/10"}, mass="3/2", stiffness=30, x0="1/5")
>>> found = turning_points(osc, 3, digits=12, times=True)
>>> found.points[1].x, found.points[1].t, found.unit
('-0.196506443629', '0.702501924734', 'm')
>>> turning_points({2: 1}, 2, digits=12).points[1].x            # a law alone: units of x0
'-0.410719686061'
"""

from dataclasses import dataclass, replace
from typing import Any

from flint import arb, ctx

from asymptotics.api.units import law_of
from asymptotics.errors import InputError, UndecidedError, require_flag
from asymptotics.law import Law, Oscillator
from asymptotics.numbers.decimals import bits_for, decimal_of_ball
from asymptotics.numbers.exact import ExactReal, square_root
from asymptotics.numbers.policy import exact_integer
from asymptotics.turning import general
from asymptotics.turning.quadratic import MAX_COUNT, MAX_DIGITS, MAX_START, TurningPoints

_GUARDS = (6, 20, 60)


@dataclass(frozen=True)
class SwingPoint:
    """The n-th turning point: x in m with its sign, t in s since n = 0 (None if not asked for)."""

    n: int
    x: str
    t: str | None


@dataclass(frozen=True, repr=False)
class OscillatorTurningPoints:
    """Turning points in SI units; ``dimensionless`` is the result they come from, and says how they were obtained."""

    oscillator: Oscillator
    digits: int
    points: tuple[SwingPoint, ...]
    dimensionless: TurningPoints
    unit: str = "m"

    @property
    def certified(self) -> bool:
        """Whether all digits are proved to be correctly rounded."""
        return self.dimensionless.certified

    @property
    def notes(self) -> tuple[str, ...]:
        """What was read or merged on the way."""
        return self.dimensionless.notes

    @property
    def ended(self) -> dict[str, Any] | None:
        """Where and why the sequence ends, or None."""
        return self.dimensionless.ended

    def to_dict(self) -> dict[str, Any]:
        """JSON-ready: numbers are strings."""
        points = [{"n": p.n, "x": p.x, "t": p.t} for p in self.points]
        rest: dict[str, Any] = {"ended": self.ended, "certified": self.certified, "method": self.dimensionless.method}
        rest |= {"notes": list(self.notes)}
        return {"oscillator": self.oscillator.to_dict(), "units": {"x": "m", "t": "s"}, "points": points, **rest}

    def __str__(self) -> str:
        lines = [f"{p.n}  {p.x} m" + (f"  {p.t} s" if p.t is not None else "") for p in self.points]
        lines += [f"ended: {self.ended}"] if self.ended else []
        return "\n".join([*lines, f"certified: {str(self.certified).lower()} ({self.dimensionless.method})"])

    def __repr__(self) -> str:
        return f"OscillatorTurningPoints({len(self.points)} points of {self.oscillator}, {self.digits} digits)"

    def _repr_latex_(self) -> str:
        timed = any(p.t is not None for p in self.points)
        rows = r" \\ ".join(f"{p.n} & {p.x}" + ("" if p.t is None else f" & {p.t}") for p in self.points)
        head, columns = r"n & x_n/\mathrm{m}", "rl"
        if timed:
            head, columns = head + r" & t_n/\mathrm{s}", "rll"
        return rf"$\begin{{array}}{{{columns}}} {head} \\ {rows} \end{{array}}$"


def turning_points(
    law: Any, count: Any = 10, *, digits: Any = 30, start: Any = 0, times: bool = False
) -> TurningPoints | OscillatorTurningPoints:
    """Turning points n = start ... start + count - 1, as far as they exist.

    A law or mapping (epsilons) starts at rest and is answered in units of x0 and tau; an oscillator in m and s, and
    with v0 != 0 its n = 0 is the first turning point after the start, where t counts from.  InputError for anti-damping
    and values out of range, LimitError with the estimate, UndecidedError.
    """
    sizes = (
        exact_integer(count, "count", 1, MAX_COUNT),
        exact_integer(digits, "digits", 1, MAX_DIGITS),
        exact_integer(start, "start", 0, MAX_START),
    )
    require_flag(times, "times")
    if not isinstance(law, Oscillator):
        return _computed(law_of(law), *sizes, times)
    for guard in _GUARDS:
        found = _computed(law.dimensionless, sizes[0], sizes[1] + guard, sizes[2], times, **_kick(law))
        points = _in_si(law, found, sizes[1])
        if points is not None:
            return OscillatorTurningPoints(law, sizes[1], points, found)
    raise UndecidedError(f"{sizes[1]} digits in SI units: a value lies too near a tie between two decimals")


def _computed(law: Law, count: int, digits: int, start: int, times: bool, **kick: Any) -> TurningPoints:
    return replace(general.turning_points(law, count, digits, start=start, times=times, **kick), notes=law.notes)


def _kick(oscillator: Oscillator) -> dict[str, ExactReal]:
    """The start (X, X') in units of sqrt(x0^2 + m v0^2/k); nothing for a start at rest."""
    x0, v0 = oscillator.x0, oscillator.v0
    if v0.is_zero:
        return {}
    try:
        ratio = oscillator.mass / oscillator.stiffness
        square = (x0 * x0 + ratio * v0 * v0).rational
        return {"x0": x0 / square_root(square), "v0": v0 * square_root(ratio.rational / square)}
    except ValueError:
        raise InputError("v0", "the unit of length is not a single root", "rational mass, stiffness, x0, v0") from None


def _in_si(oscillator: Oscillator, found: TurningPoints, digits: int) -> tuple[SwingPoint, ...] | None:
    """The points in m and s; None if the digits known do not decide the rounding."""
    with ctx.workprec(bits_for(found.digits, 64)):
        omega = oscillator.omega_0()
        length = oscillator.x0.ball() if found.first is None else oscillator.length() * _ball(found.first["amplitude"])
        points = []
        for p in found.points:
            exactly = p.n == 0  # the unit itself, with its sign
            x = decimal_of_ball((arb(-1 if p.x.startswith("-") else 1) if exactly else _ball(p.x)) * length, digits)
            t = None if p.tau is None else "0" if p.n == 0 else decimal_of_ball(_ball(p.tau) / omega, digits)
            if x is None or (t is None and p.tau is not None):
                return None
            points.append(SwingPoint(p.n, x, t))
    return tuple(points)


def _ball(text: str) -> arb:
    """What correctly rounded digits say: the decimal, half a unit of its last place to either side."""
    mantissa, _, exponent = text.lower().partition("e")
    unit = arb(10) ** (int(exponent or 0) - len(mantissa.partition(".")[2]))
    return arb(text) + arb(0, (unit / 2).upper())
