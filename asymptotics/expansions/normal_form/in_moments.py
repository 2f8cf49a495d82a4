"""The lowest coefficients of an expansion as closed forms in moments, for whatever the moments are.

A formula takes the moments from a module: of ``moments.exact`` for rational exponents, of ``moments.symbolic`` for
irrational ones and for a symbol; the proofs are told in ``normal_form.symbolic`` and ``normal_form.spring_terms``.

>>> from asymptotics.numbers import parse_real
>>> closed_forms([parse_real("3/2", "alpha")], 2, TURNING_POINT)["Omega"]
{(2,): -12/(25*pi)}
>>> closed_forms([parse_real("1", "alpha"), parse_real("3/2", "alpha")], 2, TURNING_POINT)["Omega"][1, 1]
-3*gamma(7/4)/(5*sqrt(pi)*gamma(9/4))
"""

from collections.abc import Callable, Sequence
from importlib import import_module
from types import ModuleType
from typing import Any

from asymptotics.expansions.half_swings.forces import Forces, Given
from asymptotics.expansions.moments import exact
from asymptotics.expansions.normal_form.spring_terms import first_order, second_order_p
from asymptotics.gauges import AVERAGING, NO_FIRST_HARMONIC, TURNING_POINT, require_gauge
from asymptotics.series import Key

Moment = Callable[[Any], Any]


def moments_of(forces: Forces) -> ModuleType:
    """The module of moments in which the forces have their closed forms."""
    if all(m.velocity.is_rational for m in forces.members):
        return exact
    # SymPy, which takes longer to load than most expansions take to be computed.
    return import_module("asymptotics.expansions.moments.symbolic")


def closed_forms(given: Given, order: int, gauge: str) -> dict[str, dict[Key, Any]]:
    """First order always, Omega_2 of one plain loss in any gauge; at turning points p_3 and second orders."""
    forces = Forces.read(given, order)
    moments = moments_of(forces)
    U, W = first_order(forces, moments)
    known = {"p": {k: -u for k, u in U.items()}, "Omega": {k: -w for k, w in W.items()}}
    exponents = [moments.number(m.velocity) for m in forces.members]
    if forces.is_pure and forces.variables == 1:
        known["Omega"][2,] = omega_2(exponents[0], moments.moment, gauge)
        if gauge == TURNING_POINT:
            known["p"][3,] = rates(*flow_through_third_order(exponents[0], moments.moment))[0][3]
    elif forces.is_pure and gauge == TURNING_POINT:
        known["Omega"] = {k: -w for k, w in second_order_sum(exponents, moments.moment).items()}
    elif gauge == TURNING_POINT:
        known["p"] |= second_order_p(forces, moments)
    return known


def flow_through_third_order(a: Any, moment: Moment) -> tuple[dict[int, Any], dict[int, Any]]:
    """U_1, U_3 and W_2 of one plain loss in the turning-point gauge (``normal_form.symbolic``)."""
    U_3 = -a * (3 * a + 1) / (6 * (a + 1) ** 2) * moment(3 * a + 1)
    return {1: -moment(a + 1), 3: U_3}, {2: (a / (a + 1)) ** 2 * moment(2 * a)}


def rates(U: dict[int, Any], W: dict[int, Any]) -> tuple[dict[int, Any], dict[int, Any]]:
    """p = -U/W and Omega = 1/W - 1 through third order, or through fourth where W_4 is given."""
    fourth = {4: W[2] ** 2 - W[4]} if 4 in W else {}
    return {1: -U[1], 3: -U[3] + U[1] * W[2]}, {2: -W[2], **fourth}


def omega_2(a: Any, moment: Moment, gauge: str) -> Any:
    """Omega_2 of one plain loss in any of the three gauges (``normal_form.symbolic``)."""
    require_gauge(gauge)
    # What the argument of c, chi_1 delta, adds: -(alpha - 1) p_1 chi_1 delta^2, with chi_1 of that docstring.
    shift = {
        TURNING_POINT: 0,
        AVERAGING: (a - 1) / (a + 1),
        NO_FIRST_HARMONIC: (a - 1) * (a + 3) / (2 * (a + 1)),
    }[gauge]
    return -((a / (a + 1)) ** 2) * moment(2 * a) + shift * moment(a + 1) ** 2


def second_order_sum(alphas: Sequence[Any], moment: Moment) -> dict[tuple[int, ...], Any]:
    """W at second order for a sum of laws: sum_ij alpha_i alpha_j/((alpha_i+1)(alpha_j+1)) M_(alpha_i+alpha_j) d_i d_j.

    Keys are exponents of the delta_i; the cross terms carry the factor 2.  U has no second-order term.

    >>> second_order_sum([exact.number(1), exact.number(2)], exact.moment)
    {(2, 0): 1/8, (1, 1): 8/(9*pi), (0, 2): 1/6}
    """
    found: dict[tuple[int, ...], Any] = {}
    for i, a in enumerate(alphas):
        for j, b in enumerate(alphas[i:], start=i):
            key = tuple((k == i) + (k == j) for k in range(len(alphas)))
            term = a * b * moment(a + b) / ((a + 1) * (b + 1))
            # The pairs (i, j) and (j, i) have one key.
            found[key] = term * (1 if i == j else 2)
    return found
