"""What ``data.json`` of the package holds, read once."""

import json
from functools import cache
from importlib.resources import files


@cache
def stored() -> dict[str, object]:
    """Papers, identifiers, later papers, statements, derivations, and the headings of the documentation."""
    return dict(json.loads(files("asymptotics.papers").joinpath("data.json").read_text(encoding="utf-8")))
