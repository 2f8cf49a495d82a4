"""The certified half-swing with its zeros decided by theorem: what vanishes is absent, never a ball around zero.

Each statement is derived step by step in the derivation ``zeros-by-theorem``.

**Dry friction shifts the centre.**  On a half-swing with X' < 0 the Coulomb term (alpha_0 = 0) is the constant
−epsilon_0, so Y = X − epsilon_0 moves under the remaining laws alone and starts at 1 − epsilon_0 instead of 1.  Hence,
exactly,

    e^L = (1 − delta_0) e^{L*(delta*)} − delta_0,   T = T*(delta*),   delta*_i = delta_i (1 − delta_0)^{alpha_i − 1},

where L*, T* belong to the law without dry friction; e^L = 1 − 2 delta_0 and T = pi if nothing remains.  A binomial
coefficient (n·(alpha−1) choose k) of a rational exponent is exact, so all zeros that it causes are exact.
This needs the linear spring and losses that do not see the position; with other forces alpha = 0 is a term like any
other.

**Reversal.**  Let w_i be the weights, a_n = sum n_i w_i, and ℓ(n) the loss degree (``grading``); for plain losses
a_n = n·alpha − |n| and ℓ(n) = |n|.  The half-swing is x ↦ G(x) = x + L on x = ln A, and reversing time changes the sign
of all losses and of no spring: G⁻¹(x) = x + L(S delta).  With Lagrange's formula for G⁻¹ and constant terms under x =
G(y):

* **L has no monomial with ℓ(n) = 0** (without losses the motion is periodic), **none with a_n = 0 and even ℓ(n)**
  (alpha = 1: L is odd).
* **F_i = delta_i + monomials with ℓ(n) > ℓ(e_i)**, and **none with a_n = −w_i ≠ 0 and ℓ(n) − ℓ(e_i) even**.
* **T has no monomial that is a single loss**, because T = T_q(delta) + T_q(SF) and F = delta + O(delta²).  Where only
  forces of weight 0 occur in the monomial (linear friction, |x| sgn x', a change of the linear spring) **T is even
  in ℓ**.

**Integer exponents with dry friction** (plain losses only).
With the turning amplitude a, delta_i = epsilon_i a^{alpha_i−1}, the next amplitude a e^L and T are polynomials in a at
each order in the epsilon_i if all alpha_i are integers.  So is what is made of them by products and compositions: F_i =
epsilon_i (a e^L)^{alpha_i−1} if alpha_i >= 1, and the field a U and W of ``normal_form.digits``.  In F_i, a U and W the
monomial deltaⁿ carries the power w, w + 1 and w of a: it is absent if that is negative.  T has no order 1 in the other
laws (|n| − n_0 = 1), so that W has none either and its order 2 is a mean along the straight orbit a − (2/pi)epsilon_0
psi, W_2 = (T_2/pi) (D/sinh D) a^{w_2}, D = epsilon_0 d/da, for monomials with w_2 = w + n_0: for |n| − n_0 = 2 it is
enough that w_2 is an integer >= 0.

**Dry and cubic friction.**  The first order of the field is g_1 = (l_1/pi) (D/sinh D) a^alpha, so W_2' = k g_1 if
2 alpha − 3 = alpha.  Then the third order of T is ∫_0^pi W_3 d psi + (k/2) l_1² (a − epsilon_0)^6, and proportional to
(a − epsilon_0)^6: **W has no monomial delta_0^{n_0} delta_1^3 if alpha_1 = 3**.

>>> from asymptotics.numbers.exact import parse_real
>>> coulomb = certified_half_swing([parse_real("0", "--alpha")], 3)
>>> coulomb.L[3].str(6), coulomb.T[3]                          # L = ln(1 − 2 delta), T = pi
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
from asymptotics.expansions.half_swings.certified import MAX_SECONDS, quarter_swing
from asymptotics.expansions.half_swings.forces import Forces, Given
from asymptotics.expansions.half_swings.quarter import HalfSwing, half_swing
from asymptotics.numbers.exact import ExactReal
from asymptotics.numbers.rationals import to_fmpq
from asymptotics.series import Key, Series, unit_key


def certified_half_swing(given: Given, order: int, *, max_seconds: float = MAX_SECONDS) -> HalfSwing:
    """L, F, T through ``order`` at the current precision; the forces are all different.

    A coefficient that vanishes by the module docstring is absent (reads as 0).  InputError as in `quarter_swing`.
    """
    forces = Forces.read(given, order)
    if any(a.key == b.key or a.shape == b.shape for a, b in combinations(forces.members, 2)):
        raise InputError("alphas", "equal exponents in one law", "different exponents (add their coefficients)")
    alphas = [m.velocity for m in forces.members]
    # The centre may only be shifted beside a linear spring and losses that do not see the place.
    dry = [i for i, a in enumerate(alphas) if is_value(a, 0)] if forces.is_pure else []
    if dry:
        L, T = _with_dry_friction(alphas, dry[0], order, max_seconds)
    else:
        half = half_swing(quarter_swing(forces, order, max_seconds=max_seconds))
        L, T = half.L, half.T
    # The zeros of L first: F is made of L, and would carry their balls on.
    L = without(L, lambda n: log_ratio_vanishes(forces, n))
    T = without(T, lambda n: duration_vanishes(forces, n))
    grading = forces.ball_grading()
    maps = grading.strengths(L)
    F = tuple(without(f, lambda n, i=i: map_vanishes(forces, i, n)) for i, f in enumerate(maps))  # type: ignore[misc]
    return HalfSwing(grading, L, F, T)


def is_value(a: ExactReal, value: int) -> bool:
    """Whether an exponent equals an integer, exactly."""
    return a.is_rational and a.rational == value


def without(series: Series, vanishes: Callable[[Key], bool]) -> Series:
    """The series without the monomials that vanish by theorem; their balls must contain zero."""
    dropped = {n: c for n, c in series.coefficients.items() if any(n) and vanishes(n)}
    # A ball off zero contradicts a theorem, so the program is wrong: no UndecidedError, for no precision would help.
    if any(isinstance(c, arb) and not c.contains(0) for c in dropped.values()):
        raise ArithmeticError(f"a coefficient that vanishes by theorem is not zero: {dropped}")
    kept = {n: c for n, c in series.coefficients.items() if n not in dropped}
    return Series(kept, series.variables, series.order)


def log_ratio_vanishes(forces: Forces, n: Key) -> bool:
    """Whether the coefficient of deltaⁿ in L is zero by theorem."""
    losses = forces.loss_degree(n)
    return not losses or (losses % 2 == 0 and is_zero_weight(forces, n))


def duration_vanishes(forces: Forces, n: Key) -> bool:
    """Whether the coefficient of deltaⁿ in T is zero by theorem."""
    losses = forces.loss_degree(n)
    weightless = all(not k or w.is_zero for w, k in zip(forces.weights, n, strict=True))
    return sum(n) == losses == 1 or (weightless and losses % 2 == 1)


def map_vanishes(forces: Forces, i: int, n: Key) -> bool:
    """Whether the coefficient of deltaⁿ in F_i is zero by theorem; F_i = delta_i, exactly, if its weight is 0."""
    # F_i = delta_i e^(w_i L): exactly delta_i without a weight, and else every monomial has delta_i as a factor.
    if forces.weights[i].is_zero or not n[i] or sum(n) == 1:
        return False
    unit = unit_key(i, len(n))
    more = forces.loss_degree(n) - forces.loss_degree(unit)
    balanced = is_zero_weight(forces, tuple(a + b for a, b in zip(n, unit))) and more % 2 == 0
    dry = is_pure_at(forces, n) and not is_value(forces.velocities[i], 0) and negative_power(forces, n, 0)
    return not more or balanced or dry


def is_zero_weight(forces: Forces, n: Key) -> bool:
    """Whether a_n = 0, exactly."""
    weight = _weight(forces, n)
    return weight is not None and weight == 0


def is_pure_at(forces: Forces, n: Key) -> bool:
    """Whether only plain losses v|v|^(alpha−1) occur in the monomial: the linear spring, for which more is known."""
    return all(
        s < 0 and w == v - 1 for s, w, v, k in zip(forces.signs, forces.weights, forces.velocities, n, strict=True) if k
    )


def negative_power(forces: Forces, n: Key, shift: int) -> bool:
    """Whether only plain losses of integer exponents occur, with a negative power a_n + shift of the amplitude."""
    weight = _weight(forces, n)
    integers = all(v.is_integer for v, k in zip(forces.velocities, n, strict=True) if k)
    return is_pure_at(forces, n) and integers and weight is not None and weight + shift < 0


def dry_friction_cancels(forces: Forces, n: Key) -> bool:
    """Whether the coefficient of deltaⁿ in W is zero because of dry friction (the last two paragraphs above)."""
    if not is_pure_at(forces, n):
        return False
    others = [(a, k) for a, k in zip(forces.velocities, n, strict=True) if k and not is_value(a, 0)]
    degree, weight = sum(k for _, k in others), _weight(forces, n)
    if degree == sum(n) or weight is None:
        return False
    # n_0 = sum(n) - degree counts dry friction, and D^n_0 of a^w_2, w_2 = w + n_0, is zero for a whole 0 <= w_2 < n_0.
    power = weight + sum(n) - degree
    second = degree == 2 and power.denominator == 1 and 0 <= power < sum(n) - degree
    return second or (degree == 3 and len(others) == 1 and is_value(others[0][0], 3))


def is_linear_friction(forces: Forces, n: Key) -> bool:
    """Whether only linear friction occurs in the monomial."""
    return is_pure_at(forces, n) and all(not k or w.is_zero for w, k in zip(forces.weights, n, strict=True))


def _weight(forces: Forces, n: Key) -> Fraction | None:
    """a_n if it is found rational, else None.

    Roots may cancel, as in sqrt(2) + (2 - sqrt(2)).  Where a partial sum needs two roots the rest is not looked at: a_n
    may be rational then, and a zero that follows from it is left as a ball around 0.
    """
    total = ExactReal(0)
    for w, k in zip(forces.weights, n, strict=True):
        try:
            total += w * k
        except InputError:
            return None
    return total.rational if total.is_rational else None


def _with_dry_friction(alphas: Sequence[ExactReal], dry: int, order: int, max_seconds: float) -> tuple[Series, Series]:
    """L and T by the shifted centre, from the half-swing of the other laws."""
    others = [a for i, a in enumerate(alphas) if i != dry]
    one = Series.constant(arb(1), len(alphas), order)
    delta = Series.variable(dry, len(alphas), order, arb(1))
    if not others:
        return (one - delta * 2).log(), one * arb.pi()
    rest = certified_half_swing(others, order, max_seconds=max_seconds)
    L, T = (_shifted(f, others, dry) for f in (rest.L, rest.T))
    return ((one - delta) * L.exp() - delta).log(), T


def _shifted(f: Series, others: Sequence[ExactReal], dry: int) -> Series:
    """f(delta*): the monomial deltaⁿ becomes deltaⁿ (1 − delta_0)^{n·(alpha−1)}."""
    result = {}
    for n, c in f.coefficients.items():
        weight = _weight(Forces.losses(others), n)
        exponent = sum((k * (a.ball() - 1) for a, k in zip(others, n, strict=True)), arb(0))
        for j in range(f.order - sum(n) + 1):
            factor = _binomial(exponent if weight is None else weight, j)
            # An exact zero is left out, so that what is made of it stays exactly zero; a ball around 0 stays.
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
