"""The README's console examples are run and compared, so that what a stranger reads is what the program prints."""

import doctest
import re
import shlex
from fnmatch import fnmatch
from pathlib import Path

import pytest

from asymptotics.shell.main import main

ROOT = Path(__file__).parents[1]
README = (ROOT / "README.md").read_text()
ARITHMETICS = (ROOT / "docs/maintainers/arithmetics.md").read_text()
EXAMPLES = [
    example
    for block in re.findall(r"```console\n(.*?)```", README, re.DOTALL)
    for example in re.findall(r"^\$ asymptotics (.*?)\n(.*?)(?=^\$ |\Z)", block, re.DOTALL | re.MULTILINE)
]


def test_there_are_examples():
    assert len(EXAMPLES) >= 4


@pytest.mark.parametrize(("command", "output"), EXAMPLES, ids=[command for command, _ in EXAMPLES])
def test_the_readme_shows_what_is_printed(capsys, command, output):
    assert main(shlex.split(command)) == 0
    assert capsys.readouterr().out == output


def test_the_python_of_the_readme_runs():
    blocks = re.findall(r"```python\n(.*?)```", README, re.DOTALL)
    assert blocks
    for block in blocks:
        test = doctest.DocTestParser().get_doctest(block, {}, "README", "README.md", 0)
        found: list[str] = []
        runner = doctest.DocTestRunner(optionflags=doctest.NORMALIZE_WHITESPACE)
        assert runner.run(test, out=found.append).failed == 0, found


def test_the_links_of_the_readme_lead_somewhere():
    for target in re.findall(r"\]\((?!http)([^)#]+)\)", README):
        assert (Path(__file__).parents[1] / target).exists(), target


def test_the_table_of_arithmetics_names_every_file():
    """One line for a room, and one for the files of it that differ."""
    root = ROOT / "asymptotics"
    rows = [line for line in ARITHMETICS.splitlines() if re.match(r"\|.*\| (exact|certified|heuristic|none) \|", line)]
    named = [re.findall(r"`([\w/*.]+)`", row) for row in rows]
    listed = [name for row in named for name in row]
    assert len(listed) == len(set(listed)) and all((root / name).exists() for name in listed)
    for path in root.rglob("*.py"):
        name = str(path.relative_to(root))
        if path.name.startswith("__"):
            continue
        as_file = [row for row in named if any(p.endswith(".py") and fnmatch(name, p) for p in row)]
        folders = [p for row in named for p in row if p.endswith("/") and name.startswith(p)]
        as_folder = [row for row in named if folders and max(folders, key=len) in row]
        assert len(as_file or as_folder) == 1, f"{name} stands in {len(as_file or as_folder)} rows of arithmetics.md"


def test_the_commands_of_the_readme_are_in_the_makefile():
    makefile = (Path(__file__).parents[1] / "Makefile").read_text()
    for target in set(re.findall(r"make ([a-z-]+)", README)) - {"puts"}:
        assert re.search(rf"^{target}:", makefile, re.MULTILINE), target


NEEDS = re.findall(r"^\| [a-zA-Z].*\| `asymptotics (.*?)` \|$", README, re.MULTILINE)


@pytest.mark.parametrize("command", NEEDS)
def test_a_command_of_the_first_screen_is_accepted(command, tmp_path, monkeypatch, capsys):
    """Run where it needs no data; with a file of the user's, read up to that file, which is not there."""
    monkeypatch.chdir(tmp_path)
    if command.startswith("sweep"):
        command = command.replace(":1/100", ":1/2") + " --workers 1"
    quiet = [] if command.startswith(("papers", "derive")) else ["--quiet"]
    code = main([*shlex.split(command), *quiet])
    said = capsys.readouterr()
    assert (code, said.out) == (2, "") and "FILE" in said.err if " FILE" in command else code == 0 and said.out


def test_the_first_screen_leads_to_the_commands_that_people_need():
    assert len(NEEDS) >= 9
    assert README.index("## From a need to a command") < 1500


def test_the_bounds_of_the_readme_are_those_of_the_program(capsys):
    text = README.partition("## Any exponent, any order")[2].partition("## ")[0]
    said = {}
    for command in ("expand", "motion", "solution", "turning-points", "moment"):
        assert main([command, "--help"]) == 0
        said[command] = " ".join(capsys.readouterr().out.split())
    assert "1 to 200" in said["expand"] and "| orders of the series | to 200" in text
    assert "1 to 12" in said["motion"] and "1 to 12" in said["solution"] and "(motion, A(t) and φ(t): 12)" in text
    assert "(1 to 10000;" in said["turning-points"] and "(1 to 10000;" in said["moment"]
    assert "(1 to 1000;" in said["expand"] and "(1 to 1000;" in said["motion"]
    assert "| digits | to 1000 (turning points and moments: 10000) |" in text and "| counts to 100000 |" in text
    assert "(1 to 100000)" in said["turning-points"] and "(default 60)" in said["expand"]


def test_no_command_is_shown_that_cannot_work():
    """Nothing is on a package index: what is installed by name alone is another project's."""
    for path in [ROOT / "README.md", *(ROOT / "docs").rglob("*.md"), *(ROOT / "asymptotics").rglob("*.py")]:
        assert "pip install power-law-oscillator" not in path.read_text(), path
        assert "pip install 'power-law-oscillator" not in path.read_text(), path
