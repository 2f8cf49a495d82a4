"""The docs: shell examples print what is shown, pages are reachable, references exist, the gallery asks."""

import re
import shlex
import unicodedata
from calendar import month_name
from importlib import import_module
from pathlib import Path

import matplotlib as mpl
import matplotlib.pyplot as plt
import pytest
from matplotlib.figure import Figure

import asymptotics as asy
from asymptotics.present.mathml import mathml, whole
from asymptotics.shell.main import main
from derivations.__main__ import names

mpl.use("Agg")
ROOT = Path(__file__).parents[1]
PAGES = sorted((ROOT / "docs").rglob("*.md"))
GALLERY = sorted((ROOT / "docs/gallery").glob("plot_*.py"))
EXAMPLES = [
    (page.name, *example)
    for page in PAGES
    for block in re.findall(r"```console\n(.*?)```", page.read_text(), re.DOTALL)
    for example in re.findall(r"^\$ asymptotics (.*?)\n(.*?)(?=^\$ |\Z)", block, re.DOTALL | re.MULTILINE)
]


@pytest.mark.parametrize(("page", "command", "output"), EXAMPLES, ids=lambda text: text[:40])
def test_the_docs_show_what_is_printed(capsys, page, command, output):
    assert main(shlex.split(command)) == 0
    assert capsys.readouterr().out == output


def test_every_page_stands_in_the_contents():
    contents = (ROOT / "docs/index.md").read_text()
    for page in PAGES:
        name = str(page.relative_to(ROOT / "docs").with_suffix(""))
        assert name in {"index", "benchmarks"} or re.search(rf"^{name}$", contents, re.MULTILINE), name


def test_every_gallery_page_asks_draws_and_asserts():
    assert len(GALLERY) >= 12
    for path in GALLERY:
        text = path.read_text()
        title = text.split("\n")[1]
        assert "?" in title or "amplitude" in title or "Creep" in title, path.name
        assert "plt.subplots" in text and re.search(r"^assert ", text, re.MULTILINE), path.name


def test_the_derivations_that_the_docs_name_exist():
    known, cited = set(names()), set()
    for page in PAGES:
        for group in re.findall(r"[Dd]erivations? (`[\w-]+`(?:, `[\w-]+`)*)", page.read_text()):
            cited |= set(re.findall(r"`([\w-]+)`", group))
    assert len(cited) >= 10 and cited <= known, cited - known


def test_cited_theory_pages_exist():
    pages = {path.stem for path in (ROOT / "docs/theory").glob("*.md")}
    cited = set()
    for folder in ("asymptotics", "derivations", "paper_checks", "tests"):
        for path in (ROOT / folder).rglob("*.py"):
            cited |= set(re.findall(r"theory page\s+`{0,2}([\w]+)", path.read_text()))
    assert cited and cited <= pages, cited - pages


def test_no_document_outside_the_repository_is_cited():
    for folder in ("asymptotics", "derivations", "paper_checks", "docs", "benchmarks"):
        for path in [*(ROOT / folder).rglob("*.py"), *(ROOT / folder).rglob("*.md"), *(ROOT / folder).rglob("*.j2")]:
            found = re.findall(r"\b(?:DESIGN|CERTIFY|SPRINGS|KERNELS|PEERS)(?: §?\d|\.md)", path.read_text())
            assert not found, f"{path.relative_to(ROOT)} cites {found[0]}"


def cited(text):
    """(name, year) of each work that a comment or a docstring cites as "Moore 1966" or "Moore, 1966"."""
    flowing = unicodedata.normalize("NFD", re.sub(r"\s*\n\s*#?\s*", " ", text))
    found = re.findall(r"\b([A-Z][a-z]+)(?:'s)?,? \(?((?:18|19|20)\d\d)\b", flowing)
    return {(name, year) for name, year in found if name not in month_name}


def test_every_work_that_the_sources_cite_stands_in_the_bibliography():
    page = unicodedata.normalize("NFD", (ROOT / "docs/bibliography.md").read_text())
    entries = ["".join(c for c in entry if not unicodedata.combining(c)) for entry in page.split("\n\n")]
    for folder in ("asymptotics", "derivations", "paper_checks", "benchmarks"):
        for path in sorted((ROOT / folder).rglob("*.py")):
            for name, year in cited(path.read_text()):
                assert any(name in entry and year in entry for entry in entries), (path.name, name, year)
    assert cited("as in\n# Moore 1966, and Wilks's theorem (1938), (Walter, 1998)") == {
        ("Moore", "1966"),
        ("Walter", "1998"),
    }


def test_mathml_is_an_element():
    assert mathml(r"\frac{1}{2}", display=True).startswith("<math")
    assert 'display="block"' in mathml("x", display=True)


def test_mathematics_is_well_set():
    """In the docs and in the report, which are set by the same function."""
    bars = mathml(r"b\dot x|\dot x|^{\alpha-1}", display=True)
    assert bars.count('lspace="0" rspace="0">&#x0007C;') == 2 and 'stretchy="false">&#x0007C;' not in bars
    assert "<mo>&#x02032;</mo>" in mathml("X'")
    space = '<mspace width="0.167em"/>'
    assert f"<mrow>{space}<mi>cos</mi>{space}</mrow>" in mathml(r"r\cos\theta")
    assert f"<msup><mrow>{space}<mi>sin</mi></mrow>" in mathml(r"\sin^2 x")
    assert space not in mathml(r"\exp(x)") and f"</msub>{space}<mi>cos</mi><mo" in mathml(r"x_0\cos(t)")
    assert "\N{EM DASH}so" in mathml(r"\text{---so}")
    sides = re.findall(r'form="(\w+)" stretchy="true"[^>]*>([^<]*)<', mathml(r"\Big|\big\langle x\big\rangle\Big|"))
    assert sides == [("prefix", "|"), ("prefix", "&#x027E8;"), ("postfix", "&#x027E9;"), ("postfix", "|")]
    assert mathml(r"\vert x\vert").count('lspace="0" rspace="0">&#x0007C;') == 2
    for negative, form in (("(-1)", ' form="prefix"'), ("a=-b", ' form="prefix"'), ("a-b", ""), ("(a)-b", "")):
        assert f"<mo{form}>&#x02212;</mo>" in mathml(negative), negative
    assert "<mo>&#x0223C;</mo>" in mathml(r"x\sim y") and 'rspace="0">&#x0002F;' in mathml("k/m")


def test_no_command_of_latex_is_left_in_a_formula():
    """A command that the converter does not know would stand on the page as it is written."""
    assert "\\" in mathml(r"\unheard{x}")  # a command it does not know is seen
    count = 0
    for path in sorted((ROOT / "docs").rglob("*.md")):
        text = re.sub(r"```.*?```|`[^`\n]*`", "", path.read_text(), flags=re.DOTALL)
        for both in re.findall(r"\$\$(.+?)\$\$|\$([^$\n]+)\$", text, re.DOTALL):
            count += 1
            assert "\\" not in mathml(both[0] or both[1]), (path.name, both)
    assert count > 500


def test_no_line_ends_between_a_formula_and_what_touches_it():
    x = "<math><mi>x</mi></math>"
    assert whole(f"a ({x}, and {x}-th, {x} b") == (
        f'a <span class="whole">({x},</span> and <span class="whole">{x}-th,</span> {x} b'
    )
    alone = '<math display="block"><mi>x</mi></math>.'
    assert whole(alone) == alone


def test_the_names_of_the_reference_are_public():
    """``asymptotics.Envelope``, not the file it is in; what has no public name stands with its path."""
    page = (ROOT / "docs/api.md").read_text()
    named = re.findall(r"^reference/([\w.]+)$", page, re.MULTILINE)
    assert set(asy.__all__) - set(named) == {"testing"}  # a page of its own
    assert not {name.rpartition(".")[2] for name in named if "." in name} & set(asy.__all__)


def test_every_theory_page_has_a_figure_a_number_a_derivation_and_statements(monkeypatch):
    monkeypatch.syspath_prepend(str(ROOT / "docs/extensions"))
    drawn = {figure.__name__ for figure in import_module("theory_figures").FIGURES}
    known, ids = set(names()), {statement.id for statement in asy.statements()}
    pages = {path.stem: path.read_text() for path in (ROOT / "docs/theory").glob("*.md")}
    assert drawn == set(pages)
    for name, text in pages.items():
        assert f"](figures/{name}.svg)" in text and re.search(r"```(\{doctest\}|console)\n", text), name
        code = set(re.findall(r"`([\w.:-]+)`", text))
        assert code & known, name
        cited = {c for c in code if re.match(r"(lancaster2020|lelas2024|smith2012):", c)}
        assert cited and cited <= ids, (name, cited - ids)


def test_faults_of_a_picture_are_noticed(monkeypatch):
    monkeypatch.syspath_prepend(str(ROOT / "docs/extensions"))
    faults = import_module("picture_faults").faults
    figure, axes = plt.subplots()
    axes.plot([0, 1], [0, 1], label="a line")
    axes.legend(loc="upper left")
    assert faults(figure) == []
    axes.legend(loc="upper right")
    assert "the legend covers data" in faults(figure)[0]
    axes.get_legend().remove()
    axes.set_xticks([0.5, 0.501, 0.502], ["one long label", "another", "and a third"])
    assert "ticks overlap" in faults(figure)[0]
    plt.close(figure)
    figure, axes = plt.subplots()
    axes.plot([0, 1, 2], [0, 1, 0], "o-", color="tab:blue")
    axes.plot([0, 2], [2, 2], color="tab:red", label="a bound")
    axes.legend(loc="lower center")
    assert "1 rows of points that the legend does not name" in faults(figure)[0]
    plt.close(figure)
    for levels, wrong in (((1, 2, 3), True), ((0, 1, 3), False)):
        figure, axes = plt.subplots()
        axes.contourf([[0, 1], [2, 3]], levels=levels)
        assert ("values beyond the colours stay white" in str(faults(figure))) is wrong
        plt.close(figure)
    figure, (left, right) = plt.subplots(1, 2)
    left.plot([0, 1], [0, 1])
    assert faults(figure) == ["axes: empty"]
    plt.close(figure)
    figure = Figure(layout="constrained")  # of no window: it is judged as it will be laid out
    figure.subplots().set(ylabel="a\nb\nc\nd\ne\nf\ng", xlabel="x")
    figure.axes[0].plot([0, 1], [0, 1])
    assert faults(figure) == []
    figure.text(0.9, 0.5, "a line that is longer than what is left")
    assert "cut off by the edge" in faults(figure)[0]


def split_formulas(page):
    """The cells of a page's tables in which a formula begins and does not end: a bar in it has ended the cell."""
    rows = [line for line in re.sub(r"(?ms)^```.*?^```", "", page).splitlines() if line.startswith("| ")]
    cells = [cell for row in rows for cell in re.split(r"(?<!\\)\|", re.sub(r"`[^`]*`", "", row))]
    return [cell for cell in cells if cell.count("$") % 2]


def test_no_bar_in_a_formula_ends_the_cell_of_a_table():
    assert split_formulas("| a | $x'|x'|^2$ |\n") == [" $x'", "^2$ "] and not split_formulas("| `$` | $x$ |\n")
    pages = {page: page.read_text(encoding="utf-8") for page in ROOT.glob("docs/**/*.md")}
    assert {page.name: found for page, text in pages.items() if (found := split_formulas(text))} == {}
