"""What a command answers in this process."""

import json

from asymptotics.shell.main import main


def run(capsys, line: str) -> tuple[int, str, str]:
    try:
        code = main(line.split())
    except SystemExit as stop:
        code = int(stop.code or 0)
    captured = capsys.readouterr()
    return code, captured.out, captured.err


def answer(capsys, line: str) -> dict:
    code, out, err = run(capsys, line + " --json")
    assert (code, err) == (0, "")
    return json.loads(out)
