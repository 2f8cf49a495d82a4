"""Values of envelopes as mpf, interval and ball: they hold the value, by a formula of the averaged law, and no more."""

import mpmath
import pytest
from flint import arb

import asymptotics as asy
from asymptotics.errors import InputError


def test_the_interval_holds_the_value_of_the_formula_and_not_its_neighbour():
    slow = asy.envelope({2: "1/10"})
    kappa = 4 / (30 * mpmath.pi)
    truth = 1 / (1 + 7 * kappa)  # dA/dtau = -kappa A^2
    found = slow.number("amplitude", 7, digits=12)
    assert truth in found.interval() and found.ball().contains(arb(str(truth)))
    assert abs(found.mpf() - truth) < 1e-12 and truth + mpmath.mpf("1e-12") not in found.interval()
    assert slow.number("kappa_1", digits=10).value == slow.kappas(digits=10)[0]
    assert slow.number("time", "1/2", digits=10).value == slow.time("1/2", digits=10)
    dry = asy.envelope({0: "1/10"})
    assert dry.number("extinction_time", digits=8).value == dry.extinction_time(digits=8)


def test_there_is_a_phase_just_before_the_extinction():
    slow, t = asy.envelope({"1/2": "1/10"}), "35.944207042067766223197674768409716346"
    # A = (1 - kappa tau/2)^2 and phi = (2 w epsilon^2/kappa) (1 - 1/sqrt(A)), w = (1/4) M_1/(9/4), M_1 = 2/pi.
    shrunk = 2 * 0.01 * (2 / mpmath.pi / 9) / mpmath.mpf(slow.kappas(digits=20)[0])
    found = mpmath.mpf(slow.phase(t, digits=5)) * mpmath.sqrt(mpmath.mpf(slow.amplitude(t, digits=5)))
    assert abs(found / -shrunk - 1) < 1e-4


def test_a_start_within_a_million_millionth_of_the_top_is_inside_the_well():
    nearly = "3.14159265358979323846"
    assert asy.envelope(asy.Oscillator({2: "1/20"}, spring="pendulum", x0=nearly)).amplitude(0, digits=5) == "3.1416"
    with pytest.raises(InputError, match="not certainly inside the well"):
        asy.envelope(asy.Oscillator({2: "1/20"}, spring="pendulum", x0=nearly + "3"))


def test_beside_a_spring_there_is_a_period():
    bob = asy.envelope(asy.Oscillator({2: "1/20"}, spring="pendulum", x0=3))
    truth = 4 * mpmath.ellipk(mpmath.sin(mpmath.mpf(3) / 2) ** 2)
    assert truth in bob.number("period", 3, digits=10).interval()
    with pytest.raises(InputError, match="period"):
        asy.envelope({2: "1/10"}).number("period", 1)


@pytest.mark.parametrize(
    ("asked", "said"),
    [(("amplitude",), "at: is missing"), (("kappa_2",), "kappa_1"), (("kappa_1", 3), "at: kappa_1"), ((3,), "name")],
)
def test_what_there_is_not_is_named(asked, said):
    with pytest.raises(InputError, match=said):
        asy.envelope({2: "1/10"}).number(*asked)
