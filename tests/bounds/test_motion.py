"""The proved bound at one time: above the distance from the reference motion, and hardly above."""

from fractions import Fraction

import pytest

import asymptotics as asy
from asymptotics.bounds.motion import proved_bound
from asymptotics.cli.main import main
from asymptotics.law import Oscillator
from asymptotics.motions.asymptotic import AsymptoticMotion
from asymptotics.motions.reference import reference_motion

MOTIONS = [
    (Oscillator({"3/2": "1/10"}, mass="3/2", stiffness="30", x0="1/5"), "7", "turning-point"),
    (Oscillator({1: "1/20", 2: "1/10"}, x0=1, v0="1/2"), "4", "turning-point"),
    (Oscillator({"1/2": "1/20"}, x0="-1"), "5", "averaging"),
    (Oscillator({0: "1/50"}, x0=1), "13", "turning-point"),
]


@pytest.mark.parametrize(("oscillator", "t", "gauge"), MOTIONS)
@pytest.mark.parametrize("order", [1, 3])
def test_the_bound_covers_the_distance_and_hardly_more(oscillator, t, gauge, order):
    x = AsymptoticMotion.of(oscillator, order, gauge).at(t, 15).x
    distance = abs(Fraction(reference_motion(oscillator, t, 30).x) - Fraction(x))
    bound = Fraction(proved_bound(oscillator, x, t))
    assert distance <= bound
    assert bound <= distance * Fraction(112, 100)


def test_a_late_time_is_reached_by_a_jump():
    oscillator = Oscillator({3: "1/40"})
    x = AsymptoticMotion.of(oscillator, 3).at(40_000_000, 12)
    bound = Fraction(proved_bound(oscillator, x.x, 40_000_000, max_seconds=600))
    assert 0 < bound < abs(Fraction(x.x)) / 1000


def test_the_front_door_and_the_command_line(capsys):
    motion = asy.motion(MOTIONS[0][0], order=2)
    assert motion.bound(7) == "2.1e-8"
    quantities = {"alpha": "3/2", "mass": "3/2", "stiffness": "30", "damping": "1/10", "x0": "1/5", "time": "7"}
    law = [text for name, value in quantities.items() for text in (f"--{name}", value)] + ["--digits", "30"]
    assert main(["motion", *law, "--order", "2", "--bound", "--json"]) == 0
    shown = capsys.readouterr().out
    assert '"bound": "2.1e-8"' in shown
    assert '"certified": false' in shown
    assert main(["motion", *law, "--order", "2", "--json"]) == 0
    assert "bound" not in capsys.readouterr().out
    assert main(["motion", *law, "--reference", "--bound"]) == 2
    assert main(["expand", "--alpha", "2", "--order", "2", "--bound", "--json"]) == 0
    assert '"delta_max": "0.' in capsys.readouterr().out
    for wrong in (["--gauge", "averaging"], ["--spring", "3:1"], ["--order", "60"]):
        assert main(["expand", "--alpha", "2", "--order", "2", "--bound", *wrong]) == 2
    assert main(["expand", "--alpha", "symbolic", "--bound"]) == 2
