"""What search.js searches, reduced as ``asymptotics.papers.search`` does it for the shell."""

import json
from typing import Any

from asymptotics.papers import derived, documented
from asymptotics.papers.search import Searched, plain
from asymptotics.papers.statement import PaperStatement
from paper_checks.data import record
from paper_checks.registry import Entry
from paper_checks.report.words import typeset


def search_index(papers: list[dict[str, Any]], entries: dict[str, Entry]) -> str:
    """Tables as a whole, statements, derivations, and the pages of the documentation, which have no link."""
    found = [_table(paper["key"], table) for paper in papers for table in paper["tables"]]
    found += [_statement(card, record(entries[card["id"]].statement)) for paper in papers for card in paper["entries"]]
    for s, d in zip(derived.searched(), derived.derivations()):
        found.append(
            _words(s) | {"shown": d.name, "title": typeset(d.title), "page": "derivations.html", "anchor": d.name}
        )
    for s in documented.searched():
        section = documented.sections()[s.id]
        title = section.heading or section.title
        found.append(_words(s) | {"shown": f"docs/{section.page}", "title": title, "page": ""})
    return json.dumps(found, ensure_ascii=False)


def _words(s: Searched) -> dict[str, str]:
    return {"id": s.id, "plain": s.title, "said": s.plain_words, "formula": s.formula, "notes": s.notes, "verdict": ""}


def _statement(card: dict[str, Any], data: dict[str, Any]) -> dict[str, str]:
    searched = Searched.of(PaperStatement(**{**data, "methods": tuple(data["methods"])}))
    page = card["id"].partition(":")[0] + ".html"
    return _words(searched) | {"title": typeset(card["title"]), "page": page, "verdict": card["printed"]}


def _table(key: str, table: dict[str, Any]) -> dict[str, str]:
    name = table["table"].partition(".")[2]
    searched = Searched(f"{key}:{name}", plain(table["title"]), "table", "", "")
    return _words(searched) | {"title": typeset(table["title"]), "page": f"{key}.html", "anchor": table["table"]}
