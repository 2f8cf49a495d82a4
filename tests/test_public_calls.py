"""Every public call under values that mean something else: an answer, or an InputError by name; nothing else, ever.

One parameter at a time is handed each of the hostile values, in every public function, constructor and method of a
public result; hypothesis draws pairs of them.
"""

import inspect
import math
import numbers
import operator
import sys
import time
from datetime import timedelta
from decimal import Decimal
from fractions import Fraction

import mpmath
import numpy as np
import pytest
import sympy
from flint import arb
from hypothesis import given, settings
from hypothesis import strategies as st

import asymptotics as asy
from asymptotics.errors import MAX_ACCEPTED, MAX_REASON
from asymptotics.frames import BARE, frame_of
from tests.every_question import IN_PYTHON, call_of, usual
from tests.worlds import OSCILLATOR as OSC

DECAY = {"n": list(range(12)), "x": [(-0.9) ** n for n in range(12)]}
FAR = range(10**18)  # more numbers than there is memory for


class Unprintable:
    """An object that cannot even be shown."""

    def __repr__(self):
        raise RuntimeError("this object has no text")

    __str__ = __repr__


class Lying:
    """It calls itself a rational number, and fails when it is asked for its value."""

    @property
    def numerator(self):
        raise ZeroDivisionError("no value")

    denominator = numerator


numbers.Rational.register(Lying)

NUMBERS = {
    "float": 1.5, "float32": np.float32(1.5), "float64": np.float64(0.1), "longdouble": np.longdouble("0.1"),
    "int64": np.int64(3), "uint8": np.uint8(2), "Fraction": Fraction(3, 2), "Decimal": Decimal("1.5"),
    "Rational": sympy.Rational(3, 2), "sqrt": sympy.sqrt(2), "mpf": mpmath.mpf("1.5"), "-0.0": -0.0, "0": 0, "-1": -1,
    "numpy text": np.str_("3/2"), "ExactReal": asy.ExactReal(3, 2), "tiny": 5e-324, "big": 1e308,
}  # fmt: skip
NO_NUMBERS = {
    "nan": math.nan, "inf": math.inf, "-inf": -math.inf, "numpy nan": np.float64("nan"), "None": None, "True": True,
    "numpy True": np.True_, "1j": 1j, "complex128": np.complex128(1j), "empty": "", "x": "x", "NUL": "\0",
    "surrogate": "\ud800", "superscript": "²", "huge": 10**400, "longer": 10**5000, "huge text": "1e400",
    "Decimal nan": Decimal("NaN"), "Decimal snan": Decimal("sNaN"), "Decimal inf": Decimal("Infinity"),
    "Decimal huge": Decimal("1e100000"), "I": sympy.I, "sympy nan": sympy.nan, "oo": sympy.oo, "zoo": sympy.zoo,
    "sympy Float": sympy.Float("1.5"), "pi": sympy.pi, "symbol": sympy.Symbol("x"), "sympy true": sympy.true,
    "mpc": mpmath.mpc(1, 1), "mpmath nan": mpmath.nan, "array": np.array([1.0, 2.0]), "no array": np.array([]),
    "texts": np.array(["a"]), "objects": np.array([None, 1], dtype=object), "complex array": np.array([1j]),
    "date": np.datetime64("2020-01-01"), "list": [], "ragged": [[1], [2, 3]], "tuple": (), "dict": {},
    "bad dict": {"x": 1}, "None dict": {None: None}, "nan dict": {2: math.nan}, "set": {1}, "bytes": b"1",
    "object": object(), "unprintable": Unprintable(), "mpmath interval": mpmath.iv.mpf([1, 2]),
    "mpmath complex interval": mpmath.iv.mpc(1, 1),
    "timedelta64": np.timedelta64(1, "s"), "not a time": np.timedelta64("NaT"), "timedelta": timedelta(1),
    "huge exponent": {10**400: 1}, "huge spring": {(10**400, 1): 1}, "lying number": Lying(),
    "function": lambda *_: 0, "type": int, "slice": slice(1),
    "dots": ..., "range": range(2), "far range": FAR,
    "far view": np.broadcast_to(1.0, 10**18), "law": asy.Law({2: 1}), "SI law": OSC.law, "oscillator": OSC,
    "equations": asy.expand(2, order=1), "coefficient": asy.moment(2),
}  # fmt: skip
HOSTILE = NUMBERS | NO_NUMBERS
FEW = NO_NUMBERS | {name: NUMBERS[name] for name in ("float", "int64", "-1", "big")}
KINDS = (  # one of each kind, for `make test`; all of them are walked by `make test-thorough`
    "float", "-1", "nan", "None", "True", "1j", "x", "surrogate", "huge", "Decimal huge", "sympy Float", "array",
    "dict", "nan dict", "unprintable", "far range",
    "far view", "mpmath interval", "huge exponent", "lying number", "oscillator", "coefficient",
)  # fmt: skip
WALKED = pytest.mark.parametrize(
    "kinds", [KINDS, pytest.param(tuple(HOSTILE), marks=pytest.mark.slow)], ids=["few", "all"]
)
CHEAPER = {  # or not among the questions
    "S": {"u": "1/4", "w": "-1/4"}, "T": {"u": "1/4", "w": "-1/4"}, "radii": {"w": "1/2"},
    "C": {"n": 5, "i": 3}, "Coefficient": {"value": "1", "expression": None}, "ExactReal": {"coefficient": 1},
    "G": {"i": 2}, "Law": {"law": {2: 1}}, "Oscillator": {"law": {2: 1}}, "PhysicalLaw": {"law": {2: 1}},
    "damping": {"law": {2: "1/10"}, "amplitudes": 1, "digits": 5, "motion": False},
    "derive": {"name": None}, "envelope": {"law": OSC}, "expand": {"law": "3/2", "order": 2}, "f": {"n": 3},
    "half_swing": {"law": 2, "order": 2}, "limit_cycle": {"law": {1: -1, (1, 2): 1}, "order": 2},
    "motion": {"law": OSC, "order": 2}, "multiple_scales": {"law": 3, "order": 2}, "paper": {"id": "smith2012:43"},
    "any_start": {"scales": asy.multiple_scales(2, order=1)}, "map_of_gauges": {"law": 3},
    "remainder": {"law": 2, "order": 2}, "reference": {"law": OSC}, "solution": {"law": {2: "1/10"}, "order": 2},
    "waveforms": {"law": "3/2", "order": 2},
    "statements": {}, "table": {"name": "smith2012.table1", "digits": 9}, "table_names": {},
    "stokes": {"alpha": 0},
}  # fmt: skip
ASKED = {name.replace("-", "_"): usual(call_of(name)) for name in IN_PYTHON}
ELSEWHERE = {
    "damping_law",
    "compare",
    "html_report",
    "identify",
    "plot",
    "sweep",
    "sweep_command",
    "testing",
}  # they read files and data: below, or with their own tests
FUNCTIONS = {
    name: arguments for name, arguments in (ASKED | CHEAPER).items() if arguments is not None and name not in ELSEWHERE
}
SLOW = {("limit_cycle", "mu"), ("table", "name"), ("T", "w")}  # one of the numbers takes seconds, or all its time


def public_results():
    """One of each public result that has methods with arguments."""
    eq = asy.expand("3/2", order=4)
    points = asy.turning_points(OSC, 2, digits=9)
    return [
        OSC, OSC.law, OSC.law.terms[0], asy.Law({2: 1}), eq, eq.p, eq.p[1], asy.expand(OSC, order=2),
        asy.expand("symbolic"), asy.expand(["1", "2"], order=2), asy.multiple_scales(3, order=2), asy.envelope(OSC),
        asy.motion(OSC, order=2), asy.motion(OSC, order=2).at(7), asy.reference(OSC), points, points.points[0],
        asy.limit_cycle({1: -1, (1, 2): 1}, order=2), asy.half_swing(2, order=2), asy.half_swing(2, delta="1/10"),
        asy.G(2), asy.table("smith2012.table1", digits=9), asy.paper("smith2012:43"), asy.ExactReal(1, 2),
        asy.envelope({"1/2": "1/10"}).series(3), asy.envelope({2: "1/10"}).slow(),
        asy.turning_points({2: 1}, 2, digits=9), asy.damping({2: "1/10"}, 1, digits=5),
        asy.solution({2: "1/10"}), asy.solution({1: "1/10", 2: "1/20"}, order=2),
    ]  # fmt: skip


METHODS = {
    "shape": {"phase": sympy.Symbol("p")}, "with_start_strength": {"found": sympy.Symbol("epsilon")},
    "law": {"text": "1", "name": "1"},
    "at_time": {"oscillator": OSC, "time": 1, "digits": 8}, "refined": {"digits": 8}, "physical": {"i": 0},
    "balls": {"psi": [1]}, "integral": {"n": 1}, "uniform_bound": {"until": 2}, "__getitem__": {"place": 0, "key": 1},
    "period": {"amplitude": 1, "t": 1}, "proved_until": {"within": "1/10"}, "functions": {"strength": "1/10"},
    "number": {"name": "amplitude", "at": 1},
    "best_order": {"delta": 2}, "columns": {"t": [0.0, 1.0]},
    "__call__": {"A": 0.5, "epsilon": "1/10"}, "amplitude": {"t": 1}, "amplitudes": {"t": [1.0]},
    "certificate": {"t": 1, "digits": 9}, "phase_errors": {"t": [1.0]},
    "at": {"t": 1, "time": 1, "psi": 1}, "at_order": {"t": 1, "order": 2},
    "bound": {"t": 1}, "commutator": {"i": 0, "j": 1}, "compare": {"other": asy.expand("3/2"), "epsilon": "1/10"},
    "delta": {"tau": 1, "delta_0": "1/10"}, "events": {"until": 2}, "extinction_time": {"delta_0": "1/10"},
    "from_terms": {"terms": OSC.law.terms}, "get": {"key": 1},
    "lambdify": {"modules": "numpy", "epsilon": "1/10"}, "observables": {"A": 1, "epsilon": "1/10"},
    "phase": {"t": 1, "delta": "1/20", "delta_0": "1/10"}, "phases": {"t": [1.0]},
    "plus": {"other": OSC.law.terms[0]}, "read": {"value": {2: 1}}, "require_pure": {"purpose": "x"},
    "require_dissipative": {"purpose": "x"}, "rhs": {"t": 0.0, "y": [1.0, 0.0]},
    "sample": {"t": [0.0, 1.0], "times": [0.0, 1.0], "psi": [0.0, 1.0], "A": [0.5]},
    "series": {"order": 3}, "slow": {"eta": "1/50"}, "slow_derivative": {"n": 1, "f": sympy.Symbol("a")},
    "sol": {"t": 1.0}, "time": {"amplitude": "1/10", "delta": "1/20", "delta_0": "1/10"}, "with_law": {"law": {2: 1}},
}  # fmt: skip
WORDS = {"purpose", "notes"}  # texts of our own, for messages
INNER = {"enclosed"}  # of balls
BALLS = {"delta", "deltas", "to_si", "scaled_at"}


def refused_or_answered(call):
    """Run it; the message of a refusal is one short line that names the argument."""
    if "matplotlib.pyplot" in sys.modules:  # pictures that were drawn before
        sys.modules["matplotlib.pyplot"].close("all")
    try:
        found = call()
    except (asy.InputError, asy.UndecidedError) as error:
        assert "\n" not in str(error) and len(str(error)) < MAX_REASON + MAX_ACCEPTED + 100
        return
    if type(found).__module__.startswith("asymptotics") and not isinstance(found, type):
        for show in ("__repr__", "__str__", "_repr_latex_", "to_dict"):
            getattr(found, show, str)()


def walk(name, function, usual, values=HOSTILE):
    """``function`` with its usual arguments, one of them replaced by each hostile value."""
    refused_or_answered(lambda: function(**usual))
    failed = []
    for parameter in inspect.signature(function).parameters:
        slow = (name, parameter) in SLOW
        for label, value in values.items():
            if slow and label in NUMBERS:
                continue
            if parameter in WORDS or parameter == "y" and label == "function":
                continue
            arguments = {**usual, parameter: value}
            try:
                refused_or_answered(lambda arguments=arguments: function(**arguments))
            except Exception as error:  # noqa: BLE001 (what must not happen is reported, all of it)
                failed.append(f"{name}({parameter}={label}): {type(error).__name__}: {error}")
    return failed


def test_every_public_name_is_walked():
    functions = {n for n in asy.__all__ if callable(getattr(asy, n)) and not _is_result_or_error(n)}
    assert functions - set(FUNCTIONS) - ELSEWHERE == set()


def _is_result_or_error(name):
    made_by_us = {"DampingLaw", "Envelope", "Equations", "EquivalentDamping", "Events", "Identification", "Motion",
                  "PaperStatement", "Reference", "TurningPoints"}  # fmt: skip
    thing = getattr(asy, name)
    return name in made_by_us or isinstance(thing, type) and issubclass(thing, Exception)


@WALKED
@pytest.mark.parametrize("name", FUNCTIONS)
def test_public_functions_answer_or_refuse(name, kinds):
    # A hostile value may ask for much: it is refused when its time is over, and that comes soon.
    timed = "max_seconds" in inspect.signature(getattr(asy, name)).parameters
    usual = {"max_seconds": 3} if timed else {}
    assert walk(name, getattr(asy, name), usual | FUNCTIONS[name], {kind: HOSTILE[kind] for kind in kinds}) == []


@WALKED
def test_methods_of_public_results_answer_or_refuse(kinds):
    few = {kind: FEW[kind] for kind in kinds if kind in FEW}
    failed, walked = [], set()
    for thing in public_results():
        for name in (n for n in dir(thing) if n in ("__call__", "__getitem__") or not n.startswith("_")):
            try:
                method = getattr(thing, name)
            except asy.InputError:  # a property that this result does not have
                continue
            if not (inspect.isroutine(method) or name == "__call__") or name in {*BALLS, *INNER, "bound", "with_notes"}:
                continue
            usual = {k: v for k, v in METHODS.get(name, {}).items() if k in inspect.signature(method).parameters}
            if isinstance(thing, asy.Equations) and thing.oscillator is not None:
                usual.pop("epsilon", None)
            label, made = f"{type(thing).__name__}.{name}", getattr(method, "__func__", method)
            # A method that several results share is walked once, and called for each of them; pictures take long.
            drawn = name in ("picture", "plot") and kinds is KINDS
            if not drawn or made not in walked:
                found = {} if made in walked else dict([*few.items()][: 2 if drawn else None])
                failed += walk(label, method, usual, found)
            walked.add(made)
    assert failed == []


OPERATORS = (operator.eq, operator.lt, operator.ge, operator.add, operator.sub, operator.mul, operator.truediv,
             operator.pow, lambda a, b: b + a, lambda a, b: b - a, lambda a, b: b * a)  # fmt: skip


@WALKED
def test_operators_of_exact_numbers_answer_or_refuse(kinds):
    number, row = asy.ExactReal(1, 2), asy.expand("3/2", order=2).p
    for label, value in ((kind, HOSTILE[kind]) for kind in kinds):
        if isinstance(value, np.ndarray | np.generic | sympy.Basic | type(mpmath.iv.mpf(1)) | type(mpmath.iv.mpc(1))):
            continue  # on the left of it, NumPy, SymPy and mpmath speak first
        for combine in OPERATORS:
            refused_or_answered(lambda combine=combine, value=value: combine(number, value))
        refused_or_answered(lambda value=value: row[value])
        assert label == "uint8" or isinstance(value in row, bool)


def test_compare_answers_or_refuses(tmp_path):
    file = tmp_path / "mine.csv"
    file.write_text("n,x\n0,1\n1,-0.41\n")
    assert walk("compare", asy.compare, {"file": file, "law": {2: 1}, "columns": None, "digits": None}) == []


@WALKED
def test_identify_answers_or_refuses(kinds):
    n = np.arange(12)
    decay = {"n": n, "x": (-0.9) ** n}
    usual = {"data": decay, "laws": ["1"], "bootstrap": False}
    failed = []
    for parameter in inspect.signature(asy.identify).parameters:
        for label, value in ((kind, NO_NUMBERS[kind]) for kind in kinds if kind in NO_NUMBERS):
            if value is None or label == "empty":
                continue  # what is left out: the answer takes a while
            try:
                refused_or_answered(lambda p=parameter, v=value: asy.identify(**{**usual, p: v}))
            except Exception as error:  # noqa: BLE001
                failed.append(f"identify({parameter}={label}): {type(error).__name__}: {error}")
    assert failed == []


def gated():
    """(name, method, its usual arguments) of results whose other methods take long, or are walked above."""
    explicit, implicit = asy.solution({2: "1/10"}), asy.solution({0: "1/50", 2: "1/10"}, order=2)
    found, times = asy.identify(DECAY, laws=["1"], bootstrap=False), [0.0, 1.0]
    table = asy.damping_law({"A": [1, 0.9, 0.8], "zeta": [0.01, 0.009, 0.008]}, laws=["1"])
    given = {"oscillator": asy.Oscillator({2: "1/10"}), "time": 1, "digits": 8}
    return [
        ("columns", explicit.columns, {"t": times}), ("sample", explicit.sample, {"times": times}),
        ("functions", explicit.functions, {"strength": "1/10"}),
        ("x", lambda tau, strength: explicit.functions()[2](tau, strength), {"tau": 1, "strength": 0.1}),
        ("shape", explicit.shape, {"phase": sympy.Symbol("p")}),
        ("at_time", explicit.at_time, given), ("in_units", explicit.in_units, {"units": "SI"}),
        ("refined", explicit.refined, {"digits": 8}), ("latex", explicit.latex, {"standalone": True}),
        ("implicit columns", implicit.columns, {"t": times}), ("implicit sample", implicit.sample, {"times": times}),
        ("implicit at_time", implicit.at_time, given), ("implicit latex", implicit.latex, {"standalone": True}),
        ("law", found.law, {"text": "1"}), ("table", found.table, {"count": 3}),
        ("physical", found.best.physical, {"i": 0}),
        ("damping law", table.law, {"name": "1"}), ("waves", asy.waveforms(2, order=2).sample, {"psi": times}),
        ("points", asy.turning_points({2: 1}, 2, digits=9).__getitem__, {"place": 0}),
        ("SI points", asy.turning_points(OSC, 2, digits=9).__getitem__, {"place": 0}),
    ]  # fmt: skip


@WALKED
def test_the_gate_serves_methods_too(kinds):
    few = {kind: HOSTILE[kind] for kind in kinds}
    with np.errstate(all="ignore"):
        failed = [fault for name, method, usual in gated() for fault in walk(name, method, usual, few)]
    assert failed == []


def test_constructors_of_results_check_what_they_are_given():
    usual = {
        asy.Motion: {"oscillator": OSC, "order": 2, "gauge": "turning-point", "frame": frame_of(OSC)},
        asy.Reference: {"oscillator": OSC, "static": None, "frame": BARE},
        asy.Envelope: {"oscillator": OSC, "averaging": "mean", "frame": BARE},
    }  # fmt: skip
    failed = []
    for made, arguments in usual.items():
        for name in arguments:
            for label, value in HOSTILE.items():
                try:
                    refused_or_answered(lambda m=made, a={**arguments, name: value}: m(**a))
                except Exception as error:  # noqa: BLE001
                    failed.append(f"{made.__name__}({name}={label}): {type(error).__name__}: {error}")
    assert failed == []


def square(point):
    return {"y": point["x"]}


@pytest.mark.parametrize("name", ["sweep", "sweep_command"])
def test_sweeps_answer_or_refuse(name, tmp_path):
    usual = {
        "sweep": {"task": square, "command": "square", "points": [{"x": "1"}], "folder": tmp_path / "a", "workers": 1},
        "sweep_command": {"command": "moment", "options": {"p": "1"}, "folder": tmp_path / "b", "workers": 1},
    }[name]  # fmt: skip
    failed = []
    for parameter in {*usual, "progress"} & {*inspect.signature(getattr(asy, name)).parameters}:
        for label, value in HOSTILE.items():
            if parameter in ("task", "progress") and callable(value) or parameter == "folder":
                continue  # what a function does is its own; names of folders are tried elsewhere
            if parameter == "workers" and label in ("None", "int64", "uint8", "tiny", "-0.0"):
                continue  # a pool of processes
            try:
                refused_or_answered(lambda p=parameter, v=value: getattr(asy, name)(**{**usual, p: v}))
            except Exception as error:  # noqa: BLE001
                failed.append(f"{name}({parameter}={label}): {type(error).__name__}: {error!s:.80}")
    bad = [{"p": math.nan}, {"p": [Unprintable()]}, {1: "2"}, {"p": []}, [{}], [{"p": 10**5000}], [{"p": None}]]
    for hostile in bad:
        if name == "sweep_command":
            refused_or_answered(lambda value=hostile: asy.sweep_command("moment", value, tmp_path / "c", workers=1))
    assert failed == []


def test_balls_are_not_read_as_their_middle():
    ball = arb(1, 2)
    for call in (asy.solution({2: "1/10"}).columns, asy.solution({2: "1/10"}).sample, asy.motion({2: "1/10"}).sample,
                 asy.envelope({2: "1/10"}).columns, asy.waveforms(2, order=2).sample):  # fmt: skip
        with pytest.raises(asy.InputError, match="arb is not an exact number"):
            call(ball)


def test_points_are_a_sequence():
    for found in (asy.turning_points({2: 1}, 3, digits=9), asy.turning_points(OSC, 3, digits=9)):
        assert len(found) == 3 and [*found] == [*found.points] and found[-1] is found.points[2]
        assert found[1:] == found.points[1:] and found.points[1] in found and bool(found)
        for bad in (3, -4, "x", None, 1.0):
            with pytest.raises(asy.InputError, match="argument place"):
                found[bad]


def test_arithmetic_of_coefficients_encloses():
    quarter, third = asy.Coefficient("0.25000", None), asy.Coefficient("0.33333", None)
    q, t = Fraction(1, 4), Fraction(1, 3)
    for found, true in (
        (quarter + third, q + t), (quarter - third, q - t), (quarter * third, q * t), (quarter / third, q / t),
        (1 - third, 1 - t), (2 / third, 2 / t), (-third, -t), (third * "3/2", t * Fraction(3, 2)),
        (third + 0.1, t + q * 2 / 5),
    ):  # fmt: skip
        low, high = (mpmath.mpf(end) for end in found._mpi_)
        with mpmath.workdps(40):
            value = mpmath.mpf(true.numerator) / true.denominator
            assert low < value < high and high - low < 1e-3
            assert not low < value + mpmath.mpf("1e-2") < high  # near miss
    for bad in (lambda: third / 0, lambda: third * 1j, lambda: third + None, lambda: 1 / asy.Coefficient("0", None)):
        with pytest.raises(asy.InputError):
            bad()


@settings(max_examples=60, deadline=None)
@given(st.data())
def test_any_two_hostile_values_at_once(data):
    name = data.draw(st.sampled_from(sorted(set(FUNCTIONS) - {"limit_cycle", "table", "table_names", "derive"})))
    parameters = sorted(inspect.signature(getattr(asy, name)).parameters)
    chosen = data.draw(st.lists(st.sampled_from(parameters), max_size=2, unique=True)) if parameters else []
    drawn = {p: HOSTILE[data.draw(st.sampled_from(sorted(HOSTILE)))] for p in chosen}
    refused_or_answered(lambda: getattr(asy, name)(**{**FUNCTIONS[name], **drawn}))


def test_a_strength_is_never_taken_for_an_exponent():
    for swapped in (lambda: asy.expand("1/10", "3/2"), lambda: asy.Law("3/2", "1/10"), lambda: asy.Law(1.5)):
        with pytest.raises((TypeError, asy.InputError)):
            swapped()


def test_refusing_is_quick():
    begin = time.process_time()
    for value in NO_NUMBERS.values():
        refused_or_answered(lambda value=value: asy.expand(3, order=value))
    assert time.process_time() - begin < 1
