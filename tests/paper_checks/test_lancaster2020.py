"""Every statement of Lancaster 2020: present, borne out by its check, and refutable; figures; independent routes."""

from math import cos, pi

import numpy as np
import pytest
from scipy.integrate import quad, solve_ivp
from scipy.special import beta, hyp2f1

from paper_checks.lancaster2020 import model
from paper_checks.lancaster2020.figures import Run
from paper_checks.registry import load
from paper_checks.verdict import Printed

ENTRIES = load("lancaster2020")
SOUND = (Printed.HOLDS, Printed.DEFINITION)

TABLE = ["table1.alpha0", "table1.alpha1", "table1.alpha3-2", "table1.alpha2", "table1.alpha3"]
NOT_HOLDING = {  # found by hand from the paper's own equations, see the notes of the entries
    "8": "partly",
    "15": "partly",
    "17": "partly",
    "22": "partly",
    "fn22": "partly",
    "table1.alpha3": "transcription",
    "claim.solvable-only-linear": "partly",
    "claim.corollary": "partly",
    "claim.never-strictly-zero": "partly",
    "claim.phase-at-start": "partly",
    "claim.slow-dissipation": "transcription",
    "claim.slow-timescale": "partly",
    "claim.energy-derivative": "transcription",
    "claim.weak-equals-slow": "transcription",
    "claim.valid-for-any-b": "partly",
    "claim.large-b-agreement": "partly",
    "claim.gradual-breakdown": "partly",
    "claim.fails-at-long-times": "partly",
    "claim.velocity-sign": "misprint",
    "claim.any-exponent": "partly",
    "claim.single-term-slow": "partly",
    "claim.no-exact-solutions": "partly",
    "claim.fn20-speed": "open",
}


def short(key: str) -> str:
    return key.removeprefix("lancaster2020:")


def test_the_ids_are_the_papers_numbering():
    ids = {short(key) for key in ENTRIES}
    claims = {key for key in ids if key.startswith("claim.")}
    numbered = {str(number) for number in range(1, 23)}
    assert ids - claims == numbered | {"fig1", "fig2", "fig3", "fn20", "fn22", "fn23", *TABLE}
    assert len(claims) >= 50


def test_entries_stand_in_reading_order():
    numbers = [int(short(key)) for key in ENTRIES if short(key).isdigit()]
    assert numbers == list(range(1, 23))
    assert [short(key) for key in ENTRIES if "table1.alpha" in key] == TABLE


def test_verdicts_other_than_holds():
    found = {short(key): str(entry.verdict) for key, entry in ENTRIES.items() if entry.verdict not in SOUND}
    assert found == NOT_HOLDING


def test_figure_1_stops_at_the_exact_place():
    """x_8 = 1 - 16 epsilon with epsilon = 0.0659734, from 8 pi on."""
    run = Run.of({"0": "0.0659734"}, 30)
    assert np.ptp(run.exact[run.tau > 8 * pi]) == 0
    assert run.exact[-1] == pytest.approx(1 - 16 * 0.0659734, abs=1e-14)


def test_the_reference_motion_agrees_with_an_integrator():
    """SciPy, one half-swing after the other with a terminal event at v = 0, as an independent route."""
    epsilon, end = 0.4152, 20.0
    x, time = 1.0, 0.0

    def turns(t, y):
        return y[1] if t > time + 0.1 else -np.sign(x)

    turns.terminal = True
    while True:
        s = -np.sign(x)
        run = solve_ivp(lambda t, y, s=s: [y[1], -y[0] - epsilon * s * max(s * y[1], 0) ** 1.5], (time, end), [x, 0.0],
                        events=turns, rtol=1e-11, atol=1e-12)  # fmt: skip
        if run.t[-1] >= end:
            break
        x, time = run.y[0, -1], run.t[-1]
    expected = model.exact_states((("3/2", "0.4152"),), ("20",))[0][0]
    assert run.y[0, -1] == pytest.approx(expected, abs=1e-8)


@pytest.mark.parametrize("alpha", [0, 0.5, 1.5, 2, 3, 7.3])
def test_equation_12_by_quadrature(alpha):
    mean = quad(lambda s: np.sin(s) ** (alpha + 1), 0, pi)[0] / pi
    assert 2 ** (alpha + 1) * beta(alpha / 2 + 1, alpha / 2 + 1) / pi == pytest.approx(mean, rel=1e-9)


@pytest.mark.parametrize("pair", [(1, 2), (0, 2), (2, 3), (0, 0.75), (1.5, 3)])
def test_footnote_22_by_quadrature(pair):
    """Where the exponents are not exceptional, between 1/2 and 1 with c = 1, c' = 0.3."""
    a, e = pair

    def antiderivative(x):
        index = (e - 1) / (e - a)
        return x ** (1 - e) / (0.3 * (1 - e)) * hyp2f1(1, index, (1 + a - 2 * e) / (a - e), -(x ** (a - e)) / 0.3)

    true = quad(lambda x: 1 / (x**a + 0.3 * x**e), 0.5, 1)[0]
    assert antiderivative(1) - antiderivative(0.5) == pytest.approx(true, rel=1e-9)


def test_footnote_22_is_useless_at_an_exceptional_pair():
    """(0, 1/2): index -1, lower parameter 0; and (0, 1): division by zero."""
    assert not np.isfinite(hyp2f1(1, -1.0, 0.0, -0.5))
    with pytest.raises(ZeroDivisionError):
        1.0 ** (1 - 1) / (0.3 * (1 - 1))


def test_the_literal_constant_phase_would_halve_the_rate_for_large_alpha():
    """Note of (8): with the frozen phase A' ~ -|sin|^(alpha-1)/2, mean (alpha+1)/(2 alpha) M_(alpha+1)."""
    for alpha in (0.7, 2, 3.5):
        literal = quad(lambda s, a=alpha: np.sin(s) ** (a - 1) / 2, 0, pi)[0]
        right = quad(lambda s, a=alpha: np.sin(s) ** (a + 1), 0, pi)[0]
        assert literal / right == pytest.approx((alpha + 1) / (2 * alpha), rel=1e-6)


def test_the_linear_reference_is_the_closed_form():
    assert model.exact_states((("1", "1/5"),), ("7",))[0][0] == pytest.approx(model.linear_motion(0.2, 7.0), abs=1e-14)
    assert model.linear_motion(1e-9, 2.0) == pytest.approx(cos(2.0), abs=1e-8)
