"""The first lines that run: nothing is imported before the shell that turns an interrupt into one line stands.

Ctrl-C while the libraries load (a third of a second) would otherwise end in their tracebacks, so this file and
``cli.shell`` import the standard library only, and the command line itself is loaded inside the shell.  The collector
of cycles finds nothing while SymPy loads, and costs a tenth of a short command: here it waits for more objects.
"""

import gc
import sys
from importlib import import_module

from asymptotics.cli.shell import run_guarded

# The usual threshold is some 700 objects; SymPy makes far more while it loads, and nearly all of them live.  A smaller
# number looks in vain more often: it costs time and changes nothing else.
_OBJECTS = 50_000


def main(argv: list[str] | None = None) -> int:
    """The console script ``asymptotics``; returns the exit code."""
    gc.set_threshold(_OBJECTS)
    return run_guarded("asymptotics", lambda: int(import_module("asymptotics.cli.main").run(argv)), last=argv is None)


if __name__ == "__main__":
    sys.exit(main())
