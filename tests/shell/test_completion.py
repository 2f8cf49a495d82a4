"""What shells complete."""

import argparse
import shutil
import subprocess

import pytest

from asymptotics.ask.registry import QUESTIONS
from asymptotics.shell.asked import command_of
from asymptotics.shell.completion import SHELLS
from asymptotics.shell.main import main


def parser_of(command):
    parser = argparse.ArgumentParser(prog=command)
    command_of(command).configure(parser)
    return parser


@pytest.fixture(scope="module")
def scripts(tmp_path_factory):
    folder, capture = tmp_path_factory.mktemp("completion"), pytest.MonkeyPatch()
    written = {}
    for shell in SHELLS:
        done = []
        capture.setattr("asymptotics.shell.main.emit", done.append)
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
    for command in QUESTIONS:
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
