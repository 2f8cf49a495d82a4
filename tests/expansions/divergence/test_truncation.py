"""The best order: the smallest term is where the law says, half of it is left, and the exponentials give most back."""

import json
from math import exp, pi, sqrt

import pytest

import asymptotics as asy
from asymptotics.errors import InputError, LimitError, UndecidedError
from asymptotics.expansions.divergence import truncation
from asymptotics.shell.main import main


@pytest.mark.parametrize(
    ("alpha", "delta", "gain"),
    [("2", "1/5", 1e3), pytest.param("2", "1/10", 1e20, marks=pytest.mark.slow)],
)
def test_what_is_left_at_the_best_order(alpha, delta, gain):
    best = asy.expand(alpha).best_order(delta)
    z = 0.75 / (1 / 5 if delta == "1/5" else 1 / 10)
    assert abs(best.power - 2 * pi * z) < 3  # the place of the smallest term
    assert abs(best.smallest_term / (best.predicted / pi / sqrt(z)) - 1) < 0.3  # Stirling's formula in the proved law
    assert 0.4 < best.errors[0] / best.smallest_term < 0.6  # half of it is left
    assert best.errors[1] < best.errors[0] / gain and best.label == "measured"
    if alpha == "2" and delta == "1/10":
        assert best.errors[2] < best.errors[1] / 3


def test_an_exponential_of_the_wrong_sign_gains_nothing(monkeypatch):
    """The near miss: -c_1 in the first sector doubles the error instead."""
    honest = truncation._sector
    monkeypatch.setattr(truncation, "_sector", lambda size, *rest: honest(-size, *rest))
    monkeypatch.setattr(truncation, "FURTHER", 1)
    best = asy.expand(2).best_order("1/5")
    assert best.errors[1] > 1.5 * best.errors[0]


def test_a_constant_from_delta_where_z_is_meant_is_refuted():
    """The wave is in z = |c|/delta, not in 1/delta: e^(-2 pi/delta) puts order and error elsewhere."""
    delta, c, c_1 = 1 / 5, 0.75, 0.090928001
    best = asy.expand(2).best_order("1/5")
    for size, right in ((c, True), (1.0, False)):
        z = size / delta
        assert (abs(best.power - 2 * pi * z) < 3) == right
        assert (abs(best.smallest_term / (c_1 / pi / sqrt(z) * exp(-2 * pi * z)) - 1) < 0.3) == right


@pytest.mark.slow
def test_motion_says_the_same(capsys):
    told = ["motion", "--alpha", "2", "--epsilon", "1/10", "--time", "7", "--best-order", "1/5"]
    assert main(told) == 0 and str(asy.expand(2).best_order("1/5")) in capsys.readouterr().out
    assert main([*told, "--json"]) == 0
    assert json.loads(capsys.readouterr().out)["best_order"]["order"] == 27
    assert main([*told, "--reference"]) != 0 and "no order" in capsys.readouterr().err
    spring = ["motion", "--alpha", "2", "--damping", "1/10", "--spring", "3:1/2", "--x0", "1", "--time", "7"]
    assert main([*spring, "--best-order", "1/5"]) != 0 and "one law" in capsys.readouterr().err


def test_what_has_no_best_order():
    for law, told in (({1: 1, 2: 1}, "one law"), (1, "diverge"), (0, "diverge")):
        with pytest.raises(InputError, match=told):
            asy.expand(law, order=2).best_order("1/5")
    with pytest.raises(InputError, match="positive"):
        asy.expand(2).best_order(-1)
    with pytest.raises(LimitError, match="delta"):
        asy.expand(2).best_order("1/1000")
    for delta in (2, "2/5"):  # outside at once, or after some half-swings
        with pytest.raises(UndecidedError, match="circle in which"):
            asy.expand(2).best_order(delta)
