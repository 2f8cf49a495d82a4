"""``python -m benchmarks [NAME] [--json | --report FOLDER]``: run one benchmark or all, and print tables of ratios."""

import json
import sys
from importlib import import_module
from pathlib import Path
from time import perf_counter

from asymptotics.cli.shell import complain, emit, run_guarded
from asymptotics.errors import InputError

BENCHMARKS = {
    "smith-rows": "smith_rows",
    "cubic-damping": "cubic_damping",
    "cost-against-order": "cost_against_order",
    "costs": "costs",
    "turning-points": "turning_point_tables",
    "certified-orbits": "certified_orbits",
    "integrators": "integrators",
    "certified-motion": "certified_motion",
    "hypergeometric": "hypergeometric",
    "comparing": "comparing",
    "multiple-scales": "multiple_scales",
    "start-up": "start_up",
    "promises": "promises",
    "identified": "identified",
    "certificates": "certificates",
}
"""The name of each benchmark, and its module: a function ``run`` that takes a size."""


def main(argv: list[str] | None = None) -> int:
    """Run the command: 0, or 2 for a bad name, size or folder."""
    return run_guarded("benchmarks", lambda: _run(argv))


def _run(argv: list[str] | None) -> int:
    parser = import_module("asymptotics.cli.main").Parser(prog="python -m benchmarks", description=__doc__)
    parser.add_argument("name", nargs="?", help=", ".join(BENCHMARKS) + "; without it, all of them")
    parser.add_argument("--size", type=int, help="largest row, order or number of points (default: the stated one)")
    parser.add_argument("--json", action="store_true", help="print JSON")
    parser.add_argument("--report", metavar="FOLDER", help="write JSON, Markdown and a picture there as well")
    parser.add_argument("--store", metavar="FILE", help="of identified: its records one by one; goes on where it was")
    options = parser.parse_args(argv)
    try:
        more = {} if options.store is None else {"store": Path(options.store)}
        if more and options.name != "identified":
            raise InputError("--store", "it keeps the records of one benchmark", "identified --store FILE")
        emit(_answer(options.name, options.size, options.report, as_json=options.json, **more))
    except InputError as error:
        complain(f"benchmarks: {error}")
        return 2
    return 0


def _answer(name: str | None, size: int | None, folder: str | None, *, as_json: bool, **more: Path) -> str:
    """The tables as text, after writing the report if it is wanted."""
    if name is not None and name not in BENCHMARKS:
        raise InputError("name", f"no benchmark {name!r}", ", ".join(BENCHMARKS))
    if size is not None and size < 1:
        raise InputError("--size", f"{size} is too small", "an integer >= 1")
    if folder is not None:  # refused before anything is measured
        import_module("asymptotics.present.files").require_writable(Path(folder), "--report")
    names = [name] if name else list(BENCHMARKS)
    modules = {key: import_module(f"benchmarks.{BENCHMARKS[key]}") for key in names}  # loaded inside the shell
    tables = {}
    for key, module in modules.items():
        start = perf_counter()
        tables[key] = module.run(*(() if size is None else (size,)), **more)
        if sys.stderr is not None:  # print would take None for stdout
            print(f"{key}: {perf_counter() - start:.0f} s", file=sys.stderr, flush=True)
    if folder is not None:
        write = import_module("benchmarks.report").write
        write(Path(folder), tables, {key: module.__doc__ for key, module in modules.items()})
    if as_json:
        return json.dumps({key: table.to_dict() for key, table in tables.items()}, indent=2)
    return "\n\n".join(table.text() for table in tables.values())


if __name__ == "__main__":
    sys.exit(main())
