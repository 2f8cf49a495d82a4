"""First order against the energy that the driven cosine takes, the exact linear answer, and a scan for the peak."""

import math

import pytest
from flint import arb
from scipy.integrate import quad

from asymptotics.driven import first_order
from asymptotics.driven.drive import Drive
from asymptotics.errors import InputError
from asymptotics.law import Oscillator
from asymptotics.numbers.context import ctx

CASES = [
    ({2: "1/10"}, "1/5", "3/2"),
    ({"1/2": "1/10", 3: 1}, "1/5", 1),
    ({0: "1/10", 2: "1/10"}, "1/5", "1/2"),
    ({0: "1/10"}, "1/5", "9/10"),
    ({"sqrt(2)": "3/10"}, 7, "2/3"),
]


def balance(law, f, omega, A, lag):
    """What is missing of the balance of work, and of that of the part in phase with x, by quadrature."""

    def loss(v):
        return sum(b * math.copysign(abs(v) ** a, v) for a, b in law)

    def slope(u):
        return loss(-A * omega * math.sin(u)) * -math.sin(u)

    R = sum(quad(slope, n * math.pi, (n + 1) * math.pi, epsabs=1e-13)[0] for n in (0, 1)) / math.pi
    return R - f * math.sin(lag), A * (1 - omega**2) - f * math.cos(lag)


@pytest.mark.parametrize("case", CASES)
def test_work_and_spring_balance(case):
    law, force, omega = case
    drive = Drive.read(Oscillator(law), force, omega)
    with ctx.workprec(100):
        A = first_order.amplitude(drive.balls())
        lag = first_order.phase(drive.balls(), A)
        f, w = float(drive.force.ball()), float(drive.omega.ball())
        terms = [(float(t.velocity.ball()), float(t.strength.ball())) for t in drive.losses]
    assert A.rel_accuracy_bits() > 80
    found = balance(terms, f, w, float(A), float(lag))
    assert max(map(abs, found)) < 1e-10 * f  # QUADPACK at the ends, where the integrand has a real power
    # Near miss: M for 2 M, which is half of each loss.
    wrong = balance([(a, b / 2) for a, b in terms], f, w, float(A), float(lag))
    assert abs(wrong[0]) > 1e-3 * f


def test_omega_0_from_decimals():
    """k - m Omega^2 is a ball about 0 where 0.2 * 4^2 meets 3.2: R(A) = f all the same."""
    drive = Drive.read(Oscillator({2: "0.08"}, mass="0.2", stiffness="3.2"), "0.01", 4)
    with ctx.workprec(100):
        A = first_order.amplitude(drive.balls())
        assert A.overlaps(first_order.amplitude(drive.balls_at_resonance())) and A.rel_accuracy_bits() > 80
        assert not A.overlaps(first_order.amplitude(Drive.read(drive.oscillator, "0.01", "4.01").balls()))


def test_the_peak_is_the_largest_amplitude_of_a_scan():
    for law in ({2: "1/10"}, {1: "1/2", 3: "1/5"}):
        drive = Drive.read(Oscillator(law, mass=2, stiffness=3), "1/5", 1)
        with ctx.workprec(120):
            A, omega = first_order.peak(drive)
            there = [first_order.amplitude(drive._balls(omega * s, drive.oscillator.mass.ball() * (omega * s) ** 2))
                     for s in (arb("0.999"), arb(1), arb("1.001"))]  # fmt: skip
            assert there[1].overlaps(A) and A.rel_accuracy_bits() > 90
            assert there[0] < A and there[2] < A
    # Overdamped, viscous: the amplitude falls from Omega = 0 on.
    assert first_order.peak(Drive.read(Oscillator({1: 2}), 1, 1)) is None


def test_half_power_of_an_actual_curve():
    """Q of the width, to leading order in the loss, against frequencies at which the curve has fallen to 1/sqrt 2."""
    drive = Drive.read(Oscillator({2: "1/1000000"}), "1/100000", 1)
    with ctx.workprec(100):
        A = first_order.amplitude(drive.balls_at_resonance())
        decay, width = first_order.quality(drive, A)

        def side(sign):
            low, high = arb(0), arb("0.5")
            for _ in range(60):
                middle = ((low + high) / 2).mid()
                omega = 1 + sign * middle
                outside = first_order.amplitude(drive._balls(omega, omega**2)) < A / arb(2).sqrt()
                low, high = (low, middle) if outside else (middle, high)
                low, high = (low, high) if not outside else (low, middle)
            return low

        measured = 1 / (side(1) + side(-1))
        assert abs(measured / width - 1) < 1e-4
        # Near miss: it is not the Q of the decay; they agree for alpha = 1 alone.
        assert abs(measured / decay - 1) > 0.1
        linear = Drive.read(Oscillator({1: "1/100"}), 1, 1)
        there = first_order.amplitude(linear.balls_at_resonance())
        assert all(q.overlaps(arb(100)) for q in first_order.quality(linear, there))


@pytest.mark.parametrize(
    ("law", "force", "omega", "argument"),
    [
        ({2: 1}, 0, 1, "force"), ({2: 1}, 1, -1, "omega"), ({2: 0}, 1, 1, "law"), ({2: -1}, 1, 1, "strength"),
        ({(1, 2): 1}, 1, 1, "law"), ({0: 1, 2: 1}, 1, 2, "force"),
    ],
)  # fmt: skip
def test_bad_input_is_refused_by_name(law, force, omega, argument):
    with pytest.raises(InputError) as error:
        Drive.read(Oscillator(law), force, omega)
    assert error.value.argument == argument


def test_dry_friction_below_the_threshold_of_first_order_is_refused():
    between = Drive.read(Oscillator({0: 1}), "11/10", 2)  # b < f < 4 b/pi: it slides, and sticks in every swing
    with pytest.raises(InputError, match="sticks"):
        first_order.amplitude(between.balls())
    with pytest.raises(InputError, match="omega_0"):
        first_order.amplitude(Drive.read(Oscillator({0: 1}), 2, 1).balls())
