"""The pages of the docs as Chromium draws them: ``python -m tests.docs_drawn DIR`` (a part of ``make docs``).

On a desktop (1400 px) and on a phone (390 px) no page is wider than its window, no box is clipped, and what is wide
(code, tables, displayed formulas) scrolls inside; the formulas are set in the font that the pages carry, and no command
of LaTeX stands in one.  A page that is spoilt on purpose must be noticed, else the look itself has failed.  Without
Chromium that is said, and nothing else.
"""

import sys
import tempfile
from pathlib import Path

from tests.paper_checks.drawing import missing, start

WIDTHS = (1400, 390)
LOOK = """
const page = document.documentElement, found = [];
if (page.scrollWidth > page.clientWidth) found.push(`the page is ${page.scrollWidth} px wide`);
const inside = (box) => {
  for (let outer = box; outer && outer !== document.body; outer = outer.parentElement)
    if (['auto', 'scroll'].includes(getComputedStyle(outer).overflowX)) return true;
  return false;
};
for (const box of document.querySelectorAll('article *')) {
  const style = getComputedStyle(box), name = `${box.tagName} ${box.className}`;
  if (style.display === 'inline' || ['absolute', 'fixed'].includes(style.position)) continue;
  if (box.namespaceURI.includes('MathML') && box.tagName !== 'math') continue;
  const clips = ['hidden', 'clip'].includes(style.overflowX);
  if (clips && box.clientWidth > 0 && box.scrollWidth > box.clientWidth + 1) found.push(`${name} is clipped`);
  const place = box.getBoundingClientRect();
  if (place.width > 0 && place.right > page.clientWidth + 1 && !inside(box)) found.push(`${name} sticks out`);
}
for (const formula of document.querySelectorAll('math'))
  if (formula.textContent.includes(String.fromCharCode(92))) found.push(`a formula reads ${formula.textContent}`);
const words = document.querySelector('article');
if (words) {
  const told = words.cloneNode(true);
  for (const code of told.querySelectorAll('pre, code, math')) code.remove();
  const stray = told.textContent.match(/<[\\w.]+ object at 0x|\\\\(alpha|tau|epsilon|frac)/);
  if (stray) found.push(`the page says ${stray[0]}`);
}
for (const output of document.querySelectorAll('.sphx-glr-script-out'))
  if (output.textContent.includes(' object at 0x')) found.push(`an output is ${output.textContent.slice(0, 60)}`);
return found.slice(0, 3);
"""
FONT = """
const formula = document.querySelector('math');
if (!formula) return '';
const family = getComputedStyle(formula).fontFamily;
return [...document.fonts].some((f) => family.includes(f.family.replaceAll('"', ''))) ? '' : family;
"""
SPOILT = '<html><body><article><div style="width:3000px">wide</div></article></body></html>'
RAW = "<html><body><article><math><mo>\\langle</mo></math></article></body></html>"
STRAY = "<div class='sphx-glr-script-out'>&lt;a.Legend object at 0x7f&gt;</div>"
OUTPUT = f"<html><body><article>{STRAY}</article></body></html>"
CARD = "<html><body><article><p>Creep below \\alpha = 1</p></article></body></html>"
CLIPPED = SPOILT.replace("width:3000px", "width:9em;overflow:hidden").replace("wide", '<p style="width:99em">x</p>')


def look(folder: Path) -> int:
    """The number of pages with something wrong; each is told."""
    pages = [path for path in sorted(folder.rglob("*.html")) if "_static" not in path.parts]
    wrong = 0
    with tempfile.TemporaryDirectory() as profile:
        browser = start("chromium", profile)
        try:
            for width in WIDTHS:
                browser.execute_cdp_cmd(
                    "Emulation.setDeviceMetricsOverride",
                    {"width": width, "height": 900, "deviceScaleFactor": 1, "mobile": False},
                )
                for spoilt in (SPOILT, CLIPPED, RAW, OUTPUT, CARD):
                    made = Path(profile, "spoilt.html")
                    made.write_text(spoilt, encoding="utf-8")
                    browser.get(made.as_uri())
                    if not browser.execute_script(LOOK):
                        print(f"a page that is spoilt on purpose was not noticed at {width} px")
                        return 1
                for page in pages:
                    browser.get(page.as_uri())
                    found = browser.execute_script(LOOK)
                    other = browser.execute_script(FONT) if page.name != "play.html" else ""
                    found += [f"formulas are set in {other}"] if other else []
                    wrong += bool(found)
                    for line in found:
                        print(f"{page.relative_to(folder)} at {width} px: {line}")
        finally:
            browser.quit()
    print(f"{len(pages)} pages at {' and '.join(map(str, WIDTHS))} px: {wrong or 'nothing'} wrong")
    return wrong


if __name__ == "__main__":
    if missing("chromium"):
        print(f"not installed: {', '.join(missing('chromium'))}; the pages of the docs are not looked at")
        sys.exit()
    sys.exit(bool(look(Path(sys.argv[1]).resolve())))
