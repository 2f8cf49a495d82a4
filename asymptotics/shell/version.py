"""``--version``: the version, the commit if it is known, and a warning of another package of the same name.

>>> clash(["power-law-oscillator"]) is None
True
>>> print(clash(["power-law-oscillator", "asymptotics"]))
warning: asymptotics also installs a package named 'asymptotics'; the two cannot share an environment
"""

from collections.abc import Sequence
from importlib.metadata import packages_distributions

from asymptotics import __version__
from asymptotics.made_by import commit

DISTRIBUTION = "power-law-oscillator"


def text() -> str:
    """What ``--version`` prints: the version, the commit, and a warning of a package of the same name."""
    warning = clash(packages_distributions().get("asymptotics", []))
    return f"asymptotics {__version__} (commit {commit() or 'unknown'})" + (f"\n{warning}" if warning else "")


def clash(distributions: Sequence[str]) -> str | None:
    """What to say about ``distributions``, all that install a package ``asymptotics``; None when it is ours alone."""
    others = sorted(set(distributions) - {DISTRIBUTION})
    if not others:
        return None
    # Both would install the folder asymptotics, and what was installed last has overwritten the other's files.
    named = " and ".join(others)
    return f"warning: {named} also installs a package named 'asymptotics'; the two cannot share an environment"
