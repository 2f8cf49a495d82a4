"""The command ``python -m paper_checks``: read the options, run the checks, print the verdicts."""

import argparse
import json
from collections import Counter
from importlib import import_module
from pathlib import Path

from asymptotics import __version__
from asymptotics.errors import InputError
from asymptotics.made_by import made_by
from asymptotics.present.files import require_writable, write_atomically
from asymptotics.running.progress import progress_bar
from asymptotics.shell.guarded import complain, emit
from asymptotics.shell.main import Parser
from paper_checks import reader
from paper_checks.data import DATA, written
from paper_checks.details import CHANGED, in_words
from paper_checks.registry import PAPERS, Entry, Statement, load
from paper_checks.runner import examine_all, worker_pool

DESCRIPTION = """Check the statements of the papers and write the report.

  python -m paper_checks                       check everything, print a summary
  python -m paper_checks smith2012 --json      one paper, as JSON
  python -m paper_checks --id smith2012:62b    one statement with its outcomes
  python -m paper_checks --markdown            the table of verdicts for the README
  python -m paper_checks --report build/report write index.html, report.json, report.tex and the figures

Exit code 0 if every verdict is borne out, 1 if one is not, 2 for a bad value.
"""


def run(argv: list[str] | None = None) -> int:
    """Run the command; returns the exit code.  argparse leaves it by SystemExit."""
    options = _parser().parse_args(argv)
    try:
        return _run(options)
    except InputError as error:
        complain(f"paper_checks: {error}")
        return 2


def _parser() -> argparse.ArgumentParser:
    parser = Parser(
        prog="python -m paper_checks",
        description=DESCRIPTION,
        formatter_class=argparse.RawDescriptionHelpFormatter,
        allow_abbrev=False,
    )
    parser.add_argument("paper", nargs="?", metavar="PAPER", help=f"one of {', '.join(PAPERS)} (default: all)")
    parser.add_argument("--id", metavar="ID", help="one statement, e.g. smith2012:62b")
    parser.add_argument("--json", action="store_true", help="print the entries as JSON")
    parser.add_argument("--markdown", action="store_true", help="print the summary table of the README")
    parser.add_argument("--compared", action="store_true", help="write the ledger of what was compared by hand")
    parser.add_argument("--data", action="store_true", help="write the statements for the installed package, no check")
    parser.add_argument("--report", metavar="DIR", help="write the report into this folder")
    return parser


def _run(options: argparse.Namespace) -> int:
    if options.compared:
        write_atomically(reader.LEDGER, reader.written(load().values()))
        return 0
    if options.data:
        write_atomically(DATA, written())
        return 0
    if options.report == "":
        raise InputError("--report", "the name is empty", "a folder")
    entries = _select(options.paper, options.id)
    if options.report is not None:
        require_writable(Path(options.report), "--report")
    results = _examine(entries)
    if options.report is not None:
        report = import_module("paper_checks.report")  # loads matplotlib and jinja2, which checks do without
        with progress_bar(None, unit="file", title="report") as bar:
            paths = report.write_report(Path(options.report), results, lambda name: bar.set_postfix_str(name))
        complain(f"wrote {len(paths)} files; open {Path(options.report) / 'index.html'}")
    if options.markdown:
        emit(import_module("paper_checks.report.summary").markdown_summary(results))
    else:
        _print(results, as_json=options.json, in_full=options.id is not None)
    return int(not all(result.agrees for result in results))


def _select(paper: str | None, key: str | None) -> list[Statement]:
    if paper is not None and paper not in PAPERS:
        raise InputError("PAPER", f"no paper {paper!r}", ", ".join(PAPERS))
    if key is None:
        return list(load(paper).values())
    named = key.partition(":")[0]
    if paper is not None and named in PAPERS and named != paper:
        raise InputError("--id", f"{key} is not a statement of {paper}", f"an id that begins with {paper}:")
    entries = load(named if named in PAPERS else paper)
    if key not in entries:
        raise InputError("--id", f"no statement {key!r}", f"one of the {len(entries)} ids that --json lists")
    return [entries[key]]


def _examine(entries: list[Statement]) -> list[Entry]:
    with progress_bar(len(entries), unit="check", title="checks") as bar:
        if len(entries) == 1:
            return examine_all(entries, progress=lambda _: bar.update())
        with worker_pool() as pool:
            return examine_all(entries, pool, progress=lambda _: bar.update())


def _print(results: list[Entry], *, as_json: bool, in_full: bool) -> None:
    if as_json:
        entries = [result.to_dict() for result in results]
        data = {"command": "paper_checks", "version": __version__, "entries": entries, "made_by": made_by()}
        emit(json.dumps(data, indent=2, ensure_ascii=False))
        return
    if in_full:
        emit(in_words(results[0]))
        return
    for result in results:
        if not result.agrees:
            emit(f"DISAGREES {result.statement.id}: {dict(result.outcomes) if result.compared else CHANGED}")
    counts = Counter(str(result.printed) for result in results)
    emit(f"{len(results)} statements: " + ", ".join(f"{count} {name}" for name, count in counts.most_common()))
