"""Creep between two barriers: against a stiff integrator, against Taylor steps, and with the barriers moved."""

from dataclasses import replace
from itertools import pairwise

import pytest
from flint import arb, ctx
from scipy.integrate import solve_ivp

from asymptotics.errors import UndecidedError
from asymptotics.flow.damping import Damping
from asymptotics.flow.linear_spring import linear_spring
from asymptotics.flow.linear_spring.linear_spring import Creep, LinearSpring
from asymptotics.flow.slow_manifold.slow_curve import SlowCurve, _grown, caught, one_way, solve
from asymptotics.flow.slow_manifold.slow_curve_series import Truncated, summed, truncated
from asymptotics.flow.trajectory import half_swing_pieces
from asymptotics.law import Law, Oscillator
from asymptotics.motions.reference import reference_motion
from asymptotics.numbers.exact import parse_real
from tests.flow.forces import by_strength
from tests.worlds import CREEPING, pairs_of

MIXED = ("a root", "an irrational root", "a tenth beside three halves", "a root beside the linear one")


def damping(law):
    return Damping.of([(parse_real(e, "e").ball(), parse_real(a, "a")) for a, e in dict(law).items()])


def creeping(law, bits, start="9/10"):
    """The first piece of the half-swing from rest that is a creep, and the damping, at so many bits."""
    with ctx.workprec(bits):
        law = damping(law)
        place = parse_real(start, "x").ball().mid()
        return next(
            piece for piece in half_swing_pieces(LinearSpring(law), place, arb(0)) if isinstance(piece, Creep)
        ), law


def stiff(alpha, epsilon, y, w, time):
    """(y, w) by an implicit method in doubles, in ln w."""

    def force(_, state):
        return [-state[1], state[0] - epsilon * max(state[1], 0) ** alpha]

    found = solve_ivp(force, (0, time), [y, w], "Radau", rtol=1e-9, atol=1e-15)
    return found.y[:, -1]


@pytest.mark.parametrize("law", pairs_of(*CREEPING))
def test_a_ladder_of_precisions(law):
    for bits in (40, 64, 100) if len(law) == 1 else (40, 60):
        piece, _ = creeping(law, bits)
        sharper, _ = creeping(law, 2 * bits)
        begin = max(piece.begin, sharper.begin, key=float)
        for time in ("0.001", "1", "1000", "1e18"):
            with ctx.workprec(2 * bits):
                exact = sharper.own(begin + arb(time).mid())
            with ctx.workprec(bits):
                found = piece.own(begin + arb(time).mid())
                assert all(map(arb.contains, found, exact))
                assert found[0].rad() < arb(2) ** (32 - bits), "about as narrow as the error of the pieces"


@pytest.mark.parametrize(("alpha", "epsilon"), [(0.5, 1.0), (0.25, 2.0), (0.8, 4.0)])
def test_a_stiff_integrator_agrees(alpha, epsilon):
    piece, _ = creeping({str(alpha): str(epsilon)}, 80)
    with ctx.workprec(80):
        y, w = (float(value.mid()) for value in piece.own(piece.begin))
        for time in (0.5, 5.0, 50.0):
            own = piece.own(piece.begin + arb(time))
            assert [float(value.mid()) for value in own] == pytest.approx(stiff(alpha, epsilon, y, w, time), rel=1e-5)


@pytest.mark.parametrize("law", pairs_of(*MIXED))
def test_taylor_steps_pass_between_the_barriers(law, monkeypatch):
    piece, _ = creeping(law, 80)
    monkeypatch.setattr(linear_spring, "caught", lambda *_: None)
    with ctx.workprec(240):
        exact = damping(law)
        for count, step in enumerate(
            half_swing_pieces(LinearSpring(exact), parse_real("9/10", "x").ball().mid(), arb(0))
        ):
            if step.begin > piece.begin and count % 7 == 0:
                y, w = step.own(step.begin)
                with ctx.workprec(80):
                    assert all(map(arb.contains, piece.own(step.begin), (y, w)))
                    assert all(value.rel_accuracy_bits() > 30 for value in piece.own(step.begin))
            if count > 150:
                break


def test_the_strip_is_not_much_wider_than_what_it_must_hold():
    piece, _ = creeping({"1/2": "1"}, 100)
    with ctx.workprec(100):
        y, w = piece.own(piece.begin)
        assert 0 < float(y.rad() / y) < 2e-26


@pytest.mark.parametrize("law", pairs_of("a root", "a tenth beside three halves"))
def test_half_the_strip_is_not_proved(law):
    with ctx.workprec(120):
        series = truncated(damping(law), 0, 3)
        most = arb("1e-4").log()
        least = (
            sum(((c * (e * most).exp()) for c, e in series.neglected), arb(0))
            / series.alpha
            / (series.cut * most).exp()
        )
        assert one_way(series, arb("1.2") * least, most)
        assert not one_way(series, arb("0.9") * least, most)
        # and rightly: the powers that are left have one sign, so a curve with half of it is crossed the other way
        for share, sign in (("1.2", 1), ("0.5", -1), ("-0.5", -1)):
            below = SlowCurve(
                series.epsilon, series.alpha, series.others, (*series.b, (arb(share) * least, series.cut))
            )
            assert crossing(below, damping(law), most) * sign > 0


def crossing(curve, law, log_w):
    """(d(y - Y)/d tau)/w on the curve, from the equation of motion."""
    w = log_w.exp()
    y, slope = curve.place(log_w)
    return -1 - slope / w * (y - law.resistance(w)) / w


@pytest.mark.parametrize("sign", [-1, 1])
@pytest.mark.parametrize("law", pairs_of("a tenth", "a tenth beside three halves"))
def test_on_the_barriers_the_motion_crosses_as_proved_down_to_nothing(law, sign):
    piece, _ = creeping(law, 80)
    found = piece.strip.above if sign < 0 else piece.strip.below
    with ctx.workprec(900):
        exact = next(s for s in (truncated(damping(law), 0, n) for n in range(1, 99)) if len(s.b) == len(found.b) - 1)
        theta, cut = found.b[-1]
        curve = SlowCurve(exact.epsilon, exact.alpha, exact.others, (*exact.b, (theta.mid(), cut)))
        for factor in (1, arb("0.5"), arb("1e-3"), arb("1e-9")):
            assert sign * crossing(curve, damping(law), piece.strip.starts[0].mid() + arb(factor).log()) > 0


@pytest.mark.parametrize(
    ("others", "b", "rest", "edge"),
    [(0, 0, 0, 0.1), (0, 0.05, 0, 0.07), (0, 0.12, 0, 0.008), (0.2, 0, 0, 0.08), (0.12, 0.04, 0, 0.064)],
)
def test_a_curve_is_crossed_one_way_up_to_an_edge(others, b, rest, edge):
    """alpha = 1/2, r w^1, b w^1 and theta w^2 at w = 1/8: rest + drift (...) < drift/2 and ... < 1/4, by hand."""
    w, half, one = arb("0.125"), arb("0.5"), arb(1)
    for sign in (1, -1):
        series = Truncated(one, half, ((others / w, one),), ((sign * b / w, one),), arb(2), ((rest / w**2, arb(2)),))
        for share, holds in (("0.999", True), ("1.001", False)):
            assert one_way(series, arb(share) * edge / w**2, w.log()) is holds


def test_what_is_left_over_must_be_less_than_the_drift():
    """2.5 drift^2 - drift/2 + 0.01 < 0 begins at drift = 0.0225."""
    w, half, least = arb("0.125"), arb("0.5"), (arb("0.5") - arb("0.15").sqrt()) / 5
    series = Truncated(arb(1), half, (), (), arb(2), ((arb("0.01") / w**2, arb(2)),))
    assert one_way(series, arb("1.001") * least / w**2, w.log())
    assert not one_way(series, arb("0.999") * least / w**2, w.log())


def test_the_speeds_at_a_height_are_those_between_the_curves():
    """Within the factor 2 that A > alpha/2 leaves and the tenth of the blur, no less and no more."""
    strip = creeping({"1/2": "1"}, 80)[0].strip
    with ctx.workprec(300):
        log_w = strip.starts[0].mid() - 3
        low, high = (replace(c, b=tuple((k.mid(), e.mid()) for k, e in c.b)) for c in (strip.below, strip.above))
        apart = (high.place(log_w)[0] - low.place(log_w)[0]) / high.place(log_w)[1]
        blur = (strip._speed(log_w) * (-log_w).exp() - 1).upper()
        assert apart <= blur and float(blur / apart) == pytest.approx(2.2, rel=0.01)
        last, cut = strip.above.b[-1]
        for text, served in (("0.094", True), ("0.096", False)):  # E blur < ln(11/10) = 0.0953
            wide = replace(strip, share=arb(text) / cut * (-cut * log_w).exp() * 10 / 11)
            if served:
                assert wide._speed(log_w).is_finite()
            else:
                with pytest.raises(UndecidedError, match="too wide"):
                    wide._speed(log_w)


@pytest.mark.parametrize("law", pairs_of(*CREEPING))
@pytest.mark.parametrize("order", [1, 3])
def test_the_rest_is_what_the_cut_leaves(law, order):
    """|A B - w^(2-2 alpha)/epsilon^2| at one place in 300 bits: at most the rest, whose powers begin at the cut."""
    with ctx.workprec(300):
        exact = damping(law)
        leading = min(range(len(exact.sizes)), key=lambda i: exact.sizes[i][1])
        series = truncated(exact, leading, order)
        log_w = arb("1e-3").log()
        curve = SlowCurve(series.epsilon, series.alpha, series.others, series.b)
        first = ((2 - 2 * series.alpha) * log_w).exp() / series.epsilon**2
        left = (series.alpha + summed(curve.a, log_w)) * summed(series.b, log_w) - first
        rest = summed(series.neglected, log_w)
        assert abs(left) < rest * (1 + arb(2) ** -60)
        assert len(law) > 1 or abs(left) > rest * (1 - arb(2) ** -25), "all of one sign"
        assert all(e >= series.cut for _, e in series.neglected)
        assert any(e <= series.cut * (1 + arb(2) ** -39) for _, e in series.neglected)


def test_a_corrupted_coefficient_does_not_hold_the_motion(monkeypatch):
    piece, law = creeping({"1/2": "1"}, 80)
    with ctx.workprec(80):
        y, w = piece.own(piece.begin)
        error = arb(2) ** -70
        assert caught(law, y.mid(), w.mid(), error) is not None
        for factor in (2, arb("1.001")):
            assert caught(law, y.mid(), (w * factor).mid(), error) is None
        assert caught(law, (y * arb("1.000001")).mid(), w.mid(), error) is None
        (first, power), *more = piece.strip.above.b
        above = replace(piece.strip.above, b=((first * arb("1.0001"), power), *more))
        wrong = replace(piece.strip, above=above, below=replace(above))
        assert not wrong.state(arb(3))[1].overlaps(piece.strip.state(arb(3))[1])


def test_a_root_beyond_the_checked_speeds_is_none():
    piece, _ = creeping({"1/2": "1"}, 80)
    with ctx.workprec(80):
        beyond = replace(piece.strip, most=piece.strip.starts[0].lower() - 1)
        with pytest.raises(UndecidedError, match="begins"):
            beyond.state(arb("0.001"))


def test_newton_encloses_the_root():
    with ctx.workprec(60):
        root = solve(lambda x: (x.exp(), x.exp()), arb(3), arb(5))
        with ctx.workprec(200):
            assert root.contains(arb(3).log()) and root.rad() < 1e-15
        wide = solve(lambda x: (x.exp() + arb(0, "1e-6"), x.exp()), arb(3), arb(1))
    assert wide.contains((arb(3) + arb("1e-6")).log()) and wide.contains((arb(3) - arb("1e-6")).log())


def test_late_times_and_small_exponents_are_served():
    creep = Oscillator(Law({"1/2": "1/10"}))
    late = [reference_motion(creep, time, 12) for time in ("1e4", "1e6", "1e12")]
    for earlier, later in pairwise(late):
        assert later.certified and abs(float(later.x)) < abs(float(earlier.x))
    # x -> eps^2/(t - t_0), where t_0 is what the oscillations before have left behind
    elapsed = [float(time) - 0.01 / abs(float(point.x)) for time, point in zip((1e4, 1e6), late)]
    assert elapsed[0] == pytest.approx(elapsed[1], abs=0.01)
    assert float(late[-1].x) == pytest.approx(-1e-14, rel=1e-9)
    assert reference_motion(Oscillator(Law({"1/100": 1}), x0="0.99"), 100, 8).x == "0.91069388"


def test_the_strip_holds_every_state_that_enters():
    """Twice what the state's error alone needs, the powers that are left being small: half of that is too low."""
    law = damping({"1/10": "3"})
    with ctx.workprec(120):
        e, w = arb("1e-8").mid(), arb("1e-4").mid()
        y = law.resistance(w).mid()
        strip = caught(law, y, w, e)
        above = strip.above.place((w - e).log())[0] - (y + e)
        below = (y - e) - strip.below.place((w + e).log())[0]
        height = strip.above.place(w.log())[0] - y
        assert height / 3 < above < height and height / 3 < below < height


def test_a_strip_begins_at_every_height_of_the_state():
    """At the entrance both ends of y +- e are in it, and hardly more."""
    law = damping({"1/10": "3"})
    with ctx.workprec(120):
        e, w = arb("1e-8").mid(), arb("1e-4").mid()
        y = law.resistance(w).mid()
        found, _ = caught(law, y, w, e).state(arb(0))
        for side in (1, -1):
            assert found.contains(y + side * e * arb("0.999")) and not found.contains(y + side * e * arb("1.01"))


@pytest.mark.parametrize("log_w", ["-3", "0.5"])
def test_a_power_that_may_be_a_logarithm_holds_both(log_w):
    log_w, e = arb(log_w), arb("0.02")
    found = _grown(arb(0, e), log_w)
    assert found.contains(log_w) and found.rad() < 2 * e * log_w**2
    assert all(found.contains(((d * log_w).exp() - 1) / d) for d in (e, -e, e / 2, -e / 2))


def test_newton_claims_no_root_where_there_is_none():
    """x^2 + 1 has none, and no box about any x holds its own Newton step."""
    with ctx.workprec(60), pytest.raises(UndecidedError):
        solve(lambda x: (x * x + 1, 2 * x), arb(0), arb("0.7"))


def test_a_strip_that_begins_where_its_curves_were_not_checked_is_none():
    """The speed is known to a thirtieth: so wide a strip begins at a speed more than 1 % above it."""
    with ctx.workprec(60):
        law, y = by_strength(("1", "1/2")), arb(2) ** -10
        w = (y * y).mid()
        y = (law.resistance(w) * (1 - 2 * w * w / law.resistance(w) ** 2)).mid()
        assert caught(law, y, w, (w / 30).mid()) is None and caught(law, y, w, (w / 10**6).mid()) is not None
