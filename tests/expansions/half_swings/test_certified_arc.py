"""The time and the amplitude at an angle: up to the middle it is the quarter swing."""

from flint import arb

from asymptotics.expansions.half_swings.certified import quarter_swing
from asymptotics.expansions.half_swings.certified_arc import arc
from asymptotics.expansions.half_swings.forces import Forces
from asymptotics.numbers.context import ctx
from asymptotics.terms import Term


def test_an_arc_to_the_passage_is_the_quarter_swing():
    with ctx.workprec(100):
        forces = Forces.of([Term(1, "1/2"), Term(1, "3/2")], 3)
        whole, (R, tau) = quarter_swing(forces, 3), arc(forces, 3, arb.pi() / 2)
        for k, c in whole.R.coefficients.items():
            assert c.overlaps(R[k]) and whole.T_q[k].overlaps(tau[k]) and R[k].rad() < 1e-25
