"""Every result in a real notebook: ``python -m tests.notebook DIR`` (a part of ``make docs``).

A notebook with one cell for each result type (``tests/present/every_type.py``) is run by nbclient in a kernel of its
own; each cell must leave HTML with the verdict first, LaTeX and a few lines of text, no error and nothing on stderr.
The notebook that a lecture begins with (one figure of each paper, which Sphinx has written) is run in the same way.
The executed notebook and a page of what it shows are written to DIR; where Chromium is installed the page is looked at,
at the width of a desktop and of a phone.
"""

import sys
import tempfile
from pathlib import Path

import nbformat
from nbclient import NotebookClient

from tests.docs_drawn import LOOK, WIDTHS
from tests.paper_checks.drawing import missing, start
from tests.present.every_type import SAMPLES, SETUP

LECTURE = Path(__file__).parents[1] / "docs/auto_gallery/plot_00_figures_of_the_papers.ipynb"
HEAD = """<!doctype html><meta charset="utf-8"><title>Every result in a notebook</title>
<style>body{font-family:sans-serif;margin:1rem} article{border-top:1px solid #ccc;overflow-x:auto}
table{border-collapse:collapse} td,th{padding:.1rem .6rem;text-align:right} img{max-width:100%;height:auto}</style>
"""


def results() -> nbformat.NotebookNode:
    """The notebook of all results."""
    cells = [nbformat.v4.new_code_cell(SETUP), *(nbformat.v4.new_code_cell(text) for text in SAMPLES.values())]
    return nbformat.v4.new_notebook(cells=cells)


def executed(notebook: nbformat.NotebookNode) -> nbformat.NotebookNode:
    """The notebook after its run; an error in a cell is an error here."""
    with tempfile.TemporaryDirectory() as folder:
        place = {"metadata": {"path": folder}}
        quiet = ["--IPKernelApp.log_level=ERROR"]  # it warns of its own port, which is open on this machine alone
        NotebookClient(notebook, extra_arguments=quiet, timeout=240, resources=place).execute()
    return notebook


def of_a_lecture(folder: Path) -> list[str]:
    """What is wrong with the notebook of the figures, run: a picture and its numbers for each paper, a quiet kernel."""
    if not LECTURE.exists():
        return [f"{LECTURE.name} is not there: the pages of the docs are built first"]
    notebook = executed(nbformat.read(LECTURE, as_version=4))
    nbformat.write(notebook, folder / LECTURE.name)
    cells = [cell.outputs for cell in notebook.cells if cell.cell_type == "code"]
    outputs = [out for cell in cells for out in cell]
    pictures = sum("image/png" in out.get("data", {}) for out in outputs)
    # On a machine under load the kernel sends what one cell prints in pieces.
    told = [cell for cell in cells if any(out.get("name") == "stdout" for out in cell)]
    loud = [f"stderr: {out.text[:200]}" for out in outputs if out.get("name") == "stderr"]
    papers = [] if (pictures, len(told)) == (3, 3) else [f"{pictures} pictures and {len(told)} texts of three papers"]
    return [f"{LECTURE.name}: {line}" for line in (*loud, *papers)]


def fault(outputs: list[nbformat.NotebookNode]) -> str:
    """What is wrong with what a cell has left; nothing for one that shows its result in every form."""
    results = [out for out in outputs if out.output_type == "execute_result"]
    streams = [out.text for out in outputs if out.output_type == "stream" and out.name == "stderr"]
    if streams:
        return f"stderr: {streams[0][:200]}"
    if len(results) != 1:
        return f"{len(results)} results"
    data = results[0].data
    if not data.get("text/html", "").startswith("<div><p><strong>"):
        return "its HTML does not start with the verdict"
    if not data.get("text/latex", "").startswith("$"):
        return "it has no LaTeX"
    return "" if 0 < len(data.get("text/plain", "").splitlines()) <= 9 else "its text is not a few lines"


def page(shown: dict[str, nbformat.NotebookNode]) -> str:
    """What the notebook shows, cell after cell."""
    return HEAD + "".join(f"<article><h2>{name}</h2>{html}</article>" for name, html in shown.items())


def looked_at(path: Path) -> list[str]:
    """What a browser finds wrong with the page."""
    found = []
    with tempfile.TemporaryDirectory() as profile:
        browser = start("chromium", profile)
        try:
            for width in WIDTHS:
                metrics = {"width": width, "height": 900, "deviceScaleFactor": 1, "mobile": False}
                browser.execute_cdp_cmd("Emulation.setDeviceMetricsOverride", metrics)
                browser.get(path.resolve().as_uri())
                found += [f"at {width} px: {line}" for line in browser.execute_script(LOOK)]
                broken = "return [...document.images].filter(i => !i.naturalWidth).length"
                images = browser.execute_script(broken)
                found += [f"at {width} px: {images} pictures are not drawn"] if images else []
        finally:
            browser.quit()
    return found


def main(folder: Path) -> int:
    """Run, judge, write, look; the number of faults."""
    assert fault([]) and fault([nbformat.v4.new_output("stream", name="stderr", text="x")])  # it can fail
    folder.mkdir(parents=True, exist_ok=True)
    notebook = executed(results())
    outputs = dict(zip(SAMPLES, (cell.outputs for cell in notebook.cells[1:]), strict=True))
    found = [f"{name}: {told}" for name, outs in outputs.items() if (told := fault(outs))]
    nbformat.write(notebook, folder / "results.ipynb")
    found += of_a_lecture(folder)
    shown = {name: outs[-1].data["text/html"] for name, outs in outputs.items() if not fault(outs)}
    (folder / "results.html").write_text(page(shown), encoding="utf-8")
    absent = missing("chromium")
    found += [] if absent else looked_at(folder / "results.html")
    for line in found:
        print(line)
    seen = f"not looked at, {', '.join(absent)} missing" if absent else "looked at in Chromium"
    print(f"{len(shown)} of {len(SAMPLES)} results shown in a notebook, {seen}: {len(found) or 'nothing'} wrong")
    return len(found)


if __name__ == "__main__":
    sys.exit(bool(main(Path(sys.argv[1]))))
