"""Every request is served or refused by name, in the time it was given; what is served has the right digits."""

import json
from fractions import Fraction
from math import copysign, cos, sin
from time import process_time

import pytest
from scipy.integrate import solve_ivp

from asymptotics.shell.main import main
from tests.extreme_requests import FAMILIES, requests

PATIENT, BRIEF = 60, 6

HARDEST = [
    (0, "turning-points --law 1/2:1/5 --count 1 --start 1000000000000000000"),
    (0, "turning-points --law 1/1000:1/5 --law 1/500:1/5 --count 5"),
    (0, "turning-points --law 1/125000000000000000000000000000:1.01 --count 3 --times"),
    (
        0,
        "turning-points --law 100000000000000000001/100000000000000000000:1.06 --count 2 --x0 0.211 --v0 -0.926",
    ),
    (2, "motion --law 3/50000000000000000000000000:1.45 --reference --time 1e12"),
    (0, "motion --law 1/100:2 --reference --time 1e18"),
    (0, "half-swing --law 2 --law 1/3 --delta 1e-112,1e-155"),
    (0, "half-swing --law 1/3 --law 0 --delta 0,0"),
    (2, "half-swing --law 9/1000000000000000000000000000000 --law 1/2 --delta 0.735,0.0233"),
    (2, "turning-points --law 50:1e229 --count 1 --start 1000000000000"),
    (2, "expand --law 1000:1.44 --order 4 --bound"),
]


def asked(arguments, capsys, seconds=PATIENT):
    """(exit code, the answer or None, the refusal or None); no traceback, one line, not much longer than allowed."""
    begin = process_time()
    code = main([*arguments, "--max-seconds", str(seconds), "--json"])
    spent, (out, err) = process_time() - begin, capsys.readouterr()
    assert spent < 2 * seconds and code in (0, 1, 2)
    if code:
        assert not out and len(err.splitlines()) == 1
        assert (": undecided: " if code == 1 else ": argument ") in err
        return code, None, err
    return code, json.loads(out), None


def numbers(answer):
    """Every decimal of an answer that its digits prove."""
    if "points" in answer:
        return [p[key] for p in answer["points"] for key in ("x", "tau") if p.get(key) is not None]
    return [answer[key] for key in ("x", "v", "log_ratio", "duration") if isinstance(answer.get(key), str)]


def checked(arguments, capsys, seconds=PATIENT):
    """Ten digits beside twenty-four."""
    if "--bound" in arguments:
        return asked(arguments, capsys, seconds)[0]
    code, short, _ = asked([*arguments, "--digits", "10"], capsys, seconds)
    if short is None:
        return code
    _, long, _ = asked([*arguments, "--digits", "24"], capsys, seconds)
    if long is not None:
        assert short.get("ended") == long.get("ended")
        for x, y in zip(map(Fraction, numbers(short)), map(Fraction, numbers(long)), strict=True):
            assert abs(x - y) <= abs(y) / 10**9
    return code


@pytest.mark.parametrize(("code", "line"), HARDEST)
def test_the_hardest_are_served_or_refused_at_once(code, line, capsys):
    assert checked(line.split(), capsys) == code


def test_a_creep_beside_a_second_exponent_near_the_first_is_served_like_one_law(capsys):
    """x' = -(x/b)^(1/alpha) to first order: x t -> b^2 at alpha = 1/2, b = 2/5, from two exponents 1/1000 apart."""
    line = "motion --law 1/2:1/5 --law 501/1000:1/5 --reference --time 1000"
    assert checked(line.split(), capsys) == 0
    _, answer, _ = asked(line.split(), capsys)
    assert float(answer["x"]) * 1000 == pytest.approx(0.4**2, rel=0.02)


@pytest.mark.slow
@pytest.mark.parametrize("seed", range(2))
@pytest.mark.parametrize("family", FAMILIES)
def test_each_is_served_or_refused_by_name(family, seed, capsys):
    codes = [checked(line, capsys, BRIEF) for line in requests(family, 20, seed)]
    assert codes.count(0) >= 3


@pytest.mark.parametrize("alpha", ["99/100", "10001/10000", "30", "200"])
def test_an_integrator_agrees(alpha, capsys):
    _, answer, _ = asked(["motion", "--law", f"{alpha}:0.3", "--reference", "--time", "7", "--digits", "12"], capsys)
    force = lambda _, s: [s[1], -s[0] - copysign(0.3 * abs(s[1]) ** float(Fraction(alpha)), s[1])]  # noqa: E731
    found = solve_ivp(force, (0, 7), [1.0, 0.0], "DOP853", rtol=1e-11, atol=1e-12, max_step=0.02)
    assert float(answer["x"]) == pytest.approx(found.y[0][-1], abs=1e-8)
    assert abs(float(answer["x"]) - cos(7)) > 1e-3 or abs(float(answer["v"]) + sin(7)) > 1e-3
