"""The methods that a statement names are those its check runs: each word for a tool is found in a trace, both ways."""

import functools
import gc
import random
import re
import sys

import pytest

from paper_checks.registry import PAPERS, load
from paper_checks.verdict import Printed

STATEMENTS = load()
CHECKED = [key for key, entry in STATEMENTS.items() if entry.check and entry.verdict != Printed.OPEN]
SAMPLE = sorted(CHECKED, key=lambda key: random.Random(key).random())[:9]  # a new statement changes one at most

TOOLS = {  # names of what runs, and the functions that are it
    "derivative": r"sympy\.core\.function\.diff",
    "limit": r"sympy\.series\.limits\.limit",
    "substitution": r"sympy\.core\.basic\.Basic\.subs",
    "solution": r"sympy\.solvers\.solvers\.solve",
    "expansion": r"sympy\.core\.expr\.Expr\.series|sympy\.polys\.polytools\.Poly\.__new__",
    "integral": r"sympy\.integrals\.integrals\.integrate|\w*\.?_certified_mean",
    "exact motion": r".*\.(exact_states|linear_motion|viscous|viscous_velocity|coulomb|air|half_swings|turning_error)",
    "turning points": r".*\.(turning_points|amplitudes|next_amplitude|orbit|half_swings|turning_error|linear_motion)",
    "orbit": r".*smith2012\.model\.(orbit|excludes_zero_on_orbit)",
    "balls": r".*\.(below|rounds_to|balls_agree|orbit|excludes_zero_on_orbit|with_numbers)",
    "certified comparison": r"paper_checks\.identities\.(below|rounds_to|balls_agree)",
    "quadrature": r"mpmath\.calculus\.quadrature\..*quad|.*\._certified_mean",
    "rows": r".*\.(polynomial_row|printed_polynomial)",
    "Euler steps": r".*\._mean_speed",
    "order": r".*\.(measured_order|order_of|_mean_speed)|.*weakly_damped\.<locals>\.largest",
    "dimension": r".*\.(dimension|drag_constant|slow_dissipation)",
    "polynomials": r".*\.same_polynomial",
    "exact rate": r".*\.exact_rate_expanded",
}
NEEDS = {  # a word in the methods, and the tools one of which must have run
    r"differentiat|derivative|chain rule|product rule|rate along|gradient": ("derivative", "polynomials"),
    r"\blimits?\b": ("limit", "substitution", "derivative"),
    r"substitut|inserted|initial values|at t = 0": ("substitution", "derivative", "rows", "polynomials"),
    r"\bsolved\b": ("solution", "substitution"),
    r"\bseries\b|expanded|expansion|Taylor": ("expansion", "derivative", "limit", "rows"),
    r"^mean (of|over) |means\b|integral (worked|over)": ("integral", "substitution"),
    r"exact motion": ("exact motion", "substitution"),
    r"error of (A|the)|largest error": ("order",),
    r"turning points": ("turning points", "balls", "derivative", "substitution"),
    r"\bballs\b|certified": ("balls",),
    r"on the orbit": ("orbit",),
    r"Lambert": ("orbit", "turning points"),
    r"quadrature": ("quadrature",),
    r"rows to": ("rows",),
    r"Euler steps": ("Euler steps",),
    r"^dimension": ("dimension",),
    r"exact (rate of the )?envelope": ("exact rate",),
}
SAID = {  # what ran, and the words one of which must stand in the methods
    "order": r"error|exact motion|quadrature|Euler",
    "certified comparison": r"balls|certified",
    "quadrature": r"quadrature",
    "Euler steps": r"Euler|scheme",
    "rows": r"rows|coefficients|exact rationals|<=|induction|f_2|\(59\)",
    "orbit": r"balls|orbit",
}


def caches():
    """Whatever remembers a result: a call that is answered from memory cannot be seen."""
    gc.unfreeze()  # what was frozen after the collection of the tests is not among the objects
    found = (o for o in gc.get_objects() if isinstance(o, functools._lru_cache_wrapper))
    papers = tuple(f"paper_checks.{paper}." for paper in PAPERS)
    return [o for o in found if (o.__module__ or "").startswith((*papers, "asymptotics."))]


def tools(entry):
    """The names of the tools that run when the check confirms the true form."""
    names = set()

    def note(frame, event, argument):
        if event == "call":
            names.add(f"{frame.f_globals.get('__name__', '')}.{frame.f_code.co_qualname}")

    for cache in caches():
        cache.cache_clear()
    sys.setprofile(note)
    try:
        entry.check(entry.printed if entry.corrected is None else entry.corrected)
    finally:
        sys.setprofile(None)
    return {tool for tool, pattern in TOOLS.items() if any(re.fullmatch(pattern, name) for name in names)}


def faults(entry):
    ran, said = tools(entry), "; ".join(entry.methods)
    unused = [w for w, any_of in NEEDS.items() if re.search(w, said) and not ran & set(any_of)]
    unsaid = [tool for tool, words in SAID.items() if tool in ran and not re.search(words, said)]
    return unused, unsaid


@pytest.mark.parametrize("key", SAMPLE)
def test_a_sample_names_what_ran(key):
    assert faults(STATEMENTS[key]) == ([], []), STATEMENTS[key].methods


@pytest.mark.slow
@pytest.mark.parametrize("key", sorted(set(CHECKED) - set(SAMPLE)))
def test_every_statement_names_what_ran(key):
    assert faults(STATEMENTS[key]) == ([], []), STATEMENTS[key].methods
