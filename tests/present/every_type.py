"""Every result type of the public API, found by walking it, with one of each: a new type without a sample is an error.

>>> len(types()) > 40 and {name_of(found) for found in types()} == set(SAMPLES)
True
"""

import inspect
import typing
from collections.abc import Callable
from dataclasses import is_dataclass
from functools import cache
from typing import Any

import sympy

import asymptotics as asy
from asymptotics.expansions.divergence.truncation import BestOrder
from tests.every_question import IN_PYTHON, call_of, usual

PARTS = {  # what stands inside a result and is no answer of its own
    "bounds.local.LocalBounds": "the constants behind ExpansionBounds",
    "bounds.uniform.Displacement": "the constants behind ExpansionBounds",
    "decays.identification.inverse_damping.Problem": "what was asked, behind DampingLaw",
    "envelopes.laurent.LaurentEnvelope": "formulas behind EnvelopeSeries",
    "series.PowerSeries": "arithmetic of series",
    "terms.Scaled": "a strength, printed as text",
    "terms.Units": "the units of Scaled",
    "expansions.equations.strengths.Strengths": "how an equation prints its strengths",
    "decays.identification.judging.laws.Judged": "the judged law behind LawAnswer",
    "decays.identification.measuring.observations.Observations": "the data as they were read",
    "decays.identification.fitting.printed.Decrements": "the data as they were read",
    "decays.identification.telling.record_units.RecordUnits": "the units of the data",
    "expansions.multiple_scales.initial.InitialConditions": "series behind MultipleScales",
    "expansions.multiple_scales.exact.OddHierarchy": "the kernel behind MultipleScales",
    "expansions.multiple_scales.turning.TurningHierarchy": "the kernel behind MultipleScales",
}
SETUP = """
import numpy as np, tempfile
from pathlib import Path
import asymptotics as asy
osc = asy.Oscillator({"3/2": "1/10"}, mass="3/2", stiffness=30, x0="1/5")
eq = asy.expand({"3/2": "1/10"}, order=3)
motion = asy.motion(osc, order=2)
points = asy.turning_points(osc, 4, digits=15, times=True)
cycle = asy.limit_cycle({1: -1, (1, 2): 1}, order=4, digits=12, mu='1/5')
folder = Path(tempfile.mkdtemp())
_ = (folder / "mine.csv").write_text("n,x\\n0,1\\n1,-0.4107197\\n2,0.2635711\\n")
compared = asy.compare(folder / "mine.csv", {2: 1})
rows = {"A": [1, 2, 3, 4], "zeta": [0.011, 0.019, 0.031, 0.041]}
table_law = asy.damping_law(rows, resolution="1/1000", laws=["1", "2"])
n = np.arange(30)
noise = 1e-3 * np.random.default_rng(0).standard_normal(30)
answer = asy.identify({"n": n, "x": (-1.0) ** n * 0.95**n + noise}, laws=["1", "2", "1+2"], bootstrap=False)
"""
SAMPLES = {
    "tables.validation.Validation": "asy.table('moments', alpha=1, digits=8).validate()",
    "curves.large.SpringEnvelope": "asy.envelope(asy.Oscillator({2: '1/20'}, spring='pendulum', x0=3))",
    "curves.events.Events": "motion.events(3)",
    "curves.motions.Motion": "motion",
    "curves.motions.Reference": "asy.reference(osc)",
    "curves.shown_solution.SolutionPoint": "asy.solution({2: '1/10'}, order=3).at(7, digits=12)",
    "curves.implicit.ImplicitSolution": "asy.solution({1: '1/10', 2: '1/20'}, order=2)",
    "curves.slow.Envelope": "asy.envelope(osc)",
    "curves.slow_series.EnvelopeSeries": "asy.envelope({2: '1/10'}).series(3)",
    "curves.slowness.SlowPart": "asy.envelope(osc).slow('1/50')",
    "curves.solution.Solution": "asy.solution({2: '1/10'}, order=3)",
    "curves.waves.Waveforms": "asy.waveforms('3/2', order=3)",
    "bounds.reach.Reach": "asy.solution({1: '1/10', 2: '1/20'}, order=1).proved_until('1/2')",
    "bounds.remainder.ExpansionBounds": "asy.remainder(2, order=2)",
    "bounds.uniform.UniformBound": "motion.uniform_bound()",
    "decays.comparison.run.Comparison": "compared",
    "decays.comparison.run.ComparedValue": "compared.rows[1]",
    "expansions.divergence.result.StokesConstants": "asy.stokes(2, digits=8)",
    "expansions.divergence.truncation.BestOrder": "asy.expand(3, order=1).best_order('1/5')",
    "envelopes.explicit.ClosedForm": "asy.envelope(osc).formula",
    "equivalent.conversions.Conversion": "asy.damping(asy.Oscillator({1: 1}, mass=2), 1, digits=6).conversions()[0]",
    "decays.identification.found_law.DampingLaw": "table_law",
    "decays.identification.inverse_damping.DampingCandidate": "table_law.best",
    "decays.identification.inverse_damping.Strength": "table_law.best.strengths[0]",
    "equivalent.result.EquivalentDamping": "asy.damping(osc, ['1/5', '1/10'], order=2, digits=6)",
    "equivalent.rows.DampingRow": "asy.damping(osc, '1/5', order=2, digits=6).rows[0]",
    "equivalent.rows.Measure": "asy.damping(osc, '1/5', digits=6).rows[0].first",
    "expansions.equations.comparison.EquationsComparison": "eq.compare(asy.expand({'3/2': '1/10'}, order=2))",
    "expansions.equations.observables.Observable": "eq.observables().Q",
    "expansions.equations.observables.Observables": "eq.observables()",
    "expansions.equations.result.Equations": "eq",
    "expansions.equations.row.CoefficientRow": "eq.p",
    "expansions.half_swings.half_swing_value.HalfSwingAt": "asy.half_swing(2, delta='1/10', digits=12)",
    "decays.identification.judging.allowance.Allowance": "answer.verdict.allowed[0]",
    "decays.identification.fitting.profile.Interval": "answer.law('1').law.epsilon[0]",
    "decays.identification.telling.result.Identification": "answer",
    "decays.identification.telling.law_answer.LawAnswer": "answer.best",
    "decays.identification.telling.verdicts.Verdict": "answer.verdict",
    "motions.invariants.symbolic.GeneratingFunction": "asy.G(2)",
    "law.Law": "asy.Law({0: '1/50', 2: '1/10'})",
    "law.Oscillator": "osc",
    "law.PhysicalLaw": "osc.law",
    "limit_cycles.certified.CertifiedCycle": "cycle.at_mu",
    "limit_cycles.result.LimitCycle": "cycle",
    "motions.point.MotionPoint": "motion.at(7)",
    "motions.result.MotionSamples": "motion.sample([0.0, 1.0, 2.0])",
    "expansions.multiple_scales.orders.Order": "asy.multiple_scales(2, order=2).orders[1]",
    "expansions.multiple_scales.symbolic.MultipleScales": "asy.multiple_scales(3, order=2)",
    "expansions.normal_form.results.HalfSwingCoefficients": "asy.half_swing(2, order=3, digits=12)",
    "numbers.exact.ExactReal": "asy.ExactReal(1, 2)",
    "numbers.value.Coefficient": "asy.moment(3, digits=15)",
    "papers.statement.PaperStatement": "asy.paper('smith2012:43')",
    "sweeps.run.SweepResult": "asy.sweep(lambda point: {}, 'none', [{'n': '1'}], folder / 'store', workers=1)",
    "tables.table.Table": "asy.table('smith2012.table1', digits=9)",
    "terms.Term": "osc.law.terms[0]",
    "turning.result.TurningPoint": "asy.turning_points({2: 1}, 3, digits=12, times=True).points[1]",
    "frames.Frame": "points.frame",
    "turning.result.TurningPoints": "points.dimensionless",
    "certificates.certificate.Certificate": "points.certificate()",
    "curves.turning_points.MotionTurningPoints": "asy.turning_points({2: 1}, 3, digits=12, times=True)",
}
VARIANTS = (  # of the same types: what another law, start or way of asking makes of them
    "asy.expand('symbolic')", "asy.expand(['1', '2'], order=2)", "asy.expand(osc, order=2)", "asy.expand(3, order=3)",
    "asy.expand('3/2').observables(1, epsilon='1/10')", "asy.moment(2)", "asy.Coefficient('0.5', None)",
    "asy.multiple_scales('5/2', order=3)", "asy.multiple_scales(2, order=3, gauge='turning-point')",
    "asy.multiple_scales('symbolic', order=2)", "asy.envelope({'1/2': '1/10'}).series(3)", "asy.envelope({2: '1/10'})",
    "asy.envelope(osc).sample([0.0, 1.0])", "asy.motion({2: '1/10'}).uniform_bound()",
    "asy.motion(osc).sample([0.0, np.nan])", "asy.reference(osc).sample([0.0, np.nan])", "asy.reference(osc).events(2)",
    "asy.reference({0: '1/50'}, static='1/30')", "asy.reference(osc).at(1, digits=8)", "osc.dimensionless",
    "asy.Oscillator({2: '1/20'}, spring='pendulum', x0=3)", "asy.half_swing(2, delta='1/10')",
    "asy.limit_cycle({1: -1, (1, 2): 1}, mu='1/10', order=4)", "asy.solution({'3/2': '1/10'}, order=4)",
    "asy.solution('symbolic')", "asy.solution({1: '1/10'})", "asy.solution({0: '1/50', 2: '1/10'})",
    "asy.solution(asy.Oscillator({2: '1/10'}, x0='3/5', v0='-4/5'))", "asy.turning_points(osc, 3)",
    "asy.turning_points({2: 1}, 3).certificate()", "asy.waveforms(2, order=2)", "asy.Law({2: 1}).terms[0]",
)  # fmt: skip


@cache
def made(time: int = 1) -> dict[str, Any]:
    """One of each type and variant, by its text, made once in a process for each ``time``; a part is of its whole."""
    names: dict[str, Any] = {}
    exec(SETUP, names)
    texts, found = (*SAMPLES.values(), *VARIANTS), {}
    for text in sorted(texts, key=len):
        whole = max((t for t in found if text.startswith((f"{t}.", f"{t}["))), key=len, default=None)
        part = text if whole is None else f"whole{text.removeprefix(whole)}"
        found[text] = eval(part, names | {"whole": found.get(whole)})
    return {text: found[text] for text in texts}


def name_of(found: type) -> str:
    return f"{found.__module__.removeprefix('asymptotics.')}.{found.__qualname__}"


def samples_of(call: Callable[..., Any]) -> dict[str, str]:
    """What a question answers, by the example of its docstring, and the results that stand in its fields."""
    given = usual(call)
    kind = hints(inspect.unwrap(call)).get("return")
    if given is None or not isinstance(kind, type) or not kind.__module__.startswith("asymptotics"):
        return {}
    text = f"asy.{call.__name__}({', '.join(f'{name}={value!r}' for name, value in given.items())})"
    fields = hints(kind).items() if is_dataclass(kind) else ()
    inner = {t: f"{text}.{field}" for field, hint in fields for t in (hint, *typing.get_args(hint))}
    kinds = {t: path for t, path in inner.items() if isinstance(t, type) and t.__module__.startswith("asymptotics")}
    return {name_of(t): path for t, path in {**kinds, kind: text}.items() if name_of(t) not in PARTS}


@cache
def types() -> tuple[type, ...]:
    """The classes that public functions return, and what their public attributes, properties and methods are."""
    seen: set[type] = set()
    for name in asy.__all__:
        found = getattr(asy, name)
        if inspect.isfunction(found):
            _add(hints(inspect.unwrap(found)).get("return"), seen)
        elif isinstance(found, type) and not issubclass(found, Exception):
            _add(found, seen)
    return tuple(sorted((t for t in seen if name_of(t) not in PARTS), key=name_of))


def hints(thing: object) -> dict[str, object]:
    """The hints of a function or a class; what is only named there is loaded late."""
    late = {"Expr": sympy.Expr, "Eq": sympy.Eq, "Symbol": sympy.Symbol, "BestOrder": BestOrder}
    return typing.get_type_hints(thing, localns=late)


for _name in IN_PYTHON:
    SAMPLES = samples_of(call_of(_name)) | SAMPLES


def _add(hint: object, seen: set[type]) -> None:
    for inner in typing.get_args(hint):
        _add(inner, seen)
    if not isinstance(hint, type) or not hint.__module__.startswith("asymptotics") or hint in seen:
        return
    seen.add(hint)
    if name_of(hint) in PARTS:
        return
    for name, member in inspect.getmembers(hint):
        function = getattr(member, "fget", None) or getattr(member, "func", None) or member
        if (not name.startswith("_") or name == "__call__") and inspect.isfunction(function):
            _add(hints(inspect.unwrap(function)).get("return"), seen)
    if is_dataclass(hint):
        for name, kind in hints(hint).items():
            if not name.startswith("_"):
                _add(kind, seen)
