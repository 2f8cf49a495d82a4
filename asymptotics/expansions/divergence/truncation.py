"""Where to stop the divergent series at a given local strength, what is left, what the first exponentials give back.

Optimal truncation at the smallest term, and its exponential improvement by Dingle's terminants.

The Abel function counts half-swings, so its error is a fraction of one.  At the local strength delta > 0, with z =
|c|/delta, the terms eps_n z^-n (n odd) fall until n is near 2 pi z, then grow; they stand for (``cauchy-heine``)

    R_N = +-(1/pi) z^-M int D(-iy) y^(M-1)/(1 + y^2/z^2) dy,   M = N + 2, + if (M-1)/2 is even,

D = c_1 q + c_2 q^2 + …: the first two sectors of the transseries, with q = e^(-2 pi v), v = y - eps_1/y + eps_3/y^3.

``errors`` are |Phi_N - Phi_+| (and with R_N of one sector, of two): Phi_+ is enclosed from the turning points that
follow (half-swings in balls), so they are measured, and R_N is a quadrature in floats: it claims nothing.

>>> from fractions import Fraction
>>> stop = best_truncation(ExactReal(2), ExactReal(Fraction(1, 5)))
>>> stop.order, stop.power, f"{stop.predicted:.1e} {stop.errors[0]:.1e}"
(27, 25, '5.3e-12 5.4e-13')
>>> stop.errors[0] > 1000 * stop.errors[1]
True
"""

from collections.abc import Sequence
from dataclasses import dataclass
from math import exp, pi
from typing import Any

import mpmath
from flint import acb, arb

from asymptotics.errors import InputError, LimitError, UndecidedError
from asymptotics.expansions.divergence.abel import OddSeries, at, odd_series
from asymptotics.expansions.divergence.constants import ROUGH_BITS, rough_petal, stokes_balls
from asymptotics.expansions.divergence.germ import germ
from asymptotics.numbers.context import ctx
from asymptotics.numbers.decimal_context import workdps
from asymptotics.numbers.exact import ExactReal
from asymptotics.present.shown import Page, Rows

MAX_INDEX = 90
"""The largest 2 pi |c|/delta that is served: the coefficients of about twice as many orders are needed."""
SECTORS = 2
FURTHER = 2
"""With the exponentials the best place to stop is later, so many times as many terms."""


@dataclass(frozen=True, repr=False)
class BestOrder(Rows):
    """Stop the Abel function after delta^``power``, p_k and Omega_k after ``order``; errors in half-swings.

    ``predicted``: |c_1| e^(-2 pi |c|/delta); ``smallest_term`` of the Abel function; ``errors``: measured without and
    with one and two sectors of the transseries.  The constants are certified, where to stop is not: ``label``.
    """

    alpha: str
    delta: str
    order: int
    power: int
    predicted: float
    smallest_term: float
    errors: tuple[float, ...]
    label: str = "measured"

    def to_dict(self) -> dict[str, Any]:
        """JSON-ready: numbers are strings."""
        return {
            "alpha": self.alpha, "delta": self.delta, "order": self.order, "power": self.power,
            "predicted": repr(self.predicted), "smallest_term": repr(self.smallest_term),
            "errors": [repr(error) for error in self.errors], "label": self.label,
        }  # fmt: skip

    def rows(self) -> list[tuple[str, str]]:
        """The lines of the table: what is told, and the error in half-swings."""
        names = ("measured", *(f"measured, {k} exponential{'s' * (k > 1)} added" for k in range(1, len(self.errors))))
        found = zip(names, self.errors, strict=True)
        head = [("|c_1| e^(-2 pi |c|/delta)", self.predicted), ("smallest term", self.smallest_term)]
        return [(name, f"{x:.2e}") for name, x in (*head, *found)]

    def __str__(self) -> str:
        head = (
            f"alpha = {self.alpha}, delta = {self.delta}: best order {self.order} ({self.label}); error in half-swings:"
        )
        return "\n".join([head, *(f"  {name:34}{x}" for name, x in self.rows())])

    def _page(self) -> Page:
        return Page(f"best order {self.order}", (f"alpha = {self.alpha}, delta = {self.delta}, {self.label}",),
                    ("error in half-swings", ""), tuple(self.rows()))  # fmt: skip

    def _table(self) -> dict[str, list[Any]]:
        return {"what": [name for name, _ in self.rows()], "error": [float(x) for _, x in self.rows()]}


def best_truncation(alpha: ExactReal, delta: ExactReal) -> BestOrder:
    """The best order at ``delta`` > 0 for one law; InputError at alpha = 0, 1, LimitError for a delta too small.

    UndecidedError where the half-swings from ``delta`` on are outside the circle of the majorant.
    """
    _require(alpha, delta)
    rough, p = rough_petal(alpha)
    with ctx.workprec(ROUGH_BITS):
        # A double: where to stop is measured and never claimed.
        z = float(abs(rough.c) / delta.ball())
    far = f"delta = {delta} is outside the circle in which half-swings are enclosed: a smaller one"
    if not delta.ball() < rough.half.radii[0]:
        raise UndecidedError(far)
    index = 2 * pi * z
    if index > MAX_INDEX:
        raise LimitError(
            "delta", f"the smallest term is at order {index:.0f}", f"a delta of {index / MAX_INDEX:.2g} times"
        )
    # The second exponential shows behind e^(-index) = 10^(-0.43 index) of the first, so that c_1 needs that many
    # digits, and some to spare. What is made of them is measured, not claimed.
    digits = int(0.7 * index) + 8
    constants = stokes_balls(alpha, SECTORS, digits)[0]
    # Twice the index in orders for the later stop; e^(-2 index) = 2^(-2.9 index) in bits, 260 of the 330 at MAX_INDEX.
    order, bits = int(2.2 * index) + 40, int(2 * index) + 150
    with ctx.workprec(bits):
        g = germ(alpha, order, bits, float(delta.ball()) / 2)
        series = odd_series(g)
        place = delta.ball() if g.c > 0 else -delta.ball()
        try:
            exact = _text(at(g, p, series, acb(g.c / place))[0].real)
        except UndecidedError:  # one of the half-swings from there on
            raise UndecidedError(far) from None
        sizes = [_text(x) for x in constants]
        start, terms = _text(g.c / place), _terms(series[0], place)
    with workdps(int(bits / 3.3)):
        k = min(range(1, len(terms)), key=lambda j: abs(terms[j]))
        later, size = min(FURTHER * k, len(terms) - 1), mpmath.mpf(start)
        eps = [term * size ** (2 * j + 1) for j, term in enumerate(terms)]
        with workdps(digits + 10):
            parts = [_sector(mpmath.mpf(x), i, 2 * later + 3, size, eps, p.Y_0) for i, x in enumerate(sizes, 1)]
        farther = mpmath.mpf(start) + sum(terms[: later + 1])
        sums = [mpmath.mpf(start) + sum(terms[: k + 1]), *(farther + sum(parts[:i]) for i in range(1, SECTORS + 1))]
        errors = tuple(float(abs(value - mpmath.mpf(exact))) for value in sums)
    predicted = abs(float(constants[0])) * exp(-index)
    return BestOrder(str(alpha), str(delta), 2 * k + 3, 2 * k + 1, predicted, float(abs(terms[k])), errors)


def _require(alpha: ExactReal, delta: ExactReal) -> None:
    if not alpha > 0 or alpha == ExactReal(1):
        raise InputError("alpha", f"at alpha = {alpha} the series does not diverge", "alpha > 0 other than 1")
    if not delta > 0:
        raise InputError("delta", f"{delta} is not positive", "a local strength > 0")


def _terms(f: OddSeries, delta: arb) -> list[mpmath.mpf]:
    """e_n delta^n for n = 1, 3, … as numbers: from here on nothing is claimed."""
    values = [_text(e * delta ** (2 * k + 1)) for k, e in enumerate(f.coefficients)]
    with workdps(int(ctx.prec / 3.3)):
        return [mpmath.mpf(x) for x in values]


def _text(x: arb) -> str:
    return str(arb(x.mid()).str(int(ctx.prec / 3.3), radius=False))


def _sector(size: Any, sector: int, M: int, z: Any, eps: Sequence[Any], lowest: arb) -> Any:
    """The part of c_k q^k in R_N."""

    def integrand(y: Any) -> Any:
        square, v = 1 / y**2, mpmath.mpf(0)
        # The powers in v diverge too: their terms fall until n is near 2 pi y, the place pi y in a list of odd ones.
        for e in reversed(eps[: int(mpmath.pi * y)]):
            v = e - v * square
        return size * mpmath.exp(-2 * mpmath.pi * sector * (y - v / y)) * (y / z) ** (M - 1) / (1 + (y / z) ** 2)

    # y^M e^(-2 pi sector y) has its peak there, of width sqrt(M)/(2 pi sector): panels around it, and none below Y_0.
    least, peak = mpmath.mpf(float(lowest)), M / (2 * mpmath.pi * sector)
    width = mpmath.sqrt(max(least, peak)) / 2
    ends = {max(least, peak + j * width) for j in (-16, -8, -4, -2, 0, 2, 4, 8, 16)}
    return (-1) ** ((M - 1) // 2) * mpmath.quad(integrand, sorted(ends)) / (mpmath.pi * z)
