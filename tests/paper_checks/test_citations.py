"""Every id of a statement that is cited anywhere in the repository exists."""

import re
from pathlib import Path

from paper_checks.registry import PAPERS, load

ROOT = Path(__file__).parents[2]
FOLDERS = ("asymptotics", "derivations", "paper_checks", "tests", "benchmarks", "docs")
# an f-string that completes the id is not a citation
CITATION = re.compile(rf"\b((?:{'|'.join(PAPERS)}):[\w.-]*\w)(?![\w{{-]|\.\{{)")


def cited(text):
    return set(CITATION.findall(text))


def test_the_pattern_finds_ids_and_nothing_else():
    paper = "smith2012"
    assert cited(f"see {paper}:62b, {paper}:claim.never-overdamped.") == {
        f"{paper}:62b",
        f"{paper}:claim.never-overdamped",
    }
    assert cited(paper + ":60{letter} and " + paper + ":table1.{key}") <= {f"{paper}:6", f"{paper}:table"}


def test_cited_ids_exist():
    known = set(load())
    files = [path for folder in FOLDERS for path in (ROOT / folder).rglob("*.py")] + list(ROOT.glob("*.md"))
    missing = {
        (path.name, key)
        for path in files
        for key in cited(path.read_text(encoding="utf-8"))
        if key not in known and path != Path(__file__)
    }
    missing = {(name, key) for name, key in missing if not any(k.startswith(f"{key}.") for k in known)}  # a table's
    assert not missing
