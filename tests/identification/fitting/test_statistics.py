"""Profiles against MINOS, textbook estimators against the exact map, pictures, and what swings can tell."""

import re
from dataclasses import replace
from xml.etree import ElementTree

import numpy as np
import pytest
from iminuit import Minuit

import asymptotics as asy
from asymptotics.cli.main import main
from asymptotics.errors import InputError
from asymptotics.identification.fitting.profile import coordinate, profile_interval, quantile, wald_interval
from asymptotics.identification.forward.candidates import read_candidate
from asymptotics.identification.forward.quadrature import TooStrongError
from asymptotics.identification.identifiability import standard_errors, swings_needed
from asymptotics.identification.judging.comparison import fit_law, strength
from asymptotics.identification.synthetic import exact, observed
from asymptotics.identification.telling.html_report import html_report
from asymptotics.identification.telling.plots import decrement_band
from asymptotics.identification.telling.runs import mean_of_runs
from asymptotics.identification.textbook import ESTIMATORS, textbook_estimates


def test_profile_intervals_are_those_of_minos():
    seen = observed("1+2", [0.01, 0.02], 60, 5e-3, seed=2)
    fit = fit_law(read_candidate("1+2"), seen).fit
    sigma = fit.model.scale_vector(fit.scales)

    def chi2(theta):
        return float((((fit.model.data - fit.model.predict(np.array(theta))[0]) / sigma) ** 2).sum())

    minuit = Minuit(chi2, fit.theta)
    minuit.errordef = quantile(fit, 0.95, "x") ** 2
    minuit.migrad()
    minuit.minos()
    for i in (0, 1):
        mine = profile_interval(fit, strength(fit_law(read_candidate("1+2"), seen).candidate, i, seen.reference))
        scale = seen.reference ** -fit.model.swing.elements[i].weight
        errors = minuit.merrors[1 + i]
        assert mine.low - mine.estimate == pytest.approx(errors.lower * scale, rel=0.02)
        assert mine.high - mine.estimate == pytest.approx(errors.upper * scale, rel=0.02)


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


def test_the_scatter_of_estimates_is_the_fisher_bound():
    bound = standard_errors("1+2", [0.01, 0.02], swings=60, noise=1e-3)
    found = []
    for seed in range(60):
        fit = fit_law(read_candidate("1+2"), observed("1+2", [0.01, 0.02], 60, 1e-3, seed=seed)).fit
        found.append(fit.theta[fit.model.law])
    ratio = np.std(found, axis=0) / bound
    assert ((ratio > 0.75) & (ratio < 1.3)).all()


def test_strengths_that_the_data_hardly_see_have_long_intervals_and_refute_nothing():
    # 30 swings lose a twentieth of the amplitude: four losses can hardly be told apart, and the true one is 0.001 alone
    law = asy.identify(observed("1", [1e-3], 30, 1e-6, seed=1), laws=["1", "0+1+2+3"]).law("0+1+2+3").law
    assert law.verdict == "consistent"
    assert all(e.contains(true) for e, true in zip(law.epsilon, [0.0, 1e-3, 0.0, 0.0], strict=True))
    assert all(e.high - e.low > 0.05 for e in law.epsilon)


def test_strengths_that_the_data_do_not_see_have_no_limit():
    # two turning points and three parameters; two losses of one exponent
    assert np.isinf(standard_errors("1+2", [0.01, 0.02], swings=1, noise=1e-6)).all()
    fit = fit_law(read_candidate("1+2"), observed("1+2", [0.01, 0.02], 30, 1e-4)).fit
    slopes = fit.slopes.copy()
    slopes[:, 2] = slopes[:, 1]
    blind = replace(fit, slopes=slopes)
    for i, seen in ((1, False), (2, False), (3, True)):
        assert (wald_interval(blind, coordinate(i)).low is not None) is seen


def test_more_noise_needs_more_swings():
    needed = [swings_needed("1+2", [0.002, 0.02], term=0, noise=noise) for noise in (3e-4, 1e-3, 3e-3)]
    assert needed == sorted(needed)
    assert needed[0] < needed[-1]


@pytest.mark.parametrize(
    ("law", "strengths", "term", "noise"),
    [
        ("0+1", [0.04, 0.02], 1, 0.012),  # the motion ends after the 10 swings that are enough
        ("0+1", [0.04, 0.02], 1, 0.1),  # and before those that would be
        ("1", [0.04], 0, 1e-3),
        ("1+2", [0.01, 0.02], 1, 1e-5),
    ],
)
def test_the_least_number_of_swings_is_the_first_that_is_enough(law, strengths, term, noise):
    def enough(swings):
        try:
            return strengths[term] > 3.24 * standard_errors(law, strengths, swings=swings, noise=noise)[term]
        except TooStrongError:
            return False

    first = next((n for n in range(1, 20) if enough(n)), None)
    assert swings_needed(law, strengths, term=term, noise=noise) == first


def test_random_effects_cover_runs_that_differ():
    random, hits = np.random.default_rng(0), 0
    for _ in range(300):
        true = 1 + 0.1 * random.standard_normal(6)
        mean, _ = mean_of_runs(true + 0.01 * random.standard_normal(6), [0.01] * 6)
        hits += mean.contains(1.0)
    assert 0.90 <= hits / 300 <= 0.985


def test_the_mean_of_two_runs_that_agree_has_their_pooled_error_and_covers():
    random, hits, widths = np.random.default_rng(7), 0, []
    for _ in range(1000):
        mean, between = mean_of_runs(1 + 0.01 * random.standard_normal(2), [0.01, 0.01])
        hits += mean.contains(1.0)
        widths.append((mean.high - mean.low, between > 0))
    assert 0.93 <= hits / 1000 <= 0.97
    assert {round(width, 6) for width, apart in widths if not apart} == {round(2 * 1.959964 * 0.01 / np.sqrt(2), 6)}
    assert 0.03 <= np.mean([apart for _, apart in widths]) <= 0.07


@pytest.mark.parametrize(("factor", "alike"), [(1.0, True), (1.3, False)])
def test_a_verdict_of_two_runs_says_whether_their_strengths_are_one(factor, alike):
    runs = [observed("1", [0.02 * f], 60, 1e-3, seed=s) for f, s in ((1.0, 1), (factor, 2))]
    answer = asy.identify(runs, laws=["1", "2", "1+2"])
    mean, said = answer.law("1").law.epsilon[0], answer.verdict.text
    assert answer.verdict.kind == "identified"
    assert ("the strength of 1 differs from run to run" in said) == (not alike)
    assert mean.contains(0.02) and (mean.high - mean.low < 0.03 * 0.02) == alike


def test_two_runs_are_not_identified_while_a_further_term_may_carry_over_a_fifth_of_the_loss():
    runs = [observed("1+2", [0.006, 0.006], 14, 1e-2, seed=s) for s in (1, 2)]
    answer = asy.identify(runs, laws=["1", "1+2"])
    assert answer.verdict.kind == "several laws are consistent"
    assert "a further term may carry over a fifth of the loss" in answer.verdict.text


def test_the_picture_is_drawn():
    answer = asy.identify(observed("1+2", [0.01, 0.02], 40, 1e-3, seed=1), laws=["1", "1+2"])
    svg = answer.picture("svg", panels=True)
    assert svg.startswith(b"<?xml")
    mean, decrement, band = decrement_band(answer.law("1+2").law.fit)
    first_order = np.pi / 2 * 0.01 * mean + 4 / 3 * 0.02 * mean**2
    assert (np.abs(decrement - first_order) < 3 * band + 0.02 * first_order).all()
    with pytest.raises(InputError, match="plot"):
        asy.identify([observed("1", [0.01], 30, 1e-3, seed=s) for s in (1, 2)], laws=["1"]).picture()


def test_the_page_is_whole_escapes_what_it_was_given_and_fetches_nothing(tmp_path):
    data = tmp_path / "<script>alert(1)</script>&.csv".replace("/", "_")
    seen = observed("1+2", [0.01, 0.02], 40, 1e-3, seed=1)
    data.write_text("n,x_mm\n" + "\n".join(f"{n},{x:.6f}" for n, x in zip(seen.n, seen.x)))
    page = tmp_path / "page.html"
    line = ["identify", str(data), "--laws", "1", "1+2", "--no-bootstrap", "--html", str(page)]
    assert main(line) == 0
    text = page.read_text()
    assert ElementTree.fromstring(text).tag == "html"  # well formed
    assert text.count("<svg") == 1
    assert not re.search(
        r"<script|<link|src=|@import|https?://(?!www\.w3\.org|purl\.org|creativecommons|matplotlib)", text
    )
    assert "&lt;script&gt;alert(1)&lt;_script&gt;&amp;.csv" in text
    for wanted in (
        "identified: 1+2",
        "ΔAICc",
        "SHA-256",
        "Froude",
        "41 turning points without times",
        "no_bootstrap: True",
    ):
        assert wanted in text, wanted
    assert main([*line[:-1], str(tmp_path / "page.txt")]) == 2
    assert main([*line[:-1], str(data)]) == 2


def test_a_page_of_printed_decrements_says_why_it_has_no_picture():
    table = {"amplitude": [1.0, 0.8, 0.6], "decrement": [0.1, 0.06, 0.04], "resolution": [0.005] * 3}
    text = html_report(asy.identify(table, laws=["1", "2"]))
    assert "No picture: there is no single run of turning points to draw" in text
    assert "3 decrements, mean amplitudes from 1 to 0.6" in text


TABLE = [  # the table of the theory page: percent, without and with an ignored spring of 1 % drift
    ("1", [0.1], "logarithmic decrement", [0.13], [-0.29]),
    ("2", [0.1], "Bertin", [-0.17], [-0.82]),
    ("1+2", [0.06, 0.2], "Froude", [1.41, -2.00], [2.74, -3.73]),
    ("1+2", [0.06, 0.2], "energy", [2.21, -2.38], [4.26, -4.47]),
    ("0+1", [0.01, 0.05], "Feeny-Liang", [0, 0], [4.56, -3.34]),
]


@pytest.mark.parametrize(("law", "strengths", "name", "alone", "sprung"), TABLE)
def test_the_errors_of_the_theory_page(law, strengths, name, alone, sprung):
    sign = np.where(np.arange(13) % 2, -1.0, 1.0)
    for text, given, expected in ((law, strengths, alone), (law + "+s3", [*strengths, 8 / 300], sprung)):
        found = ESTIMATORS[name][1](sign * np.exp(exact(text, given, 12).a))
        assert 100 * (found / np.array(strengths) - 1) == pytest.approx(expected, abs=0.006)


def test_pictures_have_the_quantile_of_the_intervals():
    # ten turning points leave so few freedoms that 1.96 would be far too short
    answer = asy.identify(observed("1", [0.05], 8, 1e-3, seed=4), laws=["1"], bootstrap=False)
    fit = answer.law("1").law.fit
    t = quantile(fit, 0.95, "x")
    assert t > 2.3
    slopes = fit.model.amplitudes(fit.theta)[1]
    gradient = np.zeros(fit.model.size)
    gradient[: fit.model.after] = slopes[:, 0] - slopes[:, 1]
    assert decrement_band(fit)[2][0] == pytest.approx(t * fit.directions.standard_error(gradient), rel=1e-9)
