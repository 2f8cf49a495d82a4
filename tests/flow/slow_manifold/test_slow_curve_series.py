"""The series of the slow curve for a strength that is uncertain."""

from fractions import Fraction

from flint import arb, ctx

from asymptotics.flow.damping import Damping
from asymptotics.flow.slow_manifold.slow_curve_series import truncated
from asymptotics.numbers.exact import ExactReal


def test_the_series_of_an_uncertain_strength_holds_those_of_both_ends():
    with ctx.workprec(60):
        half = ExactReal(Fraction(1, 2))
        wide, *ends = (truncated(Damping.of([(e, half)]), 0, 4) for e in (arb(1, "0.1"), arb("0.91"), arb("1.09")))
        for end in ends:
            assert wide.epsilon.contains(end.epsilon)
            assert all(b.contains(c) for (b, _), (c, _) in zip(wide.b, end.b, strict=True))
