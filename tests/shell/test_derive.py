"""The command derive."""

import json

from asymptotics.shell.main import main


def test_derive(capsys):
    assert main(["derive"]) == 0
    assert "smith-turning-points" in capsys.readouterr().out.split()
    assert main(["derive", "smith-footnote-8"]) == 0
    assert " = " in capsys.readouterr().out
    assert main(["derive", "smith-footnote-8", "--json"]) == 0
    assert json.loads(capsys.readouterr().out)["steps"]
    assert main(["derive", "closed sum"]) == 0
    assert "smith-closed-sum" in capsys.readouterr().out
    assert main(["derive", "--json"]) == 0
    found = json.loads(capsys.readouterr().out)
    assert "smith-closed-sum" in found["derivations"] and found["records"][0]["title"]
    assert main(["derive", "smith-footnot"]) == 2
    assert "smith-footnote-8" in capsys.readouterr().err
