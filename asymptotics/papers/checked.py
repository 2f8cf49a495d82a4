"""The check of a statement, run again in the time that a public call has."""

from dataclasses import asdict
from importlib import import_module
from importlib.util import find_spec
from typing import Any

from asymptotics.errors import InputError
from asymptotics.numbers.policy import Number
from asymptotics.running.public import public_beside_others


@public_beside_others
def check(paper: str, statement: str, *, max_seconds: Number = 60) -> dict[str, Any]:
    """``PaperStatement.check``, by the key of the paper and the id of the statement.

    InputError where the checks, a part of the wheel of their own, are not installed.
    """
    # Looked for without being loaded: statements are looked up far more often than checked.
    if find_spec("paper_checks") is None:
        raise InputError("check", "the checks are not installed", "all of a wheel: pip install . in a clone")
    found = import_module("paper_checks.runner").examine(import_module("paper_checks.registry").load(paper)[statement])
    apart = None if found.apart is None else asdict(found.apart)
    outcomes = {name: str(outcome) for name, outcome in found.outcomes.items()}
    return {"outcomes": outcomes, "agrees": found.agrees, "apart": apart}
