"""``asymptotics COMMAND ...``: find the question, load it, ask it, print text or JSON.

A command is a question (``ask``): its options are all read as texts here, and by the question's kinds there, so that
every error names its argument.  Exit codes: 0 for an answer, 1 for a failed check or an undecided computation, 2 for a
bad value, 70 for a fault of the program.
"""

import argparse
import json
import re
import sys
from collections.abc import Mapping, Sequence
from difflib import get_close_matches
from functools import cache
from importlib import import_module
from types import MappingProxyType
from typing import Any, NoReturn

from asymptotics.ask.registry import QUESTIONS, loaded, summary
from asymptotics.errors import MAX_ACCEPTED, InputError, LimitError, UndecidedError, printable
from asymptotics.shell.gate import typed, words
from asymptotics.shell.guarded import complain, emit, run_guarded
from asymptotics.shell.lacking import lacking


class Parser(argparse.ArgumentParser):
    """An argument parser whose errors are one line."""

    # argparse says which option is missing, not that --alhpa stands there: the words tell it.
    words: Sequence[str] = ()  # what is being parsed

    def parse_known_args(self, args: Any = None, namespace: Any = None) -> Any:
        """The same, remembering the words: an option that is missing may be there under a wrong name."""
        self.words = list(args or ())
        return super().parse_known_args(args, namespace)

    def error(self, message: str) -> NoReturn:
        """Print one line that says what is wrong, what was perhaps meant, and where help is; exit code 2."""
        # A misspelt required option is two faults for argparse, of which it tells the wrong one first.
        if "required" in message and (misspelt := next(filter(self._is_misspelt, self.words), None)):
            message = f"unrecognized arguments: {misspelt.partition('=')[0]}"
        message = lacking(self, message) + self._meant(message)
        self.exit(2, f"{self.prog}: {printable(message, MAX_ACCEPTED)} (see {self.prog} --help)\n")

    def _is_misspelt(self, word: str) -> bool:
        """Whether it is an unknown option that resembles one of ours."""
        name = word.partition("=")[0]
        return name not in self._option_string_actions and bool(self._meant(f"unrecognized arguments: {name}"))

    def _meant(self, message: str) -> str:
        """The option that an unknown one resembles."""
        unknown = re.match(r"unrecognized arguments: (--[a-z0-9-]+)", message)
        known = [
            option for action in self._actions if action.help != argparse.SUPPRESS for option in action.option_strings
        ]
        # Without the dashes, which all have: --alpha is no --help.
        near = get_close_matches(unknown[1][2:], [option.lstrip("-") for option in known], n=1) if unknown else []
        return f"; did you mean --{near[0]}?" if near else ""

    def _print_message(self, message: str, file: Any = None) -> None:
        """Help and version are answers too: argparse itself would lose them on a full disk without a word."""
        (complain if file is None or file is sys.stderr else emit)(message.rstrip("\n"))


class _Version(argparse.Action):
    """Loads what it needs only when it is asked: reading the installed packages takes time."""

    def __call__(self, parser: argparse.ArgumentParser, *rest: Any) -> NoReturn:
        """Print the version and leave."""
        parser._print_message(import_module("asymptotics.shell.version").text(), sys.stdout)
        parser.exit()


class _Schema(argparse.Action):
    """The request of a command as JSON Schema."""

    def __call__(self, parser: argparse.ArgumentParser, *rest: Any) -> NoReturn:
        """Print it and leave."""
        parser._print_message(json.dumps(loaded(parser.prog.split()[-1]).schema(), indent=2), sys.stdout)
        parser.exit()


class _Completion(argparse.Action):
    """The script that a shell reads to complete our words."""

    def __call__(self, parser: argparse.ArgumentParser, namespace: Any, value: Any, *rest: Any) -> NoReturn:
        """Print it and leave."""
        try:
            text = import_module("asymptotics.shell.completion").script(str(value), QUESTIONS)
        except InputError as error:
            parser.error(str(error))
        parser._print_message(text, sys.stdout)
        parser.exit()


def main(argv: list[str] | None = None) -> int:
    """Run one command; returns the exit code."""
    return run_guarded("asymptotics", lambda: run(argv))


def run(argv: list[str] | None = None) -> int:
    """The same without the shell that answers interrupts and lost output; argparse leaves it by SystemExit."""
    top = Parser(prog="asymptotics", description=_description(), allow_abbrev=False, formatter_class=_Raw)
    top.add_argument("--version", action=_Version, nargs=0, help="the version; warns of a package of the same name")
    top.add_argument("--completion", action=_Completion, metavar="SHELL", help="a script for bash, zsh or fish")
    top.add_argument("command", choices=QUESTIONS, metavar="COMMAND", help="one of the commands above")
    try:
        arguments = words(sys.argv[1:] if argv is None else argv)
    except InputError as error:
        top.error(str(error))
    if not arguments:
        top.print_help(sys.stdout)
        return 0
    _require_known(top, arguments[0])
    # Two parsers: the first reads one word, so that only the module of that command is loaded, and its options are
    # unknown here.
    name = top.parse_args(arguments[: 2 if arguments[0] == "--completion" else 1]).command
    command, parser = _command(name)
    options = argparse.Namespace()
    try:
        options = command.parsed(parser, arguments[1:])
        typed(options)
        return _shown(name, command, options)
    except InputError as error:
        complain(f"asymptotics {name}: {as_option(error, options, _written(parser), command.question.feeds())}")
        return 2
    except ValueError as error:
        # Python's limit on the digits of an int (4300) is met where a fraction is printed: an answer too long to be
        # one, not a fault.  InputError is a ValueError too and was caught above; any other is a fault.
        if "integer string conversion" not in str(error):
            raise
        complain(f"asymptotics {name}: the answer has an integer of more than {sys.get_int_max_str_digits()} digits "
                 "(accepted: a lower order, smaller exponents, simpler fractions)")  # fmt: skip
        return 2
    except UndecidedError as error:
        complain(f"asymptotics {name}: undecided: {printable(str(error), MAX_ACCEPTED)}")
        return 1


@cache
def _command(name: str) -> tuple[Any, Parser]:
    """The command and what reads its options, made once in a process."""
    # Loaded only here: the list of commands, --help and --version need no question.
    command = import_module("asymptotics.shell.asked").command_of(name)
    parser = Parser(prog=f"asymptotics {name}", description=command.page, allow_abbrev=False, formatter_class=_Raw)
    command.configure(parser)
    parser.add_argument("--schema", action=_Schema, nargs=0, help="the request as JSON Schema")
    return command, parser


def _require_known(top: Parser, name: str) -> None:
    """A word that is no command is answered with the command that was perhaps meant."""
    if not name.startswith("-") and name not in QUESTIONS:
        near = get_close_matches(name.lower(), QUESTIONS, n=2)
        top.error(f"argument COMMAND: no command {name!r}" + (f"; did you mean {' or '.join(near)}?" if near else ""))


def _shown(name: str, command: Any, options: argparse.Namespace) -> int:
    """Print the answer; of a command whose time is over, or that is interrupted, the rows that are done."""
    try:
        answer = _answer(command, options)
    except (LimitError, KeyboardInterrupt) as stop:
        # The rows are printed, and the error is raised again after them: the exit code and the line on stderr stay.
        rows = import_module("asymptotics.running.cut_short").done(stop)
        partial = None if rows is None else command.cut_short(options, rows)
        if partial is not None:
            partial.show(name)
        raise
    return int(answer.show(name))


def _answer(command: Any, options: argparse.Namespace) -> Any:
    if "max_seconds" not in options:
        return command.run(options)
    with import_module("asymptotics.shell.clock").timed(options):  # loaded only here: --help and --version stay instant
        return command.run(options)


def _written(parser: argparse.ArgumentParser) -> dict[str, str]:
    """What each option is called on the command line, where that is not the name it is kept under."""
    called = {a.dest: a.option_strings[-1] if a.option_strings else str(a.metavar) for a in parser._actions}
    return {dest: option for dest, option in called.items() if option != f"--{dest.replace('_', '-')}"}


def as_option(
    error: InputError,
    options: argparse.Namespace,
    written: Mapping[str, str] = MappingProxyType({}),
    feeds: Mapping[str, tuple[str, ...]] = MappingProxyType({}),
) -> InputError:
    """The same error with the library's name of a parameter turned into the option that set it.

    ``written``: what options are called that are kept under other names (``--from`` under ``table``); ``feeds``: the
    options that may have set a parameter.

    >>> line = argparse.Namespace(alpha=None, damping="-1", law=["2:-1"])
    >>> feeds = {"strength": ("law", "damping")}
    >>> str(as_option(InputError("strength", "-1 is negative", "b >= 0"), line, feeds=feeds))
    'argument --law: -1 is negative (accepted: b >= 0)'
    >>> as_option(InputError("table", "is gone", "a file"), argparse.Namespace(table="a"), {"table": "--from"}).argument
    '--from'
    """
    names = [name.replace("-", "_") for name in feeds.get(error.argument, (error.argument,))]
    # Of several options that feed one parameter the one that was typed is meant; without any, the first that exists.
    given = [name for name in names if getattr(options, name, None) not in (None, False)]
    known = given or [name for name in names if hasattr(options, name)]
    # An error that names an option already was made by the command itself.
    if error.argument.startswith("-") or not known:
        return error
    option = written.get(known[0], f"--{known[0].replace('_', '-')}")
    return type(error)(option, error.reason, error.accepted)


def _description() -> str:
    width = max(map(len, QUESTIONS)) + 2
    lines = [f"  {name:{width}}{summary(name)}" for name in QUESTIONS]
    title = "Certified asymptotics for m x'' + k x + sum b_i x'|x'|^(alpha_i - 1) = 0."
    return "\n".join([title, "", "commands:", *lines, "", "`asymptotics COMMAND --help` explains each."])


class _Raw(argparse.RawDescriptionHelpFormatter):
    """Descriptions keep their line breaks; behind the help of an option stands which others it needs, or excludes."""

    def _get_help_string(self, action: argparse.Action) -> str:
        return (action.help or "") + getattr(action, "beside", "")


if __name__ == "__main__":
    sys.exit(main())
