"""The classical multiple-scale derivation, every exponent to any order: every order an object that shows itself.  The
method of multiple scales in the form of derivative expansion: D_n = d/dT_n, and the secular terms of each order vanish
by its solvability conditions, which are the rates f_n of the amplitude and g_n of the phase.

>>> derivation = multiple_scales(2, order=3)
>>> print(derivation.orders[1])
order 1: X_1(psi) + Derivative(X_1(psi), (psi, 2)) = -a**2*cos(psi)**2 + a**2 + 2*a*g_1*cos(psi) + 2*f_1*sin(psi)
  X_1(pi): 4*a**2/3 + pi*f_1 = 0
  V_1(pi): -pi*a*g_1 = 0
  D_1 a = f_1 = -4*a**2/(3*pi)
  D_1 psi = g_1 = 0
  solution: X_1(psi) = 4*a**2*psi*cos(psi)/(3*pi) + a**2*cos(psi)**2/3 - 2*a**2*cos(psi)/3 + a**2/3
>>> derivation.amplitude_rate, derivation.phase_rate
(-2*a**4*epsilon**3/(135*pi) - 4*a**2*epsilon/(3*pi), -a**2*epsilon**2/6 + 1)
>>> multiple_scales("3/2", order=2).phase_rate                  # any exponent
-12*a*epsilon**2/(25*pi) + 1
>>> multiple_scales(1, spring={3: 1}).phase_rate                # a Duffing spring: x'' + x + epsilon x' + c x^3 = 0
-15*a**4*c**2/256 + 3*a**2*c/8 - epsilon**2/8 + 1
>>> multiple_scales(3, order=3, gauge="turning-point").phase_rate     # the default there: no-first-harmonic
-45*a**4*epsilon**2/256 + 1
"""

from collections.abc import Sequence
from dataclasses import replace
from typing import Any

from sympy import Add, Expr, Mul, Symbol

from asymptotics.errors import InputError
from asymptotics.expansions.equations.given import terms_of
from asymptotics.expansions.half_swings.forces import Forces
from asymptotics.expansions.half_swings.pi_ring import PiNumber
from asymptotics.expansions.half_swings.symbolic import I_4, alpha
from asymptotics.expansions.multiple_scales.exact import odd_hierarchy
from asymptotics.expansions.multiple_scales.initial import map_to_turning_points
from asymptotics.expansions.multiple_scales.open_orders import open_scales
from asymptotics.expansions.multiple_scales.open_start import start_of_open, theta
from asymptotics.expansions.multiple_scales.orders import a, psi, strength_symbols
from asymptotics.expansions.multiple_scales.rates import Rates, certified_rates, closed_rates
from asymptotics.expansions.multiple_scales.start import start_of
from asymptotics.expansions.multiple_scales.symbolic import MultipleScales
from asymptotics.expansions.multiple_scales.symbolic import multiple_scales as smooth_multiple_scales
from asymptotics.expansions.multiple_scales.turning import TurningHierarchy
from asymptotics.expansions.multiple_scales.turning_orders import turning_scales
from asymptotics.gauges import NO_FIRST_HARMONIC, TURNING_POINT, require_gauge
from asymptotics.law import LawLike, SpringLike
from asymptotics.numbers.bridge import to_sympy
from asymptotics.numbers.policy import Number, exact_integer
from asymptotics.running.public import public
from asymptotics.terms import Term

# Both decide refusals only.  60: integer exponents, whose work grows like a power of the order and is estimated before
# it begins.  12: open orders, whose sums grow like the partitions of N; ``motion`` and ``solution`` end there as well.
MAX_ORDER, MAX_OPEN_ORDER = 60, 12
MAX_WRITTEN = 400
"""The largest integer exponent whose waveforms are written out: a polynomial of some thousand terms is read by nobody,
and at 1000 a minute is over before it stands.  Above it they are named integrals, as for any exponent."""
_EXIST = f"{TURNING_POINT} for any law, {NO_FIRST_HARMONIC} for polynomial forces"


@public
def multiple_scales(
    law: LawLike,
    *,
    order: int = 2,
    spring: SpringLike | None = None,
    gauge: str | None = None,
    max_seconds: Number = 60,
) -> MultipleScales:
    """The hierarchy of multiple scales T_0, T_1, ... solved through ``order``, for every law.

    Exact to any order for integer exponents; for others what closes is closed and the rest are named integrals, with
    certified digits where the exponents are numbers, through order 12.

    Parameters
    ----------
    law
        an exponent, a list of exponents, a law, an oscillator, or "symbolic"
    order
        the last order that is solved, 1 to 60
    spring
        springs beside the linear one, {P: c} or {(P, Q): c} for c x|x|^(P-1) |x'|^Q, or "pendulum"
    gauge
        "turning-point" or "no-first-harmonic"; by default the latter for polynomial forces (|x|^M x'|x'|^(A-1) with A
        odd and M even, springs with P odd and Q even), else the former
    max_seconds
        the time the call may take, in s

    Returns
    -------
    MultipleScales
        ``orders``, each with its equation, solvability conditions and solution; ``amplitude_rate`` and ``phase_rate``

    Raises
    ------
    InputError
        for an order out of range, an unknown gauge or one that does not exist for the law, and where |x|^M of odd M or
        x|x|^(P-1) of even P meets an order at which its derivative is no function
    LimitError
        for too much work, with the estimate

    Examples
    --------
    >>> multiple_scales("3/2", order=2).phase_rate
    -12*a*epsilon**2/(25*pi) + 1
    """
    N = exact_integer(order, "order", 1, MAX_ORDER)
    # The one text that is no exponent: a letter alpha, for which every coefficient must be a formula.
    if isinstance(law, str) and law.strip() == "symbolic":
        return symbolic_multiple_scales(() if spring is None else terms_of([], spring)[0], N, gauge)
    terms, _, _, notes = terms_of(law, spring)
    return replace(_of_terms(tuple(terms), N, gauge), notes=notes)


def _of_terms(terms: tuple[Term, ...], order: int, gauge: Any) -> MultipleScales:
    forces = Forces.of(terms, order)
    # The order of these branches is from what is exact to what is open: trigonometric polynomials in psi; polynomials
    # in psi, sin psi, cos psi on a half-swing; closed forms and integrals with certified digits for the rates.
    if _gauge(gauge, forces.is_smooth) == NO_FIRST_HARMONIC:
        return smooth_multiple_scales(terms, order)
    if forces.is_closed and all(t.velocity <= MAX_WRITTEN for t in terms):
        return turning_scales(terms, order)
    _require_open(order)
    # The open hierarchy numbers its symbols so: epsilon_i of the powers of the velocity, then all other forces, among
    # them losses that depend on the place.  ``ordered`` gives the terms of a law in that order.
    losses = tuple(t for t in terms if t.is_power_of_velocity)
    others = tuple(t for t in terms if not t.is_power_of_velocity)
    alphas = tuple(to_sympy(t.velocity) for t in losses)
    return open_scales(alphas, others, order, _numbers((*losses, *others), closed_rates(alphas, others, order), order))


def symbolic_multiple_scales(springs: tuple[Term, ...], order: int, gauge: Any = None) -> MultipleScales:
    """One loss with a symbolic exponent beside some springs; InputError as for ``multiple_scales``."""
    _gauge(gauge, smooth=False)
    _require_open(order)
    return open_scales((alpha,), springs, order, closed_rates((alpha,), springs, order))


def _numbers(terms: tuple[Term, ...], closed: tuple[Rates, Rates, int], order: int) -> tuple[Rates, Rates, int]:
    """Certified digits wherever no closed form in moments is known."""
    # Through the third order all rates of one loss are moments in closed form (of a sum through the second); Omega_4
    # holds the nested integral I_4(alpha).  From there on the closed ones without I_4 stay and certified numbers fill
    # the rest.
    if order <= min(closed[2], 3):
        return closed
    p, Omega = ({k: c for k, c in row.items() if not c.has(I_4)} for row in closed[:2])
    found = certified_rates(terms, order)
    return found[0] | p, found[1] | Omega, order


def _gauge(gauge: Any, smooth: bool) -> str:
    """The gauge asked for, or the default of the law; InputError for one that does not exist for it."""
    if gauge is None:
        return NO_FIRST_HARMONIC if smooth else TURNING_POINT
    require_gauge(gauge)
    if gauge == NO_FIRST_HARMONIC and not smooth:
        # In the turning-point gauge x' vanishes at psi = 0 and pi at every order, so that |x'|^A can be expanded there.
        reason = f"{gauge}: the zero of x' moves with the order there, and |x'|^A is no polynomial"
        raise InputError("gauge", reason, TURNING_POINT)
    if gauge not in (NO_FIRST_HARMONIC, TURNING_POINT):
        raise InputError("gauge", f"{gauge}: no hierarchy is made in it (the equations are: expand)", _EXIST)
    return str(gauge)


def _require_open(order: int) -> None:
    if order > MAX_OPEN_ORDER:
        reason = f"{order}: at these exponents the orders are integrals of sums that grow like the partitions of N"
        raise InputError("order", reason, f"1 to {MAX_OPEN_ORDER}, or integer exponents")


@public
def map_of_gauges(
    law: LawLike, *, order: int = 2, spring: SpringLike | None = None, max_seconds: Number = 60
) -> dict[str, Expr]:
    """The exact map from the gauge no-first-harmonic to turning-point: A = a exp(lambda), psi_tp = psi + chi.

    lambda and chi are series in the local strengths.

    Parameters
    ----------
    law
        an exponent, a list of exponents, a law or an oscillator
    order
        the last power of the strengths
    spring
        springs beside the linear one, {P: c} or {(P, Q): c} for c x|x|^(P-1) |x'|^Q, or "pendulum"
    max_seconds
        the time the call may take, in s

    Returns
    -------
    dict
        "A" and "psi_tp" -> SymPy expressions in a, psi and the strengths

    Raises
    ------
    InputError
        where the gauge no-first-harmonic does not exist

    Examples
    --------
    >>> found = map_of_gauges(3)
    >>> found["A"], found["psi_tp"]
    (-87*a**5*epsilon**2/2048 + a, 9*a**2*epsilon/32 + psi)
    """
    terms = terms_of(law, spring)[0]
    order = exact_integer(order, "order", 1, MAX_ORDER)
    _gauge(NO_FIRST_HARMONIC, Forces.of(terms, order).is_smooth)
    # The expansion without first harmonic is solved for its own turning points: their amplitude and phase are series in
    # the local strengths delta_i = strength_i a^(d_i - 1), which is where the powers of a below come from.
    change, symbols = map_to_turning_points(odd_hierarchy(terms, order)), strength_symbols(terms)
    weights = [to_sympy(t.weight) for t in terms]
    rows = []
    for series in (change.log_modulus.exp(), change.argument):
        local = [s * a**w for s, w in zip(symbols, weights)]
        parts = [c.to_sympy() if isinstance(c, PiNumber) else to_sympy(c) for c in series.coefficients.values()]
        rows.append(Add(*[c * Mul(*[d**n for d, n in zip(local, k)]) for k, c in zip(series.coefficients, parts)]))
    return {"A": (a * rows[0]).expand(), "psi_tp": psi + rows[1]}


def ordered(terms: Sequence[Term], scales: MultipleScales) -> list[Term]:
    """The terms in the order of the symbols of the hierarchy: where it does not close, powers of v come first."""
    # sorted() is stable: among forces of one kind the order in which they were given stays.
    closed = isinstance(scales.kernel, TurningHierarchy)
    return sorted(terms, key=lambda t: not closed and not t.is_power_of_velocity)


@public
def any_start(scales: MultipleScales, *, max_seconds: Number = 60) -> dict[str, Expr]:
    """a(0) and psi(0) for the start X(0) = r cos theta, X'(0) = -r sin theta, 0 < theta < pi.

    A start with X' > 0 is minus one of these: theta and psi move by pi.

    Parameters
    ----------
    scales
        what ``multiple_scales`` has returned, to any order where the waveforms are polynomials; of other exponents
        through order 2 of one law and 1 of a sum (``multiple_scales.open_start``)
    max_seconds
        the time the call may take, in s

    Returns
    -------
    dict
        "a(0)" and "psi(0)" -> SymPy expressions in r, theta and the strengths, through the order of ``scales``

    Raises
    ------
    InputError
        beyond these orders, in the gauge no-first-harmonic, and beside springs of an open hierarchy

    Examples
    --------
    >>> any_start(multiple_scales(2, order=1))["psi(0)"]
    -epsilon*r*sin(theta)*cos(theta)**2/3 + epsilon*r*sin(theta)/3 + theta
    >>> any_start(multiple_scales("3/2", order=1))["psi(0)"]
    2*epsilon*sqrt(r)*sin(theta)**(5/2)/5 + theta
    """
    if not isinstance(scales, MultipleScales):
        raise InputError("scales", f"a {type(scales).__name__}", "what multiple_scales returns")
    r = Symbol("r", positive=True)
    # ``losses`` names the exponents of an open hierarchy; a closed one has its waveforms in the kernel instead.
    if scales.losses:
        return _open_start(scales, r)
    if not isinstance(scales.kernel, TurningHierarchy):
        accepted = (
            f"gauge {TURNING_POINT}; powers of x' alone (others than integers to order 2), or integer powers of x', "
            "|x|^M of losses with M even, x|x|^(P-1) with P odd"
        )
        raise InputError("start", "no waveforms of closed form are at hand", accepted)
    found = start_of(scales.kernel)
    weights = [to_sympy(w) for w in scales.kernel.grading.weights]
    local = [s * r**w for s, w in zip(scales.symbols, weights)]
    rows = []
    for series in (found.amplitude, found.phase):
        # The key (0, ..., 0) stands for r and theta themselves, which are written apart below.
        terms = [
            (Mul(*[d**n for d, n in zip(local, k)]), c.to_sympy()) for k, c in series.coefficients.items() if any(k)
        ]
        rows.append(Add(*[scale * part for scale, c in terms for part in Add.make_args(c)]).subs(psi, theta))
    return {"a(0)": (r * (1 + rows[0])).expand(), "psi(0)": theta + rows[1]}


def _open_start(scales: MultipleScales, r: Expr) -> dict[str, Expr]:
    """The same from the closed waveforms of other exponents."""
    sizes, turns = start_of_open(scales.losses, len(scales.orders) - 1)
    local = [s * r ** (x - 1) for s, x in zip(scales.symbols, scales.losses)]
    # One entry for each law at first order; of one law at second order the entries are those of rho and rho^2.
    scale = local if len(sizes) == len(local) else [local[0], local[0] ** 2]
    size, turn = (Add(*[d * part for d, part in zip(scale, parts)]) for parts in (sizes, turns))
    return {"a(0)": r * (1 + size), "psi(0)": theta + turn}
