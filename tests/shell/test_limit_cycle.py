"""The command limit-cycle: the contract of its JSON."""

import json

from asymptotics.shell.main import main


def test_the_contract(capsys):
    assert main(["limit-cycle", "--law", "1:-1", "--law", "1,2:1", "--order", "8", "--json", "--digits", "10"]) == 0
    data = json.loads(capsys.readouterr().out)
    assert data["amplitude"]["2"] == {"value": "0.01041666667", "exact": "1/96"}
    assert list(data["frequency"]) == ["0", "2", "4", "6", "8"]
    assert data["frequency"]["8"]["exact"] == "-678899/5096079360"
    line = "limit-cycle --law 1:-1 --law 1,2:1 --spring 3:1/2 --mu 1 --digits 10"
    assert main([*line.split(), "--json"]) == 0
    assert json.loads(capsys.readouterr().out)["at"]["amplitude"].startswith("1.95363")
    assert main(line.split()) == 0 and "x'' + x + 1/2 x^3 + mu (-x' + x^2 x')" in capsys.readouterr().out
    assert main(["limit-cycle", "--law", "1:-1", "--law", "1,2:1", "--near", "-1"]) == 2
    assert main(["limit-cycle", "--law", "1:1"]) == 2
