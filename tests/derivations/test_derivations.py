"""Every derivation runs and prints itself; a corrupted step stops it.

A derivation computes on import, so its examples run here and not by pytest's collection, which every worker repeats.
"""

import doctest
from importlib import import_module, util
from pathlib import Path

import pytest
import sympy
from latex2mathml.converter import convert

from derivations.__main__ import NOT_DERIVATIONS, main, names
from derivations.steps import Derivation, defined, named
from derivations.waiting import At

FOLDER = Path(__file__).parents[2] / "derivations"
SMITH = {
    "smith-integrating-factor",
    "smith-turning-points",
    "smith-time-series",
    "smith-generating-functions",
    "smith-closed-sum",
    "smith-denominators",
    "smith-footnote-8",
}
CORRUPTIONS = [  # a wrong sign, factor or exponent at a place where the source states a formula
    ("smith_integrating_factor", "factor = exp(-2 * s * gamma * x)", "factor = exp(2 * s * gamma * x)"),
    ("smith_integrating_factor", "omega**2 / (2 * s * gamma) * (x +", "omega**2 / (2 * s * gamma) * (x -"),
    ("smith_turning_points", "turning = u0 - log(2 * u0 + 1) / 2", "turning = u0 - log(2 * u0 + 1)"),
    ("smith_turning_points", "y = 1 + 2 * u0", "y = 1 + u0"),
    ("smith_time_series", "speed = 1 - 2 * w * z + z**2", "speed = 1 - 2 * w * z - z**2"),
    ("smith_time_series", "h: (n - 2) * h", "h: (n - 1) * h"),
    ("smith_generating_functions", "slope = 2 * c * (1 - c**2)", "slope = 2 * c * (1 + c**2)"),
    ("smith_generating_functions", "integral - rest.as_expr()", "integral + rest.as_expr()"),
    ("smith_closed_sum", "return 2 * (-1) ** (k - 1) * top", "return 2 * (-1) ** k * top"),
    ("smith_denominators", "field = E**3 - 2 * E**2", "field = E**3 - 3 * E**2"),
    ("smith_denominators", "return N * double_factorial(N - 2)", "return N * double_factorial(N - 1)"),
    ("quadratic_trapezoid", "(1 + p) / 2 * sympy.exp(2 * u - p)", "(1 + p) * sympy.exp(2 * u - p)"),
    ("quadratic_trapezoid", "place = end * (1 - sympy.cos(chi)) / 2", "place = end * (1 - sympy.cos(chi))"),
    ("quadratic_trapezoid", "    2 * M / (sympy.exp(a * N) - 1),\n)", "    2 * M / (sympy.exp(a * N) + 1),\n)"),
    ("quadratic_trapezoid", "    sympy.exp(-a * k),\n", "    sympy.exp(-2 * a * k),\n"),
    ("nested_integral", "    pi**2 / 12,\n", "    pi**2 / 4,\n"),
    ("nested_integral", "moment(2) ** 3 / 12", "moment(2) ** 3 / 4"),
    ("nested_integral", "moment(2 * alpha) / 4,", "moment(2 * alpha) / 12,"),
    ("nested_integral", "    -sympy.Rational(3, 10)", "    sympy.Rational(3, 10)"),
    ("smith_series_radii", "elapsed = (log_size + 1) / 2", "elapsed = (log_size - 1) / 2"),
    ("smith_series_radii", "curve = -eta * sympy.cot(eta)", "curve = eta * sympy.cot(eta)"),
    ("smith_series_radii", "exp(-1 - 2 * p**2) / (1 + b)", "exp(1 - 2 * p**2) / (1 + b)"),
    ("smith_series_radii", "2 * (n - 1) * C_1 - (n - 2)", "2 * (n - 1) * C_1 + (n - 2)"),
    ("smith_series_radii", "2 * (b - sympy.log(1 + b)) / b**2,\n)", "2 * (b + sympy.log(1 + b)) / b**2,\n)"),
    ("zeros_by_theorem", "+ ell**n * sympy.diff(-ell", "- ell**n * sympy.diff(-ell"),
    ("zeros_by_theorem", "{f: -c / (1 + size * slope)}", "{f: c / (1 + size * slope)}"),
    ("quarter_swing_tail", "x / (1 - k) - x * k**n", "x / (1 - k) + x * k**n"),
    ("wells_majorant", "(-1) ** (j + 1) * ((m - j) * c_j)", "(-1) ** j * ((m - j) * c_j)"),
    ("expansion_bounds", "h(k) - h(k + 1), a * b * h(k - 1)", "h(k) + h(k + 1), a * b * h(k - 1)"),
    ("slow_curve", "{theta: -left / a}", "{theta: left / a}"),
    ("slow_curve", "{c_n: product / a}", "{c_n: product}"),
    ("taylor_residual", "{y_next: -w_n / (n + 1)}", "{y_next: w_n / (n + 1)}"),
    ("smith_series_radii", "middle**2 * S_0) / S_0", "middle * S_0) / S_0"),
    ("zeros_by_theorem", "turn = (A - e0) * c - e0", "turn = (A - e0) * c + e0"),
    ("energy_contraction", "    -fv * wronskian,", "    fv * wronskian,"),
    ("energy_contraction", "constant = sympy.exp(-2 *", "constant = sympy.exp(2 *"),
    ("energy_contraction", "root = sympy.sqrt(4 - epsilon**2)", "root = sympy.sqrt(4 + epsilon**2)"),
    ("ratio_growth", "-rate * area + w * (w * rate - N)", "-rate * area + w * (w * rate + N)"),
    ("ratio_growth", "At(1 + (b - 1) * S / q**2", "At(1 + b * S / q**2"),
    ("uniform_bound", "sympy.I * (W - 1) * Z - U * Z", "sympy.I * (W + 1) * Z - U * Z"),
    ("uniform_bound", "delta**m / (1 + w * m)", "delta**m / (1 - w * m)"),
    ("uniform_bound", "    f_1 + (1 - a / b) * (f_2 - f_1),", "    f_1 + (a / b) * (f_2 - f_1),"),
    ("explicit_bound", "-w * p_1 * epsilon * growth**-2", "-p_1 * epsilon * growth**-2"),
    ("explicit_bound", "p_3 / (w * p_1) * (D**2 - D)", "p_3 / (w * p_1) * (D - D**2)"),
    ("explicit_bound", "    R_0 ** (1 + w) / p_1 *", "    R_0**w / p_1 *"),
    ("quarter_courses", "2 * e**2 * weights", "e**2 * weights"),
    ("quarter_courses", "{fall: -w, slope: u - N}", "{fall: -w, slope: u + N}"),
    ("one_law_quarter", "5 * T[5] + 10 * sum", "5 * T[5] + 5 * sum"),
    ("one_law_quarter", "sympy.Derivative(R, theta): -s * Y", "sympy.Derivative(R, theta): s * Y"),
    ("cauchy_heine", "    4 * pi**2 * eps1 / (n - 1),", "    2 * pi**2 * eps1 / (n - 1),"),
    ("cauchy_heine", "    y - eps1 / y + eps3 / y**3,", "    y + eps1 / y + eps3 / y**3,"),
    ("large_orders", "(1 - pi * c1 / d1 * (Wm - 1)) / Wm**2", "(1 + pi * c1 / d1 * (Wm - 1)) / Wm**2"),
    ("large_orders", "2 * pi * i * q * (c1 + d1 / pi) / Wm,", "2 * pi * i * q * c1 / Wm,"),
    ("large_orders", "pi * (Wm - 1) + h * (-2 * pi", "pi * (Wm - 1) + h * (2 * pi"),
    (
        "stokes_small_alpha",
        "4 / (2 * x + 1) - 4 / (2 * x - 1) + 2 / x**2,",
        "4 / (2 * x + 1) - 4 / (2 * x - 1) - 2 / x**2,",
    ),
    ("stokes_small_alpha", "{rho: -2 * (ln(2 * a) - 1)", "{rho: -2 * (ln(a) - 1)"),
    ("smith_not_elementary", "(y - u / y) * Derivative(f, y)", "(y + u / y) * Derivative(f, y)"),
    ("smith_not_elementary", "exp(2 * j * u) * inside**-j", "exp(2 * j * u) * inside**j"),
    ("smith_not_elementary", "k: -2 * E * gamma**2", "k: 2 * E * gamma**2"),
    ("smith_motion_not_elementary", "(path + half - rate**2)", "(path - half - rate**2)"),
    ("smith_motion_not_elementary", "    y**2 - half + k * theta,", "    y**2 + half + k * theta,"),
    (
        "smith_motion_not_elementary",
        "Derivative(2 * Theta * Derivative(U, t), s)",
        "Derivative(Theta * Derivative(U, t), s)",
    ),
    ("smith_matching", "r_next * (exp(2 * r_next) - exp", "2 * r_next * (exp(2 * r_next) - exp"),
    ("smith_quadrature", "+ 4 * omega**2 * E", "+ 3 * omega**2 * E"),
    ("smith_quadrature", "V / 2 - omega**2 / (2 * gamma)", "V / 2 - omega**2 / (4 * gamma)"),
    ("smith_viscous", "omega_0: sympy.sqrt(omega**2 + gamma**2)", "omega_0: sympy.sqrt(omega**2 - gamma**2)"),
    ("lelas_friction_exact", "(x_0 - (2 * n - 1) * d) * cos", "(x_0 - 2 * n * d) * cos"),
    ("two_laws_average", "b * (2 * omega) ** (alpha + 1)", "b * omega ** (alpha + 1)"),
    ("lancaster_literal_average", "moment(alpha - 1)}", "moment(alpha)}"),
    ("smith_footnote_8", "/ (3 * 2**m * sympy.factorial(m))", "/ (2**m * sympy.factorial(m))"),
    ("lancaster_energy", "slow * sin(2 * omega_0 * t)", "slow * sin(omega_0 * t)"),
    ("lancaster_energy", "root = x_0 * growth ** (-1 / mu)", "root = x_0 * growth ** (1 / mu)"),
    ("lancaster_average", "beta = gamma(alpha / 2 + 1) ** 2", "beta = gamma(alpha / 2 + 1)"),
    ("lancaster_average", "sin(theta) ** (n + 1), (theta", "sin(theta) ** (n + 2), (theta"),
    ("creep_arrival", "arrival = alpha / nu * e", "arrival = alpha * e"),
    ("creep_arrival", "nu * p_1 * (tau - T_c)", "nu * p_1 * (tau + T_c)"),
    ("lancaster_linear_limit", "kappa * tau) ** (-1 / mu)", "kappa * tau) ** (1 / mu)"),
    ("lancaster_linear_limit", "-(epsilon**2) / 8", "-(epsilon**2) / 4"),
    ("lelas_viscous", "solution = sympy.exp(-b * t / (2 * m))", "solution = sympy.exp(-b * t / m)"),
    (
        "lelas_viscous",
        "printed = -omega_0 * (x_0 * f * sin(omega_0 * t) +",
        "printed = -omega_0 * (x_0 * f * sin(omega_0 * t) -",
    ),  # noqa: E501
    ("lelas_friction", "slope = -mu * g / (sqrt(2) *", "slope = -mu * g / (2 *"),
    ("lelas_friction", "end = sqrt(2) * omega_0", "end = sqrt(3) * omega_0"),
    (
        "lelas_friction_exact",
        'second = defined("x_2", lambda tau: sin(tau) + e * cos(tau) - e)',
        'second = defined("x_2", lambda tau: sin(tau) - e * cos(tau) - e)',
    ),
    ("lelas_friction_exact", "law(y - sigma * b / k)", "law(y + sigma * b / k)"),
    ("lelas_line_end", "1 - 2 * mu * g * t / (pi * omega * x_0)", "1 - mu * g * t / (pi * omega * x_0)"),
    ("lelas_friction", 'line = defined("f", lambda t: 1 + slope * t)', 'line = defined("f", lambda t: 1 - slope * t)'),
    ("lelas_line_end", "last = pi * omega * x_0 / (2 * mu * g)", "last = pi * omega * x_0 / (mu * g)"),
    ("lelas_line_end", "Rational(477, 100)", "Rational(478, 100)"),
    ("lelas_powers", "-sympy.sign(V) * abs(V) ** n", "sympy.sign(V) * abs(V) ** n"),
    ("lelas_powers", "-C * (A * omega * f * s) ** (n + 1)", "-C * (A * omega * f * s) ** n"),
    ("lelas_powers", "size ** (-root * (n - 1))", "size ** (-root * n)"),
    ("lancaster_conditions", "** (-1 / (alpha - 1))", "** (1 / (alpha - 1))"),
    ("lancaster_conditions", "    M * epsilon * omega / (1 - M),", "    M * epsilon * omega / (1 + M),"),
    ("lancaster_conditions", "moment(4) * b", "moment(3) * b"),
    ("lancaster_conditions", "(4 * exp(-t / 2) - exp(-2 * t)) / 3", "(4 * exp(-t / 2) + exp(-2 * t)) / 3"),
    ("smith_harmonic", "v: omega * t - atan(omega * x / v)", "v: omega * t + atan(omega * x / v)"),
    ("smith_harmonic", "(-1) ** j * (omega * x / v) ** (2 * j)", "(omega * x / v) ** (2 * j)"),
    ("smith_viscous", "omega * (chi + 2 * sympy.pi)", "omega * (chi + sympy.pi)"),
    ("smith_turning_points", "(level * exp(2 * place) - 1) / 2", "(level * exp(2 * place) + 1) / 2"),
    ("smith_time_series", "2 * w**2 / D**2 - w**2 / D**3", "2 * w**2 / D**2 + w**2 / D**3"),
    ("smith_quadrature", "** Rational(3, 2) / (3 * below)", "** Rational(3, 2) / (2 * below)"),
    ("two_laws_time", "d**2 / c**3 * log((c + d * x) / x)", "d / c**3 * log((c + d * x) / x)"),
    ("lelas_air", "slope = C * omega_0 * x_0 / (2 * sqrt(2) * m)", "slope = C * omega_0 * x_0 / (2 * m)"),
    ("lelas_air", "trick = squaring_moment(alpha) * epsilon", "trick = squaring_moment(alpha + 1) * epsilon"),
    ("two_laws_time", "index = (beta - 1) / gap", "index = beta / gap"),
    ("two_laws_time", "lam = x_0 / (c + d * x_0)", "lam = x_0 / (c - d * x_0)"),
    ("two_laws_time", "(0, 1): -log(c + d * x) / d", "(0, 1): -log(c + d * x) / c"),
    ("finite_phase_lag", "-p_1 * A * local", "-p_1 * local"),
    ("finite_phase_lag", "phase = -w_2 * epsilon**2 * tau", "phase = -w_2 * epsilon * tau"),
    ("finite_phase_lag", "lag = w_2 * epsilon / (nu * p_1)", "lag = w_2 * epsilon / p_1"),
    ("finite_phase_lag", "sin(x) ** 6", "sin(x) ** 4"),
    ("multiple_scales_cubic", "right = rest - one_two - two_one", "right = rest - 2 * two_one"),
    ("multiple_scales_cubic", "- 3 * V[0] ** 2 * V[1]\n", "- 2 * V[0] ** 2 * V[1]\n"),
    ("multiple_scales_cubic", "R(9, 256) * a**4)", "R(27, 256) * a**4)"),
    ("multiple_scales_general", "rest = 2 * M - 4 * p * q", "rest = M - 4 * p * q"),
    ("multiple_scales_general", "weight = (alpha + beta + 1)", "weight = (alpha + beta + 2)"),
    ("multiple_scales_general", "(D_0 * D_1 + D_1 * D_0) * X_1", "2 * D_0 * D_1 * X_1"),
    ("multiple_scales_general", "Solution(2 * slope + 2 * p", "Solution(2 * slope - 2 * p"),
    ("multiple_scales_general", "drag(V_a + eps * V_b)", "drag(V_a - eps * V_b)"),
    ("multiple_scales_general", "chi = p + turn", "chi = p - turn"),
    (
        "multiple_scales_springs",
        "fall, turn = (n - alpha) / (n + alpha + 2), -(n - p)",
        "fall, turn = (n - alpha) / (n + alpha + 2), (n - p)",
    ),
    ("multiple_scales_turning", "+ alpha * (a * s) ** (alpha - 1) * V_1\n", "- alpha * (a * s) ** (alpha - 1) * V_1\n"),
    ("multiple_scales_turning", "f_1 = -p * a**alpha", "f_1 = p * a**alpha"),
    ("multiple_scales_springs", "+ (alpha + 1) * S * unit", "+ (alpha - 1) * S * unit"),
    ("multiple_scales_springs", "observed = closed + P", "observed = closed - P"),
]


def load_source(name, source, folder):
    path = folder / f"{name}.py"
    path.write_text(source, encoding="utf-8")
    spec = util.spec_from_file_location(f"corrupted_{name}", path)
    module = util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module.derivation


def test_the_derivations_of_smith_are_there():
    assert set(names()) >= SMITH


@pytest.mark.parametrize("name", [*names(), *sorted(NOT_DERIVATIONS - {"__init__", "__main__"})])
def test_the_examples_of_a_derivation(name):
    module = import_module("derivations." + name.replace("-", "_"))
    outcome = doctest.testmod(module, optionflags=doctest.NORMALIZE_WHITESPACE | doctest.ELLIPSIS)
    assert outcome.failed == 0 < outcome.attempted


@pytest.mark.parametrize("name", names())
def test_derivation_runs_and_prints_itself(name):
    derivation = import_module("derivations." + name.replace("-", "_")).derivation
    assert derivation.name == name
    assert len(derivation.steps) >= 5
    assert derivation.text().count("\n") >= 2 * len(derivation.steps)
    for step in derivation.steps:
        assert convert(step.latex()).startswith("<math")


@pytest.mark.parametrize(("name", "right", "wrong"), CORRUPTIONS)
def test_a_corrupted_step_raises(name, right, wrong, tmp_path):
    source = (FOLDER / f"{name}.py").read_text(encoding="utf-8")
    assert source.count(right) == 1
    with pytest.raises(AssertionError, match=name.replace("_", "-")):
        load_source(name, source.replace(right, wrong), tmp_path)


def test_a_step_must_be_true_and_a_relation_established():
    x = sympy.Symbol("x", positive=True)
    derivation = Derivation("d", "", source="")
    with pytest.raises(AssertionError, match="differ by"):
        derivation.step("false", x, x + 1)
    with pytest.raises(AssertionError, match="says what a name stands for"):
        derivation.step("a name", named("U_1", 2 * x), 2 * x)
    for truth in (True, False, None, 1, sympy.true, x):
        with pytest.raises(AssertionError, match="no relation that could be displayed"):
            derivation.asserts("decided elsewhere", truth)
    for relation in (sympy.Gt(x, 1, evaluate=False), sympy.Ne(x + x, 2 * x, evaluate=False), sympy.Eq(x, 1)):
        with pytest.raises(AssertionError, match="is not established"):
            derivation.asserts("one of two", sympy.Gt(x, 0, evaluate=False), relation)
    with pytest.raises(AssertionError, match="does not stand for"):
        derivation.defines("another body", defined("h", lambda z: z**2)(x), x**3)
    assert derivation.steps == []


HALF = sympy.Float(0.5)
X = sympy.Symbol("x", positive=True)
LINES = {
    "a side": lambda d, half: d.step("", sympy.Derivative(half * X**2, X), X),
    "the other side": lambda d, half: d.step("", sympy.Derivative(X**2, X) / 4, half * X),
    "a place": lambda d, half: d.step("", At(X**2, {X: half}), sympy.Rational(1, 4)),
    "a body": lambda d, half: d.step("", defined("h", lambda z: half * z)(X) * 2, X),
    "a name": lambda d, half: d.step("", 2 * named("U_1", half * X), X),
    "a relation": lambda d, half: d.asserts("", sympy.Gt(X + half, 0, evaluate=False)),
    "a body in a relation": lambda d, half: d.asserts("", sympy.Gt(defined("h", lambda z: half * z)(X), 0)),
    "a definition": lambda d, half: d.defines("", "h", half * X),
}


@pytest.mark.parametrize("line", LINES)
def test_no_line_takes_a_double(line):
    derivation = Derivation("d", "", source="")
    with pytest.raises(AssertionError, match="has a double in it"):
        LINES[line](derivation, HALF)
    LINES[line](derivation, sympy.Rational(1, 2))
    assert len(derivation.steps) == 1


def test_two_relations_stand_on_one_line():
    x = sympy.Symbol("x", positive=True)
    derivation = Derivation("d", "", source="")
    derivation.asserts("between", sympy.Gt(x, 0, evaluate=False), sympy.Ne(x, -1, evaluate=False))
    assert derivation.to_dict()["steps"][0] == {
        "reason": "between",
        "kind": "relation",
        "left": "x > 0,  x != -1",
        "right": None,
        "latex": r"x > 0,\quad x \neq -1",
        "proves": [],
        "corrects": [],
    }


def test_command(capsys):
    assert main([]) == 0
    assert set(capsys.readouterr().out.split()) == set(names())
    assert main(["smith-footnote-8"]) == 0
    assert "1." in capsys.readouterr().out
    assert main(["smith-footnote-8", "--latex"]) == 0
    assert r"\[" in capsys.readouterr().out
    assert main(["no-such"]) == 2
    assert "no derivation 'no-such'" in capsys.readouterr().err


def test_the_phase_is_derived_before_its_limit_is_told():
    """Every line of phi(tau) displays an operation that waits on its left, not a rearranged result."""
    derivation = import_module("derivations.finite_phase_lag").derivation
    waiting = (sympy.Derivative, sympy.Integral, sympy.Limit, At)
    lines = [one for one in derivation.steps if one.kind == "equality"]
    assert len(lines) > 15 and all(one.left.has(*waiting) for one in lines)
