"""The estimate of the error of first order against the certified difference, and where there is none."""

import math

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import asymptotics as asy
from asymptotics.driven.balance import balanced, estimated_error
from asymptotics.driven.drive import Drive
from asymptotics.law import Oscillator


def off(found, law, force, omega):
    """By how much the estimate is off, relative to the certified difference; its two digits are half a unit of 10."""
    told = estimated_error(Drive.read(Oscillator(law), force, omega))
    return {
        name: abs(float(told[name]) / float(found.difference[name]) - 1) for name in found.difference if name in told
    }


@pytest.mark.parametrize(
    ("law", "other", "force", "omega"),
    [({2: "1/10"}, {2: "12/100"}, "1/5", 1), ({3: "1/100"}, {3: "12/1000"}, "1/5", "9/10"),
     ({"5/4": "1/100", 2: "1/50"}, {"5/4": "1/100", 2: "3/100"}, 1, "11/10"), ({3: 1}, {3: "6/5"}, 1, "1/2"),
     ({"sqrt(2)": "1/10"}, {"sqrt(2)": "12/100"}, 1, 1)],
)  # fmt: skip
def test_the_estimate_is_the_certified_difference(law, other, force, omega):
    found = asy.response(law, force, omega, digits=12)
    shares = off(found, law, force, omega)
    assert set(shares) == {"amplitude", "phase"} and max(shares.values()) < 0.06
    assert found.first_order.error["method"].startswith("estimate")
    # Near miss: another strength.
    assert max(off(found, other, force, omega).values()) > 0.06


@settings(max_examples=3 * max(1, settings().max_examples // 80), deadline=None)  # more in the nightly profile
@given(st.sampled_from(["1.25", "1.5", "2", "3"]), st.floats(0.02, 0.5), st.floats(0.2, 2), st.floats(0.6, 1.8))
def test_random_laws(alpha, b, f, omega):
    b, f, omega = (str(round(value, 3)) for value in (b, f, omega))
    found = asy.response({alpha: b}, f, omega, digits=12)
    shares = off(found, {alpha: b}, f, omega)
    # An estimate: within a fifth of what it estimates; what nearly cancels is of the next order.
    size = {"amplitude": float(found.amplitude), "phase": 1.0}
    assert all(share < 0.2 for name, share in shares.items() if abs(float(found.difference[name])) > 1e-4 * size[name])


def test_viscous_damping_has_no_error_and_friction_has_an_estimate():
    assert asy.response({1: "1/10"}, "1/5", 1, digits=5).first_order.error["amplitude"] == "0"
    waves = balanced(1.0, 2.0, ((0.3, 1.0),), (0.5, 0.5))
    assert abs(complex(*waves[0]) - (1 / complex(-1, 0.3)).conjugate()) < 1e-12 and abs(waves[1:]).max() < 1e-12
    # Dry friction alone, sliding all along, exactly (Den Hartog, Trans. ASME 53, 1931), x in units of f/k: its
    # harmonics fall slowly, and a fifth of the error lies beyond the ninth.
    share, omega = 0.2, 2.0
    speed = math.sin(math.pi / omega) / (omega * (1 + math.cos(math.pi / omega)))
    exact = math.sqrt(1 / (1 - omega**2) ** 2 - (share * speed) ** 2)
    first = asy.response({0: "1/5"}, 1, 2, digits=8).first_order
    error = exact - float(first.amplitude)
    assert abs(float(first.error["amplitude"]) / error - 1) < 0.25 and abs(error) > 0.01 * exact
