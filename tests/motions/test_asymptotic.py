"""The expansion against the reference motion: measured orders, gauges, starts, arrays, extinction."""

from fractions import Fraction
from functools import cache
from math import cos, log, sqrt

import numpy as np
import pytest

from asymptotics.errors import InputError
from asymptotics.gauges import GAUGES
from asymptotics.law import Law, Oscillator
from asymptotics.motions.asymptotic import AsymptoticMotion
from asymptotics.motions.reference import reference_motion, reference_states
from asymptotics.numbers.exact import ExactReal

TIMES = [Fraction(n, 4) for n in range(1, 41)]
DRAG = Oscillator(Law({"3/2": "1/10"}), mass="3/2", stiffness="30", x0="1/5")


def oscillator(*pairs, **rest):
    return Oscillator(dict(pairs), **rest)


reference_at = cache(reference_motion)


def error(system, order, t, gauge="turning-point"):
    point, exact = AsymptoticMotion.of(system, order, gauge).at(t, 12), reference_at(system, t, 15)
    return abs(Fraction(point.x) - Fraction(exact.x)), Fraction(point.error), point


def test_order_one_is_lancaster_13():
    """alpha = 2: x = x0 cos(tau)/(1 + kappa tau), kappa = 4 eps/(3 pi); alpha = 1: x0 e^(-eps tau/2) cos tau."""
    found = AsymptoticMotion.of(oscillator(("2", "1/10")), 1).at("5", 15)
    assert float(found.x) == pytest.approx(cos(5) / (1 + 4 * 0.1 * 5 / (3 * np.pi)), abs=1e-14)
    found = AsymptoticMotion.of(oscillator(("1", "1/10"), x0="-2"), 1).at("5", 15)
    assert float(found.x) == pytest.approx(-2 * np.exp(-0.25) * cos(5), abs=1e-14)
    assert found.gauge == "turning-point" and found.order == 1


def largest_error(alphas, epsilon, order):
    """sup |x_N - x| over 0 < tau <= 10 at forty times, in doubles."""
    system = oscillator(*[(a, epsilon) for a in alphas])
    found = AsymptoticMotion.of(system, order).sample([float(t) for t in TIMES]).x
    return float(np.max(np.abs(found - np.array([float(x) for x in exact_at_forty_times(system)]))))


@cache
def exact_at_forty_times(system):
    return reference_states(system, [ExactReal(t) for t in TIMES], 14).x


@pytest.mark.parametrize("alphas", [("1/2",), ("3/2",), ("2",), ("3",), ("1", "2")])
@pytest.mark.parametrize("order", [1, 2, 3])
def test_measured_order(alphas, order):
    """The largest error falls like eps^N: the waveform term delta^N is the first that is missing."""
    slope = log(largest_error(alphas, "1/40", order) / largest_error(alphas, "1/80", order)) / log(2)
    assert order - 0.1 < slope < order + 0.7


def test_dry_friction_is_exact_from_order_two_on():
    """Order 1 misses the shift of the centre; Z = 1 - delta ... ends there, and so does the amplitude law."""
    assert largest_error(("0",), "1/40", 1) > 0.02
    assert largest_error(("0",), "1/40", 2) < 1e-15 and largest_error(("0",), "1/40", 3) < 1e-15


@pytest.mark.parametrize("gauge", GAUGES)
def test_gauges_agree_to_their_order_and_differ_in_amplitude_and_phase(gauge):
    for start in ({"x0": "1/5"}, {"x0": "-1/10", "v0": "1"}):
        system = oscillator(("3/2", "1/10"), mass="3/2", stiffness="30", **start)
        true, estimate, point = error(system, 3, "7", gauge)
        assert true < 3 * estimate and estimate < Fraction(1, 10**6)
        assert point.gauge == gauge
    phases = {AsymptoticMotion.of(DRAG, 2, g).at("7", 8).phase for g in GAUGES}
    assert len(phases) == 3


@pytest.mark.parametrize(
    "pairs", [(("1/2", "1/20"),), (("3/2", "1/5"),), (("3", "1/5"),), (("0", "1/100"), ("2", "1/10"))]
)
def test_the_error_estimate_is_of_the_right_size(pairs):
    for order in (1, 2, 3):
        true, estimate, _ = error(oscillator(*pairs), order, "6")
        assert true < 2 * estimate < 2000 * max(true, Fraction(1, 10**11))


def test_a_strength_beyond_the_series_is_said_to_be_so():
    """delta = 100: the mass creeps near x = 1 while the averaged amplitude has long decayed."""
    true, estimate, point = error(oscillator(("3/2", "100")), 3, "1")
    assert true > Fraction(9, 10) and estimate >= true and "not small" in point.notes[0]


def test_the_start_is_met_exactly_in_the_turning_point_gauge():
    for start in (("3/10", "-2"), ("0", "1"), ("-1/5", "0")):
        point = AsymptoticMotion.of(oscillator(("3/2", "1/20"), x0=start[0], v0=start[1]), 3).at("0", 20)
        assert abs(Fraction(point.x) - Fraction(start[0])) < Fraction(1, 10**19)
        assert abs(Fraction(point.v) - Fraction(start[1])) < Fraction(1, 10**19)


SYSTEMS = (DRAG, oscillator(("1/2", "1/20"), x0="-1", v0="1/3"), oscillator(("0", "1/50"), ("2", "1/10")))


@pytest.mark.parametrize("gauge", GAUGES[:2])
@pytest.mark.parametrize("system", [SYSTEMS[0], *(pytest.param(one, marks=pytest.mark.slow) for one in SYSTEMS[1:])])
def test_decimals_and_arrays_agree(system, gauge):
    motion = AsymptoticMotion.of(system, 2, gauge)
    times = ["0", "4"]
    array = motion.sample([float(Fraction(t)) for t in times])
    for i, t in enumerate(times):
        point = motion.at(t, 15)
        for name in ("x", "v", "amplitude", "phase"):
            assert float(getattr(point, name)) == pytest.approx(getattr(array, name)[i], abs=1e-11)


def test_fewer_digits_are_a_rounding_of_more():
    few, many = (AsymptoticMotion.of(DRAG, 3).at("7", digits) for digits in (15, 60))
    for name in ("x", "v", "amplitude", "phase"):
        a, b = Fraction(getattr(few, name)), Fraction(getattr(many, name))
        assert abs(a - b) <= abs(b) / 10**14


def test_nan_stays_in_its_place_and_shapes_are_kept():
    found = AsymptoticMotion.of(DRAG, 3).sample([[0.0, np.nan], [7.0, 1.0]])
    assert found.x.shape == (2, 2) and np.isnan(found.x[0, 1]) and found.missing == 1
    assert not np.isnan(found.x[1, 0]) and "NaN" in found.notes[0]
    assert found.to_dict()["x"][1] is None
    assert AsymptoticMotion.of(DRAG, 3).sample([]).x.size == 0


def test_a_time_before_the_start_is_refused_by_name():
    motion = AsymptoticMotion.of(DRAG, 2)
    with pytest.raises(InputError, match="time"):
        motion.at("-1")
    with pytest.raises(InputError, match=r"-2\.0 \(and 1 more\)"):
        motion.sample([1.0, -2.0, -3.0])
    with pytest.raises(InputError, match="inf"):
        motion.sample([np.inf])


def test_beyond_the_fictitious_extinction_the_answer_says_so():
    """alpha = 1/2, order 1: sqrt(A) = 1 - kappa tau/2 is extinct at tau = 2/kappa."""
    motion = AsymptoticMotion.of(oscillator(("1/2", "1/10")), 1)
    end = 2 / float(motion.oscillator.kappas()[0])
    found = motion.sample([end - 0.1, end + 0.1, 1e6])
    assert found.extinction == pytest.approx(end, rel=1e-12) and found.extinct == 2
    assert found.amplitude[0] == pytest.approx((0.05 / end * 2 * 1) ** 2, rel=0.01)
    assert list(found.x[1:]) == [0, 0] and "extinction" in found.notes[0]
    point = motion.at(str(round(end + 1, 3)), 10)
    assert (point.x, point.v, point.amplitude, point.phase) == ("0", "0", "0", None) and "extinction" in point.notes[0]
    assert point.error == "1.0"  # all that the energy says of a motion that creeps


STICKING = [  # law, start, time, order: the expansion knows the stop
    ({"0": "0.22"}, {"x0": 1}, "7.1", 3),
    ({"0": "0.3"}, {"x0": "0.46"}, "20", 3),  # back on the side it came from
    ({"0": "0.3"}, {"x0": "0.46"}, "2", 2),
    ({"0": "0.1"}, {"x0": "0.46", "v0": "-0.48"}, "30", 3),  # at -1/10
    ({"0": 1}, {"x0": "0.5"}, "2", 3),  # it never starts
    ({"0": "0.25"}, {"x0": "1.25"}, "9", 4),  # a tie: it sticks at eps itself
]


@pytest.mark.parametrize(("law", "start", "time", "order"), STICKING)
def test_dry_friction_alone_is_exact_from_order_2_on(law, start, time, order):
    found = AsymptoticMotion.of(Oscillator(law, **start), order)
    expected = {"7.1": "0.12", "20": "0.14", "30": "-0.1", "9": "0.25"}.get(time)
    point = found.at(time, 12)
    if expected is not None:
        assert Fraction(point.x) == Fraction(expected)
        assert point.v == "0" and "dry friction holds" in point.notes[-1]
    else:
        exact = reference_motion(Oscillator(law, **start), time, 15)
        assert float(point.x) == pytest.approx(float(exact.x), abs=1e-11)
    assert float(point.error) < 1e-11
    at = found.sample([0.0, float(time)])
    assert at.x[1] == pytest.approx(float(point.x), abs=1e-7)
    assert at.x[0] == pytest.approx(float(Fraction(start["x0"])), abs=1e-9)


def test_friction_beside_another_law_stops_too():
    """x'' + x + 0.22 sgn x' + 0.01 x' = 0 sticks at 0.1027338...: what the file of times shows, and the point says."""
    motion = AsymptoticMotion.of(oscillator(("0", "0.22"), ("1", "0.01")), 5)
    point = motion.at("6663/968", 12)
    assert point.x == "0.102733784854" and point.v == "0"
    found = motion.sample(np.linspace(6.4, 30, 7))
    assert np.ptp(found.x) == 0 and found.x[0] == pytest.approx(0.102733784854, abs=1e-7)
    assert set(found.v) == {0} and found.extinct == 0


@pytest.mark.parametrize("gauge", GAUGES)
@pytest.mark.parametrize("law", [{"5": 300}, {"1/2": 3}, {"2": 40, "0": 1}])
def test_where_delta_is_large_no_amplitude_grows_and_no_warning_escapes(law, gauge):
    """Warnings are errors here; the series may refuse, but may not print kilometres for a start of 32 cm."""
    system = Oscillator(law, x0="0.1", v0="0.3")
    try:
        motion = AsymptoticMotion.of(system, 2, gauge)
        point, table = motion.at("3", 8), motion.sample(np.linspace(0, 20, 41))
    except InputError as refused:
        assert refused.argument == "order"
        return
    assert max(float(point.amplitude), np.max(table.amplitude)) < 8 * float(system.length())
    assert float(point.error) >= abs(float(point.x)) and any("not small" in note for note in point.notes)


def test_samples_of_a_single_time_and_of_no_time():
    motion = AsymptoticMotion.of(DRAG, 3)
    assert motion.sample(0.0).x == pytest.approx(0.2) and motion.sample(0.0).x.shape == ()
    assert motion.sample([]).x.shape == (0,)
    assert np.isnan(motion.sample([np.nan]).x).all()
    for bad in ("x", [1j], [-1.0], [np.inf], object()):
        with pytest.raises(InputError, match="time"):
            motion.sample(bad)


def test_no_damping_and_a_term_of_strength_zero():
    free = AsymptoticMotion.of(oscillator(("3/2", "0"), stiffness="4"), 3)
    assert float(free.at("1", 15).x) == pytest.approx(cos(2), abs=1e-14)
    assert free.sample([1.0]).x[0] == pytest.approx(cos(2), abs=1e-14)
    both = AsymptoticMotion.of(oscillator(("3/2", "1/10"), ("2", "0")), 3).at("2", 12)
    assert both.x == AsymptoticMotion.of(oscillator(("3/2", "1/10")), 3).at("2", 12).x


def test_bad_choices_are_refused():
    for kind, name in (({"gauge": "energy"}, "gauge"), ({"order": 0}, "order"), ({"order": 99}, "order")):
        with pytest.raises(InputError, match=name):
            AsymptoticMotion.of(DRAG, **kind)
    with pytest.raises(InputError, match="negative"):
        AsymptoticMotion.of(oscillator(("2", "-1")))
    with pytest.raises(InputError, match="digits"):
        AsymptoticMotion.of(DRAG).at("1", 0)


@pytest.mark.parametrize(
    ("pairs", "rest", "name"),
    [
        ((("3/2", "1/10"),), {"x0": "1e400"}, "x0"),
        ((("3/2", "1e-400"),), {}, "law"),
        ((("3/2", "1"),), {"stiffness": "1e300"}, "stiffness"),
    ],
)
def test_sizes_that_doubles_cannot_hold_are_refused(pairs, rest, name):
    with pytest.raises(InputError, match=f"argument {name}: .* out of range"):
        AsymptoticMotion.of(oscillator(*pairs, **rest), 2)


def test_long_times():
    """alpha = 2: A = 1/(1 + kappa tau) at 1e30, also with a linear term that has long won; alpha = 1 at 1e6."""
    point = AsymptoticMotion.of(oscillator(("2", "1/10")), 1).at("1e30", 12)
    assert float(point.amplitude) == pytest.approx(3 * np.pi / 4 / 0.1 / 1e30, rel=1e-10)
    far = [AsymptoticMotion.of(oscillator(("2", "1/10")), 1).at("1e60", digits).x for digits in (6, 40)]
    assert float(far[0]) == pytest.approx(float(far[1]), rel=1e-5)  # the phase keeps its digits
    linear = AsymptoticMotion.of(oscillator(("1", "1/10")), 1).at("1e6", 12)
    assert linear.amplitude.endswith("e-21715")  # e^-50000
    with pytest.raises(InputError, match="time"):
        AsymptoticMotion.of(DRAG, 1).at("1e400", 5)


def test_a_million_times_agree_with_a_few():
    motion = AsymptoticMotion.of(DRAG, 3)
    times = np.linspace(0, 1000, 10**6)
    assert np.allclose(motion.sample(times).x[::250_000], motion.sample(times[::250_000]).x, rtol=0, atol=1e-12)


def test_units_scale():
    """The same dimensionless motion in other units: eps = b omega_0^alpha x0^(alpha-1)/k is 1/20 in both."""
    one = AsymptoticMotion.of(oscillator(("2", "1/20")), 3).at("3", 12)
    two = AsymptoticMotion.of(oscillator(("2", "1/10"), mass="4", stiffness="1", x0="2"), 3).at("6", 12)
    assert float(two.x) == pytest.approx(2 * float(one.x), rel=1e-11)
    assert float(two.v) == pytest.approx(2 * float(one.v) / sqrt(4), rel=1e-11)
