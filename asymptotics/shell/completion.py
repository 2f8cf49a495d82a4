"""What a shell needs to complete commands, options and their values: ``asymptotics --completion bash`` (or zsh, fish).

The script is text that is made once and holds no code of this package: completing a word starts no Python.

bash: ``asymptotics --completion bash > ~/.local/share/bash-completion/completions/asymptotics``
zsh: ``asymptotics --completion zsh >> ~/.zshrc``
fish: ``asymptotics --completion fish > ~/.config/fish/completions/asymptotics.fish``

>>> "motion" in script("bash", {"motion": "x(t)"})
True
"""

import argparse
from collections.abc import Iterable, Iterator, Mapping
from importlib import import_module

from asymptotics.ask.registry import summary
from asymptotics.errors import InputError
from asymptotics.gauges import GAUGES
from asymptotics.shell.asked import command_of

SHELLS = ("bash", "zsh", "fish")
_FILES = ("FILE", "DIR")


def script(shell: str, commands: Iterable[str]) -> str:
    """The script for a shell; InputError for one that is not known."""
    if shell not in SHELLS:
        raise InputError("--completion", f"no shell {shell[:20]!r}", ", ".join(SHELLS))
    parsers = {name: _parser(name) for name in commands}
    if shell == "fish":
        return "\n".join(_fish(parsers))
    head = ["autoload -U +X bashcompinit && bashcompinit"] if shell == "zsh" else []
    return "\n".join([*head, *_bash(parsers)])


def _parser(command: str) -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(prog=command)
    command_of(command).configure(parser)
    return parser


def _options(parser: argparse.ArgumentParser) -> Iterator[tuple[str, argparse.Action, str]]:
    """Each option with its long name and its values: words, "" where a file is wanted, "-" where there are none."""
    for action in parser._actions:
        if action.option_strings and action.help != argparse.SUPPRESS:
            yield action.option_strings[-1], action, _values(action)


def _values(action: argparse.Action) -> str:
    words = action.choices or getattr(action, "words", ())
    if words:
        return " ".join(map(str, words))
    # --gauge takes any text, refused with the list of gauges: argparse knows no choices of it.
    if action.dest == "gauge":
        return " ".join(GAUGES)
    if action.nargs == 0:
        return "-"
    return "" if action.metavar in _FILES else "-"


def _words(command: str, parser: argparse.ArgumentParser) -> list[str]:
    """What may stand where no option is: names of tables, of papers, choices."""
    places = [a for a in parser._actions if not a.option_strings]
    found = [str(c) for a in places for c in a.choices or getattr(a, "words", None) or ()]
    if command == "table":
        found += import_module("asymptotics.tables.registry").names()
    if command == "papers":
        found += import_module("asymptotics.papers.lookup").papers()
    return found


# compgen -W takes words from a text that is written into the script: names of options and choices alone, none of which
# needs quotes.
def _bash(parsers: Mapping[str, argparse.ArgumentParser]) -> Iterator[str]:
    yield "_asymptotics() {"
    yield '  local word="${COMP_WORDS[COMP_CWORD]}" before="${COMP_WORDS[COMP_CWORD-1]}" words=""'
    yield "  COMPREPLY=()"
    yield '  if [ "$COMP_CWORD" -eq 1 ]; then'
    yield f'    COMPREPLY=($(compgen -W "{" ".join(parsers)} --help --version --completion" -- "$word")); return'
    yield "  fi"
    yield '  case "${COMP_WORDS[1]} $before" in'
    for name, parser in parsers.items():
        for option, _, values in _options(parser):
            if values not in ("", "-"):
                yield f'    "{name} {option}") COMPREPLY=($(compgen -W "{values}" -- "$word")); return;;'
            elif values == "":
                yield f'    "{name} {option}") COMPREPLY=($(compgen -f -- "$word")); return;;'
    yield "  esac"
    yield '  case "${COMP_WORDS[1]}" in'
    for name, parser in parsers.items():
        known = " ".join([*_words(name, parser), *(option for option, *_ in _options(parser))])
        yield f'    {name}) words="{known}";;'
    yield "  esac"
    yield '  COMPREPLY=($(compgen -W "$words" -- "$word"))'
    yield "}"
    yield "complete -o default -F _asymptotics asymptotics"


def _fish(parsers: Mapping[str, argparse.ArgumentParser]) -> Iterator[str]:
    for name in parsers:
        yield f"complete -c asymptotics -f -n __fish_use_subcommand -a {name} -d {_quoted(summary(name))}"
    for name, parser in parsers.items():
        where = f"complete -c asymptotics -n '__fish_seen_subcommand_from {name}'"
        if _words(name, parser):
            yield f"{where} -a {_quoted(' '.join(_words(name, parser)))}"
        for option, action, values in _options(parser):
            rest = "" if action.nargs == 0 else " -r" if values == "" else " -x"
            rest += f" -a {_quoted(values)}" if values not in ("", "-") else ""
            yield f"{where} -l {option.lstrip('-')}{rest} -d {_quoted(str(action.help))}"


def _quoted(text: str) -> str:
    """In single quotes, as fish reads them."""
    return "'" + text.replace("\\", "\\\\").replace("'", "\\'").replace("\n", " ") + "'"
