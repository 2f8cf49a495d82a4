"""The statements as data for the installed package: ``python -m paper_checks --data`` writes it."""

import ast
import inspect
import json
import re
from collections import Counter
from pathlib import Path
from typing import Any

from derivations.__main__ import names as derivation_names
from paper_checks.near_misses import WORDS
from paper_checks.registry import FOLLOW_UPS, IDENTIFIERS, PAPERS, Statement, load

ROOT = Path(__file__).parents[1]
DOCS = ROOT / "docs"
UNREAD = ("maintainers", "changelog", "api", "parity", "auto_gallery", "reference", "benchmarks", "theory/figures")
"""Pages that nobody looks things up in, and what `make docs` and `make benchmarks` write there."""
DATA = ROOT / "asymptotics" / "papers" / "data.json"


def written() -> str:
    """The contents of the file, from the registry as it is."""
    references = {key: reference for key, (reference, *_) in PAPERS.items()}
    known = {
        "papers": references,
        "identifiers": IDENTIFIERS,
        "follow_ups": [{"arxiv": number, "title": title, "on": list(ids)} for number, title, ids in FOLLOW_UPS],
        "statements": [record(s) for s in load().values()],
        "derivations": derivation_records(),
        "documentation": doc_records(),
    }
    return json.dumps(known, indent=1, ensure_ascii=False) + "\n"


def derivation_records() -> list[dict[str, Any]]:
    """The derivations without running them: by paper in the order of its statements, then those beyond the papers."""
    cited: dict[str, list[str]] = {}
    for s in load().values():
        if s.derivation is not None:
            cited.setdefault(s.derivation, []).append(s.id)
    found = [_derivation_record(name, cited.get(name, [])) for name in derivation_names()]
    order = list(load())
    return sorted(found, key=lambda record: _place(record, order))


def _place(record: dict[str, Any], order: list[str]) -> tuple[int, int, str]:
    """The place of the first statement of its paper that cites it; what belongs to no paper comes last, by name."""
    own = [i for i in record["statements"] if i.startswith(record["paper"])]
    return (0, order.index(own[0]), record["name"]) if record["paper"] else (1, 0, record["name"])


def _belongs(name: str, ids: list[str]) -> str:
    """The paper of a derivation: that of its name, if this says one, else the one that cites it most.

    >>> _belongs("lelas-friction", ["lancaster2020:16", "lelas2024:22"]), _belongs("creep", ["smith2012:70"])
    ('lelas2024', 'smith2012')
    """
    cited = Counter(i.partition(":")[0] for i in ids)
    of_name = [key for key in cited if key.startswith(name.partition("-")[0])]
    return of_name[0] if of_name else max(cited, key=cited.__getitem__, default="")


def _derivation_record(name: str, ids: list[str]) -> dict[str, Any]:
    """Name, title and source as they stand in the file, with the statements that cite it."""
    path = ROOT / "derivations" / (name.replace("-", "_") + ".py")
    calls = (node for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))) if isinstance(node, ast.Call))
    call = next(node for node in calls if getattr(node.func, "id", "") == "Derivation")
    given = [ast.literal_eval(node) for node in call.args] + [ast.literal_eval(k.value) for k in call.keywords]
    paper = _belongs(name, ids)
    own = [i for i in ids if i.startswith(paper)]
    section = inspect.unwrap(load()[own[0]].check).__module__.rpartition(".")[2] if own else ""
    return {"name": name, "title": given[1], "source": given[2], "paper": paper, "section": section, "statements": ids}


def doc_records() -> list[dict[str, Any]]:
    """The pages of the documentation that people read, by title and headings; those of the gallery by their titles."""
    found = []
    for path in sorted(DOCS.rglob("*.md")):
        page = path.relative_to(DOCS).with_suffix("").as_posix()
        if page.startswith(UNREAD):
            continue
        text = re.sub(r"(?s)^(`{3,}|:{3,}).*?^\1", "", path.read_text(encoding="utf-8"), flags=re.M)
        heads = [re.sub(r"[`*$]", "", head).strip() for head in re.findall(r"(?m)^#{1,3} (.+)$", text)]
        found.append({"page": page, "title": heads[0], "headings": heads[1:]})
    for path in sorted((DOCS / "gallery").glob("plot_*.py")):
        title = str(ast.get_docstring(ast.parse(path.read_text(encoding="utf-8")))).partition("\n")[0]
        found.append({"page": f"gallery/{path.stem}", "title": title, "headings": []})
    return found


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
    """The near miss in words or signs, with what it stands in place of; None if there is none.

    >>> [near_miss(load()[key]) for key in ("lelas2024:4", "lelas2024:8", "smith2012:60b")]
    ['sgn 0 = 1, in place of 0', 'f**2*x_0*cos(omega_0*t) in place of f*x_0*cos(omega_0*t)', '1/3 w in place of 2/3 w']
    """
    form, right = s.near_miss, s.printed if s.corrected is None else s.corrected
    if form is None or s.id in WORDS:
        return WORDS.get(s.id)
    pairs = [(form, right)]
    if isinstance(form, tuple) and isinstance(right, tuple) and len(form) == len(right):
        pairs = [(a, b) for a, b in zip(form, right) if a != b]
    return "; ".join(_plain(a) + ("" if b is None else f" in place of {_plain(b)}") for a, b in pairs)


def _plain(form: Any) -> str:
    """A part of a form as text: a polynomial in w from its coefficients, several in brackets, else as it prints."""
    if isinstance(form, dict):
        return " + ".join(f"{c} w^{n}".removesuffix(" w^0").removesuffix("^1") for n, c in form.items())
    return f"({', '.join(map(_plain, form))})" if isinstance(form, tuple) else str(form)


def source(s: Statement) -> str:
    """File and line of the check."""
    check = inspect.unwrap(s.check)
    return f"{Path(check.__code__.co_filename).relative_to(ROOT)}:{check.__code__.co_firstlineno}"
