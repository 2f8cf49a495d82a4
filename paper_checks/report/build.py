"""Write the report: all contents are made in memory first, then the files appear whole, all of them or none."""

import json
from collections import Counter
from collections.abc import Callable, Iterator
from importlib import import_module
from pathlib import Path
from shutil import which
from typing import Any

import jinja2

from asymptotics import __version__
from asymptotics.made_by import made_by
from asymptotics.papers.search import words_for_pages
from asymptotics.present.figures import renderings
from asymptotics.present.files import write_all
from asymptotics.present.mathml import mathml, whole
from asymptotics.tables.cells import Formula
from asymptotics.tables.registry import build
from asymptotics.tables.standard_set import validated
from paper_checks.data import source
from paper_checks.registry import FOLLOW_UPS, IDENTIFIERS, PAPERS, Entry, Shortfall
from paper_checks.report import pages
from paper_checks.report.certificates import (
    CHECKER_LINES,
    certificate_files,
    certificate_of_table,
    certificates_of,
    listed,
)
from paper_checks.report.difference import marked
from paper_checks.report.engine import engine_data, regimes_picture, stokes_picture, validity_picture
from paper_checks.report.font import font_face
from paper_checks.report.linked import linked
from paper_checks.report.play import play_page
from paper_checks.report.search_index import search_index
from paper_checks.report.sheets import ENGINE, cell, sheet_files, tabular
from paper_checks.report.tex import said, tex
from paper_checks.report.words import LEGEND, OUTCOMES, a_kind, counted, evidence, inline, plain_note
from paper_checks.verdict import Printed

Progress = Callable[[str], None]

TABLES = {
    "lancaster2020": ("lancaster2020.table1",),
    "smith2012": ("smith2012.table1", "smith2012.transit-time"),
}
DIGITS = 20
HEADS = {  # columns as the papers write them
    "alpha": r"\alpha", "A": "A(t)", "half_cycle": "n", "S_hat": r"\hat{S}_{n-1}", "u": "u_{n-1}", "i": "i",
    "c_i": "c_i",
}  # fmt: skip
BESIDE_PLAY = (("The papers, checked", "index.html"),)
PAGES = ("index.html", "errata.html", "derivations.html", "engine.html")
FOLDER = Path(__file__).parent
MEASURED = FOLDER.parents[1] / "docs" / "benchmarks.svg"
"""What ``make benchmarks`` has drawn, if it has been run."""
SLIPS = (Printed.MISPRINT, Printed.TRANSCRIPTION, Printed.PARTLY, Printed.REFUTED)
ERRATA = (
    ("slips", "Slips of the papers", "printed", (Printed.MISPRINT, Printed.REFUTED)),
    ("garbled", "Garbled in the text at hand", "printed", (Printed.TRANSCRIPTION,)),
    ("conditions", "True under a condition that is omitted", "shortfall", (Shortfall.CONDITION,)),
    ("consequences", "Does not follow", "shortfall", (Shortfall.CONSEQUENCE,)),
    ("ranges", "False in a stated range", "shortfall", (Shortfall.RANGE,)),
)
HARMLESS = ("harmless", "Slips that change no statement")


def write_report(folder: Path, entries: list[Entry], progress: Progress = lambda name: None) -> list[Path]:
    """Write the pages, report.json, report.tex and the figures into ``folder``, which exists; returns the paths."""
    contents = {folder / name: content for name, content in _contents(entries, progress).items()}
    write_all(contents, "--report")
    return list(contents)


def _contents(entries: list[Entry], progress: Progress) -> dict[str, bytes | str]:
    contents: dict[str, bytes | str] = dict(_figures(entries, progress))
    data = report_data(entries)
    contents["report.json"] = json.dumps(data, indent=1, ensure_ascii=False)
    tables = [table for paper in data["papers"] for table in paper["tables"]]
    contents["registry.jsonld"] = json.dumps(linked(entries, tables), indent=1, ensure_ascii=False)
    contents["report.tex"] = _template("report.tex.j2").render(data)
    contents |= sheet_files(_template, data)
    made = _pages(data, {e.statement.id: e for e in entries})
    contents["style.css"] = (FOLDER / "style.css").read_text(encoding="utf-8") + font_face(made.values())
    return (
        contents | made | certificate_files() | ({"benchmarks.svg": MEASURED.read_bytes()} if MEASURED.exists() else {})
    )


def _pages(data: dict[str, Any], entries: dict[str, Entry]) -> dict[str, str]:
    """The site: an index, a page for each paper, the errata, the derivations, what goes beyond, and the sources."""
    papers = [
        {
            **p,
            "entries": [{**e, **_shown(entries[e["id"]])} for e in p["entries"]],
            "tables": [
                {**t, "certificate": certificate_of_table(t["table"]), "checker_lines": CHECKER_LINES}
                for t in p["tables"]
            ],
        }
        for p in data["papers"]
    ]
    cards = [e for p in papers for e in p["entries"]]
    shown = {**data, "papers": papers, "errata": [_slips(cards, *kind) for kind in ERRATA]}
    name, title = HARMLESS
    shown["errata"].append({"name": name, "title": title, "entries": [e for e in cards if e["slip"]]})
    shown["measured"] = MEASURED.exists()
    shown["pdf"] = which(ENGINE) is not None
    shown["legend"] = LEGEND
    shown |= {"certificates": listed(), "checker_lines": CHECKER_LINES}
    made = {name: _template(f"{name}.j2").render(shown, derivations=pages.derivations()) for name in PAGES}
    made["play.html"] = play_page(BESIDE_PLAY)
    made |= {f"{p['key']}.html": _template("paper.html.j2").render(shown, paper=p) for p in papers}
    for path in sorted({e["source"].partition(":")[0] for e in cards}):
        page = _template("source.html.j2").render(shown, path=path, lines=pages.source_lines(path))
        made[pages.source_name(path)] = page
    made |= {name: whole(page) for name, page in made.items() if name != "play.html"}  # that one sets its own lines
    script = (FOLDER / "search.js").read_text(encoding="utf-8").replace("{{ index }}", search_index(papers, entries))
    made["search.js"] = script.replace("{{ words }}", json.dumps(words_for_pages(), ensure_ascii=False))
    return made


def _shown(entry: Entry) -> dict[str, Any]:
    """What a card shows beyond the data: the difference marked, the evidence in words, the near miss, the source."""
    s, path = entry.statement, source(entry.statement)
    plain = entry.to_dict()
    return {
        "marked": marked(s.latex, s.corrected_latex) if s.corrected_latex else None,
        "evidence_words": evidence(plain),
        "outcome_words": {name: OUTCOMES[str(outcome)] for name, outcome in entry.outcomes.items()},
        "near_miss_form": pages.near_miss(s) if "near miss" in entry.outcomes else None,
        "apart": pages.apart(entry.apart),
        "source": path,
        "source_page": pages.source_name(path.partition(":")[0]) + "#L" + path.partition(":")[2],
        "section": pages.section_of(s),
        "certificates": certificates_of(s.id),
        "checker_lines": CHECKER_LINES,
    }


def _proved(table: str) -> dict[str, Any]:
    """What a table shows beyond the data: the certificate of its turning points and times."""
    return {"certificate": certificate_of_table(table), "checker_lines": CHECKER_LINES}


def _slips(cards: list[dict[str, Any]], name: str, title: str, field: str, values: tuple[str, ...]) -> dict[str, Any]:
    return {"name": name, "title": title, "entries": [e for e in cards if e[field] in values]}


def report_data(entries: list[Entry]) -> dict[str, Any]:
    """Everything the report says, as plain data."""
    return {
        "command": "paper_checks",
        "version": __version__,
        "made_by": made_by(),
        "summary": dict(Counter(str(e.printed) for e in entries)),
        "engine": engine_data(),
        "papers": [_paper(key, [e for e in entries if e.statement.paper == key]) for key in _papers(entries)],
    }


def _paper(key: str, entries: list[Entry]) -> dict[str, Any]:
    return {
        "key": key,
        "name": key[:-4].capitalize() + " " + key[-4:],
        "reference": PAPERS[key][0],
        **IDENTIFIERS[key],
        "follow_ups": [
            {"arxiv": number, "title": title, "on": on}
            for number, title, ids in FOLLOW_UPS
            if (on := [i for i in ids if i.startswith(key)])
        ],
        "summary": dict(Counter(str(e.printed) for e in entries)),
        "sections": pages.sections(key),
        "entries": [e.to_dict() for e in entries],
        "slips": [e.statement.id for e in entries if e.printed in SLIPS],
        "disagreements": [e.statement.id for e in entries if not e.agrees],
        "tables": [_table(name, entries) for name in TABLES.get(key, ())],
        "figures": [
            {"name": name, "file": f"{key}-{name}", "statement": _statement_of(key, name, entries), "caption": text}
            for name, (text, _) in _pictures(key).items()
        ],
    }


def _table(name: str, entries: list[Entry]) -> dict[str, Any]:
    table = build(name, DIGITS)
    typeset = [[cell.latex if isinstance(cell, Formula) else cell for cell in row] for row in table.rows]
    forms = {e.statement.id: e.statement.corrected_latex or e.statement.latex for e in entries}
    for row, plain_row in zip(typeset, table.rows):  # an entry of the paper as the paper writes it, or as it is right
        form = forms.get(f"{name.replace('.', ':', 1)}.alpha{str(plain_row[0]).replace('/', '-')}")
        if form is not None:
            row[-1] = form
    heads = [HEADS.get(column, rf"\text{{{column.replace('_', ' ')}}}") for column in table.columns]
    return {
        "table": name,
        "title": table.title,
        "columns": list(table.columns),
        "rows": [[str(cell) for cell in row] for row in table.rows],
        "provenance": table.source,
        "validation": validated(table),
        "heads": heads,
        "typeset": typeset,
        "tabular": tabular(heads, typeset),
    }


def _statement_of(key: str, figure: str, entries: list[Entry]) -> str:
    """The statement that a picture belongs to: its own id, or for a panel (fig1a) that of the whole figure (fig1)."""
    ids = {e.statement.id for e in entries}
    return f"{key}:{figure}" if f"{key}:{figure}" in ids else f"{key}:{figure[:-1]}"


def _papers(entries: list[Entry]) -> list[str]:
    return [key for key in PAPERS if any(e.statement.paper == key for e in entries)]


def _pictures(key: str) -> dict[str, tuple[str, Callable[[Any], Any]]]:
    return dict(import_module(f"paper_checks.{key}.figures").FIGURES)


def _figures(entries: list[Entry], progress: Progress) -> Iterator[tuple[str, bytes | str]]:
    for key in _papers(entries):
        for name, (_, draw) in _pictures(key).items():
            svg, png = renderings(draw, ("svg", "png"))
            yield f"{key}-{name}.svg", svg.decode()
            yield f"{key}-{name}.png", png
            progress(f"{key} {name}")
    yield "engine-validity.svg", validity_picture()
    yield "engine-regimes.svg", regimes_picture()
    yield "engine-stokes.svg", stokes_picture()


def _template(name: str) -> jinja2.Template:
    environment = jinja2.Environment(
        loader=jinja2.FileSystemLoader(FOLDER),
        autoescape=name.endswith(".html.j2"),
        undefined=jinja2.StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
    )
    environment.filters["inline_mathml"] = mathml
    environment.filters["mathml"] = lambda latex: mathml(latex, display=True)
    environment.filters |= {"tex": tex, "cell": cell}
    environment.filters |= {"said": said, "counted": counted, "a_kind": a_kind, "note": plain_note}
    environment.filters["signs"] = inline
    return environment.get_template(name)
