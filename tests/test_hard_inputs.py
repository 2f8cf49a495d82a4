"""Inputs that are hard, each with the reason, in ``hard_inputs.json``: whoever finds one adds it there."""

import json
from pathlib import Path

import pytest

from asymptotics.shell.main import main

INPUTS = json.loads(Path(__file__).with_name("hard_inputs.json").read_text())


@pytest.mark.parametrize("hard", INPUTS, ids=lambda hard: hard["command"])
def test_a_hard_input_is_answered(hard, capsys):
    assert main(hard["command"].split()) == hard.get("code", 0), hard["why"]
    out, err = capsys.readouterr()
    assert hard["shows"] in out + err, hard["why"]
