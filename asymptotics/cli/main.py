"""``asymptotics COMMAND ...``: find the command, load its module, run it, print text or JSON.

A command module has ``configure(parser)``, which declares the options (all as text; reading numbers is the command's
own business, so that every error names its argument), and ``run(options)``, which returns an ``Answer``.  Exit codes: 0
for an answer, 1 for a failed check or an undecided computation, 2 for a bad value.
"""

import argparse
import re
import sys
from importlib import import_module
from typing import Any, NoReturn

from asymptotics.cli.common import add_missing
from asymptotics.cli.shell import complain, emit, run_guarded
from asymptotics.errors import MAX_ACCEPTED, InputError, UndecidedError, printable

COMMANDS = {
    "compare": "your own values beside certified ones: right digits, and what the errors look like",
    "derive": "the derivations, each displayed step asserted (in a checkout)",
    "envelope": "the first-order envelope and phase: formula, certified numbers, curve",
    "expand": "the amplitude and phase equations to any order, for any exponent or sum of laws",
    "half-swing": "the map from one turning point to the next, its duration and its flow, as series",
    "identify": "which damping law is it: from a measured decay to exponents, strengths and intervals",
    "limit-cycle": "limit cycles: amplitude, frequency, multiplier in powers of mu; certified at a number",
    "moment": "the averages of |sin|^p",
    "motion": "x(t) and v(t) at a chosen order, or exact and high-precision reference motion",
    "multiple-scales": "the classical derivation, order by order, in text or LaTeX",
    "papers": "the statements of the three papers with their verdicts: list, look up, search",
    "smith": "Smith's coefficients C_i^n, polynomials f_n and generating functions G_i, exactly",
    "sweep": "any of these commands at many points, resumable, from one core to a cluster",
    "table": "reference tables with provenance",
    "turning-points": "turning points and times, to any number of certified digits",
}
_NEGATIVE_VALUE = re.compile(r"-(\d|\.\d|sqrt|inf|nan)", re.IGNORECASE)


class Parser(argparse.ArgumentParser):
    """An argument parser whose errors are one line."""

    def error(self, message: str) -> NoReturn:
        """Print one line that says what is wrong, and where help is; exit code 2."""
        self.exit(2, f"{self.prog}: {printable(message, MAX_ACCEPTED)} (see {self.prog} --help)\n")

    def _print_message(self, message: str, file: Any = None) -> None:
        """Help and version are answers too: argparse itself would lose them on a full disk without a word."""
        (complain if file is None or file is sys.stderr else emit)(message.rstrip("\n"))


class _Version(argparse.Action):
    """Loads what it needs only when it is asked: reading the installed packages takes time."""

    def __call__(self, parser: argparse.ArgumentParser, *rest: Any) -> NoReturn:
        """Print the version and leave."""
        parser._print_message(import_module("asymptotics.cli.version").text(), sys.stdout)
        parser.exit()


def main(argv: list[str] | None = None) -> int:
    """Run one command; returns the exit code."""
    return run_guarded("asymptotics", lambda: run(argv))


def run(argv: list[str] | None = None) -> int:
    """The same without the shell that answers interrupts and lost output; argparse leaves it by SystemExit."""
    arguments = _join_negative_values(list(sys.argv[1:] if argv is None else argv))
    top = Parser(prog="asymptotics", description=_description(), allow_abbrev=False, formatter_class=_Raw)
    top.add_argument("--version", action=_Version, nargs=0, help="the version; warns of a package of the same name")
    top.add_argument("command", choices=COMMANDS, metavar="COMMAND", help="one of the commands above")
    name = top.parse_args(arguments[:1]).command
    module = import_module("asymptotics.cli." + name.replace("-", "_"))  # only this command's libraries are loaded
    parser = Parser(prog=f"asymptotics {name}", description=module.__doc__, allow_abbrev=False, formatter_class=_Raw)
    module.configure(parser)
    add_missing(parser, name)
    options = parser.parse_args(arguments[1:])
    try:
        return int(_answer(module, options).show(name))
    except InputError as error:
        complain(f"asymptotics {name}: {as_option(error, options)}")
        return 2
    except UndecidedError as error:
        complain(f"asymptotics {name}: undecided: {printable(str(error), MAX_ACCEPTED)}")
        return 1


def _answer(module: Any, options: argparse.Namespace) -> Any:
    if "max_seconds" not in options:
        return module.run(options)
    with import_module("asymptotics.cli.clock").timed(options):  # loaded only here: --help and --version stay instant
        return module.run(options)


def as_option(error: InputError, options: argparse.Namespace) -> InputError:
    """The same error with the library's name of a parameter turned into the option that set it.

    >>> line = argparse.Namespace(alpha=None, damping="-1", law=["2:-1"])
    >>> str(as_option(InputError("b", "-1 is negative", "b >= 0"), line))
    'argument --law: -1 is negative (accepted: b >= 0)'
    """
    names = [name.replace("-", "_") for name in _OPTIONS.get(error.argument, (error.argument,))]
    given = [name for name in names if getattr(options, name, None) not in (None, False)]
    known = given or [name for name in names if hasattr(options, name)]
    if error.argument.startswith("-") or not known:
        return error
    return type(error)(f"--{known[0].replace('_', '-')}", error.reason, error.accepted)


_OPTIONS = {  # a parameter of the library: the options that may have set it
    "alpha": ("law", "alpha"),
    "alphas": ("law", "alpha"),
    "law": ("law", "alpha"),
    "b": ("law", "damping", "epsilon"),
    "epsilon": ("law", "epsilon", "damping"),
    "amplitude": ("amplitude", "x0"),
    "omega_0": ("omega0",),
    "eta": ("slow",),
}


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
