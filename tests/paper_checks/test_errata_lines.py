"""What the sheets and the comment say beside the formulas: numbers computed, sentences tried."""

import math
import re
from fractions import Fraction

import mpmath
import pytest

from asymptotics.law import Law
from asymptotics.motions.invariants.exact import coefficient
from asymptotics.papers.lookup import paper
from asymptotics.turning.choose import turning_points
from paper_checks.errata import LINES
from paper_checks.quoted import COMPUTED, _own, _swings, quoted, rounded
from paper_checks.registry import load
from paper_checks.report.sheets import astray, comment
from paper_checks.verdict import Kind, Printed

SAID = re.compile(r"-?\b\d+/\d+|\b[Tt]wo(?= dots)|\bSeven\b|(?<=factor )\d\b|(?<=is )\d\b")
WORDS = {"Two": 2, "two": 2, "Seven": 7}


def at(form, **values):
    """The value of a form where its letters have these values."""
    return float(form.subs({letter: values[letter.name] for letter in form.free_symbols}))


def turning_point(n):
    return float(turning_points(Law({"2": "1"}), 1, 15, start=n).points[0].x)


def factor(key):
    """By what the corrected form is more than the printed one."""
    e = load()[key]
    printed, corrected = (f[0] if isinstance(f, tuple) else f for f in (e.printed, e.corrected))
    return float((corrected / printed).simplify())


def radicand(key):
    """How much more of u + 1/2 the corrected radicand has: read off the LaTeX, 1/gamma for 1/(2 gamma)."""
    known = (r"\frac{\omega^2}{2\gamma}\left(", r"\frac{\omega^2}{\gamma}\left(")
    printed, corrected = load()[key].latex, load()[key].corrected_latex
    return 2.0 if known[0] in printed and known[1] in corrected else 0.0


def third_term(latex):
    return float(re.search(r"(\d)\\omega\^2E_ne", latex)[1])


VALUES = {  # what the lines of the sheets quote beyond their statements, computed
    "lancaster2020:claim.energy-derivative": {
        "Two": lambda: load()["lancaster2020:claim.energy-derivative"].corrected_latex.count(r"\dot"),
    },
    "lelas2024:value.tau-exact-b": {"Seven": lambda: _swings(0.03)},
    "smith2012:49": {"1/4": lambda: -at(load()["smith2012:42"].printed, u_0=0)},
    "smith2012:51": {"0.460": astray, "0.263568": lambda: turning_point(2), "1/4": lambda: factor("smith2012:51")},
    "smith2012:52a": {"-1/4": lambda: factor("smith2012:52a")},
    "smith2012:52b": {"1/4": lambda: factor("smith2012:52b")},
    "smith2012:54": {"2": lambda: radicand("smith2012:54")},
    "smith2012:55": {"2": lambda: radicand("smith2012:55")},
    "smith2012:62b": {"2/3": lambda: coefficient(2, 1)},
    "smith2012:72": {
        "3": lambda: third_term(load()["smith2012:72"].latex),
        "4": lambda: third_term(load()["smith2012:72"].corrected_latex),
    },
    "smith2012:table1.S3": {"0.235335": lambda: -edge(turning_point(3)), "0.101501": lambda: -edge(1)},
    "smith2012:table1.S5": {"0.243090": lambda: -edge(turning_point(5)), "0.101501": lambda: -edge(1)},
}  # fmt: skip


def edge(u):
    """S at a turning point, (42)."""
    return -math.exp(-2 * abs(u)) * (abs(u) / 2 + 0.25)


def transit(u0, first, last):
    """omega t between two places of the first swing by the quadrature (55): u = middle - half cos, at both ends."""
    middle, half = (first + last) / 2, (last - first) / 2

    def rate(angle):
        u = middle - half * mpmath.cos(angle)
        return half * mpmath.sin(angle) / mpmath.sqrt(u + 0.5 - (u0 + 0.5) * mpmath.exp(2 * (u - u0)))

    with mpmath.workdps(25):
        return mpmath.quad(rate, [0, mpmath.pi / 2, mpmath.pi], method="gauss-legendre")


def untied(key, text):
    """The numbers of a line that no value is behind, or another value than the one printed."""
    known = {**COMPUTED.get(key, {}), **VALUES.get(key, {})}
    faults = []
    for number in quoted(text):
        values = [known[number]()] if number in known else map(float, _own(load()[key]))
        faults += [] if any(rounded(number, abs(value)) for value in values) else [number]
    for number in SAID.findall(text):
        wanted = WORDS.get(number.strip()) or float(Fraction(number))
        faults += (
            [] if number.strip() in known and known[number.strip()]() == pytest.approx(wanted, 1e-12) else [number]
        )
    return faults


def test_every_number_of_a_line_is_computed():
    found = {key: untied(key, f"{place} {why} {effect}") for key, (place, why, effect, _) in LINES.items()}
    assert {key: numbers for key, numbers in found.items() if numbers} == {}
    for key, values in VALUES.items():  # none stands idle
        text = " ".join(LINES[key][:3])
        assert set(values) == {*quoted(text), *SAID.findall(text)} & set(values), key


@pytest.mark.parametrize(
    ("key", "text"),
    [("smith2012:51", "gives 0.461"), ("smith2012:49", "1/2 is lost"), ("lelas2024:value.tau-exact-b", "4.9184 s"),
     ("smith2012:72", "The factor 5 is 4"), ("smith2012:54", "A factor 3 is lost")],
)  # fmt: skip
def test_a_wrong_number_of_a_line_is_noticed(key, text):
    assert untied(key, text) != []


def test_the_printed_digits_of_table_i_are_differences_of_rounded_constants():
    for n in range(1, 6):
        printed = load()[f"smith2012:table1.S{n}"].latex.rpartition("= ")[2]
        assert round(-edge(turning_point(n)), 6) * -1 + round(-edge(1), 6) == pytest.approx(-float(printed), abs=1e-9)


def test_what_the_lines_say_of_54_and_72_is_so():
    """As printed the radicand of (54) is negative at both ends, (72) gives negative times; corrected both are right."""
    u0, u1 = 1.0, turning_point(1)
    for share, sign in ((0.5, -1), (1, 0)):
        for u in (u0, u1):
            value = 2 * edge(u0) * math.exp(2 * u) + share * (u + 0.5)
            assert value < 0 if sign else abs(value) < 1e-12
    u0, u = 0.01, 0.004  # on the first swing, before the arctangent jumps
    exact = float(transit(mpmath.mpf(u0), mpmath.mpf(u), mpmath.mpf(u0)))
    place = {"gamma": 1, "omega": 1, "x": u, "E": edge(u0)}
    printed, corrected = (
        math.atan(at(argument, **place)) + at(term, **place)
        for argument, term in (load()["smith2012:72"].printed, load()["smith2012:72"].corrected)
    )
    assert printed < 0 < exact and abs(corrected - exact) < 5 * u0**2


def test_what_the_comment_says_beyond_the_statements_is_so():
    said_there = comment("smith2012")
    assert (said_there["formulas"], said_there["decimals"], said_there["astray"]) == (14, 2, "0.460")
    assert said_there["second_turn"] == f"{turning_point(2):.6f}"
    assert float(said_there["astray"]) > -turning_point(1) > turning_point(2)
    points = [1.0, *(turning_point(n) for n in range(1, 6))]
    for u, following in zip(points, points[1:]):  # Lambert's W
        y = 1 + 2 * abs(u)
        assert 2 * abs(following) == pytest.approx(1 + float(mpmath.lambertw(-y * mpmath.exp(-y)).real), abs=1e-12)
    rows = re.findall(r"\$(\d)\$ & \$([-.\d]+)\$ & \$([-.\d]+)\$", said_there["table"])
    constants = [edge(1) - edge(u) for u in points]
    assert [(n, s, u) for n, s, u in rows] == [
        (str(n + 1), f"{constants[n]:.6f}" if n else "0", f"{points[n]:.6f}") for n in range(6)
    ]
    for u0 in (mpmath.mpf("0.01"), mpmath.mpf("0.005")):  # the half-period, twice: the next term is of third order
        with mpmath.workdps(40):
            u1 = -(1 + mpmath.lambertw(-(1 + 2 * u0) * mpmath.exp(-(1 + 2 * u0))).real) / 2
        whole = transit(u0, u1, u0)
        assert abs(whole / mpmath.pi - 1 - u1**2 / 6) < abs(u1) ** 3
    assert said_there["second"] == r"\tfrac{1}{6}"
    assert all(load()[f"smith2012:{n}"].verdict == Printed.HOLDS for n in ("57", "58", "61", "69", "70", *SERIES))
    assert all(load()[f"smith2012:table1.u{n}"].verdict == Printed.HOLDS for n in range(1, 6))


SERIES = [f"60{letter}" for letter in "abcdefgh"]


def test_what_the_comment_says_of_its_evidence_is_so():
    """Formulas by computer algebra, decimals in balls; never that a machine has checked everything."""
    for key, entry in load("smith2012").items():
        if entry.verdict == Printed.MISPRINT:
            assert paper(key).evidence == ("certified" if entry.kind == Kind.NUMBER else "proved"), key
