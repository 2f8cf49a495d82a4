"""The front door: the contract's calls, every kind of number, units, events, a light import."""

import subprocess
import sys
from decimal import Decimal
from fractions import Fraction
from importlib import import_module
from pathlib import Path

import mpmath
import numpy as np
import pytest
import sympy

import asymptotics as asy

ROOT = Path(__file__).parents[1]


@pytest.fixture(scope="module")
def osc():
    return asy.Oscillator(asy.Law({"3/2": "1/10"}), mass="3/2", stiffness=30, x0="1/5", v0=0)


@pytest.fixture(scope="module", autouse=True)
def every_submodule():
    """A function must not turn into a module when a room is imported."""
    for path in sorted((ROOT / "asymptotics").rglob("*.py")):
        dotted = ".".join(path.relative_to(ROOT).with_suffix("").parts).removesuffix(".__init__")
        if not dotted.endswith("__main__"):
            import_module(dotted)


def test_every_name_is_there_and_none_is_a_module():
    for name in set(asy.__all__) - {"testing"}:
        assert type(getattr(asy, name)).__name__ != "module", name
    assert set(asy.__all__) <= set(dir(asy)) and asy.__all__ == sorted(set(asy.__all__))
    with pytest.raises(AttributeError, match="no attribute 'motoin'"):
        _ = asy.motoin


def test_the_contract(osc):
    assert asy.turning_points(osc, 10, digits=30).points[1].x.startswith("-0.19")
    eq = asy.expand("3/2", order=4, gauge="turning-point")
    assert set(eq.p) == {1, 3} and set(eq.Omega) == {2, 4} and "A" in str(eq.to_sympy()[0])
    assert r"\frac{dA}{d\tau}" in eq.latex() and "+ -" not in eq.latex() and "+/-" not in eq.latex()
    assert asy.motion(osc, order=3).sample(np.array([0.0, 7.0])).x.shape == (2,)
    assert asy.moment("5/2").exact == "gamma(7/4)/(sqrt(pi)*gamma(9/4))"
    assert len(asy.multiple_scales(3, order=6).orders) == 7
    assert asy.paper("smith2012:43") is not None and asy.table("smith2012.table1").rows


@pytest.mark.parametrize("a", [Fraction(3, 2), Decimal("1.5"), 1.5, sympy.Rational(3, 2), np.float32(1.5)], ids=repr)
def test_the_same_equations_for_every_kind_of_number(a):
    assert asy.expand(a, order=3) == asy.expand("3/2", order=3)
    assert asy.expand(a, order=np.int64(3)).notes == (
        ("alpha: the float 1.5 was read as 3/2",) if isinstance(a, float | np.floating) else ()
    )
    assert asy.moment(a).value == asy.moment("3/2").value


def test_every_result_says_what_a_float_was_read_as():
    osc = asy.Oscillator({1.5: "1/10"}, mass=1.5, stiffness=30, x0="1/5")
    found = [
        asy.expand(1.5), asy.moment(1.5), asy.half_swing(1.5), asy.half_swing(1.5, delta="1/10"),
        asy.multiple_scales(1.5),
        asy.turning_points({2: 1.5}, 2), asy.turning_points(osc, 2), asy.motion(osc), asy.motion(osc).at(1),
        asy.reference(osc), asy.reference(osc).at(1, digits=5), asy.envelope(osc), asy.motion({2: "1/10"}).at(1.5),
    ]  # fmt: skip
    for result in found:
        assert any("float 1.5 was read as 3/2" in note for note in result.notes), type(result)


def test_nan_times_keep_their_place_and_none_is_negative(osc):
    for moving in (asy.motion(osc), asy.reference(osc)):
        with pytest.raises(asy.InputError):
            moving.sample(-1.0)
        assert np.isnan(moving.sample([0.0, np.nan]).x).tolist() == [False, True]


def test_si_and_dimensionless_do_not_mix(osc):
    for call in (asy.expand, asy.turning_points, asy.motion, asy.envelope):
        with pytest.raises(asy.InputError, match="epsilon is meant"):
            call(osc.law)


def test_an_oscillator_is_answered_in_its_units(osc):
    # the same physics in centimetres: lengths scale by 100, times stay
    cm = asy.Oscillator({"3/2": asy.ExactReal(Fraction(1, 100), 1)}, mass="3/2", stiffness=30, x0=20)
    x, y = (asy.turning_points(o, 3, digits=15, times=True).points[2] for o in (osc, cm))
    assert Fraction(y.x) == 100 * Fraction(x.x) and x.t == y.t
    slow, fast = asy.expand(osc)(0.1), asy.expand(cm)(10.0)
    assert np.allclose([slow[0] * 100, slow[1]], fast, rtol=1e-14)
    unit = asy.turning_points(osc.dimensionless, 3, digits=15, times=True).points[2]
    assert abs(float(unit.x) / 5 - float(x.x)) < 1e-15


def test_a_start_in_motion_turns_where_the_reference_turns():
    kicked = asy.Oscillator({2: "1/5"}, mass=2, stiffness=8, x0="1/4", v0="3/2")
    points = asy.turning_points(kicked, 3, digits=12, times=True)
    events = asy.reference(kicked).events(8)
    assert np.allclose([float(p.x) for p in points.points], events.turning_x[:3], rtol=1e-9)
    assert np.allclose([float(p.t) for p in points.points], events.turning[:3] - events.turning[0], atol=1e-9)
    with pytest.raises(asy.InputError, match="v0"):
        asy.turning_points(asy.Oscillator({2: 1}, mass="sqrt(2)", v0=1))


def test_equations_evaluate_convert_and_agree_with_an_integration(osc):
    eq = asy.expand(osc, order=6)
    dA, dpsi = eq(np.array([0.1, 0.2]))
    symbolic = [sympy.lambdify(sympy.Symbol("A", positive=True), e, "mpmath")(0.2) for e in eq.to_sympy()]
    assert np.allclose([dA[1], dpsi[1]], [float(s) for s in symbolic], rtol=1e-13)
    precise = eq.lambdify("mpmath")(mpmath.mpf(1) / 5)
    assert abs(float(precise[0]) - dA[1]) < 1e-15
    rate, turn = eq.odes()
    assert rate.lhs.has(sympy.Symbol("t", real=True)) and turn.rhs != 0
    seen, table = eq.observables(), asy.turning_points(osc, 3, digits=15, times=True).points
    assert abs(seen.half_period.value - float(table[1].t)) <= seen.half_period.error + 1e-12
    decrement = np.log(float(table[0].x) / float(table[2].x))
    assert abs(seen.decrement.value - decrement) <= seen.decrement.error + 1e-12
    assert abs(seen.half_period.value - float(table[1].t) * (1 + 1e-5)) > seen.half_period.error  # near miss


def test_rows_are_mappings_and_amplitudes_are_checked():
    eq = asy.expand({"1/2": "1/10"}, order=3)
    assert 1 in eq.p and 2 not in eq.p and "x" not in eq.p and eq.p.get(7) is None and dict(eq.p).keys() == {1, 3}
    for bad in ("x", None, [[1], [1, 2]], -0.5, [0.5, -1.0], 1j):
        with pytest.raises(asy.InputError, match="argument A"):
            eq(bad)
    assert np.isnan(eq([0.5, float("nan")])[0]).tolist() == [False, True]
    assert asy.Law({1.5: 1}) == asy.Law({"3/2": 1}) and asy.expand({1.5: 1}) == asy.expand({"3/2": 1})
    assert len({asy.Law({1.5: 1}), asy.Law({"3/2": 1})}) == 1


def test_gauges_are_compared_by_what_is_seen():
    law = {3: "1/5"}
    one, other = asy.expand(law, order=4), asy.expand(law, order=4, gauge="no-first-harmonic")
    assert one != other and one.compare(other).agree
    assert not one.compare(asy.expand({3: "1/4"}, order=4)).agree
    with pytest.raises(asy.InputError, match="other"):
        one.compare(3)
    with pytest.raises(asy.InputError, match="the function failed"):
        one.compare(lambda A, psi: 1)


def test_numbers_are_handed_out_by_name():
    c, pi_over = asy.expand(3, order=4).Omega[2], asy.expand(2, order=3).p[1]
    assert c.fraction() == Fraction(-45, 256) and c.sympy() == sympy.Rational(-45, 256) and float(c) == -45 / 256
    inside = pi_over.interval()
    with mpmath.workdps(60):
        truth, (low, high) = 4 / (3 * mpmath.pi), (mpmath.mpf(end) for end in inside._mpi_)
        assert low < truth < high and high - low < 1e-29
    with pytest.raises(asy.InputError, match="not rational"):
        pi_over.fraction()
    with pytest.raises(asy.InputError, match="depends on the exponent"):
        float(asy.expand("symbolic").p[1])


def test_events_do_not_end_where_the_product_of_two_neighbours_is_below_the_doubles():
    events = asy.motion({1: 1}).events(900)  # |x| falls to 1e-196; below 1e-162 a square is 0
    for found in (events.turning, events.zeros):
        assert np.allclose(np.diff(found), found[1] - found[0]) and 900 - found[-1] < found[1] - found[0]


def test_reference_events_of_dry_friction():
    osc = asy.Oscillator({0: "0.14715"}, mass="3/2", stiffness=30, x0="1/5")
    events = asy.reference(osc).events(20)
    assert events.stop is not None and events.stop < 20 and events.turning.max() <= events.stop + 1e-9
    assert np.allclose(np.diff(events.turning), np.pi / np.sqrt(20), rtol=1e-9)


def test_samples_become_tables(osc):
    samples = asy.motion(osc).sample([0.0, 0.5])
    frame = samples.to_dataframe()
    assert list(frame.columns)[:2] == ["t [s]", "x [m]"] and len(frame) == 2
    assert samples.to_csv().splitlines()[0] == (
        "t [s],x [m],v [m/s],amplitude [m],phase [rad],code [--order=3 --gauge=turning-point]"
    )
    assert asy.reference(osc).sample([0.0]).to_csv().splitlines()[0] == "t [s],x [m],v [m/s],code"


def test_the_import_is_light_and_the_module_runs():
    code = (
        "import sys, time; t = time.process_time(); import asymptotics; dt = time.process_time() - t;"
        "print(dt < 0.1, {'sympy', 'numpy', 'scipy', 'matplotlib', 'flint'} & set(sys.modules))"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout.split() == ["True", "set()"]
    command = [sys.executable, "-m", "asymptotics", "--version"]
    done = subprocess.run(command, capture_output=True, text=True, check=True)
    assert done.stdout.startswith(f"asymptotics {asy.__version__}")


@pytest.mark.parametrize("digits", [4400, 10_000])
def test_turning_points_of_an_oscillator_have_as_many_digits_as_those_of_a_law(digits):
    found = asy.turning_points(asy.Oscillator({1: "1/10"}, mass=3), 2, digits=digits)
    assert len(found.points[1].x) == digits + 3 and found.to_dataframe()["x [m]"][0] == 1  # -0. and the digits
    with pytest.raises(asy.InputError, match="10001 is out of range"):
        asy.turning_points(asy.Oscillator({1: "1/10"}, mass=3), 2, digits=10_001)


def test_points_are_a_sequence(osc):
    for found in (asy.turning_points({2: 1}, 3, digits=9), asy.turning_points(osc, 3, digits=9)):
        assert len(found) == 3 and [*found] == [*found.points] and found[-1] is found.points[2]
        assert found[1:] == found.points[1:] and found.points[1] in found and bool(found)
        for bad in (3, -4, "x", None, 1.0):
            with pytest.raises(asy.InputError, match="argument place"):
                found[bad]


def test_a_strength_is_never_taken_for_an_exponent():
    for swapped in (lambda: asy.expand("1/10", "3/2"), lambda: asy.Law("3/2", "1/10"), lambda: asy.Law(1.5)):
        with pytest.raises((TypeError, asy.InputError)):
            swapped()
