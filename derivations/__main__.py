"""``python -m derivations [NAME] [--latex]``: run a derivation and print it; without a name, list them."""

import argparse
import sys
from importlib import import_module
from pathlib import Path

NOT_DERIVATIONS = {"__init__", "__main__", "steps", "waiting"}


def names() -> list[str]:
    """The names of all derivations: the modules of this package, with hyphens."""
    stems = {path.stem for path in Path(__file__).parent.glob("*.py")}
    return sorted(stem.replace("_", "-") for stem in stems - NOT_DERIVATIONS)


def main(argv: list[str] | None = None) -> int:
    """Run the command; 0 if every step was asserted, 1 if one failed, 2 for an unknown name."""
    parser = argparse.ArgumentParser(prog="python -m derivations", description=__doc__)
    parser.add_argument("name", nargs="?", help="a derivation; without it, the list")
    parser.add_argument("--latex", action="store_true", help="print LaTeX instead of text")
    options = parser.parse_args(argv)
    if options.name is None:
        print("\n".join(names()))
        return 0
    if options.name not in names():
        print(f"argument name: no derivation {options.name!r} (accepted: {', '.join(names())})", file=sys.stderr)
        return 2
    try:
        derivation = import_module("derivations." + options.name.replace("-", "_")).derivation
    except AssertionError as failure:
        print(f"failed: {failure}", file=sys.stderr)
        return 1
    print(derivation.latex() if options.latex else derivation.text())
    return 0


if __name__ == "__main__":
    sys.exit(main())
