"""What each line of the checker keeps out: certificates that are refused, and accepted when that line is weakened.

`ATTACKS` has for each of them a part of the checker's text, what it is weakened to, the certificate, and what is wrong:

* ``false``: a claim of it is false;
* ``unclear``: it can be read in two ways, or claims nothing, or more than the reader sees;
* ``limit``: it is longer than the checker takes;
* ``fault``: without the line the checker ends in a traceback.
"""

import json
from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Any

from tests.certificates import examples
from tests.testing import forged


@dataclass(frozen=True)
class Attack:
    """One weakened line; ``limits`` are set in the checker with and without it."""

    name: str
    line: str
    weakened: str
    certificate: Callable[[], Any]
    wrong: str = "false"
    limits: dict[str, int] = field(default_factory=dict)


STATE = 'rounds(claim, "x", x - off, x + off) + rounds(claim, "v", v - E, v + E)'
ATTACKS = [
    Attack(
        "a law that stands twice",
        'need(len(dict(found)) == len(found), "a key stands twice")',
        "pass",
        forged.twice_the_law,
        "unclear",
    ),
    Attack(
        "a long file",
        'need(len(data) <= BYTES, f"more than {BYTES} bytes")',
        "pass",
        lambda: json.dumps(forged.whole([["0", "1"]], ["1", "0"], [], [{"kind": "rest", "number": 0}])) + 900 * " ",
        "limit",
        {"BYTES": 400},
    ),
    Attack(
        "an unknown key",
        "type(value) is dict and set(value) == keys",
        "type(value) is dict",
        forged.with_extra_key,
        "unclear",
    ),
    Attack(
        "no claim",
        "type(value) is list and low <= len(value) <= high",
        "type(value) is list",
        lambda: forged.changed(examples.turning("sum"), claims=[]),
        "unclear",
    ),
    Attack(
        "a negative number",
        "type(value) is int and low <= value <= high",
        "type(value) is int",
        lambda: forged.one_claim("sum", number=-1, **{k: examples.turning("sum")["claims"][-1][k] for k in "xt"}),
        "unclear",
    ),
    Attack(
        "another form of number",
        "and re.fullmatch(form, text, re.ASCII)",
        "",
        lambda: forged.changed(examples.turning("sum"), law=[["1", "0.05"], ["2", "1/10"]]),
        "unclear",
    ),
    Attack(
        "long numbers",
        "len(text) <= most",
        "True",
        lambda: forged.changed(examples.turning("sum"), law=[["1", "0" * 300 + "1/20"], ["2", "1/10"]]),
        "limit",
    ),
    Attack(
        "a power that stands twice",
        "powers[0] == 0 and all(n < m for n, m in zip(powers, powers[1:]))",
        "True",
        forged.two_coefficients,
        "unclear",
    ),
    Attack("a piece that runs backwards in time", "and S > 0", "", forged.backwards),
    Attack("a piece of another kind", 'p["kind"] in ("leave", "pass", "arrive")', "True", forged.under_another_name),
    Attack(
        "an exponent without its power", "== [a in (0, 1) for a, _ in law]", "is not None", forged.linear_for_quadratic
    ),
    Attack(
        "a power that may be negative",
        'need(W[0] > others(W), "W > 0 is not shown")',
        "pass",
        lambda: forged.undamped(lambda first: first + 1),
    ),
    Attack("a power far off at u = 0", "left < 2 * right < 4 * left", "True", forged.apart, "limit"),
    Attack("no error at u = 0", " + begins)", ")", forged.stronger_by_its_powers),
    Attack(
        "no error beyond u = 0",
        "Fraction(change / ((V[0] - others(V)) * (W[0] - others(W))) + begins)",
        "begins",
        forged.growing_power,
    ),
    Attack("a speed at a rest", 'kind == "pass" or all(n == 0 or n >= 2 * q for n in P)', "True", forged.pushed_off),
    Attack("a speed that may be 0", 'need(V[0] > others(V), "V > 0 is not shown")', "pass", forged.flat, "fault"),
    Attack("a power between two roots", "(m * a).denominator == 1", "True", forged.root_taken_as_none),
    Attack(
        "an error that is no number below 1",
        'need(h < 1, "W is not V^a")',
        "pass",
        lambda: forged.undamped(lambda first: first - 1),
    ),
    Attack(
        "no error of the powers",
        "sum(map(abs, r.values())) + beyond",
        "sum(map(abs, r.values()))",
        forged.stronger_by_its_powers,
    ),
    Attack(
        "another format",
        'c["format"] == FORMAT',
        "True",
        lambda: forged.changed(examples.turning("sum"), format="2"),
        "unclear",
    ),
    Attack("gains", "a >= 0 and e >= 0 and", "a >= 0 and", forged.gaining),
    Attack("a negative exponent", "a >= 0 and e >= 0 and", "e >= 0 and", forged.falling, "fault"),
    Attack(
        "long exponents",
        "a.numerator + a.denominator <= EXPONENT",
        "True",
        lambda: examples.turning("three halves"),
        "limit",
        {"EXPONENT": 4},
    ),
    Attack(
        "no stiffness",
        'need(root_low > 0, "the stiffness is not positive, or too small")',
        "pass",
        lambda: forged.changed(examples.turning("sum"), stiffness="0"),
        "fault",
    ),
    Attack("much work", "work * share <= WORK", "True", lambda: examples.turning("sum"), "limit", {"WORK": 1000}),
    Attack(
        "a list of much work",
        "work * share <= WORK",
        "work <= WORK",
        lambda: 20 * [examples.turning("sum", 2, 3)],
        "limit",
        {"WORK": 10_000},
    ),
    Attack("a list of none", "listed(content, 1, 1000) if type(content)", "content if type(content)", list, "unclear"),
    Attack("a turning point left out", 'shape[0] != "leave" or resting', "True", forged.without_one),
    Attack(
        "a jump of the place", "k / root_low * abs(begin[0] - x) + ", "", lambda: forged.other_start(place="51/100")
    ),
    Attack("a jump of the speed", " + abs(begin[1] - v)", "", lambda: forged.other_start(speed="-32/100")),
    Attack("a jump beside a stiff spring", "k / root_low * abs", "abs", forged.stiff_start, "false"),
    Attack("the defect", " + duration * defect", "", forged.other_law),
    Attack(
        "errors rounded down", "Fraction(-(-E * fine // 1), fine)", "Fraction(E * fine // 1, fine)", forged.rounded_down
    ),
    Attack("long times", "T.denominator.bit_length() <= 2 * BITS", "True", forged.in_thirds, "limit", {"BITS": 8}),
    Attack("a speed within its error", 'need(low > E, "V_low > E")', "pass", forged.kicked_up),
    Attack(
        "the least speed",
        "low, defect = (V[0] - others(V)) / unit",
        "low, defect = V[0] / unit",
        forged.kicked_up_in_one,
    ),
    Attack("an error in other units", "E / root_low, shape", "E, shape", forged.soft_start),
    Attack("a rest that is none", 'need(g > 0, "g > 0")', "pass", forged.before_it_rests),
    Attack("a turning point that is early", "T - duration * E / low, T + E / g", "T, T + E / g", forged.late),
    Attack("a turning point that is late", ", T + E / g", ", T", forged.early),
    Attack("a stop that is none", "k * (abs(x) + off) <= H", "k * abs(x) <= H", forged.held_or_not),
    Attack(
        "more digits than are claimed",
        "(d / unit).denominator == 1",
        "True",
        lambda: forged.one_claim("sum", digits=3),
        "unclear",
    ),
    Attack("a wrong digit", "max(high - d, d - low) <= unit / 2", "True", lambda: forged.one_claim("sum", x="-0.8")),
    Attack(
        "ten times the unit", "unit /= 10 if unit * 10 ** (digits - 1) > abs(d) else 1", "pass", forged.ten_for_twelve
    ),
    Attack(
        "an unknown claim",
        'need(kind in CLAIMS, "no kind of claim")',
        "pass",
        lambda: forged.one_claim("sum", kind="all"),
        "fault",
    ),
    Attack(
        "a state in the middle of a piece",
        "rest or t in states",
        "True",
        lambda: forged.changed(
            examples.state("sum", "1"), claims=[{"kind": "state", "digits": 1, "t": "1/2", "x": None, "v": None}]
        ),
        "fault",
    ),
    Attack(
        "a state before the stop", "if stays and turned[-1][3] <= t else", "if stays else", forged.state_before_the_stop
    ),
    Attack(
        "a state without its error",
        STATE,
        STATE.replace("- off", "- 0 * off")
        .replace("+ off", "+ 0 * off")
        .replace("- E", "- 0 * E")
        .replace("+ E", "+ 0 * E"),
        forged.other_law_of_a_state,
    ),
    Attack(
        "a number that is not reached", "n < len(turned)", "True", lambda: forged.one_claim("sum", number=7), "fault"
    ),
    Attack(
        "a rest that is not the last",
        "stays and n == len(turned) - 1",
        "True",
        lambda: forged.changed(examples.turning("sum"), claims=[{"kind": "rest", "number": 1}]),
    ),
    Attack(
        "a place without its error", "x - within, x + within", "x, x", lambda: forged.without_times(forged.other_law())
    ),
    Attack(
        "times since the start",
        "(first - turned[0][3], last - turned[0][2]) if n",
        "(first, last) if n",
        forged.times_since_the_start,
    ),
]
