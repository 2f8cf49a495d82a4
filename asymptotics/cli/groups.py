"""Help in groups: the law, the start, the data, what to compute, output, limits; and what a missing argument is called.

>>> parser = argparse.ArgumentParser(prog="p", add_help=False)
>>> _ = parser.add_argument("--alpha", metavar="A", help="the exponent"), parser.add_argument("--json", help="JSON")
>>> group_options(parser)
>>> [group.title for group in parser._action_groups if group._group_actions]
['the law', 'output']
>>> lacking(parser, "the following arguments are required: --alpha")
'argument --alpha A is missing: the exponent'
"""

import argparse

GROUPS = {
    "the law": ("alpha", "epsilon", "damping", "law", "spring", "mass", "stiffness", "static", "omega0"),
    "the start": ("x0", "v0"),
    "the data": (
        "columns", "resolution", "kind", "unit", "decimal", "skip", "sheet", "amplitudes", "amplitudes_only", "noise",
        "table", "list",
    ),
    "what to compute": (
        "conversions", "best_order", "bound", "check", "count", "delta", "exact", "gauge", "i", "laws", "map", "mu",
        "n", "near", "no_bootstrap", "order", "p", "phase", "quantity", "reference", "rounding", "route", "rows",
        "slow", "springs", "squaring", "start", "tau", "time", "times", "u", "verdict", "w",
    ),
    "output": (
        "csv", "digits", "dpi", "export", "format", "fragment", "html", "json", "latex", "output", "overlay", "plot",
        "points", "quiet", "size", "units",
    ),
    "limits": ("max_seconds", "workers", "dask", "store"),
}  # fmt: skip
# An option that no list names stays under argparse's own heading; a test finds it.
_GROUP_OF = {name: title for title, names in GROUPS.items() for name in names}


def group_options(parser: argparse.ArgumentParser) -> None:
    """Show each option under its heading, in the order of ``GROUPS``; how they are read does not change."""
    plain = parser._optionals
    for title in GROUPS:
        wanted = [a for a in plain._group_actions if a.option_strings and _GROUP_OF.get(a.dest) == title]
        if wanted:
            group = parser.add_argument_group(title)
            # argparse has no public way to move an action: the lists of its groups are edited, and how it parses is
            # untouched.
            group._group_actions += wanted
            plain._group_actions[:] = [a for a in plain._group_actions if a not in wanted]


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
