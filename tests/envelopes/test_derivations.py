"""The derivations behind the envelopes: each runs, and a corrupted one stops."""

from importlib import import_module, util
from pathlib import Path

import pytest
import sympy
from latex2mathml.converter import convert

from derivations.waiting import At

FOLDER = Path(__file__).parents[2] / "derivations"
CORRUPTIONS = [  # a wrong sign, factor or exponent where the source states a formula
    ("lancaster_energy", "slow * sin(2 * omega_0 * t)", "slow * sin(omega_0 * t)"),
    ("lancaster_energy", "root = x_0 * growth ** (-1 / mu)", "root = x_0 * growth ** (1 / mu)"),
    ("lancaster_average", "beta = gamma(alpha / 2 + 1) ** 2", "beta = gamma(alpha / 2 + 1)"),
    ("lancaster_average", "(p + 2) * sin(theta) ** (p + 2)", "(p + 1) * sin(theta) ** (p + 2)"),
    ("lancaster_linear_limit", "kappa * tau) ** (-1 / mu)", "kappa * tau) ** (1 / mu)"),
    ("lancaster_linear_limit", "-(epsilon**2) / 8", "-(epsilon**2) / 4"),
    ("lelas_viscous", "solution = sympy.exp(-b * t / (2 * m))", "solution = sympy.exp(-b * t / m)"),
    ("lelas_viscous", "printed = -omega_0 * (x_0 * f * sin(omega_0 * t) +", "printed = -omega_0 * (x_0 * f * sin(omega_0 * t) -"),  # noqa: E501
    ("lelas_friction", "slope = -mu * g / (sqrt(2) *", "slope = -mu * g / (2 *"),
    ("lelas_friction", "end = sqrt(2) * omega_0", "end = sqrt(3) * omega_0"),
    ("lelas_air", "slope = C * omega_0 * x_0 / (2 * sqrt(2) * m)", "slope = C * omega_0 * x_0 / (2 * m)"),
    ("lelas_air", "trick = squaring_moment(alpha) * epsilon", "trick = squaring_moment(alpha + 1) * epsilon"),
    ("two_laws_time", "index = (beta - 1) / gap", "index = beta / gap"),
    ("two_laws_time", "lam = x_0 / (c + d * x_0)", "lam = x_0 / (c - d * x_0)"),
    ("two_laws_time", "(0, 1): -log(c + d * x) / d", "(0, 1): -log(c + d * x) / c"),
    ("finite_phase_lag", "-p_1 * A * local", "-p_1 * local"),
    ("finite_phase_lag", "phase = -w_2 * epsilon**2 * tau", "phase = -w_2 * epsilon * tau"),
    ("finite_phase_lag", "lag = w_2 * epsilon / (nu * p_1)", "lag = w_2 * epsilon / p_1"),
    ("finite_phase_lag", "sin(x) ** 6", "sin(x) ** 4"),
]  # fmt: skip


@pytest.mark.parametrize("name", sorted({name for name, _, _ in CORRUPTIONS}))
def test_it_runs(name):
    derivation = import_module(f"derivations.{name}").derivation
    assert derivation.name == name.replace("_", "-")
    assert len(derivation.steps) >= 10
    for step in derivation.steps:
        assert convert(step.latex()).startswith("<math")


@pytest.mark.parametrize(("name", "right", "wrong"), CORRUPTIONS)
def test_a_corrupted_step_raises(name, right, wrong, tmp_path):
    source = (FOLDER / f"{name}.py").read_text(encoding="utf-8")
    assert source.count(right) == 1
    path = tmp_path / f"{name}.py"
    path.write_text(source.replace(right, wrong), encoding="utf-8")
    spec = util.spec_from_file_location(f"corrupted_{name}", path)
    module = util.module_from_spec(spec)
    with pytest.raises(AssertionError, match=name.replace("_", "-")):
        spec.loader.exec_module(module)


def test_the_phase_is_derived_before_its_limit_is_told():
    """Every line of phi(tau) displays an operation that waits on its left, not a rearranged result."""
    derivation = import_module("derivations.finite_phase_lag").derivation
    waiting = (sympy.Derivative, sympy.Integral, sympy.Limit, At)
    lines = [one for one in derivation.steps if one.kind == "equality"]
    assert len(lines) > 15 and all(one.left.has(*waiting) for one in lines)
