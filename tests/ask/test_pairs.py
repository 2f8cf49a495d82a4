"""Each pair of options that a question declares is refused in its words, in shell and Python, and by its schema.

What else the options of a pair need is added, and what they exclude is left out, so that this pair alone is wrong.
"""

import sys
from pathlib import Path

import jsonschema
import pytest

from asymptotics.ask import question as kernel
from asymptotics.ask.pairs import require
from asymptotics.ask.registry import QUESTIONS, loaded
from asymptotics.errors import InputError
from asymptotics.shell.main import main
from tests.every_question import ROWS, example, options_of, parser_of

SUFFIX = {"plot": ".svg", "html": ".html", "certificate": ".json", "from": ".csv", "data": ".csv"}
SAMPLE = {"law": "2:1/10", "spring": "3:1/10", "overlay": "2:1/10", "size": "8x5", "alpha": "2", "laws": "1"}


def value(name, option):
    """A value that the option takes; True of a flag."""
    asked = next((a for a in loaded(name).asked if option in a.options), None)
    schema = asked.kind.schema if asked is not None and not asked.kind.options else {}
    if not option.letter:
        return True
    if option.letter == "FILE":
        return f"data{SUFFIX.get(option.name, '.csv')}"
    return SAMPLE.get(option.name) or str((*option.words, *schema.get("enum", ()), schema.get("minimum", 1))[0])


def said(name, folder):
    """The options of its example, by name."""
    parsed = parser_of(name).parse_args(example(name, folder)[1:])
    given = {o.name: getattr(parsed, o.key, None) for o in loaded(name).options}
    return {key: v[0] if isinstance(v, list) else v for key, v in given.items() if v not in (None, False, [])}


def at_fault(pair, given):
    """The names of the options that a pair refuses, with those beside which it does; none where it refuses nothing."""
    ours, theirs = ({c.name for c in part if c.holds(given)} for part in (pair.options, pair.others))
    return ours | theirs if ours and bool(theirs) is not pair.needed else set()


def mended(pairs, own, given, of):
    """The options with what the other pairs need, and without what they refuse."""
    rest = [p for p in pairs if p is not own]
    for pair in (*rest, *rest):  # what is added may need, or exclude, what was passed
        faults, first = at_fault(pair, given), pair.others[0]
        more = {**given, first.name: of(first)}
        if (
            faults
            and pair.needed
            and first.name not in own.names
            and not any(at_fault(p, more) & own.names for p in rest)
        ):
            given = more
        given = {k: v for k, v in given.items() if k in own.names or k not in at_fault(pair, given)}
    return given


def refused(name, folder):
    """Each pair of a question with the options that it refuses: (pair, option, other, options by name)."""
    question = loaded(name)
    options = {o.name: o for o in question.options}

    def of(condition):
        return condition.words[0] if condition.words else value(name, options[condition.name])

    def otherwise(condition):
        """What the option is where the condition does not hold: another word, or nothing."""
        left = [w for w in options[condition.name].words if w not in condition.words] if condition.words else []
        return {condition.name: left[0]} if left and options[condition.name].needed else {}

    for pair in question.pairs:
        for option in pair.options:
            for other in pair.others[:1] if pair.needed else pair.others:
                given = {k: v for k, v in said(name, folder).items() if k not in pair.names}
                given |= {option.name: of(option), **(otherwise(other) if pair.needed else {other.name: of(other)})}
                yield pair, option, other, mended(question.pairs, pair, given, of)


def told(name, pair, option, other, given):
    return pair.error(option, other, given.get(other.name), loaded(name)._spelled_option)


def words(name, given):
    places = [o.name for o in loaded(name).options if o.place]
    flags = [f"--{k}" if v is True else f"--{k}={v}" for k, v in given.items() if k not in places]
    return [name, *(given[place] for place in places if place in given), *flags]


def calls(name):
    """The call from Python that is this question, public or not."""
    return [v for v in vars(sys.modules[loaded(name).function.__module__]).values()
            if getattr(v, "__question__", None) is loaded(name)]  # fmt: skip


def in_python(name, given):
    """The arguments of the call that says the same; None where Python cannot."""
    question = loaded(name)
    sayable, made = question._said({}), {}
    for a in question.asked:
        if a.is_one_option and a.option.name in given:
            made[a.name] = given[a.option.name]
        elif a.kind.word and given.get(a.kind.word) == "symbolic":
            made[a.name] = "symbolic"
        elif a.kind.options and not a.is_one_option:
            made[a.name] = {2: "1/10"}
        made |= {beside: {3: 1} for beside in a.kind.beside if beside in given and beside in sayable}
    return made


def request(schema, given):
    """The options as the JSON of a request."""
    made = {}
    for key, v in ((k, v) for k, v in given.items() if k in schema["properties"]):
        kind = schema["properties"][key].get("type")
        made[key] = int(v) if kind == "integer" else [v] if kind == "array" else v
    return made


def walk(name, folder, capsys):
    """Every pair of a question; returns how many there were in the shell and in Python."""
    question, counts = loaded(name), [0, 0]
    schema = question.schema()
    for pair, option, other, given in refused(name, folder):
        error = told(name, pair, option, other, given)
        assert main(words(name, given)) == 2, given
        assert capsys.readouterr().err.startswith(f"asymptotics {name}: {error}"), (given, str(error))
        counts[0] += 1
        if not option.words and option.name in {o.name for o in question.options}:
            action = next(a for o, a in options_of(name).items() if o == f"--{option.name}")
            assert other.in_words(question._spelled_option) in action.beside, (option, action.beside)
        names = {option.name, *(c.name for c in (pair.others if pair.needed else [other]))}
        if names <= set(schema["properties"]):
            faults = jsonschema.Draft202012Validator(schema).iter_errors(request(schema, given))
            assert any("allOf" in fault.absolute_schema_path for fault in faults), given
        sayable = question._said({})
        if names <= set(sayable):
            for call in calls(name):
                with pytest.raises(InputError) as caught:
                    call(**in_python(name, given))
                assert str(caught.value) == str(question.in_python(error)) and "--" not in str(caught.value)
                counts[1] += 1
    return counts


@pytest.mark.parametrize("name", QUESTIONS)
def test_every_pair_is_refused_in_its_words(name, tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    Path("data.csv").write_text(ROWS)
    if loaded(name).pairs:
        assert walk(name, tmp_path, capsys)[0]
        schema = loaded(name).schema()
        jsonschema.validate(request(schema, said(name, tmp_path)), schema)


def test_a_pair_that_is_not_refused_is_noticed(tmp_path, monkeypatch, capsys):
    """Near misses: a declaration that nobody reads, and one that Python does not hear of."""
    for wrong in (lambda *_: None, lambda pairs, said, *rest: require(pairs, said, *rest) if "json" in said else None):
        with monkeypatch.context() as patch:
            patch.setattr(kernel, "require", wrong)
            with pytest.raises((AssertionError, pytest.fail.Exception)):
                walk("half-swing", tmp_path, capsys)
    shell, python = walk("half-swing", tmp_path, capsys)
    assert shell > python > 3
