"""The half-swing through second order as closed forms in moments, by which rationals and ties are told.

Along a half-swing dL/dpsi = U and dtau/dpsi = W, and a monomial x of the local strengths, of weight w_x, grows as
dx/dpsi = w_x U x.  With u and v the coefficients of U and W - 1 at first order, and x and y of first order,

    L = pi U_1 + pi U_2 + pi^2/2 sum_xy w_x u_x u_y x y,    T = pi + pi W_1 + pi W_2 + pi^2/2 sum_xy w_x v_x u_y x y,
    F_i = delta_i (1 + w_i L_1),    V_i = w_i delta_i U_1.

U has odd loss degrees alone and W even ones (``digits``).

>>> from asymptotics.numbers import parse_real
>>> found = half_swing_forms(Forces.read([parse_real("3/2", "alpha")], 2))
>>> found["T"], found["F_0"][1,]
({(0,): pi, (2,): 12/25}, 1)
>>> [round(float(found["L"][k,].ball().mid()), 6) for k in (1, 2)]
[-1.437768, 0.516794]
"""

from types import ModuleType
from typing import Any

from asymptotics.expansions.half_swings.forces import Forces
from asymptotics.expansions.normal_form.in_moments import moments_of, second_order_sum
from asymptotics.expansions.normal_form.spring_terms import first_order, second_order_cross
from asymptotics.series import Key

ClosedForms = dict[Key, Any]


def half_swing_forms(forces: Forces) -> dict[str, ClosedForms]:
    """L, T, U, W, F_i and V_i at first order, and at second order where U_2 and W_2 have a closed form."""
    moments = moments_of(forces)
    pi, weights, places = moments.PI, [moments.number(w) for w in forces.weights], range(forces.variables)
    U, W = first_order(forces, moments)
    U_2, W_2 = second_order_cross(forces, moments), _of_losses(forces, moments)

    def of_order_two(first: ClosedForms, second: ClosedForms) -> ClosedForms:
        """What a rate adds up to over pi, second order."""
        found = {key: pi * c for key, c in second.items()}
        for x, c in first.items():
            weight = sum(n * w for n, w in zip(x, weights))
            for y, u in U.items():
                found[_product(x, y)] = found.get(_product(x, y), 0) + pi * pi * (weight * c * u) / 2
        return found

    L_1, one = {key: pi * u for key, u in U.items()}, pi / pi
    rows = {
        "L": L_1 | of_order_two(U, U_2),
        "T": {(0,) * forces.variables: pi} | {key: pi * w for key, w in W.items()} | of_order_two(W, W_2),
        "U": U | U_2,
        "W": {(0,) * forces.variables: one} | W | W_2,
    }
    for i, weight in enumerate(weights):
        delta = tuple(int(i == j) for j in places)
        rows[f"F_{i}"] = {delta: one} | {_product(delta, x): weight * c for x, c in L_1.items()}
        rows[f"V_{i}"] = {_product(delta, x): weight * u for x, u in U.items()}
    return rows


def _of_losses(forces: Forces, moments: ModuleType) -> ClosedForms:
    """W at second order in the losses, where these are powers of the velocity."""
    places = [i for i, sign in enumerate(forces.signs) if sign < 0]
    part = forces.only(places, 2)
    if not places or not part.is_pure:
        return {}
    row = second_order_sum([moments.number(v) for v in part.velocities], moments.moment)
    return {forces.embedded(key, places): w for key, w in row.items()}


def _product(x: Key, y: Key) -> Key:
    return tuple(a + b for a, b in zip(x, y))
