"""All questions: the files of ``questions``, found there, each loaded when it is asked.

>>> "stokes" in QUESTIONS, loaded("stokes").name
(True, 'stokes')
"""

import ast
from importlib import import_module
from pathlib import Path
from typing import TYPE_CHECKING

if TYPE_CHECKING:  # a list of commands needs no question, and none of the libraries that one loads
    from asymptotics.ask.question import Question

_FOLDER = Path(__file__).parent / "questions"
QUESTIONS = tuple(sorted(p.stem.replace("_", "-") for p in _FOLDER.glob("*.py") if not p.stem.startswith("_")))


def summary(name: str) -> str:
    """The first line of its file, read without loading it."""
    text = (_FOLDER / f"{name.replace('-', '_')}.py").read_text(encoding="utf-8")
    line = (ast.get_docstring(ast.parse(text)) or "").partition("\n")[0]
    return line.rstrip(".")


def loaded(name: str) -> "Question":
    """The question of that name; its module, and what it needs, is loaded now."""
    module = import_module(f"asymptotics.ask.questions.{name.replace('-', '_')}")
    found: list[Question] = [v.__question__ for v in vars(module).values() if hasattr(v, "__question__")]
    return next(q for q in found if q.name == name)
