"""The certified values beside which somebody's values are held, in the units of the file.

Whether they are certified is what the routes themselves say: one value that is not makes the comparison say so.

>>> from asymptotics.law import Oscillator
>>> values = at_turning_points(Oscillator({2: 1}), [0, 1], 10, {"x", "tau"}, si=False)
>>> values.columns["x"], values.columns["tau"], values.certified
(['1.000000000', '-0.4107196861'], ['0', '3.380971060'], True)
"""

from collections.abc import Callable, Sequence
from contextlib import suppress
from dataclasses import dataclass
from fractions import Fraction

from flint import arb

from asymptotics.envelopes.first_order import FirstOrderEnvelope
from asymptotics.errors import InputError, UndecidedError
from asymptotics.law import Oscillator
from asymptotics.motions.reference import reference_motion, reference_states
from asymptotics.numbers.context import ctx
from asymptotics.numbers.decimals import bits_for, decimal_of_ball
from asymptotics.numbers.digits import ball_of
from asymptotics.numbers.exact import ExactReal
from asymptotics.turning.choose import turning_points

_GUARDS = (4, 20, 60)  # digits that a change of units may cost; more where a value is nearly halfway between decimals
_GAP = 1000  # turning points between two that are asked for, beyond which they are asked for separately


@dataclass(frozen=True)
class Truth:
    """Columns of values in decimals, None where there is no such point, and where they come from.

    ``speeds``: of a motion, v in doubles, for judging errors.
    """

    columns: dict[str, list[str | None]]
    certified: bool
    method: str
    ended: str = ""
    speeds: tuple[float, ...] = ()


def at_turning_points(
    oscillator: Oscillator, numbers: Sequence[int], digits: int, wanted: set[str], *, si: bool
) -> Truth:
    """x, tau, t and amplitude at turning points; the units of ``oscillator`` if ``si``."""
    if not si:
        return _at_turning_points(oscillator, numbers, digits, wanted, _unchanged)
    for guard in _GUARDS:
        with suppress(UndecidedError), ctx.workprec(bits_for(digits + guard, 32)):
            units = _Units(oscillator.x0.ball(), oscillator.omega_0(), digits)
            return _at_turning_points(oscillator, numbers, digits + guard, wanted, units.changed)
    raise UndecidedError(f"a value in SI is too near to a tie of {digits} digits")


def _at_turning_points(
    oscillator: Oscillator, numbers: Sequence[int], digits: int, wanted: set[str], change: Callable[[str, str], str]
) -> Truth:
    found: dict[int, tuple[str, str | None]] = {}
    certified, methods, ended, law = True, [], "", oscillator.dimensionless
    for first, last in _runs(sorted(set(numbers))):
        table = turning_points(law, last - first + 1, digits, start=first, times=bool(wanted & {"tau", "t"}))
        found |= {point.n: (point.x, point.tau) for point in table.points}
        certified = certified and table.certified
        methods.append(table.method)
        if table.ended:
            ended = f"turning point {table.ended['n']} is the last: {table.ended['reason']}"
    columns: dict[str, list[str | None]] = {}
    for name in wanted:
        place = int(name in ("tau", "t"))
        texts = [found[n][place] if n in found else None for n in numbers]
        columns[name] = [None if text is None else change(name, text) for text in texts]
    return Truth(columns, certified, "; ".join(dict.fromkeys(methods)), ended)


def _unchanged(name: str, text: str) -> str:
    return text.lstrip("-") if name == "amplitude" else text


def at_times(
    oscillator: Oscillator, times: Sequence[Fraction], digits: int, wanted: Sequence[str], *, si: bool
) -> Truth:
    """What is ``wanted`` of x and v at times, t in s if ``si`` and else tau."""
    for t in times:
        if t < 0:
            raise InputError("FILE", f"the time {t} is before the start", "times >= 0")
    moved, exact = (oscillator if si else Oscillator(oscillator.law)), [ExactReal(t) for t in times]
    method, texts, speeds = "", {name: dict[int, str]() for name in wanted}, dict[int, float]()
    left = list(range(len(times)))
    for guard in _GUARDS:  # a value next to a zero, or next to a tie, asks for more
        states = reference_states(moved, [exact[i] for i in left], digits + guard)
        method = method or f"half-swing by half-swing, balls of {states.bits} bits"
        for i, x, v in zip(left, states.x, states.v):
            speeds[i] = float(v.mid())
            for name, column in texts.items():
                ball = x if name == "x" else v
                text = "0" if ball == 0 else decimal_of_ball(ball, digits)
                if text is not None:
                    column[i] = text
        left = [i for i in left if any(i not in column for column in texts.values())]
        if not left:
            break
    certified = not left
    for i in left:
        point = reference_motion(moved, exact[i], digits)
        for name, column in texts.items():
            column[i] = point.x if name == "x" else point.v
        certified, method = point.certified, f"{method}; {point.method}"
    places = range(len(times))
    columns: dict[str, list[str | None]] = {name: [column[i] for i in places] for name, column in texts.items()}
    return Truth(columns, certified, method, speeds=tuple(speeds[i] for i in places))


def at_envelope(
    oscillator: Oscillator, times: Sequence[Fraction], digits: int, wanted: Sequence[str], *, si: bool
) -> Truth:
    """A and phi of the averaged law, of first order, at times.

    >>> from asymptotics.law import Oscillator
    >>> at_envelope(Oscillator({2: "1/10"}), [Fraction(2)], 8, ["amplitude", "phase"], si=False).columns
    {'amplitude': ['0.92175869'], 'phase': ['-0.0030725290']}
    """
    envelope = FirstOrderEnvelope(oscillator if si else Oscillator(oscillator.law))
    found = {"amplitude": envelope.amplitude, "phase": envelope.phase}
    exact = [ExactReal(t) for t in times]
    columns: dict[str, list[str | None]] = {name: [found[name](t, digits) for t in exact] for name in wanted}
    return Truth(columns, True, "the averaged law of first order (not the motion)")


@dataclass(frozen=True)
class _Units:
    """The unit of length with the sign of the start, omega_0, and the digits wanted in SI."""

    length: arb
    omega: arb
    digits: int

    def changed(self, name: str, text: str) -> str:
        """A decimal in SI, correctly rounded; UndecidedError if the dimensionless one has too few digits for that."""
        value = ball_of(text)
        if name in ("x", "amplitude"):
            value *= self.length
        elif name == "t":
            value /= self.omega
        found = decimal_of_ball(abs(value) if name == "amplitude" else value, self.digits)
        if found is None and value != 0:
            raise UndecidedError(f"{name} has no certified {self.digits} digits")
        return found or "0"


def _runs(numbers: list[int]) -> list[tuple[int, int]]:
    """The numbers in stretches without large gaps, as (first, last)."""
    runs: list[tuple[int, int]] = []
    for n in numbers:
        if runs and n - runs[-1][1] <= _GAP:
            runs[-1] = (runs[-1][0], n)
        else:
            runs.append((n, n))
    return runs
