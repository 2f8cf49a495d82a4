"""All questions: the files of ``questions``, found there, each loaded when it is asked.

>>> "stokes" in QUESTIONS, "stokes" in SWEPT, loaded("stokes").name
(True, True, 'stokes')
"""

from functools import cache
from importlib import import_module
from pathlib import Path
from typing import TYPE_CHECKING

if TYPE_CHECKING:  # a list of commands needs no question, and none of the libraries that one loads
    from asymptotics.ask.question import Question

_FOLDER = Path(__file__).parent / "questions"
_FILES = {p.stem.strip("_").replace("_", "-"): p for p in sorted(_FOLDER.glob("*.py")) if not p.stem.startswith("__")}
ANSWERING = tuple(_FILES)
"""All of them; those in files with a leading underscore are asked by another command, and by the header of a file."""
QUESTIONS = tuple(name for name in sorted(ANSWERING) if not _FILES[name].stem.startswith("_"))
"""Those that are commands."""
SWEPT = tuple(name for name in QUESTIONS if "swept=True" in _FILES[name].read_text(encoding="utf-8"))
"""Those that answer one set of values with one record."""


@cache
def summary(name: str) -> str:
    """The first line of its file, a docstring, read without loading it or reading the rest."""
    with _FILES[name].open(encoding="utf-8") as file:
        return file.readline().strip().strip('"').rstrip(".")


def loaded(name: str) -> "Question":
    """The question of that name; its module, and what it needs, is loaded now."""
    module = import_module(f"asymptotics.ask.questions.{_FILES[name].stem}")
    found: list[Question] = [v.__question__ for v in vars(module).values() if hasattr(v, "__question__")]
    return next(q for q in found if q.name == name)
