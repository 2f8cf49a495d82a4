"""The pages of --html in a browser: every formula has a size, and nothing sticks out of the window of a phone."""

import shlex

import pytest
from drawing import missing

from asymptotics.shell.main import main

PAGES = {
    "solution": "--alpha 2 --epsilon 1/10 --order 2 --time 7",
    "damping": "--law 1:1/10 --law 2:1/20 --digits 5",
    "multiple-scales": "--alpha 2 --order 2",
    "papers": "lancaster2020:13",
    "stokes": "--alpha 2 --count 1 --digits 5",
}
pytestmark = pytest.mark.skipif(bool(missing("chromium")), reason="no Chromium here")


@pytest.mark.parametrize("name", PAGES)
def test_a_page_is_seen_as_it_is_meant(browser, tmp_path, name):
    path = tmp_path / f"{name}.html"
    assert main([name, *shlex.split(PAGES[name]), "--html", str(path), "--quiet"]) == 0
    browser.get(path.as_uri())
    wide, window = (
        int(browser.execute_script(f"return {what}")) for what in ("document.body.scrollWidth", "innerWidth")
    )
    assert wide <= window, "the page is wider than the window"
    sizes = browser.execute_script(
        "return [...document.querySelectorAll('math')].map(m => { const b = m.getBoundingClientRect();"
        " return [b.width, b.height]; })"
    )
    assert sizes and all(w > 3 and h > 6 for w, h in sizes), "a formula is not drawn"
    # What sticks out of a box that may scroll to the side is cut, or gets a bar of its own; a pixel is rounding.
    heights = "return [...document.querySelectorAll('math[display=block]')].map(m => m.scrollHeight - m.clientHeight)"
    assert max(browser.execute_script(heights), default=0) <= 1, "a formula is higher than its box"
    assert "$" not in browser.find_element("tag name", "body").text
