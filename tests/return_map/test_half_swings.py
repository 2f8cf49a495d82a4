"""Half-swings put together from quarters: they contain the pieces, and the residual is what they are off by."""

from dataclasses import replace

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
    swings = replace(HalfSwings.up_to(law, arb("0.5"), 40), guess=None)
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


@pytest.mark.parametrize("pairs", [(("3/2", "1"),), (("1", "1/20"), ("2", "1"))])
def test_the_guess_is_read_off_and_a_bad_one_is_paid_for(pairs):
    """Nobody proves the guess: one that is off by e is paid for, and half of that is refuted."""
    law, place, e = coordinate(pairs), arb("0.25"), arb(2) ** -20
    swings = HalfSwings.up_to(law, arb("0.3125"), 60)
    with ctx.workprec(70):
        truth = integrated(law.damping(place), arb(1))
        ratio, duration = swings(place)
        assert ratio.contains(truth.amplitude) and ratio.rad() < arb(2) ** -50
        wrong = replace(swings, guess=swings.guess + e)
        ratio, late = wrong(place)
        missing = abs(ratio.mid() - truth.amplitude)
        assert missing <= ratio.rad() and ratio.rad() / 2 < missing and late.contains(truth.duration)
        assert late.rad() < e and duration.rad() < arb(2) ** -50


@pytest.mark.parametrize("pairs", [(("5/4", "1"),), (("3/2", "1"),), (("1", "1/20"), ("3", "1"))])
def test_the_duration_is_that_of_every_place_in_the_ball(pairs):
    """The ends of a wide ball: T of both lies inside, and the ratio is that of the middle."""
    law, place, wide = coordinate(pairs), arb("0.25"), arb("0.25", arb(2) ** -6)
    swings = HalfSwings.up_to(law, arb("0.3125"), 50)
    with ctx.workprec(60):
        ratio, duration = swings(place, wide)
        alone = swings(place)
        assert ratio.mid() == alone[0].mid() and ratio.rad() == alone[0].rad() and duration.contains(alone[1].mid())
        gaps = []
        for end in (wide.lower(), wide.upper()):
            there = integrated(law.damping(end), arb(1))
            assert duration.contains(there.duration)
            gaps.append(abs(there.duration - duration.mid()))
        assert duration.rad() < 60 * max(gaps, key=float)


def test_each_of_the_two_balls_of_a_duration_is_needed(monkeypatch):
    """The quarter before the centre is that of the ball of starts, the one after it that of the ball of ends."""
    swings = HalfSwings.up_to(coordinate((("2", "1"),)), arb("0.25"), 40)
    seen = []
    honest = swings.forwards.duration
    counted = replace(swings.forwards, duration=lambda t: seen.append(t) or honest(t))
    place, wide = arb("0.125"), arb("0.125", arb(2) ** -10)
    ratio, _ = replace(swings, forwards=counted, backwards=counted)(place, wide)
    start, end = seen
    assert start.contains(swings.forwards.place(wide.lower())) and start.contains(swings.forwards.place(wide.upper()))
    # In ln A two motions do not part: z_end (1 + r) and z_end/(1 + r) both lie inside, and little more.
    r, last = arb(2) ** -7, -place * ratio
    for factor in (1 + r, 1 / (1 + r), 1 - r, 1 / (1 - r)):
        assert end.contains((swings.backwards.place(last * factor)).mid())
    assert not end.contains(swings.backwards.place(last * (1 + r * arb("1.05"))).mid())


def test_an_interval_from_zero_holds_no_place_that_may_be_outside():
    swings = HalfSwings.up_to(coordinate((("2", "1/5"),)), arb("0.5"), 30)
    assert swings.holds(arb("0.5")) and swings.holds(arb("0.25", "0.2499")) and swings.holds(arb(2) ** -900)
    assert (
        not swings.holds(arb("0.26", "0.245")) and not swings.holds(arb("0.125", "0.13")) and not swings.holds(arb(0))
    )


@pytest.mark.parametrize("pairs", [(("3/2", "1"),), (("1", "1/20"), ("2", "1"))])
@pytest.mark.parametrize("place", ["1e-40", "1e-12", "0.3125"])
def test_the_ends_of_an_interval_from_zero_are_served(pairs, place):
    """A rounded place next to 0 or to the last one is told to lie inside; refused for (1, 2) before."""
    law, bits = coordinate(pairs), 40
    swings = HalfSwings.up_to(law, arb("0.3125"), bits)
    with ctx.workprec(bits):
        z = arb(place).mid()
        found = swings.half_swing(z, arb(z, z * arb(2) ** -30))
    with ctx.workprec(110):
        truth = integrated(law.damping(z), arb(1))
    assert found.amplitude.contains(truth.amplitude) and found.duration.contains(truth.duration)
    assert found.amplitude.rad() < arb(2) ** -28
