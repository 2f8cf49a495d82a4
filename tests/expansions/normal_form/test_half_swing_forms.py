"""The closed forms of a half-swing against its coefficients in balls, which know no closed form."""

import pytest
from flint import arb, fmpq

import asymptotics as asy
from asymptotics.errors import UndecidedError
from asymptotics.expansions.half_swings.forces import Forces
from asymptotics.expansions.normal_form.coefficients import half_swing_coefficients
from asymptotics.expansions.normal_form.digits import certified_digits, expansions
from asymptotics.expansions.normal_form.half_swing_forms import half_swing_forms
from asymptotics.numbers import parse_real
from asymptotics.numbers.bridge import closed_form_ball
from asymptotics.numbers.context import ctx
from asymptotics.numbers.gamma_sums import GammaSum
from asymptotics.terms import Term

FORCES = {
    "one": ["3/2"],
    "below one": ["1/3"],
    "irrational": ["sqrt(2)"],
    "dry beside": ["0", "5/2"],
    "two": ["1/2", "2"],
    "three": ["1/2", "1", "7/3"],
    "spring": [Term(1, "3/2"), Term(1, 0, 3, "position")],
    "place": [Term(1, "3/2", 2), Term(1, 0, 2, "position")],
    "speed in a spring": [Term(1, "1/2"), Term(1, 2, 1, "position")],
    "pendulum": [Term(1, "5/2"), Term(1, 0, 3, "position", "pendulum")],
}


def forces_of(given):
    return Forces.read([parse_real(x, "alpha") if isinstance(x, str) else x for x in given], 2)


def gaps(forces, changed=1):
    """Closed forms, times a number, that miss their balls."""
    with ctx.workprec(160):
        balls = expansions(forces, 2)
        return [
            (name, key)
            for name, row in half_swing_forms(forces).items()
            for key, c in row.items()
            if sum(key) <= 2
            and not arb(balls[name][key]).overlaps(
                changed * (c.ball() if isinstance(c, GammaSum) else closed_form_ball(c))
            )
        ]


@pytest.mark.parametrize("given", FORCES.values(), ids=FORCES)
def test_each_closed_form_is_in_its_ball(given):
    forces = forces_of(given)
    assert not gaps(forces)
    # Shown to be able to fail: a number that is off by 1e-30.
    assert ("F_0", (1,) + (0,) * (forces.variables - 1)) in gaps(forces, 1 + fmpq(1, 10**30))


@pytest.mark.parametrize("name", ["one", "two", "spring"])
def test_all_of_first_and_second_order_have_one(name):
    made = half_swing_coefficients(forces_of(FORCES[name]), 2, 20)
    rows = [made.log_ratio, made.duration, made.U, made.W, *made.map, *made.V]
    assert all(c.exact for row in rows for c in row.values())


def test_a_tie_of_fractional_exponents_is_rounded_to_even():
    """V of 3/4 beside 1: 1/8 exactly, which no ball rounds to two digits."""
    alphas = [parse_real(x, "alpha") for x in ("3/4", "1")]
    assert half_swing_coefficients(alphas, 2, 2).V[0]["1,1"].value == "0.12"
    with pytest.raises(UndecidedError, match="V_0"):
        certified_digits(alphas, 2, 2, names=["V_0"])


def test_a_table_is_rounded_down_where_its_numbers_end():
    """W_0 = F_1 = 1 and, of 3/2, T_2 = 12/25: each below its ball as often as not."""
    rows = {row[1]: row[2] for row in asy.table("half-swing", alpha="3/2", rows=2, digits=5, rounding="floor").rows}
    assert (rows["W_0"], rows["F_1"], rows["T_2"]) == ("1.0000", "1.0000", "0.48000")
