"""What turning points are handed back as: a table of decimals, immutable, whose label is computed from its points.

>>> third = proved_point(1, Fraction(1, 3), None, 4)
>>> TurningPoints("0", "1/3", 4, (third,), "by hand").certified
True
>>> TurningPoints("0", "1/3", 4, (third, TurningPoint(2, "-0.3333", None)), "typed").certified
False
"""

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, field
from fractions import Fraction
from typing import Any

from flint import arb

from asymptotics.errors import AbsentError, InputError, shown
from asymptotics.frames import BARE, STRENGTHS, Frame, frame_of
from asymptotics.law import Oscillator
from asymptotics.numbers.decimals import bits_for, certified_decimal, decimal_of_ball, rational_decimal
from asymptotics.numbers.digits import spread
from asymptotics.numbers.exact import ExactReal
from asymptotics.numbers.precision import TOO_WIDE, TooWideError
from asymptotics.numbers.value import Coefficient, number_of
from asymptotics.present.counts import many
from asymptotics.present.drawn import Drawn
from asymptotics.present.figures import counted
from asymptotics.present.shown import Page, Rows, Shown

Number = Fraction | ExactReal | arb | Callable[[], arb | ExactReal]
"""An exact number, a ball at the current precision, or a function that gives one of these at any precision."""
_SPARE = 40  # bits added to what a rounding lacks, so that the next attempt is the last one
_ENDS = {
    "sticks": "sticks there", "creeps": "creeps from there on", "overdamped": "is overdamped",
    "rotates": "goes over the top and rotates", "escapes": "leaves its well and escapes",
}  # fmt: skip


def _place_in(unit: str) -> str:
    if unit == STRENGTHS:
        return rf"x_n\ \text{{({unit})}}"
    return rf"x_n/\mathrm{{{unit}}}" if unit else "x_n"


def _letters(frame: Frame) -> dict[str, str]:
    if not frame.t:
        time = {r"\tau": "its time omega_0 t since turning point 0"}
        return {"x": f"place of turning point n, in {frame.x or 'units of the start'}"} | time
    return {"x": f"place of turning point n in {frame.x}", "t": f"its time in {frame.t} since turning point 0"}


@dataclass(frozen=True, repr=False)
class TurningPoint(Shown):
    """The n-th turning point: x in the unit of its frame with its sign, the time since n = 0 (None if not asked for).

    Without units x is in units of x0, or in what its frame says, and the time is ``tau`` = omega_0 t; of an oscillator
    x is in m (rad of a pendulum) and the time is ``t`` in s.  ``certified``: its digits are proved to be the correct
    rounding; only `proved_point` says so.
    """

    n: int
    x: str
    time: str | None
    certified: bool = field(default=False, repr=False, compare=False)
    frame: Frame = BARE

    @property
    def tau(self) -> str | None:
        """The time omega_0 t, without units."""
        return self._time("tau")

    @property
    def t(self) -> str | None:
        """The time in s, of an oscillator."""
        return self._time("t")

    def _time(self, name: str) -> str | None:
        if name != self.frame.time:
            units = f"in {self.frame.x} and {self.frame.t}" if self.frame.t else "without units"
            raise AbsentError(name, f"this turning point is {units}", self.frame.time)
        return self.time

    @property
    def unit(self) -> str:
        """The unit of x: m, rad, that of the strengths, or none where it is the start."""
        return self.frame.x

    def number(self, name: str = "x") -> Coefficient:
        """``x``, ``tau`` or ``t`` as a number: mpf, interval, ball; InputError if it is not certified or not there.

        >>> proved_point(1, Fraction(1, 3), None, 4).number("x").interval()
        mpi('0.33325', '0.33335')
        """
        return number_of(self, name)

    def _page(self) -> Page:
        frame, name = self.frame, self.frame.time
        time = () if self.time is None else ((name, frame.with_unit(name, self.time)),)
        place = frame.with_unit("x", self.x)
        worth = "certified: every digit is proved" if self.certified else "not certified"
        title = ", ".join(f"{key} = {value}" for key, value in (("x", place), *time))
        return Page(f"turning point {self.n}: {title}", (worth,), ("", "value"), (("x", place), *time))

    def _formula(self) -> str:
        letter = "t" if self.frame.t else r"\tau"
        time = "" if self.time is None else rf",\quad {letter}_{{{self.n}}} = {self.frame.latex('t', self.time)}"
        return f"x_{{{self.n}}} = {self.frame.latex('x', self.x)}{time}"

    def _letters(self) -> dict[str, str]:
        return _letters(self.frame)


def proved_point(n: int, x: Number, tau: Number | None, digits: int) -> TurningPoint:
    """The point with x and tau correctly rounded; TooWideError where a ball does not decide that."""
    return TurningPoint(n, proved_digits(x, digits), None if tau is None else proved_digits(tau, digits), True)


def proved_digits(value: Number, digits: int) -> str:
    """The number correctly rounded; TooWideError, with the bits that are lacking, where a ball does not decide that."""
    if isinstance(value, Fraction):
        return rational_decimal(value, digits)
    if isinstance(value, ExactReal):
        return certified_decimal(lambda: value, digits)
    if not isinstance(value, arb):
        return certified_decimal(value, digits)
    text = decimal_of_ball(value, digits)
    if text is None:
        # What the next attempt needs beyond this one, told to whoever raises the precision.
        lacking = bits_for(digits, 8) - value.rel_accuracy_bits()
        raise TooWideError(TOO_WIDE, max(digits, _SPARE + max(0, lacking)))
    return text


class Sequenced:
    """A result with ``points`` as a sequence of them: its length, its points one by one, a point or a slice by place.

    >>> third = proved_point(1, Fraction(1, 3), None, 4)
    >>> found = TurningPoints("0", "1/3", 4, (third,), "by hand")
    >>> len(found), [p.x for p in found], found[-1] == third, bool(found[1:])
    (1, ['0.3333'], True, False)
    """

    points: Any

    def __len__(self) -> int:
        return len(self.points)

    def __iter__(self) -> Iterator[Any]:
        return iter(self.points)

    def __getitem__(self, place: int | slice) -> Any:
        """The point at that place, not that of that number n; InputError where there is none."""
        try:
            return self.points[place]
        except (TypeError, ValueError, IndexError):
            accepted = f"an integer from {-len(self)} to {len(self) - 1}, or a slice"
            raise InputError("place", f"{shown(place)} is no place of a point", accepted) from None

    def __bool__(self) -> bool:
        # A result is one also where no point is left of it.
        return True


@dataclass(frozen=True, repr=False)
class TurningPoints(Sequenced, Rows, Drawn):
    """Consecutive turning points; all digits are correctly rounded if ``certified``, which every point must be.

    ``ended``: the number of the last turning point there is and why, or None; ``method``: the route, in words.
    ``first``: for a start in motion, amplitude and time of turning point 0, from where tau counts; x of a route is in
    units of that amplitude, and of a motion in what x0 is in.
    ``oscillator``: whose units they are in, None for a law alone; ``dimensionless``: the points without units that they
    come from, which say how they were obtained.
    """

    alpha: str
    epsilon: str
    digits: int
    points: tuple[TurningPoint, ...]
    method: str
    certified: bool = field(init=False)
    ended: dict[str, Any] | None = None
    first: dict[str, str] | None = None
    notes: tuple[str, ...] = field(default=(), compare=False)
    oscillator: Oscillator | None = None
    dimensionless: "TurningPoints | None" = field(default=None, repr=False)

    def __post_init__(self) -> None:
        object.__setattr__(self, "certified", all(p.certified for p in self.points))

    @property
    def frame(self) -> Frame:
        """The units of x and t."""
        return frame_of(self.oscillator)

    @property
    def unit(self) -> str:
        """The unit of x: m, rad of a pendulum, that of the strengths, or none where it is the start."""
        return self.frame.x

    @property
    def timed(self) -> bool:
        """Whether times were asked for."""
        return any(p.time is not None for p in self.points)

    @property
    def end_text(self) -> str:
        """The last turning point and why, in a line; empty where there is none.

        >>> TurningPoints("0", "1/3", 4, (), "by hand", ended={"n": 3, "reason": "sticks"}).end_text
        'ended: turning point 3 is the last: the motion sticks there'
        """
        if self.ended is None:
            return ""
        last, reason = self.ended["n"], self.ended["reason"]
        where = f"turning point {last} is the last" if last >= 0 else "there is no turning point"
        where += " in the well" if reason in ("rotates", "escapes") else ""
        return f"ended: {where}: the motion {_ENDS[reason]}"

    @property
    def first_text(self) -> str:
        """Amplitude and time of turning point 0 of a start in motion, in a line; empty from rest."""
        line = "turning point 0 has the amplitude {amplitude}, at tau = {tau}"
        return "" if self.first is None else line.format_map(self.first)

    def named_columns(self) -> tuple[list[str], list[tuple[Any, ...]]]:
        """n, x and the time: the names with their units, and the rows."""
        frame = self.frame
        return ["n", frame.named("x"), frame.named(frame.time)], [(p.n, p.x, p.time) for p in self.points]

    def to_dict(self) -> dict[str, Any]:
        """The table as the JSON of the command line: numbers are strings."""
        points = [{"n": p.n, "x": p.x, self.frame.time: p.time} for p in self.points]
        known = {"points": points, "ended": self.ended, "certified": self.certified, "method": self.method}
        if self.oscillator is not None:
            units = {"x": self.unit, "t": self.frame.t}
            return {"oscillator": self.oscillator.to_dict(), "units": units, **known, "notes": list(self.notes)}
        law = {"alpha": self.alpha, "epsilon": self.epsilon, "digits": self.digits}
        return {**law, **known, **({} if self.first is None else {"first": self.first})}

    def __str__(self) -> str:
        if self.oscillator is None:
            return super().__str__()
        frame = self.frame
        lines = [
            f"{p.n}  {frame.with_unit('x', p.x)}" + ("" if p.time is None else f"  {frame.with_unit('t', p.time)}")
            for p in self.points
        ]
        lines += [self.end_text] if self.ended else []
        return "\n".join([*lines, f"certified: {str(self.certified).lower()} ({self.method})"])

    def _page(self) -> Page:
        head, rows = self.named_columns()
        shown = 3 if self.timed else 2
        worth = f"{'certified' if self.certified else 'not certified'}, {self.digits} digits ({self.method})"
        end: tuple[str, ...] = (self.first_text,) if self.first is not None else ()
        end += (self.end_text,) if self.ended is not None else ()
        what = f" of {self.oscillator}" if self.oscillator else f", alpha = {self.alpha}, epsilon = {self.epsilon}"
        title = f"{many(len(rows), 'turning point')}{what}"
        return Page(title, (worth, *end, *self.notes), tuple(head[:shown]), tuple(row[:shown] for row in rows))

    def _heading(self) -> str:
        return super()._heading() if self.oscillator is None else f"turning points of {self.oscillator}"

    def _curve(self, axes: Any, **style: Any) -> None:
        draw_sizes(axes, self.points, f"|x| ({self.unit})" if self.unit else "|x| / x0", style)

    def _table(self) -> dict[str, list[Any]]:
        (_, place, time), rows = self.named_columns()
        columns = {"n": [row[0] for row in rows]} | spread(place, [row[1] for row in rows], certified=self.certified)
        return columns | (spread(time, [row[2] for row in rows], certified=self.certified) if self.timed else {})

    def _letters(self) -> dict[str, str]:
        return _letters(self.frame)

    def _formula(self) -> str:
        rows = r" \\ ".join(f"{p.n} & {p.x}" + ("" if p.time is None else f" & {p.time}") for p in self.points)
        time = r"t_n/\mathrm{s}" if self.frame.t else r"\tau_n"
        head = f"n & {_place_in(self.unit)}"
        head, columns = (f"{head} & {time}", "rll") if self.timed else (head, "rl")
        return rf"\begin{{array}}{{{columns}}} {head} \\ {rows} \end{{array}}"


def draw_sizes(axes: Any, points: Sequence[Any], name: str, style: dict[str, Any]) -> None:
    """|x_n| against n, on a logarithmic scale where none of them is 0."""
    if not points:
        raise InputError("plot", "there is no turning point", "a law that has one")
    sizes = [abs(float(p.x)) for p in points]
    axes.plot([p.n for p in points], sizes, **{"marker": "o", "markersize": 4, "linewidth": 0.8, **style})
    if all(sizes):
        axes.set_yscale("log")
    axes.set(xlabel="turning point n", ylabel=name)
    counted(axes.xaxis)
