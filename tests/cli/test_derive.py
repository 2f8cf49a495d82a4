"""The command derive."""

import json

from asymptotics.cli.main import main


def test_derive(capsys):
    assert main(["derive"]) == 0
    assert "smith-turning-points" in capsys.readouterr().out.split()
    assert main(["derive", "smith-footnote-8"]) == 0
    assert " = " in capsys.readouterr().out
    assert main(["derive", "smith-footnote-8", "--json"]) == 0
    assert json.loads(capsys.readouterr().out)["steps"]
    assert main(["derive", "smith-footnot"]) == 2
    assert "smith-footnote-8" in capsys.readouterr().err
