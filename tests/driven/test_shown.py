"""What is drawn of a driven response: its curves against the certified response and the free decay."""

import pytest

import asymptotics as asy
from asymptotics.driven.drive import Drive
from asymptotics.driven.shown import backbone, first_order_at
from asymptotics.law import Oscillator


@pytest.mark.parametrize("law", [{2: "1/10"}, {"3/2": "1/10", 3: "1/20"}])
def test_the_backbone_is_the_frequency_of_the_free_decay(law):
    drive = Drive.read(Oscillator(law, mass=2, stiffness=8), "1/5", 1)
    free = asy.turning_points(Oscillator(law, mass=2, stiffness=8, x0="1/20"), 3, digits=20, times=True).points
    measured = 3.141592653589793 / (float(free[2].t) - float(free[1].t))
    mean = abs(float(free[1].x) * float(free[2].x)) ** 0.5
    shift = measured - 2
    assert shift < 0 and abs(backbone(drive, mean) - 2 - shift) < 0.02 * abs(shift)
    assert abs(backbone(drive, 2 * mean) - 2 - shift) > 0.1 * abs(shift)  # near miss: another amplitude


def test_the_picture_has_three_curves_and_the_response():
    plt = pytest.importorskip("matplotlib.pyplot")
    found = asy.response({2: "1/2"}, "1/5", "11/10", digits=8)
    axes = found.plot()
    left, right = plt.gcf().axes
    labels = [line.get_label() for line in left.lines]
    assert labels == ["first order", "backbone: the free decay", "the response, certified"]
    omegas, amplitudes = left.lines[0].get_data()
    peak = max(zip(amplitudes, omegas))
    told = found.first_order.peak
    assert abs(peak[0] - float(told["amplitude"])) < 1e-4 and abs(peak[1] - float(told["omega"])) < 0.01
    drive = Drive.read(Oscillator({2: "1/2"}), "1/5", 1)
    told = found.first_order
    assert first_order_at(drive, 1.1) == pytest.approx((float(told.amplitude), float(told.phase)))
    # A second result is drawn into the same two axes.
    asy.response({2: "1/4"}, "1/5", "11/10", digits=8).plot(axes)
    assert len(plt.gcf().axes) == 2 and len(right.lines) == 2
    plt.close("all")
