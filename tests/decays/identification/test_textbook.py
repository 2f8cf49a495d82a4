"""Textbook estimators against the exact map."""

from dataclasses import replace

import numpy as np
import pytest

from asymptotics.decays.identification.synthetic import exact, observed
from asymptotics.decays.identification.textbook import ESTIMATORS, textbook_estimates

TABLE = [  # the table of the theory page: percent, without and with an ignored spring of 1 % drift
    ("1", [0.1], "logarithmic decrement", [0.13], [-0.29]),
    ("2", [0.1], "Bertin", [-0.17], [-0.82]),
    ("1+2", [0.06, 0.2], "Froude", [1.41, -2.00], [2.74, -3.73]),
    ("1+2", [0.06, 0.2], "energy", [2.21, -2.38], [4.26, -4.47]),
    ("0+1", [0.01, 0.05], "Feeny-Liang", [0, 0], [4.56, -3.34]),
]


def test_textbook_estimators_have_the_errors_they_are_said_to_have():
    # ordinary ship data: 10 % a half-swing, quadratic law; the decrement estimators are wrong by per cents
    n = np.arange(13)
    x = (-1.0) ** n * np.exp(exact("2", [0.08], 12).a)
    bertin = ESTIMATORS["Bertin"][1](x)[0]
    assert 0.0005 < abs(bertin / 0.08 - 1) < 0.05
    said = textbook_estimates(observed("2", [0.08], 12, 0.0))
    assert float(said["Bertin"]["systematic_error"][0]) == pytest.approx(bertin - 0.08, rel=1e-3)
    # exact cases: logarithmic decrement up to (epsilon/2)^2/2, Feeny and Liang for dry and linear friction exactly
    viscous = (-1.0) ** n * np.exp(exact("1", [0.1], 12).a)
    assert ESTIMATORS["logarithmic decrement"][1](viscous)[0] == pytest.approx(0.1 / np.sqrt(1 - 0.05**2), rel=1e-9)
    both = (-1.0) ** n * np.exp(exact("0+1", [0.01, 0.05], 12).a)
    assert ESTIMATORS["Feeny-Liang"][1](both) == pytest.approx([0.01, 0.05], rel=1e-9)


def test_an_estimator_without_a_value_is_left_out():
    # Sums of neighbours that rise, as noise makes them: q > 1 is no decay, and a clip of it would be no estimate.
    rising = np.array([1.0, -0.99, 0.985, -0.97, 0.95, -0.91, 0.85])
    assert np.isnan(ESTIMATORS["Feeny-Liang"][1](rising)).all()
    seen = replace(observed("1", [0.05], 6, 0.0), x=rising)
    assert "Feeny-Liang" not in textbook_estimates(seen) and "Froude" in textbook_estimates(seen)


@pytest.mark.parametrize(("law", "strengths", "name", "alone", "sprung"), TABLE)
def test_the_errors_of_the_theory_page(law, strengths, name, alone, sprung):
    sign = np.where(np.arange(13) % 2, -1.0, 1.0)
    for text, given, expected in ((law, strengths, alone), (law + "+s3", [*strengths, 8 / 300], sprung)):
        found = ESTIMATORS[name][1](sign * np.exp(exact(text, given, 12).a))
        assert 100 * (found / np.array(strengths) - 1) == pytest.approx(expected, abs=0.006)
