"""The Stokes constants of the half-swing as correctly rounded decimals, with what they govern.

>>> found = stokes_constants(ExactReal(2), 1, 12)
>>> found.constants, found.time_constants, found.action
(('-0.0909280010378',), ('0.412525358564',), '4.71238898038')
>>> print(stokes_constants(ExactReal(0), 2, 17))
alpha = 0: the half-swing is z' = z + 1 exactly: no constant, no divergence
c_1 = 0    d_1 = 0
c_2 = 0    d_2 = 0
certified: true (by theorem)
"""

from dataclasses import dataclass
from decimal import Decimal
from functools import partial
from typing import Any

from flint import arb

from asymptotics.errors import InputError
from asymptotics.expansions.divergence.constants import stokes_balls
from asymptotics.expansions.moments.certified import moment
from asymptotics.expansions.moments.exact import integer_moment
from asymptotics.numbers.context import ctx
from asymptotics.numbers.decimals import bits_for, certified_decimal, decimal_of_ball
from asymptotics.numbers.digits import spread
from asymptotics.numbers.exact import ExactReal
from asymptotics.numbers.policy import exact_integer
from asymptotics.numbers.precision import at_growing_precision
from asymptotics.numbers.value import Coefficient
from asymptotics.present.drawn import Drawn
from asymptotics.present.shown import Page, Rows

MAX_DIGITS, MAX_COUNT, MAX_ALPHA = 100, 8, 50
FIRST_GUARD, TRIES = 16, 4
"""Guard bits of the first try (a digit for each 16: the bounds have slack already), and how often they are doubled."""
ROUTE = "Abel functions of the half-swing in balls"


@dataclass(frozen=True, repr=False)
class StokesConstants(Rows, Drawn):
    """c_1, c_2, … (amplitude) and d_1, d_2, … (time) of one law, its pole c = 1/((alpha-1) pi M_(alpha+1)), its action.

    ``action`` 2 pi |c|: the best truncation at the local strength delta leaves about e^(-action/delta).  ``certified``
    says whether each decimal was found to have its whole enclosure within half a unit of the last digit.
    """

    alpha: str
    pole: str
    action: str
    constants: tuple[str, ...]
    time_constants: tuple[str, ...]
    digits: int
    route: str
    certified: bool
    notes: tuple[str, ...] = ()

    def c(self, k: int) -> Coefficient:
        """c_k as a number: mpf, interval, float."""
        return Coefficient(self.constants[exact_integer(k, "k", 1, len(self.constants)) - 1], None)

    def d(self, k: int) -> Coefficient:
        """d_k as a number: mpf, interval, float."""
        return Coefficient(self.time_constants[exact_integer(k, "k", 1, len(self.time_constants)) - 1], None)

    def rows(self) -> list[tuple[str, str, str]]:
        """(k, c_k, d_k), one for each k."""
        return [(str(k), *pair) for k, pair in enumerate(zip(self.constants, self.time_constants, strict=True), 1)]

    def to_dict(self) -> dict[str, Any]:
        """JSON-ready: the contract of ``asymptotics stokes --json``."""
        return {
            "alpha": self.alpha, "pole": self.pole, "action": self.action, "constants": list(self.constants),
            "time_constants": list(self.time_constants), "digits": self.digits, "certified": self.certified,
            "route": self.route, "notes": list(self.notes),
        }  # fmt: skip

    def latex(self) -> str:
        """c_k and d_k, and the law of D = Phi_+ - Phi_- that they are the coefficients of."""
        sums = (rf"\{f}_+-\{f}_- = \sum_{{k\ge1}} {x}_k e^{{-2\pi i k w}}" for f, x in (("Phi", "c"), ("theta", "d")))
        law = r",\quad ".join(sums)
        numbers = [rf"c_{{{k}}} = {c},\quad d_{{{k}}} = {d}" for k, c, d in self.rows()]
        return " \\\\\n".join([*numbers, law])

    def __str__(self) -> str:
        head = f"alpha = {self.alpha}: pole c = {self.pole}, action 2 pi |c| = {self.action}"
        if self.alpha == "0":
            head = "alpha = 0: the half-swing is z' = z + 1 exactly: no constant, no divergence"
        told = "true" if self.certified else "false"
        width = max(map(len, self.constants)) + 10
        lines = [f"{f'c_{k} = {c}':{width}}d_{k} = {d}" for k, c, d in self.rows()]
        return "\n".join([head, *lines, f"certified: {told} ({self.route})", *self.notes])

    def _page(self) -> Page:
        title, *rest = str(self).splitlines()
        return Page(title, (rest[-1] if not self.notes else rest[-1 - len(self.notes)], *self.notes),
                    ("k", "c_k", "d_k"), tuple(self.rows()))  # fmt: skip

    def _curve(self, axes: Any, **style: Any) -> None:
        """|c_k| and |d_k| against k."""
        k = [int(row[0]) for row in self.rows()]
        for name, row in (("|c_k|", self.constants), ("|d_k|", self.time_constants)):
            own = style if name == "|c_k|" else {}
            axes.plot(k, [abs(float(x)) for x in row], **{"marker": "o", "markersize": 4, "label": name, **own})
        if all(float(x) for x in (*self.constants, *self.time_constants)):
            axes.set_yscale("log")
        axes.set(xlabel="k", ylabel="Stokes constant", xticks=k)

    def _table(self) -> dict[str, list[Any]]:
        k = [int(row[0]) for row in self.rows()]
        return {"k": k} | spread("c", self.constants) | spread("d", self.time_constants)

    def _letters(self) -> dict[str, str]:
        return {"c": "Stokes constant of the amplitude", "d": "Stokes constant of the time", "w": "Abel coordinate",
                r"\theta": "Abel function of the time", "i": "the imaginary unit"}  # fmt: skip

    def _formula(self) -> str:
        return rf"\displaystyle\begin{{gathered}}{self.latex()}\end{{gathered}}"


def stokes_constants(alpha: ExactReal, count: int, digits: int, notes: tuple[str, ...] = ()) -> StokesConstants:
    """c_1 ... c_count and d_1 ... d_count, rounded to ``digits`` digits; errors as in ``asymptotics.stokes``."""
    _require(alpha)
    pole, action = (certified_decimal(partial(number, alpha), digits) for number in (pole_of, action_of))
    # Dry friction alone: the one exponent at which the constants are zeros by theorem, which no ball could tell.
    if alpha.is_zero:  # z' = z + 1 and T = pi exactly
        zeros = ("0",) * count
        return StokesConstants("0", pole, action, zeros, zeros, digits, "by theorem", alpha.is_zero, notes)

    def attempt(bits: int) -> tuple[list[arb], list[str]] | None:
        balls = [x for row in stokes_balls(alpha, count, digits + bits // 16) for x in row]
        texts = [text for x in balls if (text := decimal_of_ball(x, digits)) is not None]
        return (balls, texts) if len(texts) == len(balls) else None

    balls, texts = at_growing_precision(attempt, digits, FIRST_GUARD, max_bits=FIRST_GUARD << TRIES)
    # Asked once more, by comparison instead of by rounding.
    certified = all(rounds_to(x, text, digits) for x, text in zip(balls, texts, strict=True))
    rows = tuple(texts[:count]), tuple(texts[count:])
    return StokesConstants(str(alpha), pole, action, *rows, digits, ROUTE, certified, notes)


def rounds_to(ball: arb, text: str, digits: int) -> bool:
    """Whether all of the ball lies within half a unit of the last digit of a decimal of ``digits`` digits.

    >>> rounds_to(arb("0.12349", "0.000005"), "0.1235", 4), rounds_to(arb("0.12342", "0.000005"), "0.1235", 4)
    (True, False)
    """
    with ctx.workprec(bits_for(digits)):
        half = arb(10) ** (Decimal(text).adjusted() + 1 - digits) / 2
        low, high = arb(text) - half, arb(text) + half
        return bool(ball >= low and ball <= high)


def pole_of(alpha: ExactReal) -> arb | ExactReal:
    """1/((alpha-1) pi M_(alpha+1)); a rational number for even alpha, whose ties no ball could tell."""
    if alpha.is_integer:
        times_pi, over_pi = integer_moment(alpha.rational.numerator + 1)
        if over_pi:
            return ExactReal(1 / ((alpha.rational - 1) * times_pi))
    return 1 / ((alpha.ball() - 1) * arb.pi() * moment(alpha.ball() + 1))


def action_of(alpha: ExactReal) -> arb | ExactReal:
    """2 pi |c| = 2/(|alpha-1| M_(alpha+1)); a rational number for odd alpha."""
    if alpha.is_integer:
        average, over_pi = integer_moment(alpha.rational.numerator + 1)
        if not over_pi:
            return ExactReal(2 / (abs(alpha.rational - 1) * average))
    return 2 / (abs(alpha.ball() - 1) * moment(alpha.ball() + 1))


def _require(alpha: ExactReal) -> None:
    accepted = f"a real number from 0 to {MAX_ALPHA} other than 1"
    if alpha == ExactReal(1):
        raise InputError("alpha", "1: the half-swing is the identity in delta and has no Stokes constants", accepted)
    if alpha < 0 or alpha > MAX_ALPHA:
        raise InputError("alpha", f"{alpha} is out of range", accepted)
