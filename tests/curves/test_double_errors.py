"""What doubles say they are good to, beside the same numbers with 25 digits, where a battery of laws found them short.

``python -m benchmarks double-errors`` draws such laws; these are what it found.
"""

from fractions import Fraction

import numpy as np
import pytest

import asymptotics as asy
from asymptotics.curves.double_errors import of_envelope, of_motion, of_solution

HELD = [  # friction ends them: on an arc, at rest; an averaged amplitude that vanishes
    ({0: "77/900", 1: "13/180", 2: "11/150"}, {"mass": "1/14", "stiffness": "3/4", "x0": 2}, (0.5, 1.0, 1.5, 2.0, 9.0)),
    ({"1/2": "7/100", 2: "1/30"}, {"mass": "1/3", "stiffness": "26/19", "x0": "7/10"}, (5.0, 20.0, 86.17)),
]


@pytest.mark.parametrize(("law", "units", "times"), HELD, ids=str)
@pytest.mark.parametrize("order", [1, 2, 3])
def test_an_array_says_what_one_time_says_where_the_motion_ends(law, units, times, order):
    """A = |x| and no phase on the last arc, and 0 and no phase beyond an extinction, in doubles as in decimals."""
    moving = asy.motion(asy.Oscillator(law, **units), order=order)
    rows = moving.sample(times)
    for t, x, a, phase in zip(times, rows.x, rows.amplitude, rows.phase):
        point = moving.at(t, digits=15)
        assert x == pytest.approx(float(point.x), abs=1e-8) and a == pytest.approx(float(point.amplitude), abs=1e-8)
        assert np.isnan(phase) if point.phase is None else phase == pytest.approx(float(point.phase), abs=1e-8)
    stated = of_motion(moving, rows)["amplitude"]
    assert float(stated.size) < 1e-6


def test_a_solution_has_no_phase_of_nothing():
    law = asy.Oscillator({"1/2": "7/100", 2: "1/30"}, mass="1/3", stiffness="26/19", x0="7/10")
    found = asy.solution(law, order=2)
    assert found.at_time(law, 5, 8).phase and found.at_time(law, 86, 8).phase is None
    assert np.isnan(found.columns([86.0])[2]).all() and not np.isnan(found.columns([5.0])[2]).any()


def test_an_envelope_has_its_phase_until_it_is_extinct():
    """Dry friction stops the mass before; the averaged law goes on, in decimals and in doubles."""
    found = asy.envelope({0: "1/20", 1: "1/10"})
    t = 0.99 * float(found.extinction_time())
    assert found.phases(t) == pytest.approx(float(found.phase(t, digits=12)), abs=1e-10)
    assert np.isnan(found.phases(2 * t)) and np.isnan(found.phases([np.nan])).all()


def worst(values, true, stated):
    """The largest error of doubles over the stated one."""
    errors = [abs(Fraction(float(v)) - r) / (abs(r) if stated.relative else 1) for v, r in zip(values, true)]
    return float(max(errors) / stated.size)


@pytest.mark.parametrize("alpha", ["1.001", "1.0001", "0.999"])
def test_next_to_the_linear_law_the_stated_errors_hold(alpha):
    """(1 + (alpha-1) kappa tau)^(1/(alpha-1)) is a large power of a rounded number."""
    law, t = asy.Oscillator({alpha: "21/100"}, mass="13/5", stiffness="17/8", x0="17/10"), np.array([7.0, 90.0, 2117.0])
    slow = asy.envelope(law)
    true = [Fraction(slow.amplitude(x, digits=25)) for x in t]
    assert worst(slow.amplitudes(t), true, of_envelope(slow, t)["amplitude"]) < 0.5
    found = asy.solution(law, order=3)
    points = [found.at_time(law, Fraction(x), 25) for x in t[:2]]
    for name, column in zip(("amplitude", "phase", "x"), found.columns(t[:2])[1:]):
        stated = of_solution(found, t[:2])[name]
        assert worst(column, [Fraction(getattr(p, name)) for p in points], stated) < 0.5
