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

from asymptotics.errors import InputError, shown
from asymptotics.numbers.decimals import bits_for, certified_decimal, decimal_of_ball, rational_decimal
from asymptotics.numbers.digits import spread
from asymptotics.numbers.exact import ExactReal
from asymptotics.numbers.precision import TOO_WIDE, TooWideError
from asymptotics.numbers.value import Coefficient, number_of
from asymptotics.present.drawn import Drawn
from asymptotics.present.figures import counted
from asymptotics.present.shown import Page, Rows, Shown

Number = Fraction | ExactReal | arb | Callable[[], arb | ExactReal]
"""An exact number, a ball at the current precision, or a function that gives one of these at any precision."""
_LETTERS = {
    "x": "place of turning point n, in units of the start",
    r"\tau": "its time omega_0 t since turning point 0",
}
_SPARE = 40  # bits added to what a rounding lacks, so that the next attempt is the last one


@dataclass(frozen=True, repr=False)
class TurningPoint(Shown):
    """The n-th turning point: x in units of x0 with its sign, tau = omega_0 t since n = 0 (None if not asked for).

    ``certified``: its digits are proved to be the correct rounding; only `proved_point` says so.
    """

    n: int
    x: str
    tau: str | None
    certified: bool = field(default=False, repr=False, compare=False)

    def number(self, name: str = "x") -> Coefficient:
        """``x`` or ``tau`` as a number: mpf, interval, ball; InputError if it is not certified or not there.

        >>> proved_point(1, Fraction(1, 3), None, 4).number("x").interval()
        mpi('0.33325', '0.33335')
        """
        return number_of(self, name)

    def _page(self) -> Page:
        time = () if self.tau is None else (("tau", self.tau),)
        worth = "certified: every digit is proved" if self.certified else "not certified"
        title = f"turning point {self.n}: x = {self.x}" + ("" if self.tau is None else f", tau = {self.tau}")
        return Page(title, (worth,), ("", "value"), (("x", self.x), *time))

    def _formula(self) -> str:
        time = "" if self.tau is None else rf",\quad \tau_{{{self.n}}} = {self.tau}"
        return f"x_{{{self.n}}} = {self.x}{time}"

    def _letters(self) -> dict[str, str]:
        return _LETTERS


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
    ``first``: for a start in motion, amplitude and time of turning point 0, in units of x0 and of 1/omega_0; then x is
    in units of that amplitude, and tau counts from there.
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

    def __post_init__(self) -> None:
        object.__setattr__(self, "certified", all(p.certified for p in self.points))

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

    def _page(self) -> Page:
        timed = any(p.tau is not None for p in self.points)
        rows = tuple((p.n, p.x, p.tau) if timed else (p.n, p.x) for p in self.points)
        worth = f"{'certified' if self.certified else 'not certified'}, {self.digits} digits ({self.method})"
        end = () if self.ended is None else (f"ended: {self.ended}",)
        title = f"{len(rows)} turning points, alpha = {self.alpha}, epsilon = {self.epsilon}"
        return Page(title, (worth, *end, *self.notes), ("n", "x", "tau") if timed else ("n", "x"), rows)

    def _curve(self, axes: Any, **style: Any) -> None:
        draw_sizes(axes, self.points, "|x| / x0", style)

    def _table(self) -> dict[str, list[Any]]:
        proved = self.certified
        columns = {"n": [p.n for p in self.points]} | spread("x", [p.x for p in self.points], certified=proved)
        timed = any(p.tau is not None for p in self.points)
        return columns | (spread("tau", [p.tau for p in self.points], certified=proved) if timed else {})

    def _letters(self) -> dict[str, str]:
        return _LETTERS

    def _formula(self) -> str:
        timed = any(p.tau is not None for p in self.points)
        rows = r" \\ ".join(f"{p.n} & {p.x}" + ("" if p.tau is None else f" & {p.tau}") for p in self.points)
        head, columns = (r"n & x_n & \tau_n", "rll") if timed else ("n & x_n", "rl")
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
