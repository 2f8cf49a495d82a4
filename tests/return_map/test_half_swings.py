"""Half-swings put together from quarters: they contain the pieces, and the residual is what they are off by."""

import pytest
from flint import arb, ctx

from asymptotics.errors import UndecidedError
from asymptotics.return_map.half_swing_map import integrated
from asymptotics.return_map.half_swings import HalfSwings
from tests.return_map.laws import coordinate


@pytest.mark.parametrize("pairs", [(("5/2", "1/5"),), (("1", "1/20"), ("3", "1/4")), (("3/2", "1/10"), ("2", "1/10"))])
def test_half_swings_contain_the_pieces(pairs):
    law, place = coordinate(pairs), arb("0.46875")
    with ctx.workprec(110):
        truth = integrated(law.damping(place), arb(1))
    for bits in (10, 40, 70):
        swings = HalfSwings.up_to(law, arb("0.5"), bits)
        with ctx.workprec(bits + 20):
            ratio, duration = swings(place)
        assert ratio.contains(truth.amplitude) and duration.contains(truth.duration)
        assert max(ratio.rad(), duration.rad()) < arb(2) ** (8 - bits)


@pytest.mark.parametrize(
    "pairs",
    [
        (("1.00000000000000000001", "1/2"), ("1.0000000001", "1/2")),
        (("sqrt(3/2)", "1/20"), ("sqrt(2)", "1/10")),
        (("3/2", "1/10"), ("1.50000000000000000001", "1/10"), ("sqrt(5)", "1/30")),
    ],
)
def test_half_swings_over_a_stretch_of_ln_a_contain_the_pieces(pairs):
    law, place = coordinate(pairs), arb("-0.53125")
    with ctx.workprec(110):
        truth = integrated(law.damping(place), arb(1))
    assert law.is_quartered and not law.from_zero
    for bits in (10, 40, 70):
        swings = HalfSwings.between(law, arb("-0.75"), arb("-0.5"), arb("1.875"), bits)
        with ctx.workprec(bits + 20):
            ratio, duration = swings(place)
            assert swings.forwards.place(arb("-0.5")) <= 1 and swings.backwards.place(arb("-2.625")) >= -1
        assert ratio.contains(truth.amplitude) and duration.contains(truth.duration)
        assert max(ratio.rad(), duration.rad()) < arb(2) ** (8 - bits)


def test_the_residual_of_a_half_swing_is_what_it_is_off_by(monkeypatch):
    """The derivative of the equation is near 1: a guess off by e is paid for, and half of that is refuted."""
    e, law, place = arb(2) ** -20, coordinate((("2", "1/100"),)), arb("0.5")
    swings = HalfSwings.up_to(law, arb("0.5"), 40)
    with ctx.workprec(60):
        truth = swings(place)[0]
        near = truth.log().mid()
        monkeypatch.setattr(HalfSwings, "_near", lambda *given: near + e)
        ratio, duration = swings(place)
        missing = abs(ratio.mid() - truth)
        assert missing <= ratio.rad() and ratio.rad() / 2 < missing and duration.rad() < e


def test_an_amplitude_beyond_the_interval_is_refused():
    swings = HalfSwings.up_to(coordinate((("2", "1/5"),)), arb("0.5"), 30)
    with pytest.raises(UndecidedError, match="outside the interval"):
        swings(arb("0.51"))
