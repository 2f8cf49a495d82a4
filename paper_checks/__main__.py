"""``python -m paper_checks``: the first lines that run, inside the shell that answers Ctrl-C."""

import sys
from importlib import import_module

from asymptotics.shell.guarded import run_guarded


def main(argv: list[str] | None = None) -> int:
    """Run the command; returns the exit code."""
    return run_guarded("paper_checks", lambda: int(import_module("paper_checks.command").run(argv)), last=argv is None)


if __name__ == "__main__":
    sys.exit(main())
