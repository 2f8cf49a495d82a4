"""The derivations, each displayed step asserted."""

from collections.abc import Mapping
from dataclasses import dataclass
from difflib import get_close_matches
from importlib import import_module
from importlib.util import find_spec
from typing import Annotated, Any

from asymptotics.ask.answers import Offers, Request
from asymptotics.ask.kinds import SECONDS, TEXT
from asymptotics.ask.question import question
from asymptotics.errors import InputError, shown
from asymptotics.numbers.policy import Number
from asymptotics.papers.derived import DerivationRecord, derivations, grouped


class Failed(str):
    """The words of a step that has been refuted."""

    __slots__ = ()


@dataclass(frozen=True)
class Listed:
    """Derivations by the key of their paper, or those that were found by words."""

    groups: Mapping[str, tuple[DerivationRecord, ...]]

    def to_dict(self) -> dict[str, Any]:
        """The names, and all that is known of each without running it."""
        records = [record for group in self.groups.values() for record in group]
        return {"derivations": [r.name for r in records], "records": [r.to_dict() for r in records]}

    def __str__(self) -> str:
        width = max(len(r.name) for group in self.groups.values() for r in group)
        lines = []
        for key, group in self.groups.items():
            lines += [key, *(f"  {r.name:{width}}  {r.title}" for r in group)]
        return "\n".join(lines)


def _data(found: Any, request: Request) -> dict[str, Any]:
    if isinstance(found, Failed):
        return {"name": request["name"], "failed": str(found)}
    data: dict[str, Any] = found.to_dict()
    return data


def _text(found: Any, _: Request) -> str:
    if isinstance(found, Listed):
        return str(found)
    return f"failed: {found}" if isinstance(found, Failed) else str(found.text())


def _shown(request: Request) -> Any:
    """What the shell answers: a list with titles, what is found by words, a derivation, or the step that failed."""
    name, names = request["name"], _names()
    if name is None:
        return Listed(grouped())
    # What is written as a name is one, or a slip; anything else are words.
    by_name = name in names or ("-" in name and " " not in name)
    try:
        return derive_by_name(name, names) if by_name else Listed({f"by {name!r}": derivations(name)})
    # A derivation asserts each of its steps while it is imported: one that fails has been refuted, exit code 1.
    except AssertionError as failure:
        return Failed(str(failure))
    except InputError as error:
        if by_name or error.argument != "words":
            raise
        raise _unknown(name, names, error.accepted) from error


def _names() -> list[str]:
    # Looked for without being imported: each derivation proves itself while it loads, which takes its time.
    if find_spec("derivations") is None:
        raise InputError("name", "the derivations are not installed", "all of a wheel: pip install . in a clone")
    names: list[str] = import_module("derivations.__main__").names()
    return names


def _unknown(name: str, names: list[str], words: str = "") -> InputError:
    """The error for a name that is none: the nearest, else what the same words find elsewhere."""
    near = get_close_matches(name, names, n=3)
    found = words if words and not near else f"such as {', '.join(near or names[:3])}"
    return InputError("name", f"no derivation {shown(name)}", f"{found}; without a name, the list")


def derive_by_name(name: str, names: list[str]) -> Any:
    """The derivation, run as it is loaded."""
    if name not in names:
        raise _unknown(name, names)
    return import_module("derivations." + name.replace("-", "_")).derivation


_FORMULAS = "the answer is formulas, exact: nothing to round, to tabulate or to draw"


@question(
    Offers(
        latex="print LaTeX instead of text",
        own_latex=True,
        data=_data,
        text=_text,
        as_latex=lambda found, request: found.latex() if hasattr(found, "latex") else _text(found, request),
        failed=lambda found, _: isinstance(found, Failed),
        letters=lambda *_: None,
        of_shell=_shown,
        lacks={
            **dict.fromkeys(("csv", "digits", "plot", "points"), _FORMULAS),
            "gauge": "a derivation says itself which gauge it is in",
        },
    ),
    alone=False,
    example="q-log-q",
    rests="each line decided by SymPy, most of them identities; asked of balls where they are inequalities",
)
def derive(
    name: Annotated[str | None, TEXT.called(place=True)] = None, *, max_seconds: Annotated[Number, SECONDS] = 60
) -> Any:
    """The derivations: from the equation of motion to a named result, each displayed step asserted as it is shown.

      asymptotics derive                          all of them with their titles, by paper
      asymptotics derive "closed sum"             those whose title, paper or statement has the words
      asymptotics derive smith-turning-points     run one and print it: the reason, then one line left = right a step
      asymptotics derive smith-turning-points --latex

    Parameters
    ----------
    name
        a derivation, or words of a title; without it, the list
    max_seconds
        the time the request may take, in seconds

    Returns
    -------
    Derivation
        which shows its lines as text, ``latex()`` and in a notebook; without a name the list of names

    Raises
    ------
    InputError
        where only this package was installed, without the folder ``derivations`` of its wheel, and for another name
    AssertionError
        (Python) of a step that is refuted

    Examples
    --------
    >>> derive("abel-petal").title
    '...'
    """
    names = _names()
    return names if name is None else derive_by_name(name, names)
