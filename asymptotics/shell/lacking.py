"""What a missing argument is called.

>>> parser = argparse.ArgumentParser(prog="p", add_help=False)
>>> _ = parser.add_argument("--alpha", metavar="A", help="the exponent")
>>> lacking(parser, "the following arguments are required: --alpha")
'argument --alpha A is missing: the exponent'
"""

import argparse


def lacking(parser: argparse.ArgumentParser, message: str) -> str:
    """What argparse says of missing arguments, as one would have written them and with what they mean."""
    lead, _, names = message.partition("the following arguments are required: ")
    if lead or not names:
        return message
    told = []
    for name in (n for n in names.split(", ") if n != "..."):
        action = next((a for a in parser._actions if name in (*a.option_strings, a.metavar, a.dest)), None)
        if action is None:
            told.append(f"argument {name} is missing")
            continue
        written = f"{name} {action.metavar}" if action.option_strings and action.metavar else name
        told.append(f"argument {written} is missing" + (f": {action.help}" if action.help else ""))
    return "; ".join(told)
