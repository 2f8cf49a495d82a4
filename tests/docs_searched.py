"""What the search of the docs shows first, in Chromium: ``python -m tests.docs_searched DIR`` (part of ``make docs``).

Guides come before the API, lists and single names, which mention every word; a wrong order must be noticed, else the
look itself has failed.  Without Chromium that is said, and nothing else.
"""

import sys
import tempfile
import time
from collections.abc import Sequence
from pathlib import Path

from tests.paper_checks.drawing import missing, start

WORDS = {"install": "quickstart", "units": "symbols", "damping": "theory/equivalent_damping", "compare": "tables"}
"""A page that is to be among the first five, for each word."""
LISTS = ("api", "parity", "bibliography", "changelog", "trust")
FOLDERS = ("reference", "auto_gallery", "maintainers")
PATIENCE = 60
SHOWN = "return [...document.querySelectorAll('#search-results ul.search > li > a')].map((a) => a.getAttribute('href'))"
OVER = "return document.querySelector('.search-summary')?.textContent.includes('finished')"


def misplaced(pages: Sequence[str], wanted: str) -> str:
    """What is wrong with an order of pages, or nothing."""
    is_list = [page in LISTS or page.split("/")[0] in FOLDERS for page in pages]
    if wanted not in pages[:5]:
        return f"{wanted} is not among the first five: {', '.join(pages[:5])}"
    if is_list != sorted(is_list):
        return f"{pages[is_list.index(True)]} stands before a guide"
    return ""


def look(folder: Path) -> int:
    """The number of words whose pages come in a wrong order; each is told."""
    if not misplaced(["quickstart", "api", "tables"], "quickstart") or not misplaced(["api"] * 5, "quickstart"):
        print("a wrong order was not noticed")
        return 1
    wrong = 0
    with tempfile.TemporaryDirectory() as profile:
        browser = start("chromium", profile)
        try:
            for word, wanted in WORDS.items():
                browser.get(f"{folder.joinpath('search.html').as_uri()}?q={word}")
                until = time.monotonic() + PATIENCE
                while not browser.execute_script(OVER) and time.monotonic() < until:
                    time.sleep(0.2)
                pages = [link.split(".html")[0] for link in browser.execute_script(SHOWN)]
                found = misplaced(pages, wanted)
                wrong += bool(found)
                if found:
                    print(f"search for {word!r}: {found}")
        finally:
            browser.quit()
    print(f"{len(WORDS)} words searched: {wrong or 'nothing'} wrong")
    return wrong


if __name__ == "__main__":
    if missing("chromium"):
        print(f"not installed: {', '.join(missing('chromium'))}; the search of the docs is not looked at")
        sys.exit()
    sys.exit(bool(look(Path(sys.argv[1]).resolve())))
