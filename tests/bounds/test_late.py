"""A jump to a late time: the enclosure holds the motion followed half-swing by half-swing, and is not much too wide."""

from itertools import islice

import pytest
from flint import arb, ctx

from asymptotics.bounds import motion
from asymptotics.bounds.flow import TruncatedFlow
from asymptotics.bounds.late import late_state, late_turning
from asymptotics.bounds.local import local_bounds
from asymptotics.bounds.motion import _by_energy, enclosure
from asymptotics.bounds.turning import turning_bounds
from asymptotics.errors import LimitError
from asymptotics.flow.damping import Damping
from asymptotics.flow.dense import states
from asymptotics.flow.linear_spring.linear_spring import LinearSpring
from asymptotics.flow.sequence import first_from, sequence
from asymptotics.flow.turning import TurningState, at_rest
from asymptotics.law import Law, Oscillator
from asymptotics.numbers.exact import ExactReal, parse_real
from asymptotics.return_map.panels import panels_of
from asymptotics.return_map.sequence import Interpolated

ONE = [parse_real("2", "alpha")]


def followed(law, first, tau, bits=100):
    with ctx.workprec(bits):
        return states(Interpolated(Damping.of_law(law), panels_of(law, bits)), *first, [tau])[0][0]


# A law, the start, the time, the half-swings before the jump; the share of the radius that is attained at least.
JUMPS = [
    (Law({2: "1/10"}), (arb(1), arb(0)), 152, 20, 0.6),
    (Law({3: "1/10"}), (arb(-1), arb(0)), 140, 40, 0.7),
    (Law({2: "1/10"}), (arb(1) / 2, arb(1) / 4), 122, 20, 0.1),
    pytest.param(Law({"3/2": "1/10", 2: "1/10"}), (arb(1), arb(0)), 150, 30, 0.1, marks=pytest.mark.slow),
    pytest.param(Law({1: "1/100", 3: "1/10"}), (arb(1), arb(0)), 130, 20, 0.01, marks=pytest.mark.slow),
]


@pytest.mark.parametrize(("law", "start", "tau", "lead", "share"), JUMPS)
def test_the_jump_holds_the_motion_and_is_not_wide(law, start, tau, lead, share):
    with ctx.workprec(100):
        damping = Damping.of_law(law)
        side = 1 if start[0] > 0 else -1
        rest = TurningState(0, side, arb(1), arb(0), arb(0), arb(0))
        first = rest if start[1] == 0 else first_from(LinearSpring(damping), *start)
        found = late_state(damping, first, arb(tau), lead)
        true = followed(law, start, arb(tau))
        error = abs(found.mid() - true)
        assert error < found.rad()
        assert error > share * found.rad()
        assert found.rad() < arb(10) ** -10


def test_the_turning_point_after_the_jump_is_held_and_its_errors_are_attained():
    with ctx.workprec(100):
        start, damping = TurningState(0, 1, arb(1), arb(0), arb(0), arb(0)), Damping.of([(arb(1) / 100, ONE[0])])
        found = late_turning(damping, start, arb(40), 1)
        true = next(islice(sequence(LinearSpring(damping), start), found.n, None))
        amplitude, time = abs(found.amplitude - true.amplitude), abs(found.time - true.time)
        assert 0.85 * found.amplitude_error < amplitude < found.amplitude_error
        assert 0.85 * found.time_error < time < found.time_error


def test_an_uncertain_start_counts():
    """Two motions apart by e at the start: both bounds grow by no less than what is seen, and e is not forgotten."""
    exact, wide = (turning_bounds(ONE, 3, [arb(1) / 20], e) for e in (None, arb(1) / 1000))
    assert wide.log_amplitude(0) >= arb(1) / 1000
    with ctx.workprec(100):
        near, far = (followed_points(arb(1) / 20, a, 20) for a in (arb(1), (arb(1) / 1000).exp()))
        for n in (1, 5, 20):
            apart = abs(near[n][0].log() - far[n][0].log()).upper()
            assert apart < wide.log_amplitude(n)
            late = abs(near[n][1] - far[n][1]).upper()
            assert late < wide.time(n) - exact.time(n)
            assert wide.time(n) - exact.time(n) < 4 * late


def followed_points(epsilon, amplitude, count):
    damping = Damping.of([(epsilon, ONE[0])])
    start = TurningState(0, 1, amplitude.mid(), arb(0), arb(0), arb(0))
    return [(abs(p.x), p.tau) for p in islice(sequence(LinearSpring(damping), start), count + 1)]


def test_the_truncated_equations_are_enclosed_at_every_precision():
    local = local_bounds(ONE, 3)

    def point(bits):
        with ctx.workprec(bits):
            return TruncatedFlow.of(local, [arb(1) / 50]).turning_point(500)

    exact = point(120)
    for bits in (30, 40, 60):
        for rough, fine in zip(point(bits), exact):
            assert rough.contains(fine.mid())
            assert rough.rad() < abs(fine) * arb(2) ** (16 - bits)


def test_what_is_out_of_range_falls_back_on_energy():
    creeping = Oscillator({"1/2": "1/3"})
    with pytest.raises(LimitError, match="turn"):
        late_state(Damping.of_law(Law({1: 3})), at_rest(arb(1)), arb(100), 10)
    found, known = _by_energy(creeping, ExactReal(400), 20), enclosure(creeping, ExactReal(400), 15)
    assert found.mid() == 0
    assert abs(known) < found.rad() < 20 * abs(known)
    assert _by_energy(creeping, ExactReal(400), 0).rad() >= 1  # nothing is reached: the energy of the start


def test_a_time_of_forty_places_is_reached_by_the_jump():
    """The phase has more bits than the digits asked for, and so have the strengths and the coefficients."""
    quadratic, t = Oscillator({2: "1/10"}), ExactReal(10**40)
    found, fine = (enclosure(quadratic, t, digits) for digits in (15, 24))
    assert found.contains(fine.mid()) and found.rad() < 1e-4 * abs(found) and fine.rad() < 1e-6 * abs(fine)


@pytest.mark.parametrize("late", [200, pytest.param(motion.LATE, marks=pytest.mark.slow)])
def test_an_exponent_below_one_is_followed_however_late(late, monkeypatch):
    """The jump is for exponents from 1 on, and refuses others: sqrt(|v|) past its beginning, from two sides."""
    monkeypatch.setattr(motion, "LATE", late)
    root, times = Oscillator({"1/2": "1e-6"}), (ExactReal(3 * late), ExactReal(33 * late // 10))
    assert [bool(t.ball() > late * arb.pi()) for t in times] == [False, True]
    for t in times:
        found, fine = (enclosure(root, t, digits) for digits in (10, 20))
        assert found.contains(fine.mid()) and found.rad() < 1e-9


@pytest.mark.parametrize("side", [-1, 1])
def test_a_jump_from_an_uncertain_turning_point_holds_both_ends(side):
    """A_0 = 1 +- e and tau_0 = +- e: the motions from both ends are inside, with what is left of e as the radius."""
    e = arb(2) ** -10
    with ctx.workprec(100):
        damping = Damping.of([(arb(1) / 50, parse_real("2", "alpha"))])
        found = late_turning(damping, TurningState(0, 1, arb(1), arb(0), e, e), arb(40), 1)
        end = TurningState(0, 1, 1 + side * e, side * e, arb(0), arb(0))
        true = next(islice(sequence(LinearSpring(damping), end), found.n, None))
        apart, late = abs(found.amplitude - true.amplitude), abs(found.time - true.time)
        assert found.amplitude_error / 4 < apart < found.amplitude_error
        assert found.time_error / 4 < late < found.time_error
