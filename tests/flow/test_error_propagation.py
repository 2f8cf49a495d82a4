"""How far motions part: growth, gaps and delays, each attained or seen where a part of it is left out."""

from dataclasses import dataclass

import mpmath
import pytest
from flint import arb, ctx

from asymptotics.errors import UndecidedError
from asymptotics.flow import error_propagation
from asymptotics.flow.error_propagation import growth, points_forward, state_gap, turning_delay, turning_gap
from asymptotics.numbers.exact import parse_real
from tests.flow.forces import FREE, NOTHING, Steep, damping_of, in_a_well
from tests.flow.forces import WELLS as FORCES


@dataclass(frozen=True)
class Gaining:
    """dG/du = 1 and dG/dw = 1: motions part as e^t."""

    nonexpansive: bool = False

    def slopes(self, _u, _w):
        return arb(1), arb(1)


@dataclass(frozen=True)
class Gated:
    """-1, but about 0.4 anything."""

    nonexpansive: bool = False

    def restoring(self, u):
        return arb(0, 1) if u.overlaps(arb("0.4")) else arb(-1)

    def drag(self, _u, _w):
        return arb(0)


TOP = FORCES["free pendulum"]


@dataclass(frozen=True)
class Sloped:
    """dG/du = 1 + 2 ``inside`` within 0.4 of u = 0, 1 + 2 ``outside`` beyond: the distance grows at these rates."""

    inside: float
    outside: float

    nonexpansive: bool = False

    def slopes(self, u, _w):
        return arb(1) + 2 * arb(self.inside if abs(u).upper() <= 0.45 else self.outside), arb(0)


@dataclass(frozen=True)
class Braking:
    """A force that is -1 at u = -1 and ``farther`` beyond: what is read within a ball is the weaker one."""

    farther: float

    def restoring(self, u):
        return arb(-1) if u.is_exact() else arb(self.farther)


def late_by(law, amplitude, distance):
    """How much later an orbit turns that is that far from one that turns at -amplitude."""
    return turning_delay(law, arb(1), -amplitude - law.friction, distance, distance)


def test_gains_part_motions_at_their_own_rate():
    found = error_propagation.distance_growth(Gaining(), arb(1), arb(0), arb(0), arb(2))
    assert arb(2).exp() <= found < arb(2).exp() * arb("1.001")


def test_a_force_must_point_forward_from_the_lower_to_the_upper_end():
    """Dry friction holds up to 1/2; 0.3 - u is below 0 from 0.3 on."""
    held = in_a_well({0: "1/2"})
    assert points_forward(held, arb(0), arb("0.4")) and not points_forward(held, arb(0), arb("0.4", "0.2"))
    assert points_forward(Steep(), arb("0.4"), arb("0.5")) and not points_forward(
        Steep(), arb("0.4", "0.2"), arb("0.5")
    )


def test_the_gap_of_a_state_counts_the_fall_through_its_error():
    """Energy beside the linear spring: a place farther by e turns farther by nearly as much."""
    with ctx.workprec(60):
        u, w, e = arb(-1), arb("0.05"), arb("0.001")
        turn = -(u * u + w * w).sqrt()
        found = state_gap(FREE, arb(1), u, w, turn.mid(), e)
        assert abs(-((u - e) ** 2 + w * w).sqrt() - turn) <= found < arb("0.0013")


def test_a_state_that_may_have_stopped_before_its_places_are_equal_has_no_gap():
    with pytest.raises(UndecidedError, match="too wide"):
        state_gap(FREE, arb(1), arb("-0.5"), arb("0.003"), arb("-0.50001"), arb("0.001"))


def test_the_force_ahead_is_asked_for_on_the_whole_way():
    """From the farther turning point, and from the place that the error allows: dry friction holds up to 1/2."""
    for force, u, w, turn, e in (
        (Gated(), "0.6", 1, "0.3", "0.001"),
        (in_a_well({0: "1/2"}), "0.45", 1, "-0.501", "0.06"),
    ):
        with pytest.raises(UndecidedError, match="force ahead"):
            state_gap(force, arb(1), arb(u), arb(w), arb(turn).mid(), arb(e))


@pytest.mark.parametrize("k", ["1/2", "2", "5"])
def test_growth_is_attained_in_the_worst_direction(k):
    """The linear spring, seen in the distance with another unit: (U, W) with k U = +-W grows at the full rate."""
    with ctx.workprec(120):
        unit = parse_real(k, "k").ball()
        t, e = arb(2) ** -10, arb(2) ** -40
        factor = growth(FREE, unit, arb(0), arb(1), t, e)
        best = arb(0)
        for W in (arb(1), arb(-1)):
            u, w = t.cos() / unit - W * t.sin(), W * t.cos() + t.sin() / unit
            best = max(best, (((unit * u) ** 2 + w**2) / 2).sqrt().mid())
        assert best <= factor and best - 1 > (factor - 1) / 2


def test_nothing_parts_in_the_own_unit():
    assert growth(FREE, arb(1), arb(0), arb(1), arb(3), arb(1e-9)) < 1 + arb(1e-9)


def test_the_gap_and_the_lateness_are_attained_by_free_fall():
    """A mass that passes the turning point with the speed d turns d^2/2/|s_0| farther, d/|s_0| later."""
    d, turn = arb(2) ** -20, arb(-1)
    with ctx.workprec(160):
        radius = (1 + d * d).sqrt()
        farther, later = radius - 1, d.atan()
        gap = turning_gap(FREE, turn, (d * d / 2).upper())
        late = turning_delay(FREE, arb(1), turn, arb(0), d)
        assert farther <= gap and gap / 2 < farther
        assert later <= late and late / 2 < later


def test_a_turning_point_near_the_place_of_rest_is_undecided():
    for call in (
        lambda: turning_gap(FREE, arb(-1), arb(2)),
        lambda: turning_delay(FREE, arb(1), arb(-1), arb(0), arb(1)),
        lambda: growth(FORCES["duffing"], arb(1), arb(0), arb(1), arb(10), arb(1)),
    ):
        with pytest.raises(Exception, match=r"place of rest|part too fast"):
            call()


def test_the_force_ahead_must_point_forward():
    pendulum = FORCES["free pendulum"]
    assert points_forward(pendulum, arb(-3), arb("-0.01"))
    assert not points_forward(pendulum, arb("-3.2"), arb(-1))
    assert not points_forward(pendulum, arb(-1), arb("0.01"))


def test_a_force_that_turns_round_between_two_places_is_seen():
    """1 - 5 y + 5 y^2 < 0 for u^2 = y between (5 -+ sqrt 5)/10, 0.276 and 0.724, and not at the ends."""
    hump = in_a_well({2: 0}, {3: -5, 5: 5})
    assert all(hump.restoring(arb(end)) < 0 for end in ("-1", "-0.2"))
    assert not points_forward(hump, arb(-1), arb("-0.2"))
    assert points_forward(hump, arb(-1), arb("-0.86")) and points_forward(hump, arb("-0.52"), arb("-0.2"))


def test_the_growth_counts_what_the_distance_itself_reaches():
    """At the rate 1 up to four times the error and at a higher one beyond, after t it is 4 e^(rate (t - ln 4))."""
    t, e = arb("1.6"), arb("0.1")
    for rate in (1, 2, 10):
        found = growth(Sloped(1, rate), arb(1), arb(0), arb(1), t, e)
        assert 4 * (rate * (t - arb(4).log())).exp() <= found * (1 + arb(1e-9)) and found <= (rate * t).exp() * arb(
            "1.001"
        )


def test_the_growth_counts_the_places_within_the_error():
    """Beside a hard spring: two orbits of x + 30 x^3 that begin 0.1 apart, the wider one where the slope is larger."""
    hard = in_a_well({2: 0}, {3: 30})
    with ctx.workprec(80):
        u, t, e = arb("0.05"), arb("0.1"), arb("0.1")
        factor = growth(hard, arb(1), u, arb(0).union(arb(1)), t, e)
        slope = abs(hard.slope(u + 4 * e, arb(0)) - 1) / 2
        assert factor >= (t * slope).exp()
        assert factor < (t * slope).exp() * arb("1.5")


@pytest.mark.parametrize(("turn", "beyond", "square"), [(-3.0, 0.0, 0.004), (-2.9, 0.05, 0.002), (-1.0, 0.0, 0.1)])
def test_the_gap_of_a_pendulum_is_that_of_its_energy(turn, beyond, square):
    """Near the top the force falls on the way: the gap is larger than square/|s_0| at the turning point."""
    first = turn - beyond
    truth = -float(mpmath.acos(mpmath.cos(first) - square)) - first if first < 0 else 0.0
    found = float(turning_gap(TOP, arb(turn), arb(square), arb(beyond)))
    assert abs(truth) <= found < 2.2 * abs(truth) + 1e-9
    if turn < -2:
        assert square / float(abs(mpmath.sin(turn))) < abs(truth)


def test_the_room_of_a_gap_must_hold_it():
    """Twice square/|s_0| is tried: a brake of more than half suffices there, a weaker one may let go."""
    assert turning_gap(Braking(-0.6), arb(-1), arb("0.01")) < arb("0.017")
    with pytest.raises(UndecidedError, match="place of rest"):
        turning_gap(Braking(-0.4), arb(-1), arb("0.01"))


def test_a_late_motion_near_the_top_is_later():
    """It passes at the speed d where the brake is weaker than at the turning point, by the gap and by its own way."""
    turn, gap, d = arb(-3), arb("0.05"), arb("0.03")
    with ctx.workprec(80):
        found = turning_delay(TOP, arb(1), turn, gap, d)
        weakest = (arb(3) + gap + 2 * d).sin()
        assert d / weakest <= found < d / weakest * arb("1.001")
        assert d / (arb(3) + gap + d).sin() < found and d / (arb(3) + d).sin() * arb("1.3") < found
    with pytest.raises(UndecidedError, match="place of rest"):  # in that time it would move farther than that
        turning_delay(TOP, arb(20), arb(-2), arb(0), arb("0.05"))


@pytest.mark.parametrize("share", ["0", "0.3", "0.9"])
def test_the_gap_of_a_state_counts_place_and_speed(share):
    """A free linear oscillator: states within e of (u, w), as far in place and as fast as the share says."""
    u, w, e = arb("-0.8"), arb("0.6"), arb(2) ** -12
    with ctx.workprec(100):
        bound = state_gap(FREE, arb(1), u, w, arb(-1), e)
        du, dw = e * arb(share), e * (1 - arb(share) ** 2).sqrt()
        truth = ((u - du) ** 2 + (w + dw) ** 2).sqrt() - 1
        assert truth <= bound < 3 * e
    if share == "0.9":
        best = ((u - e * arb("0.8")) ** 2 + (w + e * arb("0.6")) ** 2).sqrt() - 1
        assert bound / 2 < best


def test_a_state_that_may_be_at_rest_has_no_gap():
    with pytest.raises(UndecidedError, match="too wide"):
        state_gap(FREE, arb(1), arb("-0.8"), arb(2) ** -12, arb("-0.8") - arb(2) ** -25, arb(2) ** -13)
    with pytest.raises(UndecidedError, match="force ahead"):  # the centre lies within the error
        state_gap(TOP, arb(1), -(arb(2) ** -6), arb("0.5"), arb("-0.5"), arb(2) ** -7)


def test_a_shifted_orbit_turns_as_much_later_as_the_bound_says():
    """Undamped, an orbit d ahead on its circle turns d/p earlier."""
    p, d = arb(1), arb(2) ** -20
    bound = turning_delay(damping_of(*NOTHING), arb(1), -p, d, d)
    assert d / p <= bound and bound / 2 < d / p


@pytest.mark.parametrize("distance", ["0.01", "0.2"])
def test_the_delay_is_counted_at_the_smaller_amplitude(distance):
    """distance/(amplitude - 2 distance + friction), in doubles."""
    d = float(arb(distance))
    found = late_by(damping_of(("0", "1/10"), ("2", "1")), arb(1), arb(distance))
    assert float(found) == pytest.approx(d / (1 - 2 * d + 0.1), rel=1e-8)
