"""The ledger of trust, ``docs/trust.md``: what each answer rests on, found by asking; ``python -m tests.ledger``.

A cell is what the library answers for a law of the class: with a certificate, certified, an estimate, or refused.
"""

from pathlib import Path

import asymptotics as asy
from asymptotics.certificates.of_results import of_states, of_turning_points
from asymptotics.errors import InputError, UndecidedError

PAGE = Path(__file__).parents[1] / "docs" / "trust.md"
LAWS = {
    "dry friction": asy.Oscillator({0: "3/100"}),
    "linear": asy.Oscillator({1: "1/10"}),
    "quadratic": asy.Oscillator({2: "1/10"}),
    "another rational power": asy.Oscillator({"3/2": "1/10"}),
    "an irrational power": asy.Oscillator({"sqrt(2)": "1/10"}),
    "a sum of powers": asy.Oscillator({1: "1/20", 2: "1/10"}),
    "a sum with dry friction": asy.Oscillator({0: "1/50", 2: "1/10"}),
    "a start in motion": asy.Oscillator({2: "1/10"}, v0="1/3"),
    "air and a spring x^3": asy.Oscillator({2: "1/10"}, spring={3: "1/10"}),
    "a pendulum in air": asy.Oscillator({2: "1/10"}, spring="pendulum"),
    "a loss that knows the place": asy.Oscillator({(1, 2): "1/10"}),
    "gains": asy.Oscillator({2: "-1/10"}),
}


def _word(found):
    return CERTIFIED if found.certified else ESTIMATE


def turning_points(oscillator):
    """Places and times of turning points."""
    table = asy.turning_points(oscillator, 3, digits=8, times=True)
    return _word(table), lambda: of_turning_points(oscillator, table)


def reference(oscillator):
    """x and x' at a time, by reference."""
    point = asy.reference(oscillator).at("5", digits=8)
    return _word(point), lambda: of_states(oscillator, [("5", point)], 8)


def motion(oscillator):
    """x and x' at a time, by the expansion."""
    return _word(asy.motion(oscillator, order=2).at(5)), None


def expansion(oscillator):
    """The amplitude and phase equations."""
    return asy.expand(oscillator.dimensionless, order=2).to_dict()["arithmetic"], None


ANSWERS = {
    "turning points": (
        turning_points,
        "balls: `turning-point-majorant`, `taylor-residual`, `motions-never-part`; springs: `wells-majorant`,"
        " `wells-distance`",
    ),
    "x(t) by reference": (reference, "the same balls; closed forms: exact identities, evaluated in balls"),
    "x(t) by expansion": (
        motion,
        "a series that diverges: its error is measured, unless `--bound` proves one (`uniform-bound`,"
        " `explicit-bound`)",
    ),
    "amplitude and phase equations": (
        expansion,
        "formal series: whole exponents exact, others in balls (`quarter-swing-tail`)",
    ),
}
CERTIFICATE, CERTIFIED, ESTIMATE, REFUSED = "**certificate**", "certified", "estimate", "refused"


def cell(answer, oscillator):
    """What the answer rests on for this motion."""
    try:
        word, make = answer(oscillator)
    except (InputError, UndecidedError):
        return REFUSED
    if word != CERTIFIED or make is None:
        return word
    try:
        return CERTIFICATE if make().proved else CERTIFIED
    except InputError:
        return CERTIFIED


def table():
    """The rows of the page: a class of laws, and a cell for each answer."""
    lines = ["| motion | " + " | ".join(ANSWERS) + " |", "|---" * (len(ANSWERS) + 1) + "|"]
    for name, oscillator in LAWS.items():
        cells = [cell(answer, oscillator) for answer, _ in ANSWERS.values()]
        lines.append(f"| {name} | " + " | ".join(cells) + " |")
    rests = ["| answer | rests on, where there is no certificate |", "|---|---|"]
    rests += [f"| {name} | {words} |" for name, (_, words) in ANSWERS.items()]
    return "\n".join([*lines, "", *rests])


def page():
    """The whole page."""
    head, _, rest = PAGE.read_text(encoding="utf-8").partition("<!-- ledger -->\n")
    return f"{head}<!-- ledger -->\n{table()}\n<!-- end of ledger -->{rest.partition('<!-- end of ledger -->')[2]}"


if __name__ == "__main__":
    PAGE.write_text(page(), encoding="utf-8")
