"""The files of --csv, --plot, --html, --certificate: refused before the work, written all together or not at all.

>>> read_files(argparse.Namespace(points=None))
{}
"""

import argparse
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any

from asymptotics.ask.answers import read_points
from asymptotics.ask.question import Question
from asymptotics.errors import InputError
from asymptotics.numbers.exact import parse_real
from asymptotics.numbers.integers import parse_integer
from asymptotics.present.drawn import Drawn, pictured
from asymptotics.present.figures import DPI, MAX_DPI, MIN_DPI
from asymptotics.present.files import require_different, target_file, write_all
from asymptotics.present.inputs import MOVED_BY, with_inputs, with_words
from asymptotics.running.cut_short import changed

FILES = ("plot", "csv", "html", "certificate")
"""The options that name a file that is written."""
PICTURES = (".svg", ".png", ".pdf")
Makers = dict[str, Callable[[str], str | bytes]]


def picture_maker(
    options: argparse.Namespace, results: Callable[[], Sequence[Drawn]], **style: Any
) -> Callable[[str], bytes]:
    """What makes the file of --plot: the ``plot`` of the results, on the same axes."""
    sides = None if options.size is None else _sides(options.size)
    dots = DPI if options.dpi is None else parse_integer(options.dpi, "--dpi", MIN_DPI, MAX_DPI)

    def made(kind: str) -> bytes:
        with changed(lambda _: None):  # what a curve has computed when the time was over is no part of the answer
            return pictured(results(), kind, size=sides, dpi=dots, **style)

    return made


def _sides(text: str) -> tuple[float, float]:
    sides = text.lower().split("x")
    if len(sides) != 2:
        raise InputError("--size", f"{text[:40]!r} is no size", "two numbers of inches, such as 8x5")
    wide, high = (float(parse_real(side, "--size").ball().mid()) for side in sides)
    return wide, high


def read_files(options: argparse.Namespace, pictures: tuple[str, ...] = PICTURES) -> dict[str, Path]:
    """The files asked for, by option, after proving that each can be written; InputError otherwise.

    ``pictures``: the suffixes that --plot may have.
    """
    named = {f"--{name}": getattr(options, name, None) for name in FILES}
    found = {argument: _file(name, argument, pictures) for argument, name in named.items() if name is not None}
    require_different(dict(found))
    if "--csv" in found and getattr(options, "points", None) is not None:
        read_points(options)
    return found


def write_files(
    files: dict[str, Path],
    makers: Makers,
    options: argparse.Namespace | None = None,
    question: Question | None = None,
) -> list[str]:
    """Make all contents, then write them; a maker gets the kind of its file (csv, or that of the picture).

    With ``options`` the head of a table says which oscillator it is of, so that ``compare`` can be asked without it;
    with ``question`` it says the whole request.
    """
    # All contents before the first byte is written: a picture that fails leaves no table behind.
    contents = {path: makers[argument](_kind(path, argument)) for argument, path in files.items()}
    table = contents.get(files["--csv"]) if "--csv" in files and options is not None else None
    again = None if question is None else question.offers.again
    # A table that holds its request itself, with its data in the place of their file, has it already.
    if isinstance(table, str) and not (again is not None and again.words):
        words = [] if question is None or options is None else question.words(options)
        contents[files["--csv"]] = (
            with_words(table, words)
            if words
            else with_inputs(table, {name: getattr(options, name, None) for name in MOVED_BY})
        )
    write_all(contents, " and ".join(files))
    return [str(path) for path in files.values()]


def _kind(path: Path, argument: str) -> str:
    return path.suffix.lower()[1:] if argument == "--plot" else "csv"


def _file(name: str, argument: str, pictures: tuple[str, ...]) -> Path:
    if argument == "--plot" and Path(name).suffix.lower() not in pictures:
        raise InputError(argument, f"{name!r} has no suffix of a picture", " or ".join(pictures))
    if argument == "--html" and Path(name).suffix.lower() not in (".html", ".htm"):
        raise InputError(argument, f"{name!r} has no suffix of a page", ".html")
    if argument == "--certificate" and Path(name).suffix.lower() != ".json":
        raise InputError(argument, f"{name!r} has no suffix of a certificate", ".json")
    return target_file(name, argument)
