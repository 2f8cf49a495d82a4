"""The envelope of one law to any order: tau and phi as Laurent polynomials in delta, and delta(tau) by reversal.  The
averaged equations beyond the first order (Bogoliubov and Mitropolsky), integrated as they stand: formal series.

    (alpha-1) p_1 tau = G(delta) - G(delta_0),    (alpha-1) p_1 phi = H(delta_0) - H(delta),
    delta = sigma + g_2 sigma^3 + ...,            sigma = 1/(G(delta_0) + (alpha-1) p_1 tau)

(``envelopes.laurent``).  Dimensionless in every unit: delta = epsilon (A/x0)^(alpha-1) = b omega_0^alpha
A^(alpha-1)/k, tau = omega_0 t, and delta_0 at the start.  Formal: nothing is claimed about what is cut off.

>>> print(envelope_series(ExactReal(3), 5))
delta = epsilon A^(alpha-1), alpha = 3: through order 5, turning-point gauge, formal
p_1 = 3/8
G(delta) = 1/delta + 15/512 delta - 15057/655360 delta^3
H(delta) = -45/256 delta + 2457/262144 delta^3
delta(sigma) = sigma + 15/512 sigma^3 - 3483/163840 sigma^5
>>> cubic = envelope_series(ExactReal(3), 5)
>>> cubic.time("1/20", "1/10"), cubic.delta(13.331407, "1/10")            # heuristic: doubles, truncated
(13.331407..., 0.050000000...)
"""

from dataclasses import dataclass, field
from fractions import Fraction
from math import isfinite
from typing import Any

from flint import arb
from sympy import Expr

from asymptotics.envelopes.laurent import LaurentEnvelope, envelope_of_series, laurent_envelope
from asymptotics.envelopes.slow_time import D, epsilon, explicit, expressions, leading_amplitude
from asymptotics.envelopes.symbolic import tau
from asymptotics.errors import InputError
from asymptotics.expansions.half_swings.pi_ring import PiNumber
from asymptotics.expansions.moments.symbolic import moment
from asymptotics.expansions.normal_form.digits import expansions
from asymptotics.expansions.normal_form.expansion import exact_expansion
from asymptotics.expansions.normal_form.show import sum_latex, sum_text
from asymptotics.gauges import TURNING_POINT
from asymptotics.numbers.bridge import to_fraction, to_sympy
from asymptotics.numbers.context import cached_property
from asymptotics.numbers.decimals import bits_for, decimal_of_ball, rational_decimal
from asymptotics.numbers.exact import ExactReal
from asymptotics.numbers.policy import Number, exact_number
from asymptotics.numbers.precision import at_growing_precision
from asymptotics.numbers.value import Coefficient, coefficient_columns
from asymptotics.present.shown import Page, Rows
from asymptotics.running.public import public
from asymptotics.series import Series, divided

# Refusals alone: the work grows with the order; numbers up to 10^100 keep products of two of them within doubles.
MAX_ORDER, MAX_NUMBER = 40, Fraction(10) ** 100
_Found = tuple[list[dict[int, Coefficient]], LaurentEnvelope]
_TEXTS = {"G": "G(delta)", "H": "H(delta)", "reversal": "delta(sigma)"}


@dataclass(frozen=True, repr=False)
class EnvelopeSeries(Rows):
    """p_1, and the coefficients of G (beside 1/delta), H and the reversal, {power: number}; see the module."""

    alpha: ExactReal
    order: int
    arithmetic: str
    p_1: Coefficient
    G: dict[int, Coefficient]
    H: dict[int, Coefficient]
    reversal: dict[int, Coefficient]
    formulas: LaurentEnvelope = field(compare=False)

    @public
    def time(self, delta: Number, delta_0: Any, *, max_seconds: Number = 60) -> float:
        """tau at which the local strength has become ``delta``, in doubles."""
        return self._number("time", delta=delta, delta_0=delta_0)

    @public
    def phase(self, delta: Number, delta_0: Any, *, max_seconds: Number = 60) -> float:
        """phi at the same place, 0 at the start."""
        return self._number("phase", delta=delta, delta_0=delta_0)

    @public
    def delta(self, tau: Number, delta_0: Any, *, max_seconds: Number = 60) -> float:
        """The local strength at ``tau``, by the reversal; for alpha < 1 InputError from the extinction on."""
        if self.alpha < 1:
            end = self.extinction_time(delta_0)
            if not exact_number(tau, "tau") < ExactReal(Fraction(end)):
                raise InputError("tau", f"{tau} is not before the extinction at {end:g}", "an earlier tau")
        return self._number("delta", tau=tau, delta_0=delta_0)

    @public
    def extinction_time(self, delta_0: Any, *, max_seconds: Number = 60) -> float:
        """alpha < 1: tau beyond which these series say nothing; InputError for alpha > 1, which never ends."""
        return self._number("extinction_time", delta_0=delta_0)

    def _number(self, name: str, **given: Any) -> float:
        numbers = {key: exact_number(value, key) for key, value in given.items()}
        for key, number in numbers.items():
            # tau = 0 is the start; a strength 0 has no 1/delta.
            in_range = 1 / MAX_NUMBER <= number <= MAX_NUMBER or (key == "tau" and 0 <= number <= MAX_NUMBER)
            if not in_range:
                raise InputError(key, f"{number} is out of range", "a number from 1e-100 to 1e100")
        # Exact numbers become doubles here at last: what is found is a truncated series, no enclosure.
        found = getattr(self.formulas.numeric(), name)(*(float(n.ball()) for n in numbers.values()))
        if not isfinite(found):
            raise InputError("delta_0", "the truncated series give no number there", "smaller local strengths")
        return float(found)

    @property
    def explicit(self) -> tuple[Expr, Expr]:
        """(A/A(0), phi) in tau = omega_0 t and epsilon, explicit in the slow time, from rest (``slow_time``).

        >>> envelope_series(ExactReal(2), 2).explicit
        (1/(4*epsilon*tau/(3*pi) + 1), epsilon*(-pi/8 + pi/(8*(4*epsilon*tau/(3*pi) + 1))))
        """
        relative, phase = self._in_slow_time
        exponent = to_sympy(self.alpha)
        leading, slow = leading_amplitude(exponent, moment(exponent + 1), epsilon, tau)
        return leading * relative.subs(D, slow), phase.subs(D, slow)

    @property
    def relative(self) -> Expr:
        """A/A_0 in D and epsilon, A_0 being the amplitude of first order (``slow_time``)."""
        return self._in_slow_time[0]

    @cached_property
    def _in_slow_time(self) -> tuple[Expr, Expr]:
        return expressions(explicit(self.formulas, self.order - 1))

    @property
    def formal(self) -> bool:
        """True: no bound on the remainder is claimed."""
        return True

    def to_dict(self) -> dict[str, Any]:
        """JSON-ready: numbers are strings, keys the powers of delta, or of sigma in ``reversal``."""
        rows = {name: {str(n): c.to_dict() for n, c in getattr(self, name).items()} for name in _TEXTS}
        head = {"alpha": str(self.alpha), "order": self.order, "arithmetic": self.arithmetic, "formal": True}
        return {**head, "gauge": TURNING_POINT, "p_1": self.p_1.to_dict(), **rows}

    def __str__(self) -> str:
        claim = f"through order {self.order}, {TURNING_POINT} gauge, formal"
        lines = [f"delta = epsilon A^(alpha-1), alpha = {self.alpha}: {claim}"]
        lines.append(f"p_1 = {sum_text({(0,): self.p_1}, ('',))}")
        for name, text in _TEXTS.items():
            letter, lead = ("sigma" if name == "reversal" else "delta"), ("1/delta" if name == "G" else "")
            lines.append(f"{text} = {sum_text(_row(getattr(self, name)), (letter,), lead)}")
        return "\n".join(lines)

    def __repr__(self) -> str:
        return f"EnvelopeSeries(alpha = {self.alpha}, order {self.order}, {self.arithmetic}, formal)"

    def _page(self) -> Page:
        title, *rest = str(self).splitlines()
        return Page(title, (*rest, f"{self.arithmetic} coefficients; no bound on the remainder"))

    def _table(self) -> dict[str, list[Any]]:
        named = [(name, n, c) for name in _TEXTS for n, c in getattr(self, name).items()]
        columns = {"series": [name for name, _, _ in named], "power": [n for _, n, _ in named]}
        return columns | coefficient_columns([c for _, _, c in named])

    def _letters(self) -> dict[str, str]:
        return {"G": "p_1 (alpha-1) tau at the local strength, less its value at the start",
                "H": "phi in the same way", r"\sigma": "the slow time, by which G is inverted"}  # fmt: skip

    def _formula(self) -> str:
        G = sum_latex(_row(self.G), (r"\delta",), r"\frac{1}{\delta}")
        H, g = sum_latex(_row(self.H), (r"\delta",)), sum_latex(_row(self.reversal), (r"\sigma",))
        return rf"G(\delta) = {G}, \quad H(\delta) = {H}, \quad \delta(\sigma) = {g}"


def envelope_series(alpha: ExactReal, order: int, digits: int = 30) -> EnvelopeSeries:
    """The series for one exponent through ``order``, every digit certified; InputError for alpha = 1.

    LimitError where the cost is too high, UndecidedError where balls cannot round a coefficient.
    """
    if alpha == 1:
        raise InputError("alpha", "at alpha = 1 delta is constant and A = exp(-epsilon tau/2) exactly", "alpha != 1")
    # Integer exponents have coefficients in Q[pi, 1/pi]: a rational one may be a tie, which only exact arithmetic
    # tells, and the others are rounded from balls of pi.
    if alpha.is_integer:
        exact = laurent_envelope(exact_expansion((int(alpha.rational),), order))
        found = at_growing_precision(lambda _: _numbers(exact, digits), digits, bits_for(digits))
    else:

        def attempt(bits: int) -> _Found | None:
            # The exponent is read at this precision anew: a ball made before would carry its old radius along.
            series = expansions([alpha], order)
            return _numbers(envelope_of_series(alpha.ball(), series["p"], series["Omega"]), digits)

        # The guard grows with the order, at which the flow loses digits.  It decides how often a pass is repeated and
        # no more: a ball that is too wide to round asks for twice the bits.
        found = at_growing_precision(attempt, digits, bits_for(digits, 4 * order + 64))
    rows, formulas = found
    first, G, H, reversal = rows
    kind = "exact" if alpha.is_integer else "certified"
    return EnvelopeSeries(alpha, order, kind, first[0], G, H, reversal, formulas)


def _numbers(envelope: LaurentEnvelope, digits: int) -> _Found | None:
    """p_1, G, H, reversal, rounded, and what they come from; None where a rounding is not decided at this precision."""
    rows: list[dict[int, Any]] = [{0: envelope.p_1}, _integrated(envelope.q, -1), _integrated(envelope.r, 1)]
    rows.append({n: c for (n,), c in sorted(envelope.reversal.coefficients.items())})
    found = [{n: _coefficient(c, digits) for n, c in row.items()} for row in rows]
    if any(c is None for row in found for c in row.values()):
        return None
    return [{n: c for n, c in row.items() if c is not None} for row in found], envelope


def _integrated(series: Series, sign: int) -> dict[int, Any]:
    """+-c_k/(k-1) at the power k-1, for k >= 2."""
    # Term by term; there is no 1/delta, so no logarithm (``envelopes.laurent``).
    return {n - 1: divided(sign * c, n - 1) for (n,), c in sorted(series.coefficients.items()) if n >= 2}


def _coefficient(c: Any, digits: int) -> Coefficient | None:
    if isinstance(c, arb):
        text = decimal_of_ball(c, digits)
        return None if text is None else Coefficient(text, None)
    number = c if isinstance(c, PiNumber) else PiNumber.rational(c)
    if number.is_rational:  # integer arithmetic decides ties as well
        return Coefficient(rational_decimal(to_fraction(number.as_rational()), digits), number.closed())
    text = decimal_of_ball(number.ball(), digits)
    return None if text is None else Coefficient(text, number.closed())


def _row(numbers: dict[int, Coefficient]) -> dict[tuple[int, ...], Coefficient]:
    return {(n,): c for n, c in numbers.items()}
