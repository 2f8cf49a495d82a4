"""No option is read and left out: with it the answer is another one, or it is refused by name in one line.

Every option that says what is asked, and every force beside every law, of every question.
"""

import json

import pytest

import asymptotics as asy
from asymptotics.ask.registry import QUESTIONS, loaded
from asymptotics.shell.main import main
from tests.every_question import example, in_world, options_of, without_order, worlds_of
from tests.worlds import WORLDS

FORCES = {
    "spring": "--spring=3:1/10", "soft": "--spring=3:-1/10", "kinked": "--spring=2:1/10",
    "pendulum": "--spring=pendulum", "position": "--law=1,2:1/10", "hysteretic": "--law=0,1:1/10",
    "loss": "--law=1:1/10", "friction": "--law=0:1/10",
}  # fmt: skip
BARE = ("linear", "dry friction", "quadratic", "another rational power", "a sum of powers")
FORCED = [name for name in QUESTIONS if {"--law", "--spring"} <= options_of(name).keys()]
MODES = {  # other ways of asking: beside the example, or in the place of its order
    "expand": ["--bound"], "half-swing": ["--delta=1/10"], "turning-points": ["--times"], "motion": ["--reference"],
}  # fmt: skip
GIVEN_INPUTS = {"law": "3:1/7", "spring": "3:1/10", "laws": "2", "springs": "3", "alpha": "5/2", "name": "stops",
        "best-order": "1/10"}  # fmt: skip
"""Another value of an option, where a number is none."""
SAME = {  # an option that changes no number of the answer, and why
    "engine": "two ways to one result", "route": "another way to the same digits", "units": "what they are called",
    "exact": "a short exact form stands there anyway", "no-bootstrap": "the example has it",
    "damping x0": "the first of the amplitudes, where none is given", "limit-cycle near": "one of several, with mu",
    "identify mass": "of a record with times", "identify stiffness": "of a record with times",
    "multiple-scales epsilon": "an expansion in it", "multiple-scales law": "an expansion in it",
}  # fmt: skip


def numbers(data):
    """All that was computed: every text with a digit, in order, not the question's own words."""
    if isinstance(data, dict):
        asked = ("law", "terms", "alpha", "epsilon", "notes", "equation")
        return [n for key, value in data.items() if key not in asked for n in numbers(value)]
    if isinstance(data, list):
        return [n for value in data for n in numbers(value)]
    return [data] if isinstance(data, str) and any(ch.isdigit() for ch in data) else []


def answer(words, capsys):
    """(exit code, the answer); of a refusal one line that names an argument."""
    try:
        code = main([*words, "--json"])
    except SystemExit as stop:
        code = int(stop.code or 0)
    out, err = capsys.readouterr()
    if code:
        assert (code, out, err.count("\n")) == (2, "", 1) and ("argument " in err or "unrecognized" in err), err
    return code, json.loads(out) if out else err


KEPT = {}


def plain(words, capsys):
    """The answer without what is added, asked for once."""
    if tuple(words) not in KEPT:
        KEPT[tuple(words)] = answer(words, capsys)
    return KEPT[tuple(words)]


def some(*case, fast):
    """A case; of a kind that others try as well in ``make test-thorough`` alone."""
    return pytest.param(*case, id=" ".join(" ".join(c) if isinstance(c, list) else c for c in case if c),
                        marks=() if fast else pytest.mark.slow)  # fmt: skip


FORCE_CASES = [
    some(name, more, world, fast=world == "quadratic" and name not in ("damping", "solution") and "--bound" not in more)
    for name in FORCED
    for more in [[], *([MODES[name]] if name in MODES else [])]
    for world in worlds_of(name)
    if world in BARE
]


@pytest.mark.parametrize(("name", "more", "world"), FORCE_CASES)
def test_each_force_has_an_answer_of_its_own_or_is_refused(name, more, world, capsys, tmp_path):
    """Two forces with one answer are one that was read in the place of the other: a lost sign, a lost power."""
    words = in_world(name, tmp_path, world)
    words = [*(without_order(words) if more else words), *more]
    # A law of the world's own exponent is merged with it: one delta, whatever its strength.
    own = {f"--law={alpha}:1/10" for alpha in WORLDS[world].law}
    others = {"none": "", **{force: added for force, added in FORCES.items() if added not in own}}
    found = {force: answer([*words, *added.split()], capsys) for force, added in others.items()}
    told = {force: str(numbers(data)) for force, (code, data) in found.items() if code == 0}
    assert len({*told.values()}) == len(told), told
    assert "none" in told or world != "quadratic" or name == "limit-cycle"  # polynomials alone


def changed(words, asked, option, value=None):
    """The words with another value of one option."""
    name, integer = f"--{option.name}", asked.kind.schema.get("type") == "integer"
    value = value or GIVEN_INPUTS.get(option.name) or ("4" if integer else "1/7")
    out = {"law": ("--alpha", "--epsilon"), "damping": ("--epsilon",)}.get(option.name, ())
    words = [w for w, before in zip(words, ["", *words]) if not {w, before} & {name, *out}]
    return [*words, *([name, value] if option.letter else [name])]


STATED = [
    pytest.param(
        name, asked, option, id=f"{name} {option.name}", marks=pytest.mark.slow if "best" in option.name else ()
    )
    for name in QUESTIONS
    for asked in loaded(name).asked
    for option in asked.options
    if option.group in ("the law", "the start", "what to compute")
    and not option.place
    and not {option.name, f"{name} {option.name}"} & SAME.keys()
]


@pytest.mark.parametrize(("name", "asked", "option"), STATED)
def test_an_option_changes_the_answer_or_is_refused(name, asked, option, capsys, tmp_path):
    words = example(name, tmp_path)
    if option.name == "gauge":  # they differ from the second order on
        words = changed(words, loaded(name)["order"], loaded(name)["order"].option, "2")
    code, before = plain(words, capsys)
    assert code == 0, before
    other = [answer(changed(words, asked, option, word), capsys) for word in option.words or (None,)]
    assert any(code or numbers(found) != numbers(before) for code, found in other)
    if all(code for code, _ in other) and name in ELSEWHERE and option.name not in LAW:
        assert any(is_served(words, asked, option, capsys) for words in elsewhere(name, tmp_path))


LAW = ("law", "alpha", "epsilon", "damping", "spring")
ELSEWHERE = [name for name in FORCED if "dry friction" in worlds_of(name) and name != "compare"]
"""What is refused beside their example is served beside another law, or when it is asked in another way."""


def elsewhere(name, folder):
    words = in_world(name, folder, "dry friction")
    late = ["--time", "100"] if "--time" in words else []  # it has stopped: what holds it there counts
    return [words, without_order(words), *([[*without_order(words), *late, *MODES[name]]] if name in MODES else [])]


def is_served(words, asked, option, capsys):
    """Whether one of its values is answered, and by other numbers."""
    code, before = answer(words, capsys)
    found = [answer(changed(words, asked, option, word), capsys) for word in option.words or (None,)]
    return code == 0 and any(code == 0 and numbers(after) != numbers(before) for code, after in found)


SERVED = {  # at finite strength, certified, beside every force
    "turning-points": "--law 3/2:1/10 --count 2 --times --digits 12",
    "turning-points in motion": "--law 3/2:1/10 --v0 1/2 --count 2 --times --digits 12",
    "motion": "--law 3/2:1/10 --x0 1 --time 7 --reference --digits 12",
    "motion in motion": "--law 3/2:1/10 --x0 1/2 --v0 1/2 --time 7 --reference --digits 12",
    "half-swing": "--law 3/2 --delta 1/10,1/5 --digits 12",
}


@pytest.mark.parametrize(
    ("line", "force"),
    [some(line, force, fast=force == "spring" and "in motion" not in line) for line in SERVED for force in FORCES],
)
def test_at_finite_strength_every_force_of_the_place_is_served_and_certified(line, force, capsys):
    """Not merely refused: the answer is there, certified, and another one than without the force."""
    words = [line.split()[0], *SERVED[line].split()]
    code, found = answer([*words, FORCES[force]], capsys)
    assert code == 0 and found["certified"] is True, found
    assert numbers(found) != numbers(plain([w.removesuffix(",1/5") for w in words], capsys)[1])
    code, said = answer([*words, "--spring=1,2:1/10"], capsys)
    assert code == 2 and "depends on the velocity" in said


CALLS = {
    "expand": lambda o: asy.expand(o, order=2).p,
    "motion": lambda o: asy.motion(o, order=1).at(7).x,
    "reference": lambda o: asy.reference(o).at(7).x,
    "turning_points": lambda o: [p.x for p in asy.turning_points(o, 2, digits=12).points],
    "half_swing": lambda o: asy.half_swing(o.dimensionless, order=2).to_dict(),
    "envelope": lambda o: asy.envelope(o).to_dict(),
    "multiple_scales": lambda o: asy.multiple_scales(o, order=1),
}


@pytest.mark.parametrize("name", CALLS)
@pytest.mark.parametrize("law", [{2: "1/10"}, {1: "1/10"}])
def test_python_serves_a_spring_or_refuses_it(name, law):
    try:
        found = CALLS[name](asy.Oscillator(law, spring={3: "1/10"}))
    except asy.InputError as refused:
        assert str(refused).isprintable()
        return
    assert str(found) != str(CALLS[name](asy.Oscillator(law)))


def test_a_strength_that_nothing_asks_for_is_refused(capsys):
    code, said = answer(["half-swing", "--alpha=2", "--epsilon=1/7", "--delta=1/5"], capsys)
    assert code == 2 and "--epsilon" in said
