"""One contract for digits, order, count, start and index: what is no integer in range is an InputError, everywhere."""

import importlib
import inspect
import pkgutil
from fractions import Fraction

import pytest
import sympy
from flint import arb

import asymptotics
from asymptotics.envelopes.first_order import FirstOrderEnvelope
from asymptotics.envelopes.slow_time import certified_slow_time
from asymptotics.errors import InputError
from asymptotics.expansions.half_swings.certified import quarter_swing
from asymptotics.expansions.multiple_scales.symbolic import multiple_scales
from asymptotics.expansions.normal_form.closed_forms import symbolic_coefficients
from asymptotics.expansions.normal_form.coefficients import expansion_coefficients, half_swing_coefficients
from asymptotics.law import Law, Oscillator
from asymptotics.motions.asymptotic import AsymptoticMotion
from asymptotics.motions.coulomb import coulomb_motion, coulomb_stop
from asymptotics.motions.invariants.exact import coefficient, coefficients
from asymptotics.motions.invariants.symbolic import generating_function
from asymptotics.motions.linear import linear_motion
from asymptotics.motions.quadratic import quadratic_motion
from asymptotics.motions.reference import reference_motion
from asymptotics.numbers.decimals import certified_decimal, decimal_of_ball, rational_decimal
from asymptotics.numbers.exact import ExactReal
from asymptotics.tables.registry import build
from asymptotics.turning.choose import turning_points

EPS, TWO = ExactReal(Fraction(1, 10)), (ExactReal(Fraction(2)),)
AIR, DRY, LINEAR = (Oscillator({a: "1/10"}) for a in (2, 0, 1))
LAW = Law({2: "1/10"})
DIGITS = {
    "decimal_of_ball": lambda d: decimal_of_ball(arb(2).sqrt(), d),
    "rational_decimal": lambda d: rational_decimal(Fraction(1, 3), d),
    "certified_decimal": lambda d: certified_decimal(lambda: arb(2).sqrt(), d),
    "AsymptoticMotion.at": lambda d: AsymptoticMotion.of(AIR, 1).at(1, d),
    "reference_motion": lambda d: reference_motion(AIR, 1, d),
    "coulomb_motion": lambda d: coulomb_motion(DRY, 1, d),
    "coulomb_stop": lambda d: coulomb_stop(DRY, d),
    "linear_motion": lambda d: linear_motion(LINEAR, 1, d),
    "quadratic_motion": lambda d: quadratic_motion(AIR, 1, d),
    "FirstOrderEnvelope.amplitude": lambda d: FirstOrderEnvelope(AIR).amplitude(1, d),
    "FirstOrderEnvelope.time": lambda d: FirstOrderEnvelope(AIR).time("1/2", d),
    "FirstOrderEnvelope.phase": lambda d: FirstOrderEnvelope(AIR).phase(1, d),
    "FirstOrderEnvelope.extinction_time": lambda d: FirstOrderEnvelope(DRY).extinction_time(d),
    "turning_points": lambda d: turning_points(LAW, 2, d),
    "expansion_coefficients": lambda d: expansion_coefficients(TWO, 2, d),
    "half_swing_coefficients": lambda d: half_swing_coefficients(TWO, 2, d),
    "symbolic_coefficients": lambda d: symbolic_coefficients(2, "turning-point", d),
    "build": lambda d: build("smith2012.table1", d),
    "api moment 1/2": lambda d: asymptotics.moment("1/2", digits=d),
    "certified_slow_time": lambda d: certified_slow_time(ExactReal(Fraction(3, 2)), 2, d),
    "envelope_series": lambda d: asymptotics.envelope(AIR).series(2, digits=d),
    "api Envelope.amplitude": lambda d: asymptotics.envelope(AIR).amplitude(1, digits=d),
    "api S": lambda d: asymptotics.S(1, 0, digits=d),
    "api T": lambda d: asymptotics.T(1, "-1/4", digits=d),
    "api radii": lambda d: asymptotics.radii("1/2", digits=d),
    "api Motion.at": lambda d: asymptotics.motion(AIR).at(1, digits=0 if d is None else d),
}
ORDERS = {
    "AsymptoticMotion.of": lambda n: AsymptoticMotion.of(AIR, n),
    "quarter_swing": lambda n: quarter_swing(TWO, n),
    "expansion_coefficients": lambda n: expansion_coefficients(TWO, n, 5),
    "half_swing_coefficients": lambda n: half_swing_coefficients(TWO, n, 5),
    "symbolic_coefficients": lambda n: symbolic_coefficients(n, "turning-point", 5),
    "multiple_scales": lambda n: multiple_scales((3,), n),
    "api expand": lambda n: asymptotics.expand(2, order=n),
    "api motion": lambda n: asymptotics.motion(AIR, order=n),
    "api multiple_scales": lambda n: asymptotics.multiple_scales(3, order=n),
}
COUNTS = {
    "turning_points": lambda n: turning_points(LAW, n, 5),
    "coefficients": coefficients,
}
STARTS = {  # 0 is one of them
    "turning_points": lambda n: turning_points(LAW, 1, 5, start=n),
    "generating_function": generating_function,
}
NEVER = (-1, 10**40, 2.5, float("nan"), True, None, "x", [], 1j, object())
POSITIVE = (0, *NEVER)


def _cases():
    for group, values in ((DIGITS, POSITIVE), (ORDERS, POSITIVE), (COUNTS, POSITIVE), (STARTS, NEVER)):
        for name, call in group.items():
            yield pytest.param(call, values, id=name)


@pytest.mark.parametrize(("call", "values"), list(_cases()))
def test_what_is_no_integer_in_range_is_refused_by_name(call, values):
    for value in values:
        with pytest.raises(InputError):
            call(value)


INTERNAL = {  # helpers whose digits come from the functions above
    "asymptotics.decays.comparison", "asymptotics.testing", "asymptotics.expansions.half_swings",
    "asymptotics.motions.certify",
    "asymptotics.expansions.normal_form", "asymptotics.numbers", "asymptotics.flow.linear_spring", "asymptotics.tables",
    "asymptotics.equivalent",
    "asymptotics.shell", "asymptotics.expansions.equations",
    "asymptotics.turning.quadratic_map",
    "asymptotics.turning.energy_primitive", "asymptotics.turning.routes", "asymptotics.turning.result",
    "asymptotics.turning.half_swing",
    "asymptotics.limit_cycles", "asymptotics.bounds", "asymptotics.curves.evaluated",
    "asymptotics.curves.envelope_order",
    "asymptotics.curves.envelope_table", "asymptotics.certificates", "asymptotics.curves.started",
    "asymptotics.expansions.multiple_scales.rates", "asymptotics.curves",
    "asymptotics.driven", "asymptotics.ask",  # read by their kinds: tests/ask
}  # fmt: skip


def test_no_public_function_with_digits_is_forgotten():
    known = {name.removeprefix("api ").split(".")[-1].split()[0] for name in DIGITS}
    forgotten = []
    for found in pkgutil.walk_packages(asymptotics.__path__, "asymptotics."):
        if found.name.endswith("__main__") or any(found.name.startswith(name) for name in INTERNAL):
            continue
        module = importlib.import_module(found.name)
        for name, thing in vars(module).items():
            if getattr(thing, "__module__", None) == found.name and inspect.isfunction(thing):
                takes = "digits" in inspect.signature(thing).parameters
                if takes and not name.startswith("_") and name not in known:
                    forgotten.append(f"{found.name}.{name}")
    allowed = (
        "compare",
        "require_counts",
        "estimated_seconds",
        "map_seconds",
        "closed_form_seconds",
        "reference_states",
        "expansions.divergence.constants.effort",
        "expansions.divergence.constants.stokes_balls",
        "expansions.divergence.result.stokes_constants",
        "expansions.divergence.result.rounds_to",
    )
    assert not [name for name in forgotten if not name.endswith(allowed)]


def test_indices_of_smith_have_the_same_contract():
    for bad in (2.5, True, None, "x"):
        with pytest.raises(InputError):
            coefficient(5, bad)
    assert coefficient(5, 7) == coefficient(5, -1) == 0


def test_exact_reals_are_exact_and_normal():
    for bad in ((0.1,), (Fraction(1), 0.5), ("1",), (None,), (True,), (sympy.Integer(1),)):
        with pytest.raises(InputError):
            ExactReal(*bad)
    with pytest.raises(InputError):
        ExactReal(Fraction(1), Fraction(-2))
    assert ExactReal(1, 4) == ExactReal(2)
    assert ExactReal(1, 4).is_rational and str(ExactReal(Fraction(1), Fraction(4))) == "2"
