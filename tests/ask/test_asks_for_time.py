"""The work of every question asks for the time, in every everyday world and whatever is asked besides.

No request is listed here: each whole number of an example is multiplied, and the rows of its file, by a clock that goes
a second further each time it is read, without an alarm, until the time is over.  What is answered at the largest number
is quick; nowhere is there long work between two looks at the clock.  (SymPy is stopped by the alarm alone: up to 5 s of
``multiple-scales`` of a sum, order 8, are one look.  So the worlds are those of questions that a sweep asks.)
"""

from itertools import count
from time import process_time

import pytest

from asymptotics.ask.kinds import REAL
from asymptotics.ask.registry import QUESTIONS, loaded
from asymptotics.running import budget, public
from asymptotics.shell.main import main
from tests.every_question import example, in_world, options_of, worlds_of

LOOKS, LONG, FASTER = 12, 2, 4
"""Looks at the clock that end a request, seconds of the processor that are long without one, and how a number grows."""
ROWS, HUGE = 512, 10**6
"""Eight times so many has the longest file; a number beyond which nothing grows but digits."""


def besides(name):
    """What may be asked besides, one at a time: flags, other words than the usual one, a number."""
    for a in (a for a in loaded(name).asked if not a.kind.options and not a.option.place):
        words = [w for w in a.kind.schema.get("enum", ()) if w != a.default]
        values = [""] if a.kind.schema.get("type") == "boolean" else words
        values = ["1/3"] if a.kind.schema is REAL.schema and not a.required else values
        yield from (f"--{a.option.name}{'=' * bool(value)}{value}" for value in values)


TIMED = [name for name in QUESTIONS if "--max-seconds" in options_of(name)]
CASES = [
    *((name, world, "") for name in TIMED if loaded(name).swept for world in worlds_of(name)),
    *((name, "", more) for name in TIMED for more in ("", *besides(name))),
]


def request(name, world, more, folder):
    """The words of an example in a world, without what another option excludes, and with that option."""
    words = in_world(name, folder, world) if world else example(name, folder)
    option = more[2:].partition("=")[0]
    out = {
        f"--{c.name}" for p in loaded(name).pairs if not p.needed and option in p.names for c in (*p.options, *p.others)
    }
    left = [w for w, before in zip(words, ["", *words]) if not {w, before} & out]
    return [*(left if option else words), *([more] if more else [])]


def sizes(name, words, folder):
    """Each whole number of a request, and the rows of its file: (largest, the words with that number).

    But the digits: of ten thousand of them one operation of a ball is long, and nobody can ask meanwhile.
    """
    whole = [a for a in loaded(name).asked if a.kind.schema.get("type") == "integer" and not a.kind.options]
    for a in (a for a in whole if a.name != "digits"):
        option = f"--{a.option.name}"
        rest = [w for w, before in zip(words, ["", *words]) if option not in (w, before)]
        yield a.kind.schema["maximum"], lambda n, option=option, rest=rest: [*rest, f"{option}={n}"]
    if loaded(name).offers.reads:

        def longer(n):
            (folder / "data.csv").write_text("n,x\n" + "".join(f"{i},{(-0.99) ** i}\n" for i in range(n)))
            return words

        yield ROWS, lambda n: longer(8 * n)


def outcome(words, monkeypatch, capsys):
    """Whether a request "asked" for the time, was refused as "estimated", or its code; AssertionError if long deaf."""
    seconds, looks = count(), [process_time()]

    def now():
        looks.append(process_time())
        return float(next(seconds))

    with monkeypatch.context() as patch:
        patch.setattr(budget, "monotonic", now)
        patch.setattr(public, "PERIOD", 3600.0)
        code = main([*words, f"--max-seconds={LOOKS}"])
    looks.append(process_time())
    told = capsys.readouterr().err
    assert max(b - a for a, b in zip(looks, looks[1:])) < LONG, f"{' '.join(words)}: long without a look at the clock"
    return "asked" if "are over at" in told else "estimated" if "would take" in told else str(code)


def outcomes(name, world, more, folder, monkeypatch, capsys):
    """What became of the request, and of its numbers, each multiplied as long as it was answered."""
    words = request(name, world, more, folder)
    found = [outcome(words, monkeypatch, capsys)]
    for largest, asking in sizes(name, words, folder) if found == ["0"] else ():
        size, last = 2, "0"
        while last == "0" and size < FASTER * min(largest, HUGE):
            last = outcome(asking(min(size, largest)), monkeypatch, capsys)
            size *= FASTER
        found.append(last)
    return found


@pytest.mark.parametrize(("name", "world", "more"), CASES)
def test_the_work_asks_for_the_time(name, world, more, tmp_path, monkeypatch, capsys):
    found = outcomes(name, world, more, tmp_path, monkeypatch, capsys)
    assert "asked" in found or "estimated" not in found, found  # an estimate alone does not end what was begun


def test_work_that_never_asks_is_noticed(tmp_path, monkeypatch, capsys):
    """Near miss, and once a fault: the swings by the primitive of the energy did not ask, found by this walk."""
    monkeypatch.setattr("asymptotics.turning.energy_primitive.tick", lambda: None)
    monkeypatch.setattr("tests.ask.test_asks_for_time.LONG", 0.1)
    with pytest.raises(AssertionError, match="long without a look at the clock"):
        outcomes("turning-points", "air and a spring x^3", "", tmp_path, monkeypatch, capsys)
