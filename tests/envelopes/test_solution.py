"""The solution as functions: order of its error, every form beside every other, units, LaTeX, bad input."""

import json
import shutil
import subprocess
from dataclasses import replace
from fractions import Fraction
from random import Random

import mpmath
import numpy as np
import pytest
import sympy
from scipy.integrate import solve_ivp

import asymptotics as asy
from asymptotics.api.implicit import ImplicitSolution
from asymptotics.api.solution import A_0, D, epsilon, kappa, tau
from asymptotics.cli.main import main
from asymptotics.envelopes.named_slow_time import named_slow_time, rate_letters
from asymptotics.errors import InputError
from asymptotics.expansions.half_swings.symbolic import alpha as symbolic_alpha
from asymptotics.expansions.multiple_scales.orders import a
from asymptotics.expansions.normal_form.digits import certified_digits
from asymptotics.terms import Term

_SLOW_ROWS = [("3", 3), ("4", 3), ("3/2", 3), ("1/2", 2), ("sqrt(2)", 4), ("5/2", 3), ("7/3", 2)]
SLOW = [Fraction(k, 8) for k in (5, 7, 9, 10)]


def error(law, order, eps):
    """The largest error of x at a few fixed slow times, against certified motion."""
    found, moving = asy.solution({law: str(eps)}, order=order), asy.reference({law: str(eps)})
    gaps = []
    for slow in SLOW:
        time = str(slow / eps)
        gaps.append(abs(mpmath.mpf(found.at(time, digits=20).x) - mpmath.mpf(moving.at(time, digits=18).x)))
    return max(gaps)


@pytest.mark.parametrize(
    ("law", "order"),
    [("2", 2), ("2", 4), *(pytest.param(*row, marks=pytest.mark.slow) for row in _SLOW_ROWS)],
)  # fmt: skip
def test_the_error_at_fixed_slow_time_falls_like_the_order(law, order):
    """Twenty and forty: the measured order is above N - 1/2, and an order less is refused by the size of the error."""
    coarse, fine = (error(law, order, Fraction(1, n)) for n in (20, 40))
    assert mpmath.log(coarse / fine, 2) > order - 0.6
    assert error(law, order - 1, Fraction(1, 40)) > 1.5 * fine


def integrated(strengths, times):
    """x at many times by an integrator in doubles: no route of ours."""

    def field(_, y):
        return [y[1], -y[0] - sum(e * np.sign(y[1]) * abs(y[1]) ** a for a, e in strengths.items())]

    span = (0.0, times[-1])
    return solve_ivp(field, span, [1.0, 0.0], "DOP853", rtol=1e-10, atol=1e-12, t_eval=times, max_step=0.1).y[0]


def random_laws():
    """Laws that nobody chose: one exponent, or two."""
    draw = Random(20261123)
    one = [{Fraction(draw.randint(11, 35), 10): 1} for _ in range(2)]
    return [
        (one[0], 2),
        (one[1], 3),
        ({Fraction(draw.randint(10, 19), 10): 1, Fraction(draw.randint(21, 30), 10): 2}, 2),
    ]


@pytest.mark.parametrize(("law", "order"), random_laws())
def test_the_error_of_random_laws_falls_like_the_order_and_a_wrong_coefficient_is_noticed(law, order):
    """At fixed slow time, beside an integrator: epsilon^N; a phase wrong by a tenth makes it larger."""
    gaps, wrong = [], []
    for n in (20, 40):
        strengths = {a: weight / Fraction(n) for a, weight in law.items()}
        times = [n * s for s in (0.5, 0.8, 1.1)]
        true = integrated({float(a): float(e) for a, e in strengths.items()}, times)
        found = asy.solution(strengths, order=order)
        gaps.append(np.max(np.abs(found.sample(np.array(times))[2] - true)))
        if len(law) == 1:
            miss = replace(found, slow_phase=found.slow_phase * sympy.Rational(9, 10))
            wrong.append(np.max(np.abs(miss.sample(np.array(times))[2] - true)))
    assert np.log2(gaps[0] / gaps[1]) > order - 0.5
    assert not wrong or wrong[1] > 3 * gaps[1]


@pytest.mark.parametrize("law", ["1", "2", "3", pytest.param("3/2", marks=pytest.mark.slow)])
def test_the_three_forms_of_one_solution_agree(law):
    found = asy.solution({law: "1/10"}, order=3)
    numbers = {tau: sympy.Rational(23, 3), epsilon: sympy.Rational(1, 10)}
    point = found.at("23/3", digits=25)
    A, phi, x = (float(f(np.array([23 / 3]), 0.1)[0]) for f in found.functions())
    for text, number, form in zip(point, (A, phi, x), (found.amplitude, found.phase, found.x)):
        assert abs(mpmath.mpf(text) - mpmath.mpf(form.subs(numbers).evalf(30))) < mpmath.mpf(10) ** -23
        assert float(text) == pytest.approx(number, abs=1e-12)


@pytest.mark.parametrize("law", ["0", "2", "3/2", "5"])
def test_the_start_is_exact(law):
    found = asy.solution(law, order=4)
    gaps = [sympy.simplify(e.subs(D, 1).subs(epsilon, 1)) for e in (found.relative - 1, found.slow_phase)]
    assert all(abs(gap) < sympy.Rational(1, 10**30) if gap.has(sympy.Float) else gap == 0 for gap in gaps)
    assert float(found.functions()[2](np.array([0.0]), 0.1)[0]) == pytest.approx(1, abs=1e-14)


@pytest.mark.parametrize(("x0", "v0"), [("3/5", "-4/5"), ("-3/5", "4/5"), ("0", "1"), ("-5/13", "-12/13")])
@pytest.mark.parametrize(
    "law", ["2", pytest.param("1", marks=pytest.mark.slow), pytest.param("3", marks=pytest.mark.slow)]
)
def test_a_start_in_motion_has_the_error_of_its_order(law, x0, v0):
    """Against certified motion at fixed slow times; a start without the corrections of A(0) and phi(0) is refuted."""

    def largest(n, *, corrected=True):
        osc = asy.Oscillator({law: f"1/{n}"}, x0=x0, v0=v0)
        found, moving = asy.solution(osc, order=3), asy.reference(osc)
        if not corrected:
            found = replace(found, start=tuple(e.subs(epsilon, 0) for e in found.start))
        times = ["0", *(str(s * n) for s in SLOW[::2])]
        assert float(found.functions(1 / n)[2](np.array([float(Fraction(times[1]))]))[0]) == pytest.approx(
            float(found.at(times[1]).x), abs=1e-11
        )
        return max(abs(mpmath.mpf(found.at(t).x) - mpmath.mpf(moving.at(t, digits=18).x)) for t in times)

    coarse, fine = largest(20), largest(40)
    assert mpmath.log(coarse / fine, 2) > 2.4 and largest(40, corrected=False) > 100 * fine


def test_a_start_in_motion_is_told_in_full(capsys, tmp_path):
    line = ["solution", "--alpha", "2", "--damping", "1/10", "--mass", "3/2", "--stiffness", "30", "--x0", "1/5"]
    line += ["--v0=-1/2", "--time", "7", "--bound"]
    assert main([*line, "--json"]) == 0
    found = json.loads(capsys.readouterr().out)
    osc = asy.Oscillator({2: "1/10"}, mass="3/2", stiffness=30, x0="1/5", v0="-1/2")
    true = float(asy.reference(osc).at("7", digits=15).x)
    assert abs(true - float(found["x_value"])) <= float(found["bound"]) < 1e-6
    assert main(line) == 0
    shown = capsys.readouterr().out
    assert all(f"{name} " in shown for name in ("a_0", "phi_0", "epsilon_0"))
    assert r"\epsilon_{0}" in asy.solution(osc, order=2).latex(standalone=True)


def test_a_table_of_open_integrals_is_the_closed_wave():
    """Orders above 3 of other exponents are tables; those of 2 and 3 are checked against the closed forms."""
    found, times = asy.solution("3/2", order=3), np.linspace(0.1, 30, 50)
    closed = sympy.lambdify([tau, epsilon], found.x, "mpmath")
    numbers = found.functions()[2](times, 0.1)
    assert max(abs(float(closed(t, 0.1)) - x) for t, x in zip(times, numbers)) < 1e-11


def test_no_logarithm_and_a_finite_lag():
    found = asy.solution("2", order=6)
    assert not (found.relative.has(sympy.log) or found.slow_phase.has(sympy.log))
    assert sympy.Poly(found.slow_phase.coeff(epsilon, 1), D).degree() == 1
    lag = -sympy.limit(found.slow_phase.coeff(epsilon, 1), D, 0)
    assert lag == sympy.pi / 8  # w_2/((alpha-1) p_1) = (1/6)/(4/(3 pi))


def test_units():
    found = asy.solution("2", order=2)
    assert sympy.simplify(found.in_units("kappa")[0] - 1 / (1 + kappa * tau)) == 0
    m, k, b, x_0, t = sympy.symbols("m k b x_0 t", positive=True)
    known = x_0 / (1 + 4 * b * sympy.sqrt(k / m) * x_0 * t / (3 * sympy.pi * m))  # Lancaster 2020, Table I
    assert sympy.simplify(found.in_units("SI")[0] - known) == 0
    osc = asy.Oscillator({2: "1/10"}, mass="3/2", stiffness=30, x0="1/5")
    si = asy.solution(osc, order=2).at_time(osc, "7", 15)
    assert float(si.x) == pytest.approx(float(asy.motion(osc, order=2).at("7", digits=15).x), abs=1e-7)


def test_sums_are_implicit_and_their_quadrature_is_the_motion():
    found = asy.solution({1: "1/10", 2: "1/20"}, order=3)
    assert isinstance(found, ImplicitSolution) and found.to_dict()["x"] is None
    point = found.at("10", digits=20)
    strengths = dict(zip(found.scales.symbols, (sympy.Rational(1, 10), sympy.Rational(1, 20))))
    for form, value in ((found.time_of_amplitude, 10), (found.phase_of_amplitude, float(point.phase))):
        integrand = sympy.lambdify(form.variables[0], form.function.subs(strengths), "mpmath")
        assert float(mpmath.quad(integrand, [mpmath.mpf(point.amplitude), 1])) == pytest.approx(value, abs=1e-10)


FADING, GROWING = {1: "1/10", 2: "1/20"}, {"1/2": "1/100", 2: "1/100"}


@pytest.mark.parametrize(
    ("law", "size", "kind"),
    [
        (GROWING, "1/1000000000", "0"),
        pytest.param(FADING, "1/500", "oo", marks=pytest.mark.slow),
        pytest.param(GROWING, "1/1000", "some", marks=pytest.mark.slow),
    ],
)
def test_until_when_a_sum_is_proved_within_a_size(law, size, kind):
    """The label is computed: for ever, up to a time, not at all; and what is proved is true of certified motion."""
    found = asy.solution(law, order=2)
    reach, moving = found.proved_until(size), asy.reference(law)
    assert reach.label == ("not proved" if kind == "0" else "proved")
    assert reach.until == kind or (kind == "some" and float(Fraction(reach.until)) > 1)
    if kind != "0":
        last = 30 if kind == "oo" else Fraction(reach.until)
        for time in (last / 3, last):
            point = found.at(str(time), digits=20)
            assert abs(float(point.x) - float(moving.at(str(time), digits=15).x)) <= float(Fraction(size))


def test_a_proved_time_needs_a_size():
    with pytest.raises(InputError, match="within"):
        asy.solution(FADING, order=2).proved_until(0)


def test_what_is_proved_is_told_and_what_is_not_has_its_reason(capsys):
    """One law from rest: proved, with a size; no strength, a start in motion, strong damping: asymptotic, and why."""
    proved = asy.solution({2: "1/20"}, order=2)
    told = proved.to_dict()
    assert (told["valid_until"], told["valid_label"]) == ("oo", "proved")
    assert told["valid_within"] == proved.proved().size and f"<= {told['valid_within']} for every tau" in str(proved)
    moving = asy.reference({2: "1/20"})
    for time in ("7", "30"):
        gap = float(moving.at(time, digits=15).x) - float(proved.at(time, digits=20).x)
        assert 0 < abs(gap) <= float(told["valid_within"])
    for law, why in ((2, "strength"), ({2: 2}, "range"), (asy.Oscillator({2: "1/10"}, v0=1), "start in motion")):
        found = asy.solution(law, order=2).to_dict()
        assert found["valid_label"] == "asymptotic" and why in found["not_proved"]
    both = asy.Oscillator({1: "1/40", "3/2": "1/40"}, x0="3/5", v0="-4/5")
    summed, moving = asy.solution(both, order=2), asy.reference(both)
    told = summed.to_dict()
    assert told["valid_label"] == "proved" and f"<= {told['valid_within']} for every tau" in str(summed)
    gap = float(moving.at("9", digits=15).x) - float(summed.at("9", digits=20).x)
    assert 0 < abs(gap) <= float(told["valid_within"])
    sprung = asy.solution(asy.Oscillator({2: "1/10"}, spring={3: "1/10"}), order=2).to_dict()
    assert (sprung["valid_until"], sprung["valid_label"]) == (None, "asymptotic") and "springs" in sprung["not_proved"]
    assert asy.solution("symbolic", order=2).valid_until.subs(symbolic_alpha, 2) == sympy.oo
    assert proved.proved_until("1/1000").until == "oo" and proved.proved_until("1/10000000").label == "not proved"
    with pytest.raises(InputError, match="within"):
        proved.proved_until(0)
    assert main(["solution", "--alpha", "2", "--epsilon", "3", "--order", "2"]) == 0
    assert "proved  nothing for all times" in capsys.readouterr().out


@pytest.mark.parametrize("order", [4, 5, 7])
def test_rates_held_by_name_give_the_closed_solution(order):
    """Letters replaced by the exact rates of alpha = 2: the solution of that law; with one of them wrong it is not."""
    exact, (relative, phase) = asy.solution("2", order=order), named_slow_time(symbolic_alpha, order)
    values = {symbolic_alpha: 2}
    for letters, side in zip(rate_letters(order), (0, 1)):
        for n, letter in letters.items():
            values[letter] = exact.scales.rates[n][side].subs(a, 1) * (1 if side else -1)
    assert sympy.expand(relative.subs(values) - exact.relative) == 0
    assert sympy.expand(phase.subs(values) - exact.slow_phase) == 0
    third = next(letter for letter in values if str(letter) == "p_3")
    assert sympy.expand(relative.subs(values | {third: values[third] * 2}) - exact.relative) != 0


def test_every_letter_of_a_symbolic_exponent_is_defined():
    found = asy.solution("symbolic", order=5)
    told = found.to_dict()["where"]
    letters = (found.amplitude.free_symbols | found.phase.free_symbols) - {tau, epsilon, symbolic_alpha}
    assert letters and all(any(line.startswith(f"{letter} = ") for line in told) for letter in letters)
    assert any(line.startswith("p_5 = -a**(") and "f_5" in line for line in told)
    assert any(line.startswith("f_5 = Integral(") for line in told)


@pytest.mark.slow
def test_a_symbolic_exponent_reaches_order_twelve():
    """No rate is expanded: the whole of order 12 in a few seconds, and still x(0) = 1."""
    found = asy.solution("symbolic", order=12)
    assert sympy.expand(found.relative.subs(D, 1)) == 1 and sympy.expand(found.slow_phase.subs(D, 1)) == 0


@pytest.mark.slow
def test_a_sum_in_motion_has_a_start_and_refuses_what_is_not_exact():
    found = asy.solution(asy.Oscillator({1: "1/40", "3/2": "1/40"}, x0="-5/13", v0="-12/13"), order=3)
    true = asy.reference(found.oscillator)
    assert all(abs(float(found.at(t, digits=12).x) - float(true.at(t, digits=12).x)) < 3e-6 for t in (0, 20))
    assert "a_0 = " in str(found) and "varphi_{0}" in found.latex() and "a_0" in found.to_dict()
    bent = asy.solution(asy.Oscillator({1: 1, 2: 1}, stiffness="sqrt(2)", v0=1), order=2)
    with pytest.raises(InputError, match="argument v0"):
        bent.at(1)


@pytest.mark.parametrize("law", ["3/2", pytest.param("1/2", marks=pytest.mark.slow)])
def test_any_exponent_starts_in_motion(law):
    """The error of order 3 at fixed slow time; without the corrections of A(0) and phi(0) it is of order 1."""
    gaps = []
    for n in (20, 40):
        osc = asy.Oscillator({law: f"1/{n}"}, x0="-3/5", v0="4/5")
        found, moving, time = asy.solution(osc, order=3), asy.reference(osc), 7 * n // 8
        gaps.append(abs(float(found.at(time).x) - float(moving.at(time, digits=15).x)))
        plain = replace(found, start=tuple(e.subs(epsilon, 0) for e in found.start))
        assert abs(float(plain.at(time).x) - float(moving.at(time, digits=15).x)) > 100 * gaps[-1]
    assert np.log2(gaps[0] / gaps[1]) > 2.4


def test_digits_beyond_those_that_are_shown_are_right():
    """Rates and start of a law without closed forms are made again for more digits."""
    osc = asy.Oscillator({"3/2": "1/10"}, x0="3/5", v0="-4/5")
    short, long = (asy.solution(osc, order=4).at(7, digits=d) for d in (40, 60))
    for x, y in zip(short, long):
        assert abs(mpmath.mpf(x) - mpmath.mpf(y)) < mpmath.mpf(10) ** -39
    assert asy.solution("5/2", order=4).to_dict()["x"].count("x_3(") == 1


def test_a_strength_that_is_a_product_of_roots_has_the_digits_asked_for():
    """epsilon = b sqrt(k/m)^alpha x0^(alpha-1)/k, to 40 digits as it is shown and to more inside."""
    osc = asy.Oscillator({"3/2": "1/10"}, mass=2, stiffness="sqrt(3)", x0="1/5")
    found = asy.solution(osc, order=2)
    with mpmath.workdps(90):
        k, omega = mpmath.sqrt(3), mpmath.sqrt(mpmath.sqrt(3) / 2)
        right = (k / 2) ** mpmath.mpf("0.75") * mpmath.sqrt(mpmath.mpf(1) / 5) / k / 10
        assert str(found.strength) == mpmath.nstr(right, 40)
        exact = asy.solution({"3/2": Fraction(mpmath.nstr(right, 85))}, order=2)
    assert found.at(7, digits=60) == exact.at(7, digits=60)
    # The same x in metres: tau = omega_0 t, in units of x0 = 1/5.
    metres = float(found.at_time(osc, 7, 60).x)
    assert metres == pytest.approx(float(exact.at(str(7 * omega), digits=20).x) / 5, rel=1e-12)


@pytest.mark.parametrize("time", [10**20, 10**60])
def test_the_turns_of_a_late_phase_take_no_digits(time):
    """As many digits are right as are asked for, with and without units."""
    osc = asy.Oscillator({2: "1/10"})
    found = asy.solution(osc, order=2)
    long = found.at(time, digits=60)
    with mpmath.workdps(100):
        for short in (found.at(time, digits=20), found.at_time(osc, time, 20)):
            for x, y in zip(short, long):
                assert abs(mpmath.mpf(x) / mpmath.mpf(y) - 1) < 1e-18
        # Far beyond: x = A cos psi with delta below 1e-18.
        psi = time + mpmath.mpf(long.phase)
        assert abs(mpmath.mpf(long.x) / (mpmath.mpf(long.amplitude) * mpmath.cos(psi)) - 1) < 1e-15


def test_a_time_of_very_many_swings_is_no_fault():
    assert abs(float(asy.solution({2: "1e400"}, order=2).at(5, digits=5).phase)) > 1e300


@pytest.mark.parametrize(
    ("law", "order", "argument"),
    [({2: 1}, 0, "order"), ({2: 1}, 13, "order"), ({-2: 1}, 2, "alpha"), ({2: -1}, 2, "b"), ("-1", 2, "alpha")],
)  # fmt: skip
def test_bad_input_is_refused_by_name(law, order, argument):
    with pytest.raises(InputError, match=f"argument {argument}"):
        asy.solution(law, order=order)


def test_numbers_need_a_strength_and_a_time_before_the_end():
    with pytest.raises(InputError, match="epsilon"):
        asy.solution("2").at(1)
    with pytest.raises(InputError, match="time"):
        asy.solution({"1/2": "1/10"}, order=2).at(100)
    with pytest.raises(InputError, match="units"):
        asy.solution("2").in_units("feet")


def test_the_command_has_the_keys_of_the_contract(capsys, tmp_path):
    line = ["solution", "--alpha", "2", "--epsilon", "1/10", "--order", "3", "--time", "50", "--bound", "--json"]
    line += ["--csv", str(tmp_path / "x.csv"), "--plot", str(tmp_path / "x.svg"), "--points", "20"]
    assert main(line) == 0
    found = json.loads(capsys.readouterr().out)
    assert found["certified"] is False and found["order"] == 3 and found["valid_until"] == "oo"
    names = {"tau": tau, "epsilon": epsilon}
    values = {tau: sympy.Integer(50), epsilon: sympy.Rational(1, 10)}
    for name in ("amplitude", "phase", "x"):
        form = sympy.sympify(found[name], locals=names)
        assert abs(form.subs(values).evalf(25) - sympy.Float(found[f"{name}_value"], 25)) < 1e-20
        assert form.subs({tau: 0}).subs(epsilon, sympy.Rational(1, 7)) == {"amplitude": 1, "phase": 0, "x": 1}[name]
    true = float(asy.reference({2: "1/10"}).at("50", digits=20).x)
    assert abs(true - float(found["x_value"])) <= float(found["bound"]) < 1e-5
    rows = (tmp_path / "x.csv").read_text().splitlines()
    assert rows[0].startswith("tau,amplitude,phase,x") and len(rows) == 22
    assert float(rows[-1].split(",")[3]) == pytest.approx(float(found["x_value"]), abs=1e-12)
    assert (tmp_path / "x.svg").read_text().startswith("<?xml")


@pytest.mark.parametrize(
    ("law", "order"),
    [("2", 5), ("1", 3), *(pytest.param(*row, marks=pytest.mark.slow) for row in (("2", 4), ("0", 5)))],
)
def test_the_text_of_x_is_x(law, order):
    """Read by SymPy: the number that ``at`` gives, x(0) = 1; from order 5 on A and psi are written once."""
    found = asy.solution({law: "1/10"}, order=order)
    text = found.to_dict()["x"]
    form = sympy.sympify(text, locals={"tau": tau, "epsilon": epsilon})
    assert form.free_symbols <= {tau, epsilon} and form.subs({tau: 0}).subs(epsilon, sympy.Rational(1, 7)) == 1
    with mpmath.workdps(30):
        value = sympy.lambdify([tau, epsilon], form, "mpmath")(mpmath.mpf(7), mpmath.mpf(1) / 10)
        assert abs(value - mpmath.mpf(found.at(7, digits=25).x)) < mpmath.mpf(10) ** -22
    assert text.startswith("Lambda((A, psi)") == (order > 4) and len(text) < 15_000
    named = found.to_dict()["x_by_name"]
    assert set(named) == {"x", "chi", "psi", "delta", "A"} and "delta" in named["x"]


@pytest.mark.parametrize("law", ["2", "3/2", "symbolic", "1", "0"])
def test_latex_is_a_document(law, tmp_path):
    text = asy.solution(law, order=4 if law == "2" else 2).latex(standalone=True)
    assert text.startswith(r"\documentclass") and text.rstrip().endswith(r"\end{document}")
    assert text.count(r"\[") == text.count(r"\]") and A_0 is not None
    if shutil.which("pdflatex") is None:
        pytest.skip("no pdflatex to compile it with")
    (tmp_path / "s.tex").write_text(text)
    done = subprocess.run(
        ["pdflatex", "-interaction=nonstopmode", "-halt-on-error", "s.tex"],
        cwd=tmp_path,
        capture_output=True,
        check=False,
    )
    assert done.returncode == 0, done.stdout[-800:]


def test_the_envelope_of_an_order_is_that_of_the_solution_everywhere(capsys, tmp_path):
    line = ["envelope", "--alpha", "2", "--epsilon", "1/10", "--order", "6", "--time", "20", "--digits", "15", "--json"]
    assert main([*line, "--csv", str(tmp_path / "e.csv"), "--points", "4"]) == 0
    found, point = json.loads(capsys.readouterr().out), asy.solution({2: "1/10"}, order=6).at(20, digits=15)
    assert (found["amplitude"], found["phase"]) == (point.amplitude, point.phase)
    assert found["certified"] is False and found["order"] == 6 and "epsilon**4" in found["formula"]
    first = asy.envelope({2: "1/10"}).amplitude(20, digits=15)
    assert abs(float(first) - float(found["amplitude"])) > 1e-6  # no silent first order
    last = (tmp_path / "e.csv").read_text().splitlines()[-1].split(",")
    assert float(last[1]) == pytest.approx(float(point.amplitude), abs=1e-12)
    assert main(["envelope", "--alpha", "2", "--epsilon", "1/10", "--order", "2", "--latex"]) == 0
    assert capsys.readouterr().out.strip().count("\n") == 0
    assert main(["envelope", "--alpha", "2", "--epsilon", "1/10", "--order", "2", "--v0", "1"]) == 2
    assert "--order" in capsys.readouterr().err


def residual_of_the_flow(found, alpha, rates, eps):
    """The larger of |A'/A + p(delta)| and |phi' - Omega(delta)| at one slow time: no algebra of the slow time."""
    time = mpmath.mpf(1) / 2 / eps
    A, phi = (sympy.lambdify([tau], e.subs(epsilon, eps), "mpmath") for e in (found.amplitude, found.phase))
    delta = eps * A(time) ** (alpha - 1)
    p, Omega = (sum(mpmath.mpf(c) * delta**n for (n,), c in rates[name].items()) for name in ("p", "Omega"))
    return max(abs(mpmath.diff(A, time) / A(time) + p), abs(mpmath.diff(phi, time) - Omega))


@pytest.mark.parametrize(("law", "order"), [("5/2", 9), pytest.param("3/2", 12, marks=pytest.mark.slow)])
def test_open_exponents_reach_order_twelve(law, order):
    """Decimals beyond the closed orders solve the truncated flow to O(eps^(N+1)); one of them changed does not."""
    found, rates = asy.solution(law, order=order), certified_digits([Term(1, law)], order, 40, names=("p", "Omega"))
    with mpmath.workdps(60):
        alpha, eps = mpmath.mpf(Fraction(law).numerator) / Fraction(law).denominator, mpmath.mpf(1) / 40
        coarse, fine = (residual_of_the_flow(found, alpha, rates, e) for e in (eps, eps / 2))
        assert mpmath.log(coarse / fine, 2) > order + 0.4
        wrong = replace(found, slow_phase=found.slow_phase + epsilon**3 * D**3 / 10**12)
        assert residual_of_the_flow(wrong, alpha, rates, eps / 2) > 10 * fine
    assert not found.relative.coeff(epsilon, 2).has(sympy.Float)
    assert max(len(str(e)) for e in (found.amplitude, found.phase)) < 6000


@pytest.mark.slow
def test_the_command_answers_at_order_nine(capsys):
    assert main(["solution", "--alpha", "5/2", "--epsilon", "1/10", "--order", "9", "--time", "7", "--json"]) == 0
    found = json.loads(capsys.readouterr().out)
    low = asy.solution({"5/2": "1/10"}, order=8).at(7, digits=20).x
    assert 0 < abs(float(found["x_value"]) - float(low)) < 1e-8
