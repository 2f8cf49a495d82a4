"""Nearly equal exponents, a standing random class: 10^-9 to 10^-40 apart, both signs, on both sides of 1.

They cost what one law costs, counted in calls (of functions in Python and in C, no seconds), whether the motion turns
a hundred times or creeps.  Independent routes: the linear motion in closed form, from which a law parts by no more
than the work of the difference of the two forces (two motions never part), and one law alone on either side.
"""

import sys
from random import Random

import mpmath
import pytest

from asymptotics.law import Law, Oscillator
from asymptotics.motions.reference import reference_motion
from asymptotics.numbers.exact import parse_real
from asymptotics.turning.choose import turning_points

BASES = ["1", "1", "1", "3/2", "1/2", "sqrt(2)", "4/3", "1"]


def drawn(seed, low, high):
    """Exponents base + d with 10^-40 <= |d| <= 10^-9, in turn on one side and on both, and strengths low to high
    together: (strength, base, d) of each."""
    random = Random(seed)
    base, count = BASES[seed % len(BASES)], random.choice((2, 3))
    gaps = [f"{random.choice('+-')}{random.randint(11, 99)}e-{random.randint(11, 41)}" for _ in range(count)]
    if seed % 2 == 0:
        gaps[:2] = ["+" + gaps[0][1:], "-" + gaps[1][1:]]
    total = random.randint(int(100 * low), int(100 * high))
    shares = [random.randint(1, 5) for _ in gaps]
    return [(parse_real(f"{total * s}/{100 * sum(shares)}", "e"), base, gap) for s, gap in zip(shares, gaps)]


def exponent(base, gap):
    return parse_real(base, "a") + parse_real(gap, "a").rational


def law_of(terms):
    return Law({exponent(base, gap): e for e, base, gap in terms})


def alone(terms, pick):
    """All strengths with one of the exponents, which is not 1 itself."""
    total = sum((e.rational for e, _, _ in terms), 0)
    base, gap = pick((float(gap), (base, gap)) for _, base, gap in terms)[1]
    return Law({exponent(base, gap): str(total)})


def calls(function):
    """What a function returns, and how many calls it takes: a cost that no machine changes."""
    count = 0

    def hook(_frame, event, _arg):
        nonlocal count
        count += event in ("call", "c_call")

    before = sys.getprofile()
    sys.setprofile(hook)
    try:
        found = function()
    finally:
        sys.setprofile(before)
    return found, count


def state(law, time, digits=15):
    return reference_motion(Oscillator(law), time, digits, max_seconds=1e4)


def same(a, b, rel=1e-6):
    size = max(abs(mpmath.mpf(b.x)), abs(mpmath.mpf(b.v)))
    return abs(mpmath.mpf(a.x) - mpmath.mpf(b.x)) < rel * size and abs(mpmath.mpf(a.v) - mpmath.mpf(b.v)) < rel * size


@pytest.mark.parametrize("seed", range(8))
def test_a_motion_that_turns_costs_what_one_law_costs(seed):
    """A hundred turning points, where exponents allow as many; one law alone may use NumPy, which is not counted."""
    time = "100" if seed == 2 else "300"  # the one in `make test`
    terms = drawn(seed, 0.1, 1.3)
    found, work = calls(lambda: state(law_of(terms), time))
    single, least = calls(lambda: state(alone(terms, max), time))
    assert same(found, single) and work < 8 * least


@pytest.mark.parametrize("seed", range(0, 16, 2))
def test_a_creep_beside_1_costs_what_one_law_costs(seed):
    time = "60" if seed == 10 else "150"  # the one in `make test`
    terms = [(e, "1", gap) for e, _, gap in drawn(seed, 2.3, 5)]
    found, work = calls(lambda: state(law_of(terms), time))
    single, least = calls(lambda: state(alone(terms, min), time))
    assert same(found, single) and work < 6 * least


@pytest.mark.parametrize(("total", "time"), [("1/2", 40), ("7/5", 40), ("5/2", 30), ("9/2", 40)])
@pytest.mark.parametrize("gaps", [("1e-20", "-1e-20"), ("-1e-12", "3e-12"), ("1e-10", "1.2e-10"), ("-1e-10", "-1e-11")])
def test_next_to_the_linear_law_the_closed_form_is_missed_by_the_work_of_the_difference(total, time, gaps):
    """Two motions never part: off by at most t max |N(w) - epsilon w|, and |w^(1+d) - w| <= |d|/(e (1 - |d|)) for w <=
    1.  Relative to a motion that fades it is off by some t^2 gaps at most."""
    terms = [(parse_real(f"{total}", "e") / 2, "1", gap) for gap in gaps]
    found = state(law_of(terms), str(time), 40)
    with mpmath.workdps(60):
        e = mpmath.mpf(str(parse_real(total, "e").rational.numerator)) / parse_real(total, "e").rational.denominator
        omega = mpmath.sqrt(1 - e**2 / 4 + 0j)
        x = mpmath.exp(-e * time / 2) * (mpmath.cos(omega * time) + e / 2 * mpmath.sin(omega * time) / omega)
        widest = max(abs(mpmath.mpf(gap)) for gap in gaps)
        off = abs(mpmath.mpf(found.x) - x.real)
        assert 0 < off < time * e * widest / mpmath.e / (1 - widest)
        assert off < 100 * time * widest * abs(x) * time


@pytest.mark.parametrize("gap", ["1e-40", "1e-30", "1e-20", "-1e-30"])
def test_turning_points_next_to_the_linear_law_are_those_of_the_linear_law(gap):
    """By interpolation, also where no ball at the working precision tells the exponent from 1."""
    start = 8 if gap == "1e-40" else 60  # the one in `make test`
    near, linear = (
        turning_points(Law({exponent("1", d): "1"}), start=start, count=2, digits=15).points for d in (gap, "0")
    )
    for found, exact in zip(near, linear, strict=True):
        assert mpmath.almosteq(mpmath.mpf(found.x), mpmath.mpf(exact.x), 1e-14, 0)


def test_a_straddling_pair_against_an_ordinary_integrator():
    """From one time to another in the first half-swing, by mpmath's Taylor integrator."""
    terms = [(parse_real("1/2", "e"), "1", gap) for gap in ("4e-9", "-7e-9")]
    begin, end = (state(law_of(terms), time, 25) for time in ("1", "5/4"))
    with mpmath.workdps(24):
        e, a, b = mpmath.mpf("0.5"), 1 + mpmath.mpf("4e-9"), 1 - mpmath.mpf("7e-9")
        orbit = mpmath.odefun(
            lambda t, z: [z[1], -z[0] + e * ((-z[1]) ** a + (-z[1]) ** b)],
            1,
            [mpmath.mpf(begin.x), mpmath.mpf(begin.v)],
            tol=mpmath.mpf(10) ** -19,
        )
        for found, exact in zip((end.x, end.v), orbit(mpmath.mpf("1.25")), strict=True):
            assert abs(exact - mpmath.mpf(found)) < mpmath.mpf(10) ** -17
