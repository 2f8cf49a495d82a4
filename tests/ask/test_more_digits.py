"""Every number of every answer at 25 digits is the same number at 35, rounded: a digit that is printed is one.

And none is a double written out: such a number has the same wrong digits at 25 and at 35, and shows nothing there.
An expansion has an error of its own, but its numbers are those of its formula to the last digit.
"""

import json
import re
from contextlib import nullcontext
from fractions import Fraction

import pytest

from asymptotics.ask.registry import QUESTIONS
from asymptotics.curves import envelope_order
from asymptotics.shell.main import main
from tests.every_question import example, in_world, options_of, without_order

NUMBER = re.compile(r"[+-]?\d+(?:\.(\d+))?(?:e([+-]?\d+))?")
ASKED = [
    name for name in QUESTIONS if "--digits" in options_of(name) and name != "compare"
]  # whose answers count digits
SIZES = ("enclosure", "radius", "tail")
"""How wide a ball is, or its ends: more digits need narrower ones."""
WORLDS = ("SI", "a start in motion", "air and a spring x^3", "a sum with dry friction")
MORE = {  # what an example leaves out
    "envelope": ("--time=7", "--time=7 --order=3", "--time=7 --squaring", "--time=7 --slow=1/20"),
    "expand": ("--order=5 --gauge=averaging", "--best-order=1/3", "--order=3 --bound"),
    "damping": ("--order=3", "--spring=pendulum --unit=deg"),
    "motion": ("--order=4", "--gauge=averaging", "--bound"),
    "turning-points": ("--times --start=5", "--times --v0=1/2"),
    "solution": ("--time=7 --order=4",), "half-swing": ("--delta=1/10",), "limit-cycle": ("--mu=1",),
}  # fmt: skip
CASES = [
    *((name, "", "") for name in ASKED),
    *((name, "", more) for name, each in MORE.items() for more in each),
    *((name, world, more) for name, more in (("motion", ""), ("envelope", "--time=7")) for world in WORLDS),
]


def numbers(found, path=""):
    """(where, text) of every number in an answer."""
    if isinstance(found, dict | list):
        for key, value in found.items() if isinstance(found, dict) else enumerate(found):
            yield from numbers(value, f"{path}.{key}") if key not in ("made_by", *SIZES) else ()
    elif isinstance(found, str) and NUMBER.fullmatch(found):
        yield path, found


def no_float(text):
    """Numbers of JSON are strings: a float would have lost digits before anybody reads it."""
    raise AssertionError(text)


def unit(text):
    """A unit in the last place."""
    places, power = NUMBER.fullmatch(text).groups()
    return Fraction(10) ** (int(power or 0) - len(places or ""))


def wrong(few, many):
    """Numbers of few digits that are not those of many, rounded; another length (an error that is shorter) is none."""
    more = dict(numbers(many))
    for path, text in numbers(few):
        if path in more and abs(Fraction(text) - Fraction(more[path])) > Fraction(11, 20) * unit(text):
            yield path, text, more[path]


def doubles(found):
    """Numbers of many digits that are those of the double next to them, as no other number is but a short one."""
    for path, text in numbers(found):
        digits = re.sub(r"e.*|\D", "", text).strip("0")
        if len(digits) > 25 and abs(Fraction(text) - Fraction(float(text))) <= unit(text):
            yield path, text


@pytest.mark.parametrize(("name", "world", "more"), CASES)
def test_more_digits_are_the_same_number(capsys, tmp_path, name, world, more):
    words = in_world(name, tmp_path, world) if world else example(name, tmp_path)
    words = ["smith", "t", "--u=1/4", "--w=-1/4", "--tau=3"] if name == "smith" else words  # f is exact
    words = without_order(words) if "--delta" in more else words
    own = {word.partition("=")[0] for word in more.split()} | {"--digits"}
    words = [w for w, before in zip(words, ["", *words]) if w not in own and (before not in own or w.startswith("--"))]
    found = []
    for digits in (25, 35):
        assert main([*words, *more.split(), f"--digits={digits}", "--json"]) == 0
        found.append(json.loads(capsys.readouterr().out, parse_float=no_float))
    assert not [*wrong(*found)] and not [*doubles(found[1])]
    assert [*numbers(found[0])]


def test_a_double_that_is_written_out_is_noticed(capsys, monkeypatch):
    """As it was: through mpmath's number at the precision of a double; the true digits are the solution's."""
    line = "envelope --alpha 2 --epsilon 1/10 --time 7 --order 3 --digits 45 --json"
    monkeypatch.setattr(envelope_order, "workdps", lambda digits: nullcontext())
    assert main(line.split()) == 0
    assert {path for path, _ in doubles(json.loads(capsys.readouterr().out))} >= {".amplitude", ".phase"}


def test_a_digit_of_a_double_is_noticed():
    assert [*wrong({"A": "0.77094185877641197013"}, {"A": "0.7709418587764120147466048"})]
    assert not [*wrong({"A": "0.77094186"}, {"A": "0.7709418587764120147466048"})]
    assert [*wrong({"A": [{"x": "1.2e-5"}]}, {"A": [{"x": "1.3e-5"}]})] == [(".A.0.x", "1.2e-5", "1.3e-5")]
