"""Every table at 30 digits as CSV, JSON, LaTeX, and an index: ``make tables`` runs it with a folder."""

import sys
from importlib import import_module
from pathlib import Path

from asymptotics.errors import InputError
from asymptotics.shell.guarded import complain, emit, run_guarded


def main(argv: list[str] | None = None) -> int:
    """Run the command; 0, or 2 for a folder that cannot be written."""
    return run_guarded("tables", lambda: _run(argv), last=argv is None)


def _run(argv: list[str] | None) -> int:
    make = import_module("asymptotics.shell.main").Parser  # inside the shell, as all that takes its time to load
    parser = make(prog="python -m asymptotics.shell.standard_tables", description=__doc__)
    parser.add_argument("folder", help="made if it does not exist")
    folder = parser.parse_args(argv).folder
    try:
        # An empty name would be the current folder, which nobody means by it.
        if not folder:
            raise InputError("FOLDER", "the name is empty", "a folder")
        tables = import_module("asymptotics.tables.standard_set").standard_set(Path(folder))
    except InputError as error:
        complain(f"tables: {error}")
        return 2
    emit(f"{len(tables)} tables in {folder}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
