"""How often the look of errors is right: the table of docs/tables.md, on laws that no threshold was chosen on."""

from collections import Counter
from pathlib import Path

import numpy as np
import pytest

from asymptotics.decays.comparison.errors import Errors, of_motion, of_turning_points
from asymptotics.decays.comparison.quick_look import _exponent, look_of
from tests.decays.comparison import battery

DOCS = Path(__file__).parents[3] / "docs" / "tables.md"
ANSWERS = ("rounding", "truncation", "phase drift", "wrong law", "undecided")


def looks(law, tau, what=None):
    """(what it is, its name, the answer) for every way of being wrong."""
    x, v, (times, sizes) = battery.truth(law, tau)
    near = times <= tau[-1]
    for kind, name, run in battery.WAYS:
        if what is None or kind in what:
            given = run(law, tau)
            errors, ns = of_motion(tau, given, x, v, (times[near], sizes[near]))
            relative = np.max(abs(given - x) / np.maximum(abs(x), 1e-9))
            lost = 0.0 if kind == battery.ROUNDED else 16 + np.log10(max(relative, 1e-17))
            yield kind, name, look_of(errors, errors.tau - np.pi * ns, lost)


def counted(laws, grids=(battery.FINE, battery.COARSE)):
    found = {kind: Counter() for kind in battery.RIGHT}
    for law in laws:
        for tau in grids:
            for kind, _, look in looks(law, tau):
                found[kind][look.kind] += 1
    return found


def as_table(found):
    """The lines of the table in the docs."""
    lines = [f"| what the values are | {' | '.join(ANSWERS)} |", "|---" * (1 + len(ANSWERS)) + "|"]
    for kind, counts in found.items():
        cells = (
            f"**{counts[a]}**" if counts[a] and a in battery.RIGHT[kind] else str(counts[a] or "") for a in ANSWERS
        )
        lines.append(f"| {kind} | {' | '.join(cells)} |")
    return lines


@pytest.mark.slow
def test_no_integrator_is_called_a_wrong_law_and_no_law_an_integrator():
    """One law here; eight others in the slow test."""
    for kind, name, look in looks(((1.5,), (0.15,)), battery.FINE, set(battery.RIGHT) - {battery.SLIGHTLY}):
        assert look.kind in battery.RIGHT[kind] | {"undecided"}, (name, look)


@pytest.mark.slow
def test_the_table_in_the_docs_is_what_is_measured():
    text = DOCS.read_text()
    assert "\n".join(as_table(counted(battery.UNSEEN))) in text


@pytest.mark.parametrize("times", [True, False])
@pytest.mark.parametrize(("factor", "power"), [(1.1, 0.0), (0.95, 0.0), (1.001, 0.0), (1.0, 0.2), (1.0, -0.05)])
def test_a_table_of_turning_points_of_another_law(times, factor, power):
    tau, law = battery.FINE, ((2.0,), (0.1,))
    (T, A), (wrong_T, wrong_A) = (battery.truth(((2.0 + p,), (0.1 * f,)), tau)[2] for f, p in ((1, 0), (factor, power)))
    n = np.arange(min(len(T), len(wrong_T)))
    errors = of_turning_points(n, wrong_A[n], A[n], *((wrong_T[n], T[n]) if times else ()))
    assert look_of(errors, T[n] - np.pi * n if times else None, 9.0).kind == "wrong law", law


def test_a_noisy_table_of_turning_points_is_undecided():
    T, A = battery.truth(((2.0,), (0.1,)), battery.FINE)[2]
    noisy = A * (1 + 1e-2 * np.random.default_rng(1).standard_normal(len(A)))
    assert look_of(of_turning_points(np.arange(len(A)), noisy, A), None, 13.0).kind == "undecided"


@pytest.mark.parametrize(("share", "kind"), [(0.5, "phase drift"), (1e-3, "phase drift"), (1e-5, "truncation")])
def test_wrong_times_beside_dry_friction_are_told_as_a_share_of_the_time(share, kind):
    ns = np.arange(8)
    size = 1 - 0.1 * ns
    errors = of_turning_points(ns, size * (1 + 1e-7 * ns), size, np.pi * ns * (1 + share), np.pi * ns)
    look = look_of(errors, errors.tau - np.pi * ns, 5.0)
    assert (look.kind, float(look.frequency)) == (kind, pytest.approx(share, rel=1e-2))
    assert kind == "truncation" or look.reason.endswith(f"off by {share:.2%}")


def test_the_exponent_is_that_of_the_given_amplitudes_not_of_the_true_ones():
    tau = np.linspace(0, 40, 14)
    true, given = np.exp(-tau / 100), 1 / (1 + tau / 10)  # A' = -A/100, A' = -A^2/10
    assert _exponent(Errors(tau, true, np.log(given / true), None)).endswith("as if alpha were 2.00")
