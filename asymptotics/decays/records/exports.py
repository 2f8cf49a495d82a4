"""Files that this program wrote and that hold no data: which command wrote them, and which one takes them.

>>> require_data(("law", "verdict", "parameter", "estimate", "code [identify]"), "out.csv")
Traceback (most recent call last):
    ...
asymptotics.errors.InputError: argument FILE: out.csv is what asymptotics identify --csv wrote: laws, strengths and ...
"""

from collections.abc import Mapping, Sequence
from typing import Any

from asymptotics.errors import InputError

_WRITTEN: dict[tuple[str, ...], tuple[str, str, str]] = {
    ("law", "verdict", "parameter"): (
        "identify --csv", "laws, strengths and what the envelope says",
        "the record itself: no command takes these; Q of the rows 'before any law' in a table A,Q is one of damping",
    ),
    ("law", "grade", "alpha"): (
        "damping --from (or identify of a table) --csv", "the strengths of laws",
        "the table itself; asymptotics compare takes what damping --from wrote",
    ),
    ("part", "amplitude", "zeta"): (
        "damping --csv", "numbers of a law in several parts",
        "asymptotics compare, which takes it as it is; or of one part the columns amplitude and zeta in a file",
    ),
}  # fmt: skip


def require_data(names: Sequence[str], name: str) -> None:
    """InputError where the columns are those of an answer, which is no measurement.

    Each of them ends with its code; a table of somebody else may begin with the same names.

    >>> require_data(("part", "amplitude", "zeta"), "mine.csv")
    """
    plain = [n.split(" [")[0] for n in names]
    found = _WRITTEN.get(tuple(plain[:3]))
    if found is not None and plain[-1] == "code":
        command, holds, accepted = found
        raise InputError("FILE", f"{name} is what asymptotics {command} wrote: {holds}", accepted)


def answered_by(found: Any) -> str | None:
    """The command whose ``--json`` this is; None for another file.

    >>> answered_by({"command": "identify", "version": "0.1.0"}), answered_by({"t": [0, 1], "x": [1, 0]})
    ('identify', None)
    """
    if not isinstance(found, Mapping) or not isinstance(found.get("version"), str):
        return None
    command = found.get("command")
    return command if isinstance(command, str) else None


def require_no_answer(found: Any, name: str) -> None:
    """InputError for what ``--json`` wrote, whose numbers are texts."""
    command = answered_by(found)
    if command is not None:
        reason = f"{name} is the answer of asymptotics {command} --json, and no table"
        accepted = "a measured record or table" if command == "identify" else "what --csv of the same command writes"
        raise InputError("FILE", reason, accepted)
