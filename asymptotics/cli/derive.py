"""The derivations: from the equation of motion to a named result, each displayed step asserted as it is shown.

asymptotics derive                          the names, one per line
asymptotics derive smith-turning-points     run one and print it: the reason, then one line left = right for each step
asymptotics derive smith-turning-points --latex
"""

import argparse
from difflib import get_close_matches
from importlib import import_module
from importlib.util import find_spec

from asymptotics.cli.answer import Answer, add_common
from asymptotics.errors import InputError


def configure(parser: argparse.ArgumentParser) -> None:
    """Declare the options."""
    parser.add_argument("name", nargs="?", metavar="NAME", help="a derivation; without it, the list")
    parser.add_argument("--latex", action="store_true", help="print LaTeX instead of text")
    add_common(parser)


def run(options: argparse.Namespace) -> Answer:
    """Run the command; a step that fails is a failed check."""
    if find_spec("derivations") is None:
        raise InputError("NAME", "the derivations are not installed", "all of a wheel: pip install . in a clone")
    names = import_module("derivations.__main__").names()
    if options.name is None:
        return Answer({"derivations": names}, "\n".join(names), options.json)
    if options.name not in names:
        near = get_close_matches(options.name, names, n=3) or names[:3]
        raise InputError(
            "NAME", f"no derivation {options.name[:80]!r}", f"such as {', '.join(near)}; without NAME, the list"
        )
    try:
        derivation = import_module("derivations." + options.name.replace("-", "_")).derivation
    # A derivation asserts each of its steps while it is imported: one that fails has been refuted, exit code 1.
    except AssertionError as failure:
        return Answer({"name": options.name, "failed": str(failure)}, f"failed: {failure}", options.json, failed=True)
    return Answer(derivation.to_dict(), derivation.latex() if options.latex else derivation.text(), options.json)
