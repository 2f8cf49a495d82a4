"""What a missing argument, or a missing value, is called.

>>> parser = argparse.ArgumentParser(prog="p", add_help=False)
>>> _ = parser.add_argument("--alpha", metavar="A", help="the exponent")
>>> lacking(parser, "the following arguments are required: --alpha")
'argument --alpha A is missing: the exponent'
>>> lacking(parser, "argument --alpha: expected one argument")
'argument --alpha A: its value is missing: the exponent'
"""

import argparse
import re


def lacking(parser: argparse.ArgumentParser, message: str) -> str:
    """What argparse says of missing arguments, as one would have written them and with what they mean."""
    if found := re.fullmatch(r"argument (--[a-z0-9-]+): expected (?:one|at least one) argument", message):
        return _missing(parser, found[1], ": its value is missing")
    lead, _, names = message.partition("the following arguments are required: ")
    if lead or not names:
        return message
    return "; ".join(_missing(parser, name, " is missing") for name in names.split(", ") if name != "...")


def _missing(parser: argparse.ArgumentParser, name: str, fault: str) -> str:
    action = next((a for a in parser._actions if name in (*a.option_strings, a.metavar, a.dest)), None)
    if action is None:
        return f"argument {name}{fault}"
    written = f"{name} {action.metavar}" if action.option_strings and action.metavar else name
    return f"argument {written}{fault}" + (f": {action.help}" if action.help else "")
