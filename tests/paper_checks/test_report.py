"""The report and its command: complete, self-contained, reproducible, and refusing what it cannot do."""

import json
import os
import re
import shutil
import subprocess
import sys
from html.parser import HTMLParser
from pathlib import Path
from xml.etree import ElementTree

import jsonschema
import pytest

from asymptotics.errors import InputError
from derivations.__main__ import names
from paper_checks import registry
from paper_checks.__main__ import main
from paper_checks.registry import PAPERS, Entry, expected_outcomes, load
from paper_checks.report import build, certificates, write_report
from paper_checks.report.summary import markdown_summary

VOID = {"meta", "br", "img", "hr", "link", "input"}


class Page(HTMLParser):
    """Collects ids and links, and insists that tags are balanced."""

    def __init__(self) -> None:
        super().__init__()
        self.open: list[str] = []
        self.ids: set[str] = set()
        self.links: list[str] = []

    def feed(self, data):
        """Formulas, most of a page, are XML: expat reads them in no time, and refuses what is not balanced."""
        super().feed(re.sub(r"<math\b.*?</math>", self.formula, data, flags=re.DOTALL))

    def formula(self, found):
        for node in ElementTree.fromstring(found[0]).iter():
            assert not {"id", "href", "src"} & {*node.attrib}, found[0]
        return ""

    def handle_starttag(self, tag, attrs):
        values = dict(attrs)
        if tag not in VOID:
            self.open.append(tag)
        if "id" in values:
            self.ids.add(values["id"])
        self.links += [values[k] for k in ("href", "src") if values.get(k)]

    def handle_startendtag(self, tag, attrs):
        self.links += [v for k, v in attrs if k in ("href", "src") and v]

    def handle_endtag(self, tag):
        assert self.open.pop() == tag


CITED = ("https://doi.org/", "https://arxiv.org/abs/")  # to follow, not fetched


def checked(folder, name):
    """What the page beside a certificate says of it, which it accepts."""
    command = [sys.executable, "-I", "-S", "check_certificate.py", name]
    ran = subprocess.run(command, cwd=folder, capture_output=True, text=True)
    assert ran.stdout.startswith("accepted\n"), name
    return ran.stdout


@pytest.mark.slow
def test_the_other_certificates_of_a_report_are_proved_too(other_certificates, tmp_path):
    shutil.copy(certificates.CHECKER, tmp_path)
    assert len(other_certificates) == 7
    for each in other_certificates:
        (tmp_path / each.file).write_text(each.make().to_json())
        checked(tmp_path, each.file)


def test_the_certificates_beside_the_report_are_proved_by_the_page_beside_them(report):
    """Every file that is written, as a stranger would; each is listed, and linked from the entries that it proves."""
    made = sorted(path.name for path in report.glob("certificate-*.json"))
    assert made == sorted(each.file for each in certificates.PROVED) and len(made) == 6
    index, told = (report / "index.html").read_text(), {}
    for name in made:
        assert f'<a href="{name}">' in index
        told[name] = checked(report, name)
    for each in certificates.PROVED:
        for statement in each.statements:
            page = (report / f"{statement.partition(':')[0]}.html").read_text()
            card = page.partition(f'<article id="{statement}"')[2].partition("</article>")[0]
            assert f'<a href="{each.file}">certificate</a>, checked by' in card, statement
    assert 'href="certificate-table-smith2012.table1.json"' in (report / "smith2012.html").read_text()
    # The numbers of the papers as they print them: the stops of Fig. 1 in s and in units of x0 = 1/5 m, u_5 of Table I.
    assert "turning point 20: x = 0.0038000000000000000000" in told["certificate-lelas2024-fig1a.json"]
    assert "t = 14.0496" in told["certificate-lelas2024-fig1a.json"]
    assert "turning point 7: x = 0.0060100000000000000000" in told["certificate-lelas2024-fig1b.json"]
    assert "t = 4.9173" in told["certificate-lelas2024-fig1b.json"]
    assert "turning point 5: x = -0.127907509" in told["certificate-smith2012-table1.json"]
    assert "turning point 8: it stays" in told["certificate-lancaster2020-fig1.json"]


def test_every_page_is_well_formed_and_self_contained(report):
    pages = {path.name: Page() for path in report.glob("*.html")}
    for name, page in pages.items():
        page.feed((report / name).read_text())
        assert page.open == []
    files = {path.name for path in report.iterdir()}
    for name, page in pages.items():
        for link in page.links:
            target, _, anchor = link.partition("#")
            assert not target or target in files or target.startswith(CITED), link  # nothing comes from a network
            assert not anchor or anchor in pages[target or name].ids, link
        text = (report / name).read_text()
        if name == "play.html":  # one file, its script inside: test_play.py
            continue
        assert "play.html" in page.links
        assert text.count("<script") == text.count('<script src="search.js">') == 1
        assert text.count("<img") == text.count(' alt="')
        assert 'alt=""' not in text and 'src="http' not in text
        assert "<svg" not in text
    drawn = {path.name for path in report.glob("*.svg")}
    assert drawn <= {link for page in pages.values() for link in page.links}
    assert "http" not in (report / "search.js").read_text() + (report / "style.css").read_text()


def test_every_card_is_complete(report):
    for key in PAPERS:
        text = (report / f"{key}.html").read_text()
        cards = text.count("<article")
        assert cards == sum(entry.paper == key for entry in load().values())
        for part in ("Conditions: ", "<summary>TeX</summary>", "Check: paper_checks/", "data-verdict="):
            assert text.count(part) >= cards, part
        assert "Near miss, refuted by the check" in text
        assert text.count("<h2 id=") >= 7
    errata = (report / "errata.html").read_text()
    assert errata.index('id="slips"') < errata.index('id="garbled"') < errata.index('id="conditions"')
    assert "mathcolor" in errata  # what a correction changes is coloured


def test_the_first_table_of_lancaster_has_the_form_of_the_paper():
    entries = [Entry(entry, expected_outcomes(entry), 0.0) for entry in load("lancaster2020").values()]
    table = build._table("lancaster2020.table1", entries)
    shown = {str(row[0]): typeset[-1] for row, typeset in zip(table["rows"], table["typeset"])}
    assert shown["2"] == r"\frac{x_0}{1 + \frac{4b\omega_0x_0t}{3\pi m}}" and r"\Gamma^2" in shown["3/2"]
    assert shown["3"] == load()["lancaster2020:table1.alpha3"].corrected_latex  # printed garbled
    assert list(shown) == ["0", "1", "3/2", "2", "3", "alpha"]


def test_derivations_are_rendered(report):
    text = (report / "derivations.html").read_text()
    for name in names():
        assert f'id="{name}"' in text
    assert text.count("<math") > 300


def test_every_statement_is_on_the_page_and_in_the_data(report):
    page = Page()
    for key in PAPERS:
        page.feed((report / f"{key}.html").read_text())
    data = json.loads((report / "report.json").read_text())
    found = [entry["id"] for paper in data["papers"] for entry in paper["entries"]]
    assert found == list(load())
    schema = json.loads((Path(build.__file__).parent / "schema.json").read_text())
    jsonschema.validate(data, schema)
    data["papers"][0]["entries"][0]["printed"] = "probably"
    with pytest.raises(jsonschema.ValidationError):
        jsonschema.validate(data, schema)
    assert set(found) <= page.ids


def test_the_latex_document_has_every_statement(report):
    text = (report / "report.tex").read_text()
    assert text.count(r"\paragraph{") == len(load())
    assert text.isascii(), sorted({c for c in text if not c.isascii()})  # every other character has its command
    assert text.count(r"\begin{tabular}") == text.count(r"\end{tabular}") >= 2


def test_the_same_entries_give_the_same_bytes_however_long_they_took(report, tmp_path):
    entries = [Entry(entry, expected_outcomes(entry), 1.5) for entry in load().values()]
    for path in write_report(tmp_path, entries):  # every picture is drawn again
        assert path.read_bytes() == (report / path.name).read_bytes(), path.name
        assert path.suffix != ".svg" or b"<svg" in path.read_bytes()


def test_a_report_that_cannot_be_finished_changes_no_file(tmp_path, monkeypatch):
    names, real = ["index.html", "style.css"], Path.replace
    for name in names:
        (tmp_path / name).write_text("old")

    def replace(self: Path, target: Path) -> Path:
        if Path(target).name == "style.css" and self.read_text() == "new":
            raise OSError(28, "No space left on device")
        return real(self, target)

    monkeypatch.setattr(build, "_contents", lambda entries, progress: dict.fromkeys(names, "new"))
    with monkeypatch.context() as full:
        full.setattr(Path, "replace", replace)
        with pytest.raises(InputError, match="argument --report: .*No space"):
            write_report(tmp_path, [])
    assert {path.name: path.read_text() for path in tmp_path.iterdir()} == dict.fromkeys(names, "old")
    write_report(tmp_path, [])
    assert {path.name: path.read_text() for path in tmp_path.iterdir()} == dict.fromkeys(names, "new")


@pytest.mark.slow
def test_the_published_report_has_the_same_bytes_under_hash_seeds_and_time_zones(tmp_path):
    """Each made by the command, with all laws on the page of the engine and every statement checked."""
    made = []
    for seed, zone in (("1", "UTC"), ("2", "Pacific/Kiritimati")):
        folder, surroundings = tmp_path / seed, {**os.environ, "PYTHONHASHSEED": seed, "TZ": zone, "LC_ALL": "C"}
        command = [sys.executable, "-m", "paper_checks", "--report", str(folder)]
        subprocess.run(command, check=True, env=surroundings, capture_output=True)
        made.append({path.name: path.read_bytes() for path in folder.iterdir()})
    assert made[0].keys() == made[1].keys()
    assert [name for name in made[0] if made[0][name] != made[1][name]] == []


def test_one_statement_on_the_command_line(capsys):
    assert main(["--id", "smith2012:62b", "--json"]) == 0
    entry = json.loads(capsys.readouterr().out)["entries"][0]
    assert entry["printed"] == "misprint"
    assert entry["evidence"] == "proved"
    assert entry["outcomes"] == {"printed": "refuted", "corrected": "confirmed", "near miss": "refuted"}
    assert {"id", "kind", "printed", "evidence", "corrected", "digits", "order", "methods"} <= set(entry)


def test_a_verdict_that_is_not_borne_out_ends_with_1(capsys, monkeypatch):
    entry = load()["smith2012:45"]
    changed = registry.Statement(**{**entry.__dict__, "printed": entry.near_miss})
    monkeypatch.setitem(registry._REGISTRY, entry.id, changed)
    assert main(["--id", entry.id, "--json"]) == 1
    shown = json.loads(capsys.readouterr().out)["entries"][0]
    assert (shown["printed"], shown["evidence"], shown["agrees"]) == ("open", "none", False)


@pytest.mark.parametrize(
    ("arguments", "named"),
    [
        (["nobody2000"], "PAPER"),
        (["--id", "smith2012" + ":nonsense"], "--id"),
        (["--report", "/dev/null/x"], "--report"),
    ],
)
def test_bad_requests_are_one_line(capsys, arguments, named):
    assert main(arguments) == 2
    captured = capsys.readouterr()
    assert captured.out == ""
    assert captured.err.count("\n") == 1
    assert named in captured.err


def test_the_readme_shows_the_recorded_verdicts():
    entries = [Entry(entry, expected_outcomes(entry), 0.0) for entry in load().values()]
    readme = (Path(__file__).parents[2] / "README.md").read_text()
    assert markdown_summary(entries) in readme, "paste the output of: python -m paper_checks --markdown"
