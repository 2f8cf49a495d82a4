"""The derivations, each displayed step asserted."""

from difflib import get_close_matches
from importlib import import_module
from importlib.util import find_spec
from typing import Annotated, Any

from asymptotics.ask.answers import Offers, Request
from asymptotics.ask.kinds import SECONDS, TEXT
from asymptotics.ask.question import question
from asymptotics.errors import InputError, shown
from asymptotics.numbers.policy import Number


class Failed(str):
    """The words of a step that has been refuted."""

    __slots__ = ()


def _data(found: Any, request: Request) -> dict[str, Any]:
    if isinstance(found, list):
        return {"derivations": found}
    if isinstance(found, Failed):
        return {"name": request["name"], "failed": str(found)}
    data: dict[str, Any] = found.to_dict()
    return data


def _text(found: Any, _: Request) -> str:
    if isinstance(found, list):
        return "\n".join(found)
    return f"failed: {found}" if isinstance(found, Failed) else str(found.text())


def _shown(name: str | None, max_seconds: Any) -> Any:
    """A step that fails is an answer of the shell: a failed check; its time is kept by the shell."""
    try:
        return derivation_of(name)
    # A derivation asserts each of its steps while it is imported: one that fails has been refuted, exit code 1.
    except AssertionError as failure:
        return Failed(str(failure))


def derivation_of(name: str | None) -> Any:
    """The derivation, run as it is loaded; the list of names without one."""
    # Looked for without being imported: each derivation proves itself while it loads, which takes its time.
    if find_spec("derivations") is None:
        raise InputError("name", "the derivations are not installed", "all of a wheel: pip install . in a clone")
    names: list[str] = import_module("derivations.__main__").names()
    if name is None:
        return names
    if name not in names:
        near = get_close_matches(name, names, n=3) or names[:3]
        raise InputError("name", f"no derivation {shown(name)}", f"such as {', '.join(near)}; without a name, the list")
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
        of_shell=_shown,
        lacks={
            **dict.fromkeys(("csv", "digits", "plot", "points"), _FORMULAS),
            "gauge": "a derivation says itself which gauge it is in",
        },
    ),
    alone=False,
)
def derive(
    name: Annotated[str | None, TEXT.called(place=True)] = None, *, max_seconds: Annotated[Number, SECONDS] = 60
) -> Any:
    """The derivations: from the equation of motion to a named result, each displayed step asserted as it is shown.

      asymptotics derive                          the names, one per line
      asymptotics derive smith-turning-points     run one and print it: the reason, then one line left = right a step
      asymptotics derive smith-turning-points --latex

    Parameters
    ----------
    name
        a derivation; without it, the list
    max_seconds
        the time the request may take, in seconds

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
    return derivation_of(name)
