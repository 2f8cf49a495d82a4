"""The certified set of an unknown exponent: it holds the truth, and its ends are nearly attained."""

import json
from fractions import Fraction

import numpy as np
import pytest
from flint import ctx
from scipy.optimize import brentq

from asymptotics.decays.identification.certified_sets import free_exponent
from asymptotics.decays.identification.certified_sets.central_point import chebyshev_point
from asymptotics.decays.identification.certified_sets.certified_ratio import BITS
from asymptotics.decays.identification.certified_sets.free_exponent import _Strips, exponents_that_fit
from asymptotics.decays.identification.fitting.printed import Decrements
from asymptotics.decays.identification.forward.candidates import read_candidate
from asymptotics.shell.main import main
from tests.decays.identification.certified_sets.printed_tables import printed


@pytest.mark.parametrize("size", [1.0, 3.0])
def test_the_strengths_at_one_exponent_hold_the_truth_from_both_sides_and_are_not_wide(size):
    """x'^2: (1 + 2 e A) exp(-2 e A) = (1 - 2 e B) exp(2 e B) from A to -B, in any unit; printed to four digits."""
    e, tops = 0.03, size * np.array([1.0, 0.8, 0.6])
    energy = lambda y: np.log1p(y) - y  # noqa: E731
    ends = [brentq(lambda y, a=a: energy(-y) - energy(2 * e * a), 0, 2 * e * a) / (2 * e) for a in tops]
    table = Decrements((tops + ends) / 2, np.round(tops - ends, 4), np.full(3, 5e-5))
    with ctx.workprec(BITS):
        low, high = _Strips.of(table).strengths(2.0, 2.0)
    assert low < e < high < 1.01 * low


@pytest.mark.parametrize(("law", "strength"), [("3/2", 0.05), ("0", 0.05)])
def test_the_set_of_a_free_exponent_holds_the_truth_and_its_ends_are_nearly_attained(law, strength):
    table, alpha = printed(law, [strength], 4, rows=20), float(Fraction(law))
    found = exponents_that_fit(table)
    assert found.verdict == "consistent"
    assert found.alpha.low <= alpha <= found.alpha.high < found.alpha.low + 0.005
    assert found.epsilon.low <= strength <= found.epsilon.high < found.epsilon.low + 1e-3
    # at a fixed exponent the least t with |D(epsilon) - D_k| <= t r_k, in doubles
    least = lambda a: chebyshev_point(read_candidate(str(Fraction(a))), table)[0]  # noqa: E731
    width = found.alpha.high - found.alpha.low
    assert least(found.alpha.high - 0.2 * width) < 1 < least(found.alpha.high + 0.01 * width)
    if alpha > 0:
        assert least(found.alpha.low + 0.2 * width) < 1 < least(found.alpha.low - 0.01 * width)


def test_no_exponent_fits_a_sum_and_a_wrong_digit_is_noticed():
    assert exponents_that_fit(printed("0+2", [0.01, 0.03], 4)).verdict == "refuted"
    table = printed("2", [0.05], 4)
    assert exponents_that_fit(table).alpha.contains(2.0)
    wrong = Decrements(table.amplitude, table.decrement + 3e-4 * (np.arange(12) == 5), table.resolution)
    assert exponents_that_fit(wrong).verdict == "refuted"


@pytest.mark.slow
def test_the_table_of_an_unknown_exponent_names_it(tmp_path, capsys):
    table = printed("3/2", [0.05], 4)
    path = tmp_path / "decrements.csv"
    rows = [f"{a},{d:.4f},0.00005" for a, d in zip(table.amplitude, table.decrement)]
    path.write_text("amplitude,decrement,resolution\n" + "\n".join(rows) + "\n")
    assert main(["identify", str(path), "--laws", "1", "2", "free", "--json"]) == 0
    answer = json.loads(capsys.readouterr().out)
    assert answer["verdict"].startswith("identified: free with alpha = 1.5")
    law = answer["laws"][0]
    assert law["alphas"] == ["free"]
    assert law["intervals"] == "certified set"
    assert float(law["alpha"]["low"]) <= 1.5 <= float(law["alpha"]["high"])


@pytest.mark.parametrize("reference", [1.0, 0.37])
def test_the_strength_beside_a_free_exponent_is_the_one_that_is_proved(monkeypatch, reference):
    asked = []
    meets = free_exponent._Strips.meets
    monkeypatch.setattr(free_exponent._Strips, "meets", lambda *a: asked.append(a[1:]) or meets(*a))
    a = np.array([1.0, 0.7, 0.4]) * reference
    found = exponents_that_fit(Decrements(a, 0.1 * a**2, np.full(3, 5e-4)))
    assert found.verdict == "consistent"
    assert asked == [(found.epsilon.estimate, found.alpha.estimate)]
