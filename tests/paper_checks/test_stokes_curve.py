"""The stored constants: computed again for a sample, at another height too; the conjectured limits at alpha = 1."""

from fractions import Fraction

import numpy as np
import pytest
from flint import arb

from asymptotics.expansions.divergence.constants import stokes_balls
from asymptotics.numbers.exact import parse_real
from asymptotics.present.figures import render
from paper_checks.report import stokes_curve


def test_the_file_has_the_grid_and_says_what_made_it():
    assert [r["alpha"] for r in stokes_curve.stored()] == stokes_curve.grid()
    assert '"made by": "python -m paper_checks.report.stokes_curve"' in stokes_curve.STORED.read_text()


@pytest.mark.parametrize("alpha", ["1/5", "2", "11/4", pytest.param("17/16", marks=pytest.mark.slow)])
def test_a_sample_is_computed_again(alpha):
    """By the command, and in balls at another height."""
    row = next(r for r in stokes_curve.stored() if r["alpha"] == alpha)
    assert stokes_curve.row(alpha) == row
    c, d = stokes_balls(parse_real(alpha, "alpha"), 1, 12, lift=0.3)
    for ball, text in ((c[0], row["c_1"]), (d[0], row["d_1"])):
        assert abs(ball - arb(text)) < arb("1e-11") * abs(ball)


@pytest.mark.parametrize(("side", "near"), [(1, 0.002), (-1, 0.06)])
def test_near_1_the_constants_beat(side, near):
    """c_1 -> cos(pi x)/pi, d_1 -> sin(pi x) - cos(pi x), with corrections in powers of |alpha - 1|^(1/3): fitted."""
    x, c_1, d_1 = (row[np.sign(stokes_curve.beats()[0]) == side] for row in stokes_curve.beats())
    cosine, sine, rest = stokes_curve.fitted(x, c_1, 8)
    assert abs(cosine[0] * np.pi - 1) < near and abs(sine[0]) < near / 4 + 0.001 and rest < 1e-9
    cosine, sine, rest = stokes_curve.fitted(x, d_1, 8)
    assert abs(cosine[0] + 1) < 2 * near and abs(sine[0] - 1) < 2 * near and rest < 1e-8
    for period in (0.98, 1.02):  # no other period
        assert stokes_curve.fitted(x * period, c_1, 6)[2] > 100 * stokes_curve.fitted(x, c_1, 6)[2]


def test_the_amplitude_is_no_third_and_the_powers_are_not_whole():
    x, c_1, _ = (row[stokes_curve.beats()[0] > 0] for row in stokes_curve.beats())
    assert not abs(stokes_curve.fitted(x, c_1, 8)[0][0] - 1 / 3) < 0.01
    for step in (1.0, 0.5):
        assert stokes_curve.fitted(x, c_1, 6, step)[2] > 10 * stokes_curve.fitted(x, c_1, 6)[2]


def test_zeros_of_c_1_lie_between_neighbouring_signs():
    """The picture's zeros near 1: one in each interval of 1/(alpha - 1) of length about 1, on both sides."""
    for side in (1, -1):
        rows = [r for r in stokes_curve.stored() if (Fraction(r["alpha"]) - 1) * side > 0]
        x = np.array([abs(float(1 / (Fraction(r["alpha"]) - 1))) for r in rows])
        signs = np.sign([float(r["c_1"]) for r in rows])[np.argsort(x)]
        x = np.sort(x)
        zeros = [(a + b) / 2 for a, b, s, t in zip(x, x[1:], signs, signs[1:], strict=False) if s != t and a >= 4]
        assert len(zeros) == 12 and all(0.7 < b - a < 1.3 for a, b in zip(zeros, zeros[1:], strict=False))


def test_it_is_drawn():
    assert b"<svg" in render(stokes_curve.draw, size=(11, 4))
