"""``python -m benchmarks [NAME] [--json | --report FOLDER]``: run one benchmark or all, and print tables of ratios.

A peer that is wanted and missing is an error before anything is measured; ``--no-peers`` measures ours alone.
"""

import json
import sys
from collections.abc import Mapping
from concurrent.futures import ProcessPoolExecutor
from contextlib import nullcontext
from importlib import import_module
from multiprocessing import get_context
from pathlib import Path

from asymptotics.errors import InputError
from asymptotics.shell.guarded import complain, emit, run_guarded
from benchmarks import peers
from benchmarks.table import measured

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
    "fits": "fits",
    "identified": "identified",
    "certificates": "certificates",
    "double-errors": "double_errors",
}
"""The name of each benchmark, and its module: a function ``run`` that takes a size, and the ``PEERS`` that it asks."""
WHOLE = {"identified": 15, "fits": 10, "double-errors": 12}
"""Sizes of a run of all benchmarks that are not the stated ones: a record of each class; two of each law; a third of
the laws."""
BESIDE = ("identified", "fits")
"""What counts more than it times: in a run of all benchmarks a second process makes them meanwhile."""
QUICK = {
    "smith-rows": 200, "cubic-damping": 1, "cost-against-order": 16, "costs": 10, "turning-points": 300,
    "certified-orbits": 20, "integrators": 100, "certified-motion": 400, "hypergeometric": 300, "comparing": 10_000,
    "multiple-scales": 1, "start-up": 1, "promises": 4, "fits": 3, "identified": 2, "certificates": 2,
    "double-errors": 1,
}  # fmt: skip
"""Sizes of ``--quick``."""


def main(argv: list[str] | None = None) -> int:
    """Run the command: 0, or 2 for a bad name, size or folder."""
    return run_guarded("benchmarks", lambda: _run(argv), last=argv is None)


def _run(argv: list[str] | None) -> int:
    parser = import_module("asymptotics.shell.main").Parser(prog="python -m benchmarks", description=__doc__)
    parser.add_argument("name", nargs="?", help=", ".join(BENCHMARKS) + "; without it, all of them")
    parser.add_argument("--size", type=int, help="largest row, order or number of points (default: the stated one)")
    parser.add_argument("--quick", action="store_true", help="smaller sizes, all benchmarks in a minute")
    parser.add_argument("--no-peers", action="store_true", help="measure ours alone; else a missing peer is an error")
    parser.add_argument("--json", action="store_true", help="print JSON")
    parser.add_argument("--report", metavar="FOLDER", help="write JSON, Markdown and a picture there as well")
    parser.add_argument("--store", metavar="FILE", help="of identified: its records one by one; goes on where it was")
    options = parser.parse_args(argv)
    try:
        more = {} if options.store is None else {"store": Path(options.store)}
        if more and options.name != "identified":
            raise InputError("--store", "it keeps the records of one benchmark", "identified --store FILE")
        if options.size is not None and options.quick:
            raise InputError("--size", "--quick has sizes of its own", "one of the two")
        if options.size is not None and options.size < 1:
            raise InputError("--size", f"{options.size} is too small", "an integer >= 1")
        given = dict.fromkeys(BENCHMARKS, options.size) if options.size else {} if options.name else WHOLE
        sizes = QUICK if options.quick else given
        with peers.none() if options.no_peers else nullcontext():
            emit(_answer(options.name, sizes, options.report, as_json=options.json, **more))
    except InputError as error:
        complain(f"benchmarks: {error}")
        return 2
    return 0


def _answer(name: str | None, sizes: Mapping[str, int], folder: str | None, *, as_json: bool, **more: Path) -> str:
    """The tables as text, after writing the report if it is wanted; what has no size takes the stated one."""
    if name is not None and name not in BENCHMARKS:
        raise InputError("name", f"no benchmark {name!r}", ", ".join(BENCHMARKS))
    if folder is not None:  # refused before anything is measured
        import_module("asymptotics.present.files").require_writable(Path(folder), "--report")
    names = [name] if name else list(BENCHMARKS)
    modules = {key: import_module(f"benchmarks.{BENCHMARKS[key]}") for key in names}  # loaded inside the shell
    wanted = {peer: None for module in modules.values() for peer in getattr(module, "PEERS", ())}
    peers.require(list(wanted))
    with ProcessPoolExecutor(1, get_context("spawn"), peers.use, (peers.PYTHON,)) as another:
        calls = {key: (key, f"benchmarks.{BENCHMARKS[key]}", sizes.get(key)) for key in names}
        later = {key: another.submit(measured, *calls[key]) for key in names if not name and key in BESIDE}
        made = {key: measured(*calls[key], **more) for key in names if key not in later}
        made |= {key: future.result() for key, future in later.items()}
    tables = {key: made[key] for key in names}
    if folder is not None:
        write = import_module("benchmarks.report").write
        write(Path(folder), tables, {key: module.__doc__ for key, module in modules.items()})
    if as_json:
        return json.dumps({key: table.to_dict() for key, table in tables.items()}, indent=2)
    return "\n\n".join(table.text() for table in tables.values())


if __name__ == "__main__":
    sys.exit(main())
