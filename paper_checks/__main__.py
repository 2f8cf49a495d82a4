"""Check the statements of the papers and write the report.

  python -m paper_checks                       check everything, print a summary
  python -m paper_checks smith2012 --json      one paper, as JSON
  python -m paper_checks --id smith2012:62b    one statement with its outcomes
  python -m paper_checks --markdown            the table of verdicts for the README
  python -m paper_checks --report build/report write index.html, report.json, report.tex and the figures

Exit code 0 if every verdict is borne out, 1 if one is not, 2 for a bad value.
"""

import argparse
import json
import os
import sys
from collections import Counter
from concurrent.futures import ProcessPoolExecutor
from importlib import import_module
from pathlib import Path

from tqdm import tqdm

from asymptotics import __version__
from asymptotics.cli.main import Parser
from asymptotics.errors import InputError
from asymptotics.present.files import require_writable
from paper_checks.details import in_words
from paper_checks.registry import PAPERS, Entry, Statement, load
from paper_checks.runner import examine_all


def main(argv: list[str] | None = None) -> int:
    """Run the command; returns the exit code."""
    options = _parser().parse_args(argv)
    try:
        return _run(options)
    except InputError as error:
        print(f"paper_checks: {' '.join(str(error).split())}", file=sys.stderr)
        return 2
    except KeyboardInterrupt:
        print("paper_checks: interrupted; no file was left half-written", file=sys.stderr)
        return 130


def _parser() -> argparse.ArgumentParser:
    parser = Parser(
        prog="python -m paper_checks",
        description=__doc__,
        formatter_class=argparse.RawDescriptionHelpFormatter,
        allow_abbrev=False,
    )
    parser.add_argument("paper", nargs="?", metavar="PAPER", help=f"one of {', '.join(PAPERS)} (default: all)")
    parser.add_argument("--id", metavar="ID", help="one statement, e.g. smith2012:62b")
    parser.add_argument("--json", action="store_true", help="print the entries as JSON")
    parser.add_argument("--markdown", action="store_true", help="print the summary table of the README")
    parser.add_argument("--report", metavar="DIR", help="write the report into this folder")
    return parser


def _run(options: argparse.Namespace) -> int:
    if options.report == "":
        raise InputError("--report", "the name is empty", "a folder")
    if options.report is not None:
        require_writable(Path(options.report), "--report")
    entries = _select(options.paper, options.id)
    results = _examine(entries)
    if options.report is not None:
        report = import_module("paper_checks.report")  # loads matplotlib and jinja2, which checks do without
        with _bar("report", len(entries)) as bar:
            paths = report.write_report(Path(options.report), results, lambda name: bar.set_postfix_str(name))
        print(f"wrote {len(paths)} files; open {Path(options.report) / 'index.html'}", file=sys.stderr)
    if options.markdown:
        print(import_module("paper_checks.report.summary").markdown_summary(results))
    else:
        _print(results, as_json=options.json, in_full=options.id is not None)
    return int(not all(result.agrees for result in results))


def _select(paper: str | None, key: str | None) -> list[Statement]:
    if paper is not None and paper not in PAPERS:
        raise InputError("PAPER", f"no paper {paper!r}", ", ".join(PAPERS))
    if key is None:
        return list(load(paper).values())
    named = key.partition(":")[0]
    entries = load(named if named in PAPERS else paper)
    if key not in entries:
        raise InputError("--id", f"no statement {key!r}", f"one of the {len(entries)} ids that --json lists")
    return [entries[key]]


def _examine(entries: list[Statement]) -> list[Entry]:
    with _bar("checks", len(entries)) as bar:
        if len(entries) == 1:
            return examine_all(entries, progress=lambda _: bar.update())
        with ProcessPoolExecutor(os.cpu_count()) as pool:
            return examine_all(entries, pool, progress=lambda _: bar.update())


def _bar(title: str, total: int) -> tqdm:
    return tqdm(total=total, desc=title, leave=False, disable=not sys.stderr.isatty())


def _print(results: list[Entry], *, as_json: bool, in_full: bool) -> None:
    if as_json:
        entries = [result.to_dict() for result in results]
        data = {"command": "paper_checks", "version": __version__, "entries": entries}
        print(json.dumps(data, indent=2, ensure_ascii=False))
        return
    if in_full:
        print(in_words(results[0]))
        return
    for result in results:
        if not result.agrees:
            print(f"DISAGREES {result.statement.id}: {dict(result.outcomes)}")
    counts = Counter(str(result.printed) for result in results)
    print(f"{len(results)} statements: " + ", ".join(f"{count} {name}" for name, count in counts.most_common()))


if __name__ == "__main__":
    sys.exit(main())
