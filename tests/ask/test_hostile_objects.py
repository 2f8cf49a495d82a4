"""Every public function, constructor and method under values that mean something else: answered, or refused by name.

One parameter at a time is handed each of the hostile values; hypothesis draws pairs of them.  Where the hint of a
parameter is a whole number, or a number, what is none is refused, never taken for one.
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
from numpy.typing import ArrayLike

import asymptotics as asy
from asymptotics.errors import MAX_ACCEPTED, MAX_REASON
from asymptotics.numbers.policy import Number
from tests.every_call import CALLS, answered, methods, parameters
from tests.present.every_type import hints
from tests.worlds import OSCILLATOR as OSC

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
    "ball": arb(1, 2), "function": lambda *_: 0, "type": int, "slice": slice(1),
    "dots": ..., "range": range(2), "far range": FAR,
    "far view": np.broadcast_to(1.0, 10**18), "law": asy.Law({2: 1}), "SI law": OSC.law, "oscillator": OSC,
    "equations": asy.expand(2, order=1), "coefficient": asy.moment(2),
}  # fmt: skip

HOSTILE = NUMBERS | NO_NUMBERS
KINDS = (  # one of each kind, for `make test`; all of them are walked by `make test-thorough`
    "float", "-1", "nan", "None", "True", "1j", "x", "surrogate", "huge", "Decimal huge", "sympy Float", "array",
    "dict", "nan dict", "unprintable", "far range",
    "far view", "mpmath interval", "huge exponent", "lying number", "oscillator", "coefficient", "ball",
)  # fmt: skip
ALL = tuple(HOSTILE)
WALKED = pytest.mark.parametrize("kinds", [KINDS, pytest.param(ALL, marks=pytest.mark.slow)], ids=["few", "all"])
BIG = ("huge", "longer", "huge text")
"""Numbers, though few can be computed with."""
ARRAYS = ("nan", "numpy nan", "-inf", "array", "no array", "list", "tuple", "range", "bytes")
"""What may stand for an array: where it has no number, the answer has none."""
OURS = ("notes", "purpose", "folder", "path")
"""Texts of our own, for messages; files, whose names are tried elsewhere."""
SLOW = {("T", "w"), ("remainder", "law"), ("stokes", "alpha"), ("response", "law"), ("best_order", "delta")}
"""A number takes seconds there, or all its time."""
DRAWN = ("picture", "plot", "html_report")
"""They take long: few values, in the short walk."""
DEAR = {
    "ImplicitSolution.at", "ImplicitSolution.at_time", "ImplicitSolution.proved", "ImplicitSolution.to_dict",
    "Reference.certificate", "Solution.sample", "TurningPoints.picture",
}  # fmt: skip
"""Half a second each: in the walk over all values alone, where others of their kind stay in the short one."""
BALLS = {"Oscillator.deltas", "Oscillator.to_si", "Term.delta", "Waveforms.enclosed", "GeneratingFunction.scaled_at"}
"""Formulas in balls for the package itself."""


def refused_or_answered(call):
    """Whether it answers; the message of a refusal is one short line that names an argument, as Python calls it."""
    if "matplotlib.pyplot" in sys.modules:  # pictures that were drawn before
        sys.modules["matplotlib.pyplot"].close("all")
    begin = time.process_time()
    try:
        found = call()
    except (asy.InputError, asy.UndecidedError) as error:
        assert "\n" not in str(error) and len(str(error)) < MAX_REASON + MAX_ACCEPTED + 100
        assert isinstance(error, asy.UndecidedError) or (
            error.argument[:1] != "-" and error.argument and error.accepted
        )
        # A library may be loaded on the way.
        assert isinstance(error, asy.LimitError) or time.process_time() - begin < 4, "refused late"
        return False
    if type(found).__module__.startswith("asymptotics") and not isinstance(found, type):
        for show in ("__repr__", "__str__", "_repr_latex_", "to_dict"):
            getattr(found, show, str)()
    return True


def never(function, parameter):
    """Which hostile values mean nothing for a parameter, by its hint."""
    own = inspect.unwrap(function.__init__ if isinstance(function, type) else function)
    hint = hints(own).get(parameter)
    if hint == ArrayLike:
        return NO_NUMBERS.keys() - {*ARRAYS}
    if hint not in (int, Number, int | None, Number | None):  # a ball is never its middle
        return {"ball"} if parameter in ("t", "times", "A", "law") and hint is not float else set()
    may = {"None"} if hint in (int | None, Number | None) else set()
    return NO_NUMBERS.keys() - may - (set() if hint in (int, int | None) else {*BIG})


def faults(label, function, usual, kinds=ALL):
    """``function`` with its usual arguments, one of them replaced by each hostile value: what must not happen."""
    found = []
    # A hostile value may ask for much: it is refused when its time is over, and that comes soon.
    usual = {**usual, **({"max_seconds": 3} if "max_seconds" in parameters(function) else {})}
    for parameter in (p for p in parameters(function) if p not in OURS):
        refuses = never(function, parameter)
        for kind in kinds:
            value = HOSTILE[kind]
            slow = {(label, parameter), (label.rpartition(".")[2], parameter)} & SLOW and kind in NUMBERS
            # What a function of the caller does is its own; without ``workers`` there is a pool of processes.
            if slow or callable(value) and parameter in ("y", "task", "progress", "crew"):
                continue
            if parameter == "max_seconds" and kind in NUMBERS and kinds is not ALL:  # the usual call once more
                continue
            if parameter == "workers" and kind in ("None", "int64", "uint8", "tiny", "-0.0"):
                continue
            arguments = {**usual, parameter: value}
            try:
                taken = refused_or_answered(lambda arguments=arguments: function(**arguments))
            except Exception as error:  # noqa: BLE001 (what must not happen is reported, all of it)
                found.append(f"{label}({parameter}={kind}): {type(error).__name__}: {error!s:.80}")
            else:
                found += [f"{label}({parameter}={kind}) is answered"] if taken and kind in refuses else []
    return found


@WALKED
@pytest.mark.parametrize("name", [name for name in CALLS if name != "plot"])
def test_public_calls_answer_or_refuse(name, kinds, tmp_path):
    call = getattr(asy, name)
    usual = answered(call, folder=tmp_path / "store")
    assert usual is not None, f"no usual arguments of {name} are answered: tests/every_call.py"
    assert faults(name, call, usual, kinds[:2] if kinds is KINDS and name in DRAWN else kinds) == []


@WALKED
def test_methods_of_results_answer_or_refuse(kinds, tmp_path):
    found, drawn = [], set()
    with np.errstate(all="ignore"):
        for label, bound in methods():
            name = label.rpartition(".")[2]
            if label in BALLS or (kinds is KINDS and (name in drawn or label in DEAR or name == "best_order")):
                continue
            few = kinds[:2] if kinds is KINDS and name in DRAWN else kinds
            drawn |= {name} & {*DRAWN}
            usual = ((method, answered(method, path=tmp_path / "file")) for method in bound)
            method, first = next(((m, u) for m, u in usual if u is not None), (None, None))
            assert first is not None, f"no usual arguments of {label} are answered: tests/every_call.py"
            found += faults(label, method, first, few)
            if name not in DRAWN and kinds is not KINDS:  # what several share is called for one more
                next(usual, None)
    assert found == []


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
        assert label == "uint8" or isinstance(value in row, bool)


@settings(max_examples=60, deadline=None)
@given(st.data())
def test_any_two_hostile_values_at_once(data):
    name = data.draw(st.sampled_from(sorted({*CALLS} - {"plot", "html_report", "sweep", "sweep_command", "identify"})))
    own = sorted({*parameters(getattr(asy, name))} - {*OURS})
    chosen = data.draw(st.lists(st.sampled_from(own), max_size=2, unique=True)) if own else []
    drawn = {p: HOSTILE[data.draw(st.sampled_from(sorted(HOSTILE)))] for p in chosen}
    usual = answered(getattr(asy, name)) | ({"max_seconds": 3} if "max_seconds" in own else {})
    refused_or_answered(lambda: getattr(asy, name)(**{**usual, **drawn}))


BAD = ({"p": math.nan}, {"p": [Unprintable()]}, {1: "2"}, {"p": []}, [{}], [{"p": 10**5000}], [{"p": None}])


@pytest.mark.parametrize("options", BAD, ids=range(len(BAD)))
def test_options_of_a_sweep_that_mean_something_else(options, tmp_path):
    refused_or_answered(lambda: asy.sweep_command("moment", options, tmp_path / "store", workers=1))
