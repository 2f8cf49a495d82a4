"""The tables of the options that all commands share, in the place of a mark in a page: what each question declares."""

from asymptotics.ask.registry import QUESTIONS, loaded

MARK = "<!-- which command has which common option, and why not -->\n"
SHOWN = ("csv", "plot", "latex", "points", "gauge", "digits")


def tables():
    """A row for each command, and a row for each reason that it has not one of the options.

    >>> print(tables().splitlines()[2])
    | `compare` | yes | yes | – | – | – | yes |
    >>> "| `derive` | `--gauge` | a derivation says itself which gauge it is in |" in tables()
    True
    """
    there, why = [], []
    for name in QUESTIONS:
        lacks = loaded(name).offers.lacks
        there.append(f"| `{name}` | {' | '.join('–' if option in lacks else 'yes' for option in SHOWN)} |")
        for reason in sorted({*lacks.values()}, key=lambda r, lacks=lacks: min(o for o in lacks if lacks[o] == r)):
            options = ", ".join(f"`--{o}`" for o in sorted(lacks) if lacks[o] == reason)
            why.append(f"| `{name}` | {options} | {reason} |")
    head = f"| command | {' | '.join(f'`--{o}`' for o in SHOWN)} |\n{'|---' * (len(SHOWN) + 1)}|"
    return "\n".join([head, *there, "", "| command | not there | why |\n|---|---|---|", *why]) + "\n"


def _put(_app, _name, source):
    source[0] = source[0].replace(MARK, tables()) if MARK in source[0] else source[0]


def setup(app):
    """When a page is read."""
    app.connect("source-read", _put)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
