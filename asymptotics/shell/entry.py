"""The first lines that run: nothing is imported before the shell that turns an interrupt into one line stands.

Ctrl-C while the libraries load (a third of a second) would otherwise end in their tracebacks, so this file and
``cli.shell`` import the standard library only, and the command line itself is loaded inside the shell.  The collector
of cycles finds nothing while SymPy loads, and costs a tenth of a short command: here it waits for more objects.
"""

import gc
import sys
from importlib import import_module
from types import ModuleType

from asymptotics.shell.guarded import REFUSED, complain, run_guarded

# The usual threshold is some 700 objects; SymPy makes far more while it loads, and nearly all of them live.  A smaller
# number looks in vain more often: it costs time and changes nothing else.
_OBJECTS = 50_000


def spoilt(package: ModuleType) -> str | None:
    """What is wrong with the package that this file stands in, where its first file is gone or another's; else None.

    Another distribution installs a package of this name: what came last has overwritten our first file, and its removal
    has taken it away, while all the others are still there.

    >>> spoilt(import_module("asymptotics")) is None, spoilt(ModuleType("asymptotics"))
    (True, 'its __init__.py is missing')
    """
    if getattr(package, "__file__", None) is None:
        return "its __init__.py is missing"
    return None if "expand" in getattr(package, "__all__", ()) else "its __init__.py is another's"


def main(argv: list[str] | None = None) -> int:
    """The console script ``asymptotics``; returns the exit code."""
    gc.set_threshold(_OBJECTS)
    wrong = spoilt(import_module("asymptotics"))
    if wrong is not None:
        accepted = "pip uninstall asymptotics, then pip install --force-reinstall . in a clone"
        complain(f"asymptotics: {wrong}: another distribution of this name was here (accepted: {accepted})")
        return REFUSED
    return run_guarded("asymptotics", lambda: int(import_module("asymptotics.shell.main").run(argv)), last=argv is None)


if __name__ == "__main__":
    sys.exit(main())
