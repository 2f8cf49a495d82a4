"""The command papers."""

import json
import subprocess
import sys

from asymptotics.shell.main import main


def test_command(capsys):
    assert main(["papers"]) == 0
    assert "smith2012" in capsys.readouterr().out
    assert main(["papers", "smith2012:48", "--json"]) == 0
    data = json.loads(capsys.readouterr().out)
    assert data["command"] == "papers"
    assert [e["id"] for e in data["entries"]] == ["smith2012:48"]
    assert main(["papers", "smith2012:48", "--check"]) == 0
    assert "borne out" in capsys.readouterr().out
    assert main(["papers", "smith2012:48"]) == 0
    assert "near miss" in capsys.readouterr().out
    assert main(["papers", "48", "--latex"]) == 0
    assert "e^{2u_1}" in capsys.readouterr().out


def test_a_near_miss_is_told_without_latex(capsys):
    """Failed before: ``at u_{0} = \\frac{2}{7}`` stood in the terminal."""
    assert main(["papers", "smith2012:43", "--check"]) == 0
    out = capsys.readouterr().out
    assert "at u_0 = 2/7, u_1 = 3/5" in out and not {*"\\{}"} & {*out}


def test_the_checks_have_a_time(capsys, monkeypatch):
    main(["papers", "smith2012:48", "--check"])  # the runner is loaded
    capsys.readouterr()

    def endless(_):
        while True:
            pass

    monkeypatch.setattr("paper_checks.runner.examine", endless)
    assert main(["papers", "smith2012", "--check", "--max-seconds", "1/4"]) == 2
    told = capsys.readouterr()
    assert told.out == "" and "--max-seconds: 0.25 s are over at the check of smith2012:" in told.err


def test_looking_up_loads_no_heavy_library():
    probe = (
        "import sys; from asymptotics.shell.main import main; main(['papers', 'smith2012:43']);"
        "assert not {'sympy', 'numpy', 'mpmath', 'matplotlib', 'scipy'} & set(sys.modules)"
    )
    subprocess.run([sys.executable, "-c", probe], check=True, capture_output=True)
