"""What refusals say: what is near is named, and it is what can be typed."""

import re

import pytest
from flint import arb

import asymptotics as asy
from asymptotics.shell.main import main

SAID = {
    "a word is no id": (
        lambda: asy.paper("Lambert"),
        r"no statement has the id 'Lambert' \(accepted: an id, such as \w+:",
    ),
    "a misspelt id": (lambda: asy.paper("smith:43"), "did you mean smith2012:43"),
    "a misspelt table": (lambda: asy.table("smith2012.tabel1"), "did you mean smith2012.table1"),
    "a comma": (lambda: asy.turning_points({2: "0,1"}), "'0,1' is not an exact number: it has a comma"),
    "anti-damping": (
        lambda: asy.turning_points({2: -1}),
        "^argument strength: -1 is negative: anti-damping has no sequence of turning points to rest",
    ),
    "an article": (lambda: asy.turning_points({2: [1]}), "a list is"),
    "the other article": (lambda: asy.turning_points({2: arb(1)}), "an arb is"),
}


@pytest.mark.parametrize("name", SAID)
def test_a_refusal_says_what_is_meant(name):
    call, said = SAID[name]
    with pytest.raises(asy.InputError) as caught:
        call()
    assert re.search(said, str(caught.value)), caught.value
    assert not re.search(r"did you mean Lambert|no a ", str(caught.value))


@pytest.mark.parametrize("command", ["expand", "solution", "envelope"])
def test_help_offers_no_negative_number_where_none_is_accepted(command, capsys):
    assert main([command, "--help"]) == 0
    (said,) = re.findall(r"A >= 0: ([^\n]*(?:\n {10,}[^-\n][^\n]*)*)", capsys.readouterr().out)
    assert "2.5e-3" in said and "-2.5e-3" not in said
