"""The waveforms in balls: beside the exact polynomials, the closed forms, the table, and the start read backwards."""

import numpy as np
import pytest
import sympy
from flint import arb

import asymptotics as asy
from asymptotics.errors import InputError
from asymptotics.expansions.half_swings.forces import Forces
from asymptotics.expansions.multiple_scales.certified_waves import start_series, wave_source, waves_at
from asymptotics.expansions.multiple_scales.open_orders import first_wave, second_wave
from asymptotics.expansions.multiple_scales.orders import psi
from asymptotics.expansions.multiple_scales.start import start_of
from asymptotics.expansions.multiple_scales.turning import turning_hierarchy
from asymptotics.numbers.context import ctx
from asymptotics.shell.main import main
from asymptotics.terms import Term

PHASES = ["1/3", "7/5", "2", "3"]


@pytest.mark.parametrize("law", [("0",), ("2",), ("3",), ("0", "2")])
def test_the_balls_hold_the_polynomials_of_integer_exponents(law):
    terms, order = [Term(1, a) for a in law], 5 if len(law) == 1 else 3
    exact, source = turning_hierarchy(terms, order), wave_source(Forces.of(terms, order), order, 90)
    for phase in PHASES:
        with ctx.workprec(200):
            at = sympy.Rational(phase)
            point = arb(int(at.p)) / int(at.q)
            true = {k: wave.at(point) for part in exact.X[1:] for k, wave in part.items()}
            found = waves_at(source, point)
            assert all(found[k].overlaps(c) and found[k].rad() < 1e-24 for k, c in true.items())
            assert all(not (found[k] + arb(2) ** -60).overlaps(c) for k, c in true.items())  # a near miss is seen


@pytest.mark.parametrize("alpha", ["3/2", "sqrt(2)"])
def test_the_balls_hold_the_closed_forms(alpha):
    found = asy.waveforms(alpha, order=2)
    exponent = sympy.sqrt(2) if "sqrt" in alpha else sympy.Rational(alpha)
    for phase in PHASES[:2]:
        values = found.at(phase, digits=20)
        for n, wave in ((1, first_wave(exponent)), (2, second_wave(exponent))):
            assert abs(wave.subs(psi, sympy.Rational(phase)).evalf(30) - sympy.Float(values[n], 30)) < 1e-19


@pytest.mark.parametrize(
    ("law", "spring"), [("5/2", None), (["0", "3/2"], None), pytest.param("3/2", {3: 1}, marks=pytest.mark.slow)]
)
def test_balls_and_arrays_agree_at_every_phase(law, spring):
    """Two routes to every integral: the orbits at fixed time, and quadrature of the hierarchy."""
    waves, phases = asy.waveforms(law, order=4, spring=spring), ["-1", "1/10", "3/2", "2", "4", "10"]
    table, balls = waves.sample([float(sympy.Rational(p)) for p in phases]), waves.balls(phases, digits=20)
    assert table.keys() == balls.keys()
    for k, row in table.items():
        assert np.max(np.abs(row - [float(b.mid()) for b in balls[k]])) < 1e-11
        assert all(b.rad() < 1e-18 for b in balls[k])


@pytest.mark.parametrize("law", ["3/2", ["1/2", "2"]])
def test_more_digits_are_narrower_and_overlap(law):
    waves = asy.waveforms(law, order=3)
    rows = [waves.balls(["1/3", "2", "-5"], digits=d) for d in (5, 20, 60)]
    for k in waves.keys:
        label = k[0] if len(k) == 1 else k
        for few, more, most in zip(*(row[label] for row in rows)):
            assert few.overlaps(more) and more.overlaps(most) and few.overlaps(most)
            assert most.rad() < 1e-58 and most.rad() <= more.rad() <= few.rad() < 1e-4


def test_high_orders_have_values_and_zeros_are_told():
    high = asy.waveforms("5/2", order=9)
    assert float(high.at("2", digits=10)[9]) == pytest.approx(high.sample([2.0])[9][0], rel=1e-8)
    dry = asy.waveforms(["0", "3/2"], order=2).at("1", digits=10)
    assert dry[2, 0] == "0" and dry[0, 1] != "0"
    assert set(asy.waveforms("3/2", order=3).at(0).values()) == {"0"}


@pytest.mark.parametrize("angle", ["1/5", "3/2", "5/2"])
def test_a_start_by_the_orbit_is_the_ansatz_read_backwards(angle):
    terms = [Term(1, 0), Term(1, 2)]
    exact, at = start_of(turning_hierarchy(terms, 3)), sympy.Rational(angle)
    with ctx.workprec(150):
        point = arb(int(at.p)) / int(at.q)
        found = start_series(wave_source(Forces.of(terms, 3), 3, 90), point)
        for series, true in zip(found, (exact.log_amplitude, exact.phase)):
            for k, wave in true.coefficients.items():
                ball = arb(series[k])
                assert ball.overlaps(wave.at(point)) and ball.rad() < 1e-24


def test_bad_phases_are_refused_by_name():
    waves = asy.waveforms("3/2", order=2)
    for call, name in (
        (lambda: waves.balls("1"), "psi"), (lambda: waves.balls(1), "psi"), (lambda: waves.at("x"), "psi"),
        (lambda: waves.integral(3), "n"), (lambda: asy.waveforms("3/2", order=13), "order"),
    ):  # fmt: skip
        with pytest.raises(InputError, match=f"argument {name}"):
            call()


def test_the_command_tells_values_of_the_integrals(capsys):
    assert main(["multiple-scales", "--alpha", "5/2", "--order", "4", "--phase", "1", "--digits", "12"]) == 0
    assert "x_3 = 0.0141947515195\n" in capsys.readouterr().out
    for line in (["--alpha", "3", "--phase", "1"], ["--alpha", "symbolic", "--phase", "1"]):
        assert main(["multiple-scales", *line]) == 2
        assert "--phase" in capsys.readouterr().err
