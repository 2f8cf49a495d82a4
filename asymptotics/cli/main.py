"""``asymptotics COMMAND ...``: find the command, load its module, run it, print text or JSON.

A command module has ``configure(parser)``, which declares the options (all as text; reading numbers is the command's
own business, so that every error names its argument), and ``run(options)``, which returns an ``Answer``.  Exit codes: 0
for an answer, 1 for a failed check or an undecided computation, 2 for a bad value.
"""

import argparse
import os
import re
import sys
from importlib import import_module
from typing import NoReturn

from asymptotics import __version__
from asymptotics.cli.answer import Answer
from asymptotics.errors import InputError, UndecidedError

COMMANDS = {
    "expand": "the amplitude and phase equations to any order, for any exponent or sum of laws",
    "half-swing": "the map from one turning point to the next, its duration and its flow, as series",
    "moment": "the averages of |sin|^p",
    "motion": "x(t) and v(t) at a chosen order, or exact and high-precision reference motion",
    "smith": "Smith's coefficients C_i^n, polynomials f_n and generating functions G_i, exactly",
    "table": "reference tables with provenance",
    "turning-points": "turning points and times, to any number of certified digits",
}
_NEGATIVE_VALUE = re.compile(r"-(\d|\.\d|sqrt|inf|nan)", re.IGNORECASE)


class Parser(argparse.ArgumentParser):
    """An argument parser whose errors are one line."""

    def error(self, message: str) -> NoReturn:
        """Print one line that says what is wrong, and where help is; exit code 2."""
        self.exit(2, f"{self.prog}: {' '.join(message.split())} (see {self.prog} --help)\n")


def main(argv: list[str] | None = None) -> int:
    """Run one command; returns the exit code."""
    arguments = _join_negative_values(list(sys.argv[1:] if argv is None else argv))
    top = Parser(prog="asymptotics", description=_description(), allow_abbrev=False, formatter_class=_Raw)
    top.add_argument("--version", action="version", version=f"asymptotics {__version__}")
    top.add_argument("command", choices=COMMANDS, metavar="COMMAND", help="one of the commands above")
    name = top.parse_args(arguments[:1]).command
    module = import_module("asymptotics.cli." + name.replace("-", "_"))  # only this command's libraries are loaded
    parser = Parser(prog=f"asymptotics {name}", description=module.__doc__, allow_abbrev=False, formatter_class=_Raw)
    module.configure(parser)
    try:
        answer = module.run(parser.parse_args(arguments[1:]))
    except InputError as error:
        print(f"asymptotics {name}: {_as_option(error, parser)}", file=sys.stderr)
        return 2
    except UndecidedError as error:
        print(f"asymptotics {name}: undecided: {error}", file=sys.stderr)
        return 1
    except KeyboardInterrupt:
        print(f"asymptotics {name}: interrupted, nothing was written", file=sys.stderr)
        return 130
    return _printed(answer, name)


def _printed(answer: Answer, name: str) -> int:
    """Print the answer; a reader that has gone (``| head``) is no error, a full disk is."""
    try:
        code = answer.show(name)
        sys.stdout.flush()
    except OSError as error:
        sys.stdout = open(os.devnull, "w")  # noqa: PTH123, SIM115 (what is buffered must not be written at exit)
        if isinstance(error, BrokenPipeError):
            return 0
        print(f"asymptotics {name}: cannot write the answer: {error.strerror}", file=sys.stderr)
        return 2
    return code


def _as_option(error: InputError, parser: argparse.ArgumentParser) -> str:
    """The message on one line, with the library's name of an argument turned into the option that set it."""
    option = "--" + {"alphas": "alpha"}.get(error.argument, error.argument)
    known = option in parser.format_help()
    shown = InputError(option if known else error.argument, error.reason, error.accepted)
    return " ".join(str(shown).split())


def _description() -> str:
    width = max(map(len, COMMANDS)) + 2
    lines = [f"  {name:{width}}{summary}" for name, summary in COMMANDS.items()]
    title = "Certified asymptotics for m x'' + k x + sum b_i x'|x'|^(alpha_i - 1) = 0."
    return "\n".join([title, "", "commands:", *lines, "", "`asymptotics COMMAND --help` explains each."])


class _Raw(argparse.RawDescriptionHelpFormatter):
    """Descriptions keep their line breaks."""


def _join_negative_values(arguments: list[str]) -> list[str]:
    """``--epsilon -1/2`` -> ``--epsilon=-1/2``: argparse would take the value for an option."""
    joined: list[str] = []
    for argument in arguments:
        if joined and re.fullmatch(r"--[a-z][a-z0-9-]*", joined[-1]) and _NEGATIVE_VALUE.match(argument):
            joined[-1] += "=" + argument
        else:
            joined.append(argument)
    return joined


if __name__ == "__main__":
    sys.exit(main())
