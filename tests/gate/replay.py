"""The command lines of tests, docs and README with what they answered: ``python -m tests.gate.replay`` records them.

A line of ``recorded.jsonl`` is [words, exit code, digest of stdout, stderr, {file: digest of a table, or suffix}].
What changes from run to run (the code that made it, seconds, folders) is taken out first, and lines that the clock cuts
are not recorded.  New lines are added by hand to ``recorded.jsonl`` as [words], and recorded with the rest.
"""

import contextlib
import hashlib
import io
import json
import os
import re
import tempfile
from pathlib import Path

from asymptotics.ask.registry import QUESTIONS, loaded
from asymptotics.shell.main import main

RECORD = Path(__file__).parent / "recorded.jsonl"
_CHANGING = (
    (r"sha256:\w+", "sha256"),
    (r"\d+\.\d+ s\b", "N s"),
    (r"/tmp/\w+", "/tmp/X"),
    (r'"(commit|date|seconds|code)": "[^"]*"', r'"\1": ""'),
    (r"(?m)^([%#]? ?)(commit|code|date|versions): .*$", r"\1\2"),
)


def steady(text: str) -> str:
    """The text without what changes from run to run."""
    for pattern, word in _CHANGING:
        text = re.sub(pattern, word, text)
    return text


def digest(text: str) -> str:
    """A few letters that tell two texts apart."""
    return hashlib.sha256(steady(text).encode("utf-8", "backslashreplace")).hexdigest()[:12]


def outcome(words: list[str]) -> list[object]:
    """[exit code, digest of stdout, stderr, files] of a command line, run in an empty folder."""
    out, err, home = io.StringIO(), io.StringIO(), Path.cwd()
    with tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)
        try:
            with contextlib.redirect_stdout(out), contextlib.redirect_stderr(err):
                try:
                    code = main(words)
                except SystemExit as stop:
                    code = int(stop.code or 0)
            files = {
                str(p.relative_to(folder)): digest(p.read_text()) if p.suffix == ".csv" else p.suffix
                for p in sorted(Path(folder).rglob("*"))
                if p.is_file()
            }
        finally:
            os.chdir(home)
    return [code, digest(out.getvalue()), steady(err.getvalue()), files]


def recorded() -> list[list[object]]:
    """The rows of the record."""
    return [json.loads(row) for row in RECORD.read_text(encoding="utf-8").splitlines()]


def is_steady(found: list[object]) -> bool:
    """Whether it is no line that the clock has cut."""
    return not re.search(r"are over|cut short|takes about|would take", str(found[2]))


def unrecorded(rows: list[list[object]]) -> list[list[str]]:
    """The examples of commands that no row asks, but those that need a file."""
    known = {row[0][0] for row in rows if row[0]}  # type: ignore[index]
    examples = {name: loaded(name).example for name in QUESTIONS if name not in known}
    return [[name, *text.split()] for name, text in examples.items() if "{" not in text]


def record() -> None:
    """Every line again, and what it answers now."""
    rows = []
    for words, *_ in [*recorded(), *([words] for words in unrecorded(recorded()))]:
        found = outcome([str(w) for w in words])  # type: ignore[attr-defined]
        if is_steady(found):
            rows.append(json.dumps([words, *found], ensure_ascii=True))
    RECORD.write_text("\n".join(rows) + "\n", encoding="utf-8")


if __name__ == "__main__":
    record()
