"""A spring or a position-dependent loss is served or refused by name; it is never read and left out.

Each command is asked with and without the force: the answers must differ, or the second is one line with exit code 2.
"""

import json

import pytest

import asymptotics as asy
from asymptotics.shell.main import main, run

COMMANDS = {"expand", "half-swing", "turning-points", "motion", "envelope", "multiple-scales"}
START = "--x0 1"
ASKED = {
    "expand": "--law 2:1/10 --order 2",
    "expand-bound": "--law 2:1/10 --order 2 --bound",
    "half-swing": "--law 2:1/10 --order 2",
    "half-swing-delta": "--law 2 --delta 1/10",
    "turning-points": "--law 2:1/10 --count 2 --times --digits 12",
    "turning-points-two": "--law 2:1/10 --law 3/2:1/10 --count 2 --times --digits 12",
    "motion": f"--law 2:1/10 {START} --time 7",
    "motion-bound": f"--law 2:1/10 {START} --time 7 --bound",
    "motion-reference": f"--law 2:1/10 {START} --time 7 --reference",
    "motion-linear": f"--law 1:1/10 {START} --time 7 --reference",
    "motion-dry": f"--law 0:1/10 {START} --time 7 --reference",
    "envelope": f"--law 2:1/10 {START} --time 7",
    "multiple-scales": "--law 3:1/10 --order 2",
    "multiple-scales-general": "--law 3/2:1/10 --order 2",
}
FORCES = {"spring": ["--spring", "3:1/10"], "soft": ["--spring", "3:-1/10"], "position": ["--law", "1,2:1/10"]}
PLAIN = {}


def plain_answer(arguments, capsys):
    """The answer without the force, asked for once."""
    asked = tuple(arguments)
    if asked not in PLAIN:
        PLAIN[asked] = answer(arguments, capsys)
    return PLAIN[asked]


def answer(arguments, capsys):
    """(exit code, JSON without what merely echoes the question)."""
    code = run([*arguments, "--json"])
    captured = capsys.readouterr()
    if code:
        assert len(captured.err.strip().splitlines()) == 1, captured.err
        return code, captured.err
    return code, json.loads(captured.out)


@pytest.mark.parametrize("force", FORCES)
@pytest.mark.parametrize("name", ASKED)
def test_a_force_changes_the_answer_or_is_refused(name, force, capsys):
    command = next(c for c in sorted(COMMANDS, key=len, reverse=True) if name.startswith(c))
    arguments = [command, *ASKED[name].split()]
    try:
        code, found = answer([*arguments, *FORCES[force]], capsys)
    except SystemExit as stopped:  # the parser knows no such option: refused
        assert stopped.code == 2
        return
    if code:
        assert code == 2, found
        return
    _, plain = plain_answer(arguments, capsys)
    assert numbers(found) != numbers(plain)


SERVED = {
    "turning-points": "--law 3/2:1/10 --count 2 --times --digits 12",
    "turning-points-v0": "--law 3/2:1/10 --v0 1/2 --count 2 --times --digits 12",
    "motion": f"--law 3/2:1/10 {START} --time 7 --reference --digits 12",
    "motion-v0": "--law 3/2:1/10 --x0 1/2 --v0 1/2 --time 7 --reference --digits 12",
    "half-swing": "--law 3/2 --delta 1/10,1/5 --digits 12",
}
WELLS = {
    "spring": ["--spring", "3:1/10"], "soft": ["--spring", "3:-1/10"], "kinked": ["--spring", "2:1/10"],
    "pendulum": ["--spring", "pendulum"], "position": ["--law", "1,2:1/10"], "hysteretic": ["--law", "0,1:1/10"],
}  # fmt: skip


@pytest.mark.parametrize("force", WELLS)
@pytest.mark.parametrize("name", SERVED)
def test_at_finite_strength_every_force_of_the_place_is_served_and_certified(name, force, capsys):
    """Not merely refused: the answer is there, certified, and another one than without the force."""
    command = next(c for c in sorted(COMMANDS, key=len, reverse=True) if name.startswith(c))
    arguments = [command, *SERVED[name].split()]
    code, found = answer([*arguments, *WELLS[force]], capsys)
    assert code == 0 and found["certified"] is True, found
    _, plain = plain_answer([a.removesuffix(",1/5") for a in arguments], capsys)
    assert numbers(found) != numbers(plain)


def test_a_spring_that_depends_on_the_velocity_is_refused_by_name(capsys):
    for name, text in SERVED.items():
        command = name.removesuffix("-v0")
        code, said = answer([command, *text.split(), "--spring", "1,2:1/10"], capsys)
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
@pytest.mark.parametrize("losses", [{2: "1/10"}, {1: "1/10"}])
def test_python_serves_a_spring_or_refuses_it(name, losses):
    plain, bent = asy.Oscillator(losses), asy.Oscillator(losses, spring={3: "1/10"})
    try:
        found = CALLS[name](bent)
    except asy.InputError as refused:
        assert str(refused).isprintable()
        return
    assert str(found) != str(CALLS[name](plain))


def numbers(data):
    """All that was computed: every text that reads as a number, in order, not the question's own words."""
    if isinstance(data, dict):
        asked = ("law", "terms", "alpha", "epsilon", "notes")
        return [n for key, value in data.items() if key not in asked for n in numbers(value)]
    if isinstance(data, list):
        return [n for value in data for n in numbers(value)]
    return [data] if isinstance(data, str) and any(ch.isdigit() for ch in data) else []


@pytest.mark.parametrize("line", [
    "expand --alpha 2 --epsilon {} --order 2", "half-swing --alpha 2 --epsilon {} --order 2",
    "half-swing --law 2:{} --order 2", "multiple-scales --alpha 3 --epsilon {} --order 2",
    "multiple-scales --alpha symbolic --epsilon {}", "multiple-scales --law 1:{} --spring 3:1/9 --order 2",
    "turning-points --alpha 2 --epsilon {} --count 3", "envelope --alpha 2 --epsilon {} --time 3",
    "limit-cycle --law 1:-1 --law 1,2:{}",
])  # fmt: skip
def test_a_strength_has_an_effect(capsys, line):
    answers = []
    for strength in ("1/7", "1/11"):
        assert main([*line.format(strength).split(), "--json"]) == 0
        answers.append(json.loads(capsys.readouterr().out))
    assert answers[0] != answers[1]


def test_a_strength_that_nothing_asks_for_is_refused(capsys):
    assert main(["half-swing", "--alpha", "2", "--epsilon", "1/7", "--delta", "1/5"]) == 2
    assert "--epsilon" in capsys.readouterr().err
