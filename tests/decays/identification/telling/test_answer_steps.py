"""The whole answer, entry by entry: its JSON, its table, its page and its report, each from known numbers."""

from types import SimpleNamespace

import numpy as np
import pytest

from asymptotics.decays.identification.fitting.printed import Decrements
from asymptotics.decays.identification.fitting.profile import Interval
from asymptotics.decays.identification.judging.allowance import Allowance
from asymptotics.decays.identification.judging.laws import UNTRIED
from asymptotics.decays.identification.measuring.observations import Observations
from asymptotics.decays.identification.telling import equivalents, result
from asymptotics.decays.identification.telling import html_report as report
from asymptotics.decays.identification.telling.result import Identification, LawAnswer, RecordUnits
from asymptotics.decays.identification.telling.verdicts import IDENTIFIED, Verdict
from asymptotics.errors import InputError
from tests.decays.identification.small_laws import SURE, fit, law

SEEN = Observations.of([0, 1, 2], [0.5, -0.4, 0.32], [0.0, 1.0, 2.0], unit="mm", name="a <run>")
FIT = fit(2.0, bic=1.0)


def law_answer(text="1", **more):
    return LawAnswer(law(text, FIT, excess=0.5, **more), RecordUnits("mm", 1e-3))


def answer(*laws, runs=(SEEN,), **more):
    known = {
        "verdict": Verdict(IDENTIFIED, "identified: 1", "more swings", (Allowance("2", 0.01, 0.1),)),
        "textbook": {}, "notes": ("a note",), "units": RecordUnits("mm", 1e-3, omega_0=2.0),
    }  # fmt: skip
    return Identification(laws=laws or (law_answer(),), runs=runs, **(known | more))


@pytest.fixture
def words(monkeypatch):
    """What a law means at its amplitudes, as known numbers."""
    known = {
        "amplitudes": [0.5, 0.32],
        "Q": [10.0, 20.0],
        "zeta": [0.05, 0.025],
        "half_life": np.inf,
        "half_life_unit": "s",
    }
    asked = []
    for module in (result, equivalents):
        monkeypatch.setattr(module, "equivalent", lambda law, omega: (asked.append((law, omega)), known)[1])
    monkeypatch.setattr(result, "agreed", lambda laws, units: None)  # what all laws say of Q: told elsewhere
    monkeypatch.setattr(LawAnswer, "lines", property(lambda answer: (f"words of {answer.law.candidate}",)))
    return SimpleNamespace(known=known, asked=asked)


def test_every_entry_of_the_json_of_an_answer(words):
    untried = law_answer("2", missed=UNTRIED, verdict="undetermined")
    found = answer(law_answer(), untried).to_dict()
    assert found.pop("laws") == [law_answer().to_dict(), untried.to_dict()]
    assert found.pop("envelope")["quality"] and found.pop("agreed") is None is found.pop("envelope_untold")
    assert found == {
        "verdict": "identified: 1", "verdict_kind": IDENTIFIED, "telling": "more swings",
        "equivalent": {"amplitudes": ["0.5", "0.32"], "Q": ["10", "20"], "zeta": ["0.05", "0.025"], "half_life": None,
                       "half_life_unit": "s"},
        "not_excluded": [Allowance("2", 0.01, 0.1).to_dict()], "untried": ["2"],
        "data": [{"name": "a <run>", "turning_points": 3, "times": True, "first": "0.5"}], "textbook": {}, "unit": "mm",
        "omega_0": "2", "notes": ["a note"],
    }  # fmt: skip
    best = answer().best.law
    assert {omega for one, omega in words.asked if one == best} == {2.0, None}  # of the record, and of the law alone


def test_what_an_answer_does_not_know_is_null(words):
    verdict = Verdict(IDENTIFIED, "identified: 1")
    one = answer(verdict=verdict, units=RecordUnits())
    several = answer(verdict=verdict, units=RecordUnits(), per_run=(one, one))
    found = several.to_dict()
    assert (found["telling"], found["unit"], found["omega_0"]) == (None, None, None)
    assert found["runs"] == [one.to_dict()] * 2 and "runs" not in one.to_dict()
    assert several.in_words == one.in_words and one.in_words.startswith("Q = 10 at 0.5, 20 at 0.32")
    assert answer().in_words.startswith("Q = 10 at 0.5 mm, 20 at 0.32 mm")


def test_the_envelope_is_that_of_the_first_run_and_says_whether_a_law_is_known(words):
    n = np.arange(30)
    long = Observations.of(n, (-1.0) ** n * np.exp(-0.05 * n), 0.5 * n)
    for kind, known in ((IDENTIFIED, True), ("undecided", False)):
        found = answer(runs=(long, SEEN), verdict=Verdict(kind, "x")).to_dict()["envelope"]
        assert found["law_known"] == known and found["period"]["estimate"] == "1"
    none = answer(runs=(Decrements(np.ones(3), np.ones(3) / 10),)).to_dict()
    assert none["envelope"] is None and none["envelope_untold"].startswith("decrements are no decay")


def test_the_table_has_its_columns_under_each_other(words):
    laws = (law_answer("1", held_out=1.25), law_answer("0+1+2+3", epsilon=(SURE,) * 4, verdict="refuted"))
    lines = answer(*laws).table().splitlines()
    assert lines[0] == "law      verdict     dAICc  held-out  strengths [interval]"
    assert lines[1] == "1        consistent  0.5    1.25      0.05 [0.04, 0.06]"
    assert (
        lines[2].startswith("0+1+2+3  refuted     0.5    -         0: 0.05 [0.04, 0.06]  1: 0.05") and len(lines) == 3
    )
    many = answer(*[law_answer()] * 14)
    assert len(many.table().splitlines()) == 13 and len(many.table(2).splitlines()) == 3
    with pytest.raises(InputError, match="count"):
        many.table(0)


def test_the_page_and_the_formula_of_an_answer(words):
    found = answer(law_answer("1+2", epsilon=(SURE, SURE)), law_answer())
    page = found._page()
    assert page.title == "identified: 1" and page.lines == (*found.lines, "more swings", "a note")
    assert found.lines == ("words of 1", found._bare().in_words())  # the law of the verdict: 1+2 contains it
    assert page.head == ("law", "verdict", "ΔAICc", "held-out error", "strengths [interval]")
    assert page.rows == tuple(one.row() for one in found.laws)
    assert found._heading() == "identified: 1" and repr(found) == "Identification(identified: 1)"
    assert found._formula().startswith(r"\text{identified: 1}\quad\text{first of 2: } x'' + x + \varepsilon_{1} x'")
    assert found.best is found.laws[0] and found.law("1") is found.laws[1]
    with pytest.raises(InputError, match="text"):
        found.law("3")
    assert found._table()["parameter"] == ["epsilon 1", "epsilon 2", "epsilon 1"]
    assert answer()._letters() == law_answer()._letters() and answer()._letters()["x"] == "displacement"


@pytest.mark.parametrize(
    ("text", "tex"),
    [
        ("0", r"x'' + x + \varepsilon_{1} \operatorname{sgn}(x') = 0"),
        ("1+2+s3", r"x'' + x + \varepsilon_{1} x' + \varepsilon_{2} x'|x'| + c_{3} x^3 = 0"),
        ("free", r"x'' + x + \varepsilon_{1} x'|x'|^{\alpha-1} = 0"),
        ("3/2", r"x'' + x + \varepsilon_{1} x'|x'|^{3/2-1} = 0"),
    ],
)
def test_a_law_has_its_formula_in_tex(text, tex):
    assert law_answer(text)._formula() == tex


def test_the_page_of_a_law_has_a_row_for_each_strength():
    one = law_answer("1+2", epsilon=(SURE, Interval(None, 1 / 3, None)), verdict="refuted", reason="why")
    page = one._page()
    assert page.title == "law 1+2: refuted" and page.lines == ("why", "intervals: curvature")
    assert page.head == ("", "estimate", "at least", "at most")
    assert page.rows == (("epsilon 1", "0.05", "0.04", "0.06"), ("epsilon 2", "0.333333", "no limit", "no limit"))
    assert one._table()["low"] == [0.04, None] and LawAnswer(law("1", FIT, epsilon=()))._table() == {}
    with pytest.raises(InputError, match="argument i"):
        one.physical(2)


def drawn(monkeypatch, *names):
    asked = []

    def picture(self, kind, *, size, panels):
        asked.append((self.runs[0].name, kind, size, panels))
        if not self.runs[0].name:
            raise InputError("plot", "nothing < to draw", "x")
        return b'<?xml version="1.0"?><svg>drawn</svg>'

    monkeypatch.setattr(Identification, "picture", picture)
    monkeypatch.setattr(report, "_textbook", lambda answer: "")
    return asked


def test_a_report_has_a_picture_of_each_run_or_says_why_not(monkeypatch, words):
    asked = drawn(monkeypatch)
    one, two = answer(), answer(runs=(Observations.of([0, 1], [1.0, -0.5]),))
    pictures = list(report._pictures(answer(per_run=(one, two))))
    label = "decay, decrement against amplitude, residuals and profiles of a &lt;run&gt;"
    assert pictures == [
        f'<figure role="img" aria-label="{label}"><svg>drawn</svg></figure>',
        "<p>No picture: nothing &lt; to draw.</p>",
    ]
    assert asked == [("a <run>", "svg", (10, 7.5), True), ("", "svg", (10, 7.5), True)]
    assert len(list(report._pictures(one))) == 1


def test_a_report_names_its_runs_its_laws_and_its_provenance(monkeypatch, words):
    drawn(monkeypatch)
    page = report.html_report(answer(law_answer(reason="for < this")), {"SHA-256": "<digest>"})
    for wanted in (
        "Which damping law? a &lt;run&gt;", "<p>more swings</p>", "<p>words of 1</p>",
        "x'' + x + e1 x' = 0",
        "<tr><td>1</td><td>consistent</td><td>0.5</td><td>-</td><td>0.05 [0.04, 0.06]</td><td>for &lt; this</td></tr>",
        "<th>law</th><th>verdict</th><th>ΔAICc</th><th>held-out error</th><th>strengths [interval]</th><th>why</th>",
        "<tr><td>SHA-256</td><td>&lt;digest&gt;</td></tr>", "<ul><li>a note</li></ul>", "identified: 1",
        "<tr><td>arithmetic</td><td>Python ", ", NumPy ", ", SciPy ", "<tr><td>made by</td><td>",
        "<tr><td>program</td><td>power-law-oscillator ",
        "<tr><td>a &lt;run&gt;</td><td>3 turning points with times, |x| from 0.5 to 0.32 mm</td></tr>",
    ):  # fmt: skip
        assert wanted in page, wanted
    silent = answer(verdict=Verdict(IDENTIFIED, "identified: 1"), per_run=(answer(),))
    assert "<p></p>" not in report.html_report(silent) and "more swings" not in report.html_report(silent)
    for wrong, name in (((3, None), "answer"), ((answer(), 3), "provenance")):
        with pytest.raises(InputError, match=f"argument {name}"):
            report.html_report(*wrong)


def test_textbook_estimators_have_a_table_where_there_are_some():
    found = {
        "Froude": {"alphas": ["1", "2"], "epsilon": ["0.1", "0.2"], "systematic_error": None},
        "Bertin": {"alphas": ["2"], "epsilon": ["0.3"], "systematic_error": ["0.01"]},
    }
    head = "<th>estimator</th><th>exponents</th><th>strengths</th><th>systematic error</th>"
    rows = (
        "<td>Froude</td><td>1, 2</td><td>0.1, 0.2</td><td>-</td>",
        "<td>Bertin</td><td>2</td><td>0.3</td><td>0.01</td>",
    )
    body = "".join(f"<tr>{row}</tr>" for row in (head, *rows))
    assert report._textbook(answer(textbook=found)) == f"<h2>Textbook estimators</h2><table>{body}</table>"
    assert report._textbook(answer()) == ""


def test_data_are_told_in_words():
    table = Decrements(np.array([0.5, 1.0, 0.7]), np.ones(3) / 10, None, "cm", "d")
    assert report._told(table) == ("d", "3 decrements, mean amplitudes from 1 to 0.5 cm")
    plain = Observations.of([0, 1], [-1.0, 0.123456])
    assert report._told(plain) == ("the data", "2 turning points without times, |x| from 1 to 0.1235")


def test_tables_and_texts_are_escaped_and_shortened():
    assert report.table(("", ""), [("a", "<b>")], "") == "<table><tr><td>a</td><td>&lt;b&gt;</td></tr></table>"
    assert report.table(("h",), [], "c & d") == "<table><caption>c &amp; d</caption><tr><th>h</th></tr></table>"
    assert report.text("\"'<") == "&quot;&#x27;&lt;" and len(report.text("a" * 3000)) < 2100
