"""The certified values beside which somebody's values are held, in the units of the file.

Whether they are certified is what the routes themselves say: one value that is not makes the comparison say so.

>>> from asymptotics.law import Oscillator
>>> values = at_turning_points(Given(Oscillator({2: 1})), [0, 1], 10, {"x", "tau"})
>>> values.columns["x"], values.columns["tau"], values.certified
(['1.000000000', '-0.4107196861'], ['0', '3.380971060'], True)
"""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from typing import Any

from flint import arb

from asymptotics.certificates.known import unit_start
from asymptotics.envelopes.first_order import FirstOrderEnvelope
from asymptotics.errors import InputError, UndecidedError
from asymptotics.flow.dense import State
from asymptotics.law import Oscillator
from asymptotics.law_given import Given
from asymptotics.motions.point import MotionPoint
from asymptotics.motions.reference import reference_motion, reference_states
from asymptotics.numbers.context import ctx
from asymptotics.numbers.decimals import bits_for, decimal_of_ball
from asymptotics.numbers.digits import ball_of
from asymptotics.numbers.exact import ExactReal
from asymptotics.running.cut_short import changed, keeping
from asymptotics.turning.choose import turning_points
from asymptotics.turning.result import TurningPoints

_GUARDS = (4, 20, 60)  # digits that a change of units may cost; more where a value is nearly halfway between decimals
_GAP = 1000  # turning points between two that are asked for, beyond which they are asked for separately


@dataclass(frozen=True)
class Truth:
    """Columns of values in decimals, None where there is no such point, and where they come from.

    ``speeds``: of a motion, v in doubles, for judging errors.  ``places``: which of the rows that were asked for these
    are, where the work was cut short; None for all of them.
    """

    columns: dict[str, list[str | None]]
    certified: bool
    method: str
    ended: str = ""
    speeds: tuple[float, ...] = ()
    places: tuple[int, ...] | None = None


def of_its_law(given: Given) -> Oscillator:
    """The oscillator in its units; without any, that of its law alone."""
    return given.oscillator if given.frame else Oscillator(given.oscillator.law)


def at_turning_points(given: Given, numbers: Sequence[int], digits: int, wanted: set[str]) -> Truth:
    """x, tau, t and amplitude at turning points, in the frame of what is given."""
    oscillator = given.oscillator
    if not given.frame:
        return _at_turning_points(oscillator, numbers, digits, wanted, _unchanged)
    reason = None
    for guard in _GUARDS:
        # A decimal stands for all numbers that round to it: in SI its rounding may be undecided, and more digits are
        # asked for.
        try:
            with ctx.workprec(bits_for(digits + guard, 32)):
                # The precision is set before x0 and omega_0 become balls.
                units = _Units(_length(oscillator, digits + guard), oscillator.omega_0(), digits, ctx.prec)
                return _at_turning_points(oscillator, numbers, digits + guard, wanted, units.changed)
        except UndecidedError as undecided:
            reason = undecided
    raise UndecidedError(f"a value in SI is not decided to {digits} digits: {reason}")


def _kick(oscillator: Oscillator) -> dict[str, Any]:
    """The start in units of its radius, for one in motion."""
    return {} if oscillator.v0.is_zero else dict(zip(("x0", "v0"), unit_start(oscillator)))


def _length(oscillator: Oscillator, digits: int) -> arb:
    """The unit of places, with the sign of point 0: the start at rest, or the amplitude of turning point 0."""
    if oscillator.v0.is_zero:
        return oscillator.x0.ball()
    first = turning_points(oscillator.dimensionless, 1, digits + 8, **_kick(oscillator)).first
    # A motion that never turns has no point to be measured.
    return oscillator.length() * (arb(1) if first is None else ball_of(first["amplitude"]))


def _at_turning_points(
    oscillator: Oscillator, numbers: Sequence[int], digits: int, wanted: set[str], change: Callable[[str, str], str]
) -> Truth:
    """The tables of the stretches; an error carries the rows of those that are done, and of the last so far."""
    made: list[TurningPoints] = []

    def so_far(last: TurningPoints | None = None) -> Truth | None:
        tables = made if last is None else [*made, last]
        there = {point.n for table in tables for point in table.points}
        places = tuple(i for i, n in enumerate(numbers) if n in there)
        if not places:
            return None
        return replace(_from_tables(tables, [numbers[i] for i in places], wanted, change), places=places)

    with changed(so_far, otherwise=so_far):
        # Points far apart are asked for in stretches: the table of all between them may have 10^30 rows.
        for first, last in _runs(sorted(set(numbers))):
            times = bool(wanted & {"tau", "t"})
            law, kick = oscillator.dimensionless, _kick(oscillator)
            made.append(turning_points(law, last - first + 1, digits, start=first, times=times, **kick))
    return _from_tables(made, numbers, wanted, change)


def _from_tables(
    tables: Sequence[TurningPoints], numbers: Sequence[int], wanted: set[str], change: Callable[[str, str], str]
) -> Truth:
    found = {point.n: (point.x, point.tau) for table in tables for point in table.points}
    columns: dict[str, list[str | None]] = {}
    for name in wanted:
        place = int(name in ("tau", "t"))
        texts = [found[n][place] if n in found else None for n in numbers]
        columns[name] = [None if text is None else change(name, text) for text in texts]
    ends = [f"turning point {t.ended['n']} is the last: {t.ended['reason']}" for t in tables if t.ended]
    method = "; ".join(dict.fromkeys(table.method for table in tables))
    # One table that is an estimate makes the whole comparison one.
    return Truth(columns, all(table.certified for table in tables), method, ends[-1] if ends else "")


def _unchanged(name: str, text: str) -> str:
    return text.lstrip("-") if name == "amplitude" else text


def at_times(given: Given, times: Sequence[Fraction], digits: int, wanted: Sequence[str]) -> Truth:
    """What is ``wanted`` of x and v at times, t in s in a frame with units and else tau."""
    for t in times:
        if t < 0:
            raise InputError("FILE", f"the time {t} is before the start", "times >= 0")
    # The printed times are exact numbers; as doubles they would be other times.
    moved, exact = of_its_law(given), [ExactReal(t) for t in times]
    made = _Moments(tuple(wanted), digits)
    left = list(range(len(times)))
    for guard in _GUARDS:  # a value next to a zero, or next to a tie, asks for more

        def so_far(found: Mapping[int, State], left: Sequence[int] = tuple(left)) -> Truth | None:
            for place, state in found.items():
                made.add(left[place], *state)
            return made.done()

        with changed(so_far, otherwise=made.done):
            states = reference_states(moved, [exact[i] for i in left], digits + guard)
        made.methods = made.methods or {f"half-swing by half-swing, balls of {states.bits} bits": None}
        for i, x, v in zip(left, states.x, states.v):
            made.add(i, x, v)
        # Balls good to 10^-digits of the first amplitude: near a zero they have fewer digits of the value, and only
        # those places are asked again.
        placed = made.places()
        left = [i for i in left if i not in placed]
        if not left:
            break
    # The last resort, one time after the other, at whatever precision it takes.
    for i in left:
        with changed(lambda _: made.done(), otherwise=made.done):
            made.take(i, reference_motion(moved, exact[i], digits))
    return replace(made.truth(range(len(times))), places=None)


class _Moments:
    """What is ``wanted`` of x and v at the times that are done, by their places."""

    def __init__(self, wanted: tuple[str, ...], digits: int) -> None:
        self.digits, self.certified = digits, True
        self.methods: dict[str, None] = {}  # each once, in the order of their use
        self.texts: dict[str, dict[int, str]] = {name: {} for name in wanted}
        self.speeds: dict[int, float] = {}

    def add(self, place: int, x: arb, v: arb) -> None:
        """From balls: a column whose ball is too wide for its digits is not there yet."""
        self.speeds[place] = float(v.mid())
        for name, column in self.texts.items():
            ball = x if name == "x" else v
            # Exactly 0, such as v at the start from rest; a ball that only holds 0 has no digits, and gives None.
            text = "0" if ball == 0 else decimal_of_ball(ball, self.digits)
            if text is not None:
                column[place] = text

    def take(self, place: int, point: MotionPoint) -> None:
        """From a motion at one time, which says itself whether it is certified."""
        for name, column in self.texts.items():
            column[place] = point.x if name == "x" else point.v
        self.certified = self.certified and point.certified
        self.methods[point.method] = None

    def places(self) -> set[int]:
        """Where every column has its value."""
        # A row counts where all that is wanted of it is decided.
        return set.intersection(*(set(column) for column in self.texts.values()))

    def done(self) -> Truth | None:
        """The rows that are there, None without any."""
        places = sorted(self.places())
        return self.truth(places) if places else None

    def truth(self, places: Sequence[int]) -> Truth:
        """The rows at these places."""
        columns: dict[str, list[str | None]] = {name: [c[i] for i in places] for name, c in self.texts.items()}
        method = "; ".join(self.methods) or "half-swing by half-swing"
        speeds = tuple(self.speeds[i] for i in places)
        return Truth(columns, self.certified, method, speeds=speeds, places=tuple(places))


def at_envelope(given: Given, times: Sequence[Fraction], digits: int, wanted: Sequence[str]) -> Truth:
    """A and phi of the averaged law, of first order, at times.

    >>> from asymptotics.law import Oscillator
    >>> at_envelope(Given(Oscillator({2: "1/10"})), [Fraction(2)], 8, ["amplitude", "phase"]).columns
    {'amplitude': ['0.92175869'], 'phase': ['-0.0030725290']}
    """
    envelope = FirstOrderEnvelope(of_its_law(given))
    found = {"amplitude": envelope.amplitude, "phase": envelope.phase}
    exact = [ExactReal(t) for t in times]
    rows: list[list[str]] = []

    def truth() -> Truth:
        columns: dict[str, list[str | None]] = {name: [row[i] for row in rows] for i, name in enumerate(wanted)}
        return Truth(columns, True, "the averaged law of first order (not the motion)")

    with keeping(lambda: replace(truth(), places=tuple(range(len(rows)))) if rows else None):
        for t in exact:
            rows.append([found[name](t, digits) for name in wanted])
    return truth()


@dataclass(frozen=True)
class _Units:
    """The unit of length with the sign of the start, omega_0, the digits wanted in SI, and the bits to work with."""

    length: arb
    omega: arb
    digits: int
    bits: int

    def changed(self, name: str, text: str) -> str:
        """A decimal in SI, correctly rounded; UndecidedError if the dimensionless one has too few digits for that."""
        with ctx.workprec(self.bits):
            # All numbers that round to the decimal: half a unit of its last digit either way, so that the result holds
            # the truth.
            value = ball_of(text)
            if name in ("x", "amplitude"):
                value *= self.length
            elif name == "t":
                value /= self.omega
        # None unless all numbers of the ball have one rounding.
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
