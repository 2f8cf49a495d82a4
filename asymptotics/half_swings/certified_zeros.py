"""The certified half-swing with its zeros decided by theorem: what vanishes is absent, never a ball around zero.

**Dry friction shifts the centre.**  On a half-swing with X' < 0 the Coulomb term (α_0 = 0) is the constant −ε_0, so
Y = X − ε_0 moves under the remaining laws alone and starts at 1 − ε_0 instead of 1.  Hence, exactly,

    e^L = (1 − δ_0) e^{L*(δ*)} − δ_0,      T = T*(δ*),      δ*_i = δ_i (1 − δ_0)^{α_i − 1},

where L*, T* belong to the law without dry friction; e^L = 1 − 2δ_0 and T = π if nothing remains.  A binomial
coefficient (n·(α−1) choose k) of a rational exponent is exact, so all zeros that it causes are exact.

**Reversal.**  Put δ_i = d_i e^{(α_i−1) x}: a monomial dⁿ carries e^{wx}, w = n·(α−1) = n·α − |n|, and x ↦ G(x) = x + L
is the half-swing.  Reversing time changes the sign of all δ_i, so G⁻¹(x) = x + L(−δ).

* Lagrange's formula G⁻¹(x) = x + Σ_{k≥1} (−1)^k/k! (d/dx)^{k−1} L^k shows that at w = 0, where derivatives have no
  coefficient, L(−δ) and −L(δ) agree: **L has no monomial of even degree with n·α = |n|** (α = 1: L is odd).
* Let γ = α_i − 1 ≠ 0.  Substituting x = G(y) in the constant term of e^{γ G⁻¹(x) − wx} and integrating by parts, the
  coefficient of weight w in e^{γ G⁻¹} is γ/w times that of weight −γ in e^{−wG}.  At w = −γ: minus that of e^{γG}.  As
  e^{γG} stands for F_i(δ) and e^{γG⁻¹} for −F_i(−δ): **F_i has no monomial of odd degree with n·α + α_i = |n| + 1**.

**Durations.**  T has no first order, because T = T_q(δ) + T_q(−F) and F = δ + O(δ²).  For linear friction alone (only
the law α = 1 occurs in the monomial) T is even, because F = δ.

**Integer exponents with dry friction.**  With the turning amplitude a, δ_i = ε_i a^{α_i−1}, the formulas above say that
the next amplitude a e^L and T are polynomials in a at each order in the ε_i if all α_i are integers.  So is what is
made of them by products and compositions: F_i = ε_i (a e^L)^{α_i−1} if α_i >= 1, and the field a U and W of
``normal_form.digits``.  In F_i, a U and W the monomial δⁿ carries the power w, w + 1 and w of a: it is absent if that
is negative.  T has no order 1 in the other laws (|n| − n_0 = 1), so that W has none either and its order 2 is a mean
along the straight orbit a − (2/π)ε_0 ψ, W_2 = (T_2/π) (D/sinh D) a^{w_2}, D = ε_0 d/da, for monomials with
w_2 = w + n_0: for
|n| − n_0 = 2 it is enough that w_2 is an integer >= 0.

**Dry and cubic friction.**  The first order of the field is g_1 = (l_1/π) (D/sinh D) a^α, so W_2' = k g_1 if
2α − 3 = α.  Then the third order of T is, with a_1' = g_1 on the straight orbit, ∫_0^π W_3 dψ + k ∫_0^π a_1 a_1' dψ,
and the last term is (k/2) l_1² (a − ε_0)^6.  T_3 itself is proportional to (a − ε_0)^6 by the first paragraph, and at
ε_0 = 0, where W_3 = 0 by parity, they agree.  Hence the mean of W_3 over each straight orbit vanishes, and with it W_3:
**W has no monomial δ_0^{n_0} δ_1^3 if α_1 = 3**.

>>> from asymptotics.numbers.exact import parse_real
>>> coulomb = certified_half_swing([parse_real("0", "--alpha")], 3)
>>> coulomb.L[3].str(6), coulomb.T[3]                          # L = ln(1 − 2δ), T = π
('[-2.66667 +/- ...]', 0)
>>> mixed = certified_half_swing([parse_real(a, "--alpha") for a in ("1/2", "3/2")], 2)
>>> mixed.L[1, 1], mixed.T[1, 0]
(0, 0)
"""

from collections.abc import Callable, Sequence
from fractions import Fraction
from itertools import combinations

from flint import arb

from asymptotics.errors import InputError
from asymptotics.half_swings.certified import MAX_WORK, quarter_swing
from asymptotics.half_swings.grading import Grading
from asymptotics.half_swings.quarter import HalfSwing, half_swing
from asymptotics.numbers.bridge import to_fmpq
from asymptotics.numbers.exact import ExactReal
from asymptotics.series import Key, Series


def certified_half_swing(alphas: Sequence[ExactReal], order: int, *, max_work: int = MAX_WORK) -> HalfSwing:
    """L, F, T through ``order`` at the current precision; the exponents are >= 0 and all different.

    A coefficient that vanishes by the module docstring is absent (reads as 0).  InputError as in `quarter_swing`.
    """
    if any(a == b for a, b in combinations(alphas, 2)):
        raise InputError("alphas", "equal exponents in one law", "different exponents (add their coefficients)")
    dry = [i for i, a in enumerate(alphas) if is_value(a, 0)]
    if dry:
        L, T = _with_dry_friction(alphas, dry[0], order, max_work)
    else:
        half = half_swing(quarter_swing(alphas, order, max_work=max_work))
        L, T = half.L, half.T
    L = without(L, lambda n: log_ratio_vanishes(alphas, n))
    T = without(T, lambda n: duration_vanishes(alphas, n))
    grading = Grading.of(a.ball() for a in alphas)
    maps = grading.strengths(L)
    F = tuple(without(f, lambda n, i=i: map_vanishes(alphas, i, n)) for i, f in enumerate(maps))  # type: ignore[misc]
    return HalfSwing(grading, L, F, T)


def is_value(a: ExactReal, value: int) -> bool:
    """Whether an exponent equals an integer, exactly."""
    return a.is_rational and a.rational == value


def without(series: Series, vanishes: Callable[[Key], bool]) -> Series:
    """The series without the monomials that vanish by theorem; their balls must contain zero."""
    dropped = {n: c for n, c in series.coefficients.items() if any(n) and vanishes(n)}
    if any(isinstance(c, arb) and not c.contains(0) for c in dropped.values()):
        raise ArithmeticError(f"a coefficient that vanishes by theorem is not zero: {dropped}")
    kept = {n: c for n, c in series.coefficients.items() if n not in dropped}
    return Series(kept, series.variables, series.order)


def log_ratio_vanishes(alphas: Sequence[ExactReal], n: Key) -> bool:
    """Whether the coefficient of δⁿ in L is zero by theorem."""
    return sum(n) % 2 == 0 and _total(alphas, n) == sum(n)


def duration_vanishes(alphas: Sequence[ExactReal], n: Key) -> bool:
    """Whether the coefficient of δⁿ in T is zero by theorem."""
    return sum(n) == 1 or (only(alphas, n, {1}) and sum(n) % 2 == 1)


def map_vanishes(alphas: Sequence[ExactReal], i: int, n: Key) -> bool:
    """Whether the coefficient of δⁿ in F_i is zero by theorem; F_i = δ_i, exactly, if α_i = 1."""
    if is_value(alphas[i], 1) or not alphas[i].is_rational or not n[i]:
        return False
    total = _total(alphas, n)
    balanced = total is not None and sum(n) % 2 == 1 and total + alphas[i].rational == sum(n) + 1
    return balanced or (not is_value(alphas[i], 0) and negative_power(alphas, n, 0))


def negative_power(alphas: Sequence[ExactReal], n: Key, shift: int) -> bool:
    """Whether all exponents that occur are integers and the power of the amplitude, n·α − |n| + shift, is negative."""
    integers = all(a.is_rational and a.rational.denominator == 1 for a, k in zip(alphas, n, strict=True) if k)
    total = _total(alphas, n)
    return integers and total is not None and total - sum(n) + shift < 0


def dry_friction_cancels(alphas: Sequence[ExactReal], n: Key) -> bool:
    """Whether the coefficient of δⁿ in W is zero because of dry friction (the last two paragraphs above)."""
    others = [(a, k) for a, k in zip(alphas, n, strict=True) if k and not is_value(a, 0)]
    degree, total = sum(k for _, k in others), _total(alphas, n)
    if degree == sum(n) or total is None:
        return False
    power = total - degree
    second = degree == 2 and power.denominator == 1 and 0 <= power < sum(n) - degree
    return second or (degree == 3 and len(others) == 1 and is_value(others[0][0], 3))


def only(alphas: Sequence[ExactReal], n: Key, values: set[int]) -> bool:
    """Whether all laws that occur in the monomial have their exponent among ``values``."""
    return all(not k or any(is_value(a, v) for v in values) for a, k in zip(alphas, n, strict=True))


def _total(alphas: Sequence[ExactReal], n: Key) -> Fraction | None:
    """n·α if all exponents that occur are rational, else None: then n·α is irrational.

    A sum of rationals and of positive multiples of square roots is rational only if each root is.
    """
    if any(k and not a.is_rational for a, k in zip(alphas, n, strict=True)):
        return None
    return sum((k * a.rational for a, k in zip(alphas, n, strict=True) if k), Fraction(0))


def _with_dry_friction(alphas: Sequence[ExactReal], dry: int, order: int, max_work: int) -> tuple[Series, Series]:
    """L and T by the shifted centre, from the half-swing of the other laws."""
    others = [a for i, a in enumerate(alphas) if i != dry]
    one = Series.constant(arb(1), len(alphas), order)
    delta = Series.variable(dry, len(alphas), order, arb(1))
    if not others:
        return (one - delta * 2).log(), one * arb.pi()
    rest = certified_half_swing(others, order, max_work=max_work)
    L, T = (_shifted(f, others, dry) for f in (rest.L, rest.T))
    return ((one - delta) * L.exp() - delta).log(), T


def _shifted(f: Series, others: Sequence[ExactReal], dry: int) -> Series:
    """f(δ*): the monomial δⁿ becomes δⁿ (1 − δ_0)^{n·(α−1)}."""
    result = {}
    for n, c in f.coefficients.items():
        power = _total(others, n)
        weight = None if power is None else power - sum(n)
        exponent = sum((k * (a.ball() - 1) for a, k in zip(others, n, strict=True)), arb(0))
        for j in range(f.order - sum(n) + 1):
            factor = _binomial(exponent if weight is None else weight, j)
            if factor != 0 or not factor.is_exact():
                result[(*n[:dry], j, *n[dry:])] = c * factor * (-1) ** j
    return Series(result, f.variables + 1, f.order)


def _binomial(exponent: arb | Fraction, j: int) -> arb:
    """(exponent choose j), exactly zero when a rational exponent says so."""
    if isinstance(exponent, Fraction):
        product = Fraction(1)
        for i in range(j):
            product *= (exponent - i) / (i + 1)
        return arb(to_fmpq(product))
    result = arb(1)
    for i in range(j):
        result = result * (exponent - i) / (i + 1)
    return result
