"""The waveform by quadrature against the exact Fourier waveform (odd alpha), closed forms, and reversibility."""

from math import pi

import numpy as np
import pytest
from flint import acb, arb, ctx

from asymptotics.expansions.half_swings.certified import quarter_swing
from asymptotics.expansions.half_swings.forces import Forces
from asymptotics.expansions.normal_form.expansion import expansion_of
from asymptotics.expansions.normal_form.flow import Flow
from asymptotics.motions.waveform import WaveformTable, waveform_at
from asymptotics.numbers.exact import parse_real
from asymptotics.series import Series
from tests.worlds import pairs_of

LAWS = pairs_of(
    "dry friction", "below the linear one", "linear", "another rational power", "quadratic", "an irrational power",
    "dry friction beside three halves",
)  # fmt: skip


def flow(laws, order=4):
    return expansion_of(quarter_swing([parse_real(a, "a") for a in laws], order), arithmetic="certified").flow


def losses(*laws):
    return Forces.losses([parse_real(a, "a") for a in laws])


@pytest.mark.parametrize("pairs", LAWS)
def test_reversibility_holds_for_the_right_flow(pairs):
    """Odd P_n and even Q_n vanish at pi/2: this needs the right p_k and Omega_k, found by another route."""
    laws = [exponent for exponent, _ in pairs]
    with ctx.workprec(100):
        found = waveform_at(flow(laws), losses(*laws), (arb.pi() / 2).mid(), 3)
        for key, (p, q) in found.items():
            assert abs(p if sum(key) % 2 else q) < arb(10) ** -26


def test_a_wrong_frequency_breaks_it():
    with ctx.workprec(100):
        right = flow(("3/2",))
        wrong = Flow(right.grading, right.U, Series({**right.W.coefficients, (2,): right.W[2] * 1.0001}, 1, 4))
        assert abs(waveform_at(wrong, losses("3/2"), (arb.pi() / 2).mid(), 2)[(2,)][1]) > arb(10) ** -6


@pytest.mark.parametrize("alpha", ["0", "1/2", "3/2", "7/2"])
def test_first_order_in_closed_form(alpha):
    """Im Z_1 = -sin^(alpha+1)/(alpha+1); Re Z_1 = p_1 psi - int sin^(alpha+1), here by acb.integral."""
    with ctx.workprec(80):
        a, psi = parse_real(alpha, "a").ball(), arb("1.3")
        p, q = waveform_at(flow((alpha,)), losses(alpha), psi, 1)[(1,)]
        assert abs(q + psi.sin() ** (a + 1) / (a + 1)) < arb(10) ** -20
        power = 2 * (a + 1)  # sin = y^2 near 0: no branch point left for even powers
        integral = acb.integral(lambda y, f: 2 * y * (y * y).sin().pow(a + 1, analytic=f), arb("0.001"), psi.sqrt())
        start = arb("0.001") ** (power + 2) / (a + 2)
        U_1 = flow((alpha,)).U[1]
        assert abs(p - (-U_1 * psi - integral.real - start)) < arb(10) ** -10


def test_linear_damping_exactly():
    """alpha = 1, e = 2 sin b: A = e^(-psi tan b), X = A (cos psi + tan b sin psi), X' = -A sin psi/cos b."""
    with ctx.workprec(80):
        e, psi = arb(1) / 50, arb("2.1")
        terms = waveform_at(flow(("1",), 6), losses("1"), psi, 5)
        Z = sum((acb(p, q) * e ** key[0] for key, (p, q) in terms.items()), acb(1))
        b = (e / 2).asin()
        exact = acb(psi.cos() + b.tan() * psi.sin(), psi.sin() / b.cos()) * (acb(0, -1) * psi).exp()
        assert abs(Z - exact) < arb(10) ** -11  # e^6 = 6e-11 times a coefficient below 0.1
        assert abs(Z - exact) > arb(10) ** -16


def test_the_table_agrees_with_the_balls_and_keeps_its_symmetry():
    with ctx.workprec(80):
        for laws in (("1/2",), ("3/2",), ("0", "3/2")):
            table = WaveformTable.of(flow(laws), losses(*laws), 2)
            chi = np.array([1e-6, 0.01, 0.7, 1.5, 2.9])
            rows = table.at(chi)
            for j, x in enumerate(chi):
                exact = waveform_at(flow(laws), losses(*laws), arb(float(x)), 2)
                for i, key in enumerate(table.keys):
                    assert abs(float(exact[key][0]) - rows[2 * i, j]) < 2e-13
                    assert abs(float(exact[key][1]) - rows[2 * i + 1, j]) < 2e-13
            assert np.allclose(table.at(np.array([0.0, pi])), 0, atol=1e-13)
