"""``python -m benchmarks [NAME] [--json | --report FOLDER]``: run one benchmark or all, and print tables of ratios."""

import argparse
import json
import sys
from collections.abc import Callable
from importlib import import_module
from pathlib import Path

from benchmarks import (
    certified_motion,
    certified_orbits,
    comparing,
    cost_against_order,
    cubic_damping,
    hypergeometric,
    integrators,
    promises,
    smith_rows,
    start_up,
    turning_point_tables,
)
from benchmarks.report import write
from benchmarks.table import Table

BENCHMARKS: dict[str, Callable[..., Table]] = {
    "smith-rows": smith_rows.run,
    "cubic-damping": cubic_damping.run,
    "cost-against-order": cost_against_order.run,
    "turning-points": turning_point_tables.run,
    "certified-orbits": certified_orbits.run,
    "integrators": integrators.run,
    "certified-motion": certified_motion.run,
    "hypergeometric": hypergeometric.run,
    "comparing": comparing.run,
    "start-up": start_up.run,
    "promises": promises.run,
}


def main(argv: list[str] | None = None) -> int:
    """Run the command: 0, or 2 for a bad name or size."""
    parser = argparse.ArgumentParser(prog="python -m benchmarks", description=__doc__)
    parser.add_argument("name", nargs="?", help=", ".join(BENCHMARKS) + "; without it, all of them")
    parser.add_argument("--size", type=int, help="largest row, order or number of points (default: the stated one)")
    parser.add_argument("--json", action="store_true", help="print JSON")
    parser.add_argument("--report", metavar="FOLDER", help="write JSON, Markdown and a picture there as well")
    options = parser.parse_args(argv)
    if options.name is not None and options.name not in BENCHMARKS:
        print(f"argument name: no benchmark {options.name!r} (accepted: {', '.join(BENCHMARKS)})", file=sys.stderr)
        return 2
    if options.size is not None and options.size < 1:
        print(f"argument --size: {options.size} is too small (accepted: an integer >= 1)", file=sys.stderr)
        return 2
    sizes = () if options.size is None else (options.size,)
    names = [options.name] if options.name else list(BENCHMARKS)
    tables = {name: BENCHMARKS[name](*sizes) for name in names}
    if options.report is not None:
        write(
            Path(options.report), tables, {name: import_module(BENCHMARKS[name].__module__).__doc__ for name in names}
        )
    if options.json:
        print(json.dumps({name: table.to_dict() for name, table in tables.items()}, indent=2))
    else:
        print("\n\n".join(table.text() for table in tables.values()))
    return 0


if __name__ == "__main__":
    sys.exit(main())
