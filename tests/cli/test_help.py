"""Help in groups, missing arguments named as they are written, and what shells complete."""

import argparse
import shutil
import subprocess
from importlib import import_module

import pytest

from asymptotics.cli.completion import SHELLS
from asymptotics.cli.groups import GROUPS, group_options
from asymptotics.cli.main import COMMANDS, main


def parser_of(command):
    parser = argparse.ArgumentParser(prog=command)
    import_module("asymptotics.cli." + command.replace("-", "_")).configure(parser)
    return parser


@pytest.mark.parametrize("command", COMMANDS)
def test_every_option_stands_under_one_heading(command):
    parser = parser_of(command)
    before = {o for a in parser._actions for o in a.option_strings}
    group_options(parser)
    assert [a.dest for a in parser._optionals._group_actions if a.option_strings] == ["help"]
    shown = [o for group in parser._action_groups for a in group._group_actions for o in a.option_strings]
    assert sorted(shown) == sorted(before)  # each once
    assert parser.format_help().count("\n  --json ") == 1
    titles = [group.title for group in parser._action_groups if group._group_actions]
    assert [t for t in titles if t in GROUPS] == [t for t in GROUPS if t in titles]


def test_an_option_without_a_heading_is_noticed():
    parser = argparse.ArgumentParser()
    parser.add_argument("--stray")
    group_options(parser)
    assert [a.dest for a in parser._optionals._group_actions] == ["help", "stray"]


@pytest.mark.parametrize(
    ("line", "said"),
    [
        ("turning-points --alpha 2", "--count N is missing: how many points"),
        ("moment", "--p P is missing"),
        ("smith", "argument WHAT is missing"),
        ("compare", "argument FILE is missing"),
        ("sweep", "argument COMMAND is missing"),
        ("motion --alpha 2 --time 3", "--epsilon: is missing (accepted: --epsilon E, without units; or --damping B"),
        ("motion --alpha 2 --time 3 --mass 2", "--damping: is missing"),
        ("envelope --alpha 2", "--epsilon: is missing"),
        ("expand", "--alpha A and --epsilon E, or --law A:E"),
    ],
)
def test_what_is_missing_is_named_as_it_is_written(capsys, line, said):
    assert main(line.split()) == 2
    captured = capsys.readouterr()
    assert (captured.out, captured.err.count("\n")) == ("", 1)
    assert said in captured.err and "..." not in captured.err


@pytest.fixture(scope="module")
def scripts(tmp_path_factory):
    folder, capture = tmp_path_factory.mktemp("completion"), pytest.MonkeyPatch()
    written = {}
    for shell in SHELLS:
        done = []
        capture.setattr("asymptotics.cli.main.emit", done.append)
        assert main(["--completion", shell]) == 0
        written[shell] = folder / shell
        written[shell].write_text("\n".join(done) + "\n")
    capture.undo()
    return written


COMPLETED = [
    ("asymptotics tur", {"turning-points"}),
    ("asymptotics motion --ref", {"--reference"}),
    ("asymptotics motion --gauge av", {"averaging"}),
    ("asymptotics table smith2012.ta", {"smith2012.table1"}),
    ("asymptotics papers smi", {"smith2012"}),
    ("asymptotics smith c --", {"--help", "--n", "--i", "--json", "--quiet", "--digits"}),
    ("asymptotics moment --gau", set()),
]


@pytest.mark.parametrize(("line", "wanted"), COMPLETED)
def test_bash_completes(scripts, line, wanted):
    words = line.split()
    ask = f"""source {scripts["bash"]}; COMP_WORDS=({" ".join(words)}); COMP_CWORD={len(words) - 1}
    _asymptotics; printf '%s\\n' "${{COMPREPLY[@]}}" """
    found = set(subprocess.run(["bash", "-c", ask], capture_output=True, text=True, check=True).stdout.split())
    assert wanted <= found and (found == wanted or len(wanted) > 1), found


def test_zsh_and_fish_have_the_same_words(scripts):
    bash, zsh, fish = (scripts[shell].read_text() for shell in SHELLS)
    assert zsh.startswith("autoload -U +X bashcompinit && bashcompinit\n") and zsh.endswith(bash)
    for command in COMMANDS:
        assert f"-a {command} " in fish
        for action in parser_of(command)._actions:
            for option in (o for o in action.option_strings if o.startswith("--") and action.help != "==SUPPRESS=="):
                assert option in bash and f"from {command}' -l {option[2:]}" in fish
    for shell in ("zsh", "fish"):
        if shutil.which(shell):
            subprocess.run([shell, "-n", str(scripts[shell])], check=True)


def test_another_shell_is_refused(capsys):
    assert main(["--completion", "tcsh"]) == 2
    assert "bash, zsh, fish" in capsys.readouterr().err
    assert main(["--completion"]) == 2


FILES = {  # what a command needs before it looks at its files; sweep writes nothing before a point is done
    "compare": "mine.csv --alpha 2 --epsilon 1", "damping": "--alpha 2 --epsilon 1",
    "envelope": "--alpha 2 --epsilon 1 --time 1",
    "expand": "--alpha 2", "half-swing": "--alpha 2", "identify": "mine.csv", "limit-cycle": "--law 1:-1 --law 1,2:1",
    "motion": "--alpha 2 --epsilon 1 --time 1", "smith": "f --n 3", "solution": "--alpha 2 --epsilon 1 --time 1",
    "stokes": "--alpha 2", "sweep": "moment --p 1", "table": "moments",
    "turning-points": "--alpha 2 --epsilon 1 --count 2",
}  # fmt: skip
TAKEN = [
    (command, action.option_strings[-1])
    for command in COMMANDS
    for action in parser_of(command)._actions
    if action.option_strings and action.metavar in ("FILE", "DIR")
]


def test_every_command_with_a_file_is_walked():
    assert {command for command, _ in TAKEN} <= set(FILES) and len(TAKEN) > 25
    assert ("damping", "--from") in TAKEN and ("sweep", "--list") in TAKEN


@pytest.mark.parametrize(("command", "option"), TAKEN)
def test_a_file_that_is_not_there_is_named_by_its_option(command, option, tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "mine.csv").write_text("n,x\n0,1\n1,-0.5\n")
    suffix = {"--plot": "svg", "--html": "html"}.get(option, "csv")
    line = FILES[command] if option != "--from" else ""
    line += " --store store" if command == "sweep" and option != "--store" else ""
    place = "missing/there" if option != "--store" else "mine.csv"  # a folder is made, but not in the place of a file
    assert main([command, *line.split(), option, f"{place}.{suffix}" if option != "--store" else place]) == 2
    captured = capsys.readouterr()
    assert (captured.out, captured.err.count("\n")) == ("", 1)
    assert f"argument {option}: " in captured.err


@pytest.mark.parametrize("command", ["compare", "identify"])
def test_a_file_without_an_option_is_called_as_in_the_help(command, capsys):
    assert (
        main([command, "missing/there.csv", *(["--alpha", "2", "--epsilon", "1"] if command == "compare" else [])]) == 2
    )
    assert "argument FILE: cannot read" in capsys.readouterr().err
