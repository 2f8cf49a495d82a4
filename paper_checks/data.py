"""The statements as data for the installed package: ``python -m paper_checks --data`` writes it."""

import inspect
import json
from pathlib import Path
from typing import Any

from paper_checks.near_misses import WORDS
from paper_checks.registry import PAPERS, Statement, load

ROOT = Path(__file__).parents[1]
DATA = ROOT / "asymptotics" / "papers" / "data.json"


def written() -> str:
    """The contents of the file, from the registry as it is."""
    references = {key: reference for key, (reference, *_) in PAPERS.items()}
    return json.dumps({"papers": references, "statements": [record(s) for s in load().values()]}, indent=1,
                      ensure_ascii=False) + "\n"  # fmt: skip


def record(s: Statement) -> dict[str, Any]:
    """One statement as plain data."""
    return {
        "id": s.id,
        "paper": s.paper,
        "kind": str(s.kind),
        "title": s.title,
        "printed": str(s.verdict),
        "evidence": str(s.evidence),
        "extent": s.extent,
        "latex": s.latex,
        "corrected": s.corrected_latex,
        "conditions": s.conditions,
        "note": s.note,
        "methods": list(s.methods),
        "derivation": s.derivation,
        "line": s.line,
        "paraphrase": s.paraphrase,
        "shortfall": s.shortfall and str(s.shortfall),
        "slip": s.slip,
        "digits": s.digits,
        "order": s.order,
        "near_miss": near_miss(s),
        "source": source(s),
    }


def near_miss(s: Statement) -> str | None:
    """The near miss in words or signs; None if there is none."""
    if s.near_miss is None:
        return None
    if s.id in WORDS:
        return WORDS[s.id]
    return s.near_miss.__name__.strip("_").replace("_", " ") if inspect.isfunction(s.near_miss) else str(s.near_miss)


def source(s: Statement) -> str:
    """File and line of the check."""
    check = inspect.unwrap(s.check)
    return f"{Path(inspect.getsourcefile(check)).relative_to(ROOT)}:{inspect.getsourcelines(check)[1]}"
