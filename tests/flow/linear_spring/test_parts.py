"""Parts of the bounds beside a linear spring that no motion shows at the full precision: each alone."""

from dataclasses import replace
from fractions import Fraction
from types import SimpleNamespace

import pytest
from flint import arb, ctx, fmpq

from asymptotics.errors import UndecidedError
from asymptotics.flow.damping import Damping
from asymptotics.flow.linear_spring.expansion import TurningExpansion
from asymptotics.flow.linear_spring.linear_spring import LinearSpring
from asymptotics.flow.slow_manifold.attraction import attracted
from asymptotics.flow.slow_manifold.slow_curve import caught
from asymptotics.flow.slow_manifold.slow_curve_series import truncated
from asymptotics.flow.slow_manifold.strong_damping import strong_damping_strip
from asymptotics.flow.turning import TurningState
from asymptotics.numbers.exact import ExactReal
from asymptotics.return_map import quarters
from asymptotics.return_map.half_swing_map import HalfSwingBalls
from asymptotics.return_map.panels import Panel
from asymptotics.return_map.quarters import HAND_OVERS, Bundle, Path
from asymptotics.return_map.sequence import following
from tests.return_map.test_quarters import LAWS, path_of


def damping(*terms):
    return Damping.of([(ExactReal(Fraction(e)).ball(), ExactReal(Fraction(a))) for e, a in terms])


def test_no_settling_beside_a_force_that_grows_faster_than_the_speed():
    """w n'/n is near 3 where the cubic loss is all: the region of the slow curve asks for less than 1."""
    with ctx.workprec(60):
        assert attracted(damping(("1/1000", "1/2"), ("1e35", "3")), arb("0.1"), arb(0), arb(0)) is None
        assert attracted(damping(("1", "1/1000")), arb("0.1"), arb(0), arb(0)) is not None


def test_no_slide_below_the_exponent_1():
    with ctx.workprec(60):
        for alpha, held in (("1/2", False), ("3/2", True)):
            law, w = damping(("1e6", alpha)), arb("0.001" if alpha == "1/2" else 1).mid()
            found = strong_damping_strip(law, law.resistance(w).mid(), w, w * arb("1e-9"))
            assert (found is not None) is held


def test_a_strip_that_begins_where_its_curves_were_not_checked_is_none():
    """The speed is known to a thirtieth: so wide a strip begins at a speed more than 1 % above it."""
    with ctx.workprec(60):
        law, y = damping(("1", "1/2")), arb(2) ** -10
        w = (y * y).mid()
        y = (law.resistance(w) * (1 - 2 * w * w / law.resistance(w) ** 2)).mid()
        assert caught(law, y, w, (w / 30).mid()) is None and caught(law, y, w, (w / 10**6).mid()) is not None


def test_the_series_of_an_uncertain_strength_holds_those_of_both_ends():
    with ctx.workprec(60):
        half = ExactReal(Fraction(1, 2))
        wide, *ends = (truncated(Damping.of([(e, half)]), 0, 4) for e in (arb(1, "0.1"), arb("0.91"), arb("1.09")))
        for end in ends:
            assert wide.epsilon.contains(end.epsilon)
            assert all(b.contains(c) for (b, _), (c, _) in zip(wide.b, end.b, strict=True))


def test_a_hand_over_behind_the_centre_is_undecided(monkeypatch):
    fake = SimpleNamespace(state=lambda _w: (arb("-0.1"), arb(1)))
    monkeypatch.setattr(quarters, "TurningExpansion", SimpleNamespace(at=lambda *_: fake))
    with ctx.workprec(60), pytest.raises(UndecidedError, match="hand-over"):
        Bundle.of([(damping(("1/10", "2")), 1)])


def test_a_hand_over_is_late_by_twice_what_half_of_its_place_is_off():
    with ctx.workprec(40):
        law, w = damping(("1/10", "2")), arb(HAND_OVERS[0])
        y, _ = TurningExpansion.at(law, arb(1), w).state(w)
        place = ((y * y + w * w).sqrt() + y) / w
        assert Bundle.of([(law, 1)]).dz >= place.log().rad() > 0


def test_the_arcs_of_the_ellipse_leave_no_gap(monkeypatch):
    """From the angle 0 to pi."""
    path, arcs = path_of(LAWS[0], 40), []

    class Recording:
        pi, union, sin_pi = staticmethod(arb.pi), staticmethod(arb.union), staticmethod(arb.sin_pi)

        def __call__(self, *given):
            return arb(*given)

        def cos_pi(self, angle):
            arcs.append((angle.lower(), angle.upper()))
            return angle.cos_pi()

    monkeypatch.setattr(quarters, "arb", Recording())
    with ctx.workprec(53):
        path.on_ellipse(arb("1.5"))
    assert arcs[0][0] <= 0 and arcs[-1][1] >= 1
    assert all(high >= low for (_, high), (low, _) in zip(arcs, arcs[1:]))


def test_the_load_on_the_ellipse_is_counted_whole():
    """One law: |f| is at most h max |s^2 D|/(1 - kappa), where kappa is at least |c D| at a place of the rim."""
    path, rim = path_of(LAWS[2], 40), arb("1.5")
    with ctx.workprec(53):
        fast, slow = path.on_ellipse(rim)
        drags = path.drags((path.sizes(rim) + path.sizes(1 / rim)) / 2)
        h, (a, b) = path.grid.bundle.h[0], ((rim + 1 / rim) / 2, (rim - 1 / rim) / 2)
        load, slowest = arb(0), arb(0)
        for k in range(257):
            angle = arb(fmpq(k, 256))
            x, y = h * (a * angle.cos_pi() - 1), h * b * angle.sin_pi()
            under = x.sinh() ** 2 + y.cos() ** 2
            drag = sum((d * under ** (-e / 2) for d, e in zip(drags, path.grid.bundle.alphas)), arb(0))
            load = load.max(drag * ((x.sinh() ** 2 + y.sin() ** 2) / under).sqrt())
            slowest = slowest.max(h / under.sqrt())
        assert slow >= slowest / (1 - load) * arb("0.9999") and fast > 0


def test_strengths_beyond_polar_coordinates_are_undecided(monkeypatch):
    path = path_of(LAWS[2], 40)
    monkeypatch.setattr(Path, "on_ellipse", lambda *_: (arb(1), arb(1)))
    with pytest.raises(UndecidedError, match="too large for polar"):
        replace(path, loads=tuple(1000 * load for load in path.loads)).enclosed(1.5)


def test_a_half_swing_read_off_carries_the_ratio_of_its_error():
    """Linear damping: q e/p, exactly."""
    with ctx.workprec(60):
        law, e, ratio = damping(("1/2", "1")), arb(2) ** -10, arb("0.5")
        here = TurningState(0, 1, arb(1), arb(0), e, arb(0))
        there = following(law, here, HalfSwingBalls(ratio, arb(3), "panels", 1, arb(0)))
        assert e * ratio <= there.amplitude_error < e * ratio * arb("1.01")


def test_the_losses_of_a_linear_spring_are_those_at_the_upper_end():
    law = damping(("1/2", "2"))
    with ctx.workprec(60):
        assert law.drag(arb(0), arb(1, "0.5")) >= arb("1.125")
        assert law.strongest(arb(1, "0.5"), arb(1)) >= 2


def test_a_closed_half_swing_begins_farther_than_its_error():
    spring = LinearSpring(damping(("1/2", "1")))
    with ctx.workprec(60):
        assert spring.closed(arb("0.01"), arb(0), arb("0.001")) is not None
        with pytest.raises(UndecidedError, match="holds the mass here"):
            spring.closed(arb("0.01"), arb(0), arb("0.02"))


def test_a_closed_half_swing_counts_the_friction_after_its_end():
    with ctx.workprec(30):
        law = damping(("1/2", "1"), ("1/10", "0"))
        found = LinearSpring(law).closed(arb(1), arb(0), arb(2) ** -10)
        assert found.errors.error >= arb(2) ** -10 + 4 * law.friction * found.clock.rad() * arb("0.999")
        alone = LinearSpring(law).closed(arb(1), arb(0), arb(0))
        assert alone.errors.error >= 4 * law.friction * alone.clock.rad() * arb("0.999") > 0


def test_at_the_exponent_1_a_next_turning_point_is_not_promised():
    assert LinearSpring(damping(("1/2", "3/2"))).endless and not LinearSpring(damping(("3", "1"))).endless
    assert not LinearSpring(damping(("3", "1"), ("1/2", "3/2"))).endless


def test_a_panel_holds_no_amplitude_that_may_be_0():
    panel = SimpleNamespace(low=arb(-1), high=arb(2))
    assert Panel.holds(panel, arb("0.5"), arb("0.25")) and not Panel.holds(panel, arb("0.5"), arb("0.75"))
