"""``python -m derivations [NAME] [--latex]``: run a derivation and print it; without a name, list them.

``--latex`` prints a document that compiles by itself; without a name, one with all derivations.
"""

import sys
from importlib import import_module
from pathlib import Path
from typing import TYPE_CHECKING

from asymptotics.errors import InputError
from asymptotics.shell.guarded import complain, emit, run_guarded

if TYPE_CHECKING:  # SymPy is loaded inside the shell, which answers Ctrl-C
    from derivations.steps import Derivation

NOT_DERIVATIONS = {"__init__", "__main__", "breaking", "document", "pieces", "relations", "steps", "waiting", "words"}


def names() -> list[str]:
    """The names of all derivations: the modules of this package, with hyphens."""
    stems = {path.stem for path in Path(__file__).parent.glob("*.py")}
    return sorted(stem.replace("_", "-") for stem in stems - NOT_DERIVATIONS)


def derivation(name: str) -> "Derivation":
    """Run a derivation; AssertionError if a step fails."""
    found: Derivation = import_module("derivations." + name.replace("-", "_")).derivation
    return found


def main(argv: list[str] | None = None) -> int:
    """Run the command; 0 if every step was asserted, 1 if one failed, 2 for an unknown name."""
    return run_guarded("derivations", lambda: _run(argv), last=argv is None)


def _run(argv: list[str] | None) -> int:
    parser = import_module("asymptotics.shell.main").Parser(prog="python -m derivations", description=__doc__)
    parser.add_argument("name", nargs="?", help="a derivation; without it, the list")
    parser.add_argument("--latex", action="store_true", help="print LaTeX instead of text")
    options = parser.parse_args(argv)
    if options.name is None and not options.latex:
        emit("\n".join(names()))
        return 0
    if options.name is not None and options.name not in names():
        error = InputError("name", f"no derivation {options.name!r}", "a name that the command without one lists")
        complain(f"derivations: {error}")
        return 2
    try:
        found = [derivation(name) for name in ([options.name] if options.name else names())]
    except AssertionError as failure:
        complain(f"failed: {failure}")
        return 1
    emit(import_module("derivations.document").document(found) if options.latex else found[0].text())
    return 0


if __name__ == "__main__":
    sys.exit(main())
