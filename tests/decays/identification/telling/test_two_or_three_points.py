"""Q of two or three amplitudes: a decrement, its interval from errors that are known or from three of them."""

import json

import numpy as np
import pytest

import asymptotics as asy
from asymptotics.decays.identification.measuring.observations import Observations
from asymptotics.decays.identification.telling.envelope import envelope, why_none
from asymptotics.errors import InputError
from asymptotics.shell.main import main

FALL = 0.08


def peaks(count, noise=0.0, seed=0, **more):
    """Amplitudes of one side, a period of 1.3 apart, of viscous drag."""
    n = 2 * np.arange(count)
    size = 3 * np.exp(-FALL * n) * (1 + noise * np.random.default_rng(seed).standard_normal(count))
    return {"t (s)": 0.65 * n, "amplitude (cm)": size, **more}


def test_two_peaks_have_their_decrement_and_say_that_they_have_no_interval():
    """Failed before: at least 14 samples."""
    answer = asy.identify(peaks(2))
    found = answer.to_dict()
    assert found["verdict"].startswith("undecided: 2 turning points tell no law from another")
    bare = found["envelope"]
    assert bare["period"] == {"low": None, "estimate": "1.3", "high": None}
    for row in bare["quality"]:
        assert float(row["estimate"]) == pytest.approx(np.pi / 2 / FALL, rel=1e-5)
        assert row["low"] is None is row["high"]
    assert float(bare["half_life"]["estimate"]) == pytest.approx(np.log(2) / FALL * 0.65, rel=1e-3)
    assert "only with their errors" in bare["intervals_untold"] and bare["law_known"] is False
    assert any("no period apart: --kind damping" in note for note in answer.notes)
    assert any("Q = 19.6 at 2.77 cm" in line and "only with their errors" in line for line in answer.lines)


def test_where_no_law_is_fitted_no_equation_stands_as_if_one_were():
    """The page, the notebook and LaTeX had that of dry friction, the first of 63; and 63 rows that said the same."""
    answer = asy.identify(peaks(2))
    assert answer.told_laws == () and len(answer.to_dict()["laws"]) == len(answer.laws) > 10
    assert answer.table() == f"none of {len(answer.laws)} laws was fitted"
    page = asy.html_report(answer)
    assert "sgn" not in page and "was fitted" in page
    assert "sgn" not in answer._repr_html_() and "operatorname" not in answer._repr_latex_()
    other = asy.identify({"n": np.arange(9), "x": 3 * (-0.9) ** np.arange(9.0)}, laws=["1"])
    assert (
        other.told_laws == other.laws and "x&#x27;&#x27;" in asy.html_report(other) or "x''" in asy.html_report(other)
    )


def test_a_picture_without_laws_is_refused_with_the_reason():
    """It said that there was no single run, of one run."""
    with pytest.raises(InputError, match="argument plot: no law is fitted"):
        asy.identify(peaks(2)).plot()


def test_with_errors_two_peaks_have_intervals():
    """In the middle all powers of A agree, and the error is that of the logarithm of a quotient."""
    errors = {"uncertainty (cm)": [0.02, 0.02], "uncertainty t (s)": [0.01, 0.01]}
    bare = asy.identify(peaks(2, **errors)).to_dict()["envelope"]
    assert bare["intervals_untold"] is None
    first, last = 3.0, 3 * np.exp(-2 * FALL)
    reach = 1.96 * 0.02 * np.hypot(1 / first, 1 / last) / 2
    middle = {k: np.pi / 2 / float(bare["quality"][1][k]) for k in ("low", "high")}
    assert middle["low"] == pytest.approx(FALL + reach, rel=0.02)
    assert middle["high"] == pytest.approx(FALL - reach, rel=0.02)
    assert float(bare["period"]["high"]) - 1.3 == pytest.approx(1.96 * 0.01 * np.sqrt(2), rel=1e-3)


@pytest.mark.parametrize("errors", [False, True])
@pytest.mark.parametrize("powers", [-1, 0, 1])
def test_three_points_cover_the_quality_whatever_the_law(errors, powers):
    """Failed before: at least 4."""
    size = {-1: 3 - 0.24 * np.arange(3), 0: 3 * np.exp(-FALL * np.arange(3)), 1: 3 / (1 + FALL * np.arange(3))}[powers]
    hits = []
    for seed in range(100):
        noise = 0.01 * np.random.default_rng(seed).standard_normal(3)
        known = np.full(3, 0.01) if errors else ()
        seen = Observations.of(np.arange(3), (size + noise) * [1, -1, 1], 0.65 * np.arange(3), sigma_x=known)
        for row in envelope(seen).quality:
            a = row["amplitude"]
            fall = {-1: 2 * np.arcsinh(0.12 / a), 0: FALL, 1: 2 * np.arcsinh(FALL * a / 6)}[powers]
            hits.append(row["low"] <= np.pi / 2 / fall <= row["high"])
    assert np.mean(hits) >= 0.93


def test_a_base_line_that_was_not_taken_off_shows_in_three_points():
    size = 3 * np.exp(-FALL * np.arange(3)) * [1, -1, 1] + 0.1
    for row in envelope(Observations.of(np.arange(3), size, np.arange(3.0))).quality:
        assert row["low"] <= np.pi / 2 / FALL <= row["high"]


def test_three_rows_of_both_signs_are_turning_points_and_three_plain_ones_are_asked_for(tmp_path, capsys):
    t = np.array([0.0, 0.65, 1.3])
    bare = asy.identify({"t": t, "x (cm)": 3 * (-np.exp(-FALL)) ** np.arange(3)}).to_dict()["envelope"]
    assert float(bare["quality"][1]["estimate"]) == pytest.approx(np.pi / 2 / FALL, rel=1e-5)
    with pytest.raises(asy.InputError, match="'amplitude'"):
        asy.identify({"t": t, "x (cm)": 3 * np.exp(-FALL * np.arange(3))})


def test_no_envelope_says_why():
    """Failed before: envelope was null, without a reason."""
    nothing = Observations.of([0, 1], [1.0, 0.0])
    answer = asy.identify(nothing, laws=["1"])
    found = answer.to_dict()
    assert found["envelope"] is None and found["envelope_untold"] == why_none(nothing)
    assert found["envelope_untold"] == "fewer than 2 turning points other than 0, and it has no samples"
    assert f"no envelope: {why_none(nothing)}" in answer.lines
    table = {"amplitude": [1.0, 0.5], "decrement": [0.1, 0.03]}
    answer = asy.identify(table, kind="decrement", laws=["1"])
    assert "decrements" in answer.to_dict()["envelope_untold"]


def test_files_of_two_peaks_are_answered_in_every_form(tmp_path, capsys):
    path = tmp_path / "peaks.csv"
    path.write_text("t (s),amplitude (cm)\n0,3\n1.3,2.556\n")
    for form in (["--json"], ["--csv", str(tmp_path / "out.csv")], []):
        assert main(["identify", str(path), *form]) == 0
    said = capsys.readouterr().out
    assert json.loads(said[: said.index("\n}") + 2] if "\n}" in said else said.splitlines()[0])["envelope"]
    assert "Q at 2.76912 cm" in (tmp_path / "out.csv").read_text()
