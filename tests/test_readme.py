"""The README's console examples are run and compared, so that what a stranger reads is what the program prints."""

import doctest
import re
import shlex
from fnmatch import fnmatch
from pathlib import Path

import pytest

from asymptotics.cli.main import main

README = (Path(__file__).parents[1] / "README.md").read_text()
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
    root = Path(__file__).parents[1] / "asymptotics"
    rows = [line.split("|")[2] for line in README.splitlines() if line.startswith("|") and "/`" in line]
    named = [re.findall(r"`([\w/*.]+)`", row) for row in rows]
    for path in root.rglob("*.py"):
        name = str(path.relative_to(root))
        if path.name.startswith("__"):
            continue
        as_file = [row for row in named if any(p.endswith(".py") and fnmatch(name, p) for p in row)]
        as_folder = [row for row in named if any(p.endswith("/") and name.startswith(p) for p in row)]
        assert len(as_file or as_folder) == 1, f"{name} stands in {len(as_file or as_folder)} rows"


def test_the_commands_of_the_readme_are_in_the_makefile():
    makefile = (Path(__file__).parents[1] / "Makefile").read_text()
    for target in set(re.findall(r"make ([a-z-]+)", README)) - {"puts"}:
        assert re.search(rf"^{target}:", makefile, re.MULTILINE), target
