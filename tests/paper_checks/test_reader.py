"""The printed LaTeX is tied to the form: read by machine, or compared by hand and recorded."""

import random
import re
from dataclasses import replace
from pathlib import Path

import pytest
import sympy

from paper_checks.grammar import UnreadableError, read
from paper_checks.near_misses import WORDS
from paper_checks.quoted import COMPUTED, quoted, texts, untied
from paper_checks.reader import (
    CORRECTED,
    REFERENCES,
    SORTS,
    Tie,
    compared,
    digest,
    how_read,
    ledger,
    numbered,
    references,
    tie,
    tied,
)
from paper_checks.registry import FOLLOW_UPS, Entry, load
from paper_checks.verdict import Evidence, Printed
from tests.each import each

ENTRIES = load()
NUMBERED = [entry for entry in ENTRIES.values() if numbered(entry)]
LEDGER = ledger()
DIGESTS = {key: digest for sort in SORTS for key, digest in LEDGER[sort].items()}
READ = {sort: [key for key in LEDGER[sort] if numbered(ENTRIES[key])] for sort in SORTS}
WHOLE = [
    name
    for key in READ[Tie.WHOLE]
    for name in (key, key + CORRECTED)
    if name == key or ENTRIES[key].corrected_latex is not None
]
ROOT = Path(__file__).parents[2]

GREEK = "alpha|beta|zeta|eta|theta|gamma|kappa|lambda|mu|omega|pi|tau"
SIGNS = "ll|gg|simeq|approx|le|ge|neq|pm|mp"
COMMANDS = rf"{GREEK}|{SIGNS}|sin|cos|ln|exp|sqrt|hat|dot|ddot|tilde|infty|min|max"
TOKEN = re.compile(
    rf"\\(?:{COMMANDS})(?![a-z])|(?<![A-Za-z\\_])d[vxt](?![a-z])|[0-9]|[+\-=<>']|(?<![A-Za-z\\])[A-Za-z](?![a-z])"
)
SAYS_THE_SAME = {  # an even power of -1, where the exponent is changed by an even number
    "smith2012:62b corrected": "(-1)^{k+1}",
    "smith2012:65": "(-1)^{(n+2)/2}", "smith2012:66": "(-1)^{(n+4)/2}", "smith2012:67": "(-1)^{(n+2)/2}",
}  # fmt: skip
OTHER = {"+": "-", "-": "+", "=": "<", "<": ">", ">": "<", "'": "", "dv": "dx", "dx": "dv", "dt": "dx"}
PAIRS = ("sin cos", "ll gg", "le ge", "pm mp", "ln exp", "min max", "dot ddot")
OTHER |= {f"\\{a}": f"\\{b}" for pair in map(str.split, PAIRS) for a, b in (pair, pair[::-1])}
OTHER |= {r"\simeq": "=", r"\approx": "=", r"\neq": "=", r"\infty": "0", r"\hat": "", r"\tilde": "", r"\sqrt": ""}
FIXED = re.compile(r"\\(?:begin|end)\{cases\}|\\(?:text|mathrm)\{[^{}]*\}|\(t\)")


def altered(latex):
    """The formula with one token another (a digit one more, a sign the other, a letter q (q: h), a command its like),
    with two sides of a sign exchanged, and with the conditions of two cases exchanged, each in turn."""
    fixed = [found.span() for found in FIXED.finditer(latex)]
    for found in TOKEN.finditer(latex):
        if not any(first <= found.start() < last for first, last in fixed):
            other = OTHER.get(found[0])
            if other is None:
                other = str((int(found[0]) + 1) % 10) if found[0].isdigit() else "q" if found[0] != "q" else "h"
            yield f"{latex[: found.start()]}{other} {latex[found.end() :]}"
    yield from (changed for _, changed in exchanged(latex))


CHAIN = re.compile(r"(\\simeq|\\approx|\\ll|\\xrightarrow\{[^{}]*\}|=)")
CONDITION = re.compile(r"&.*?(?=\\\\|\\end)")


def exchanged(latex):
    """The conditions of two cases exchanged; of a chain, the sides of an order and neighbouring signs."""
    first, second = (CONDITION.findall(latex) * 2)[:2] if CONDITION.search(latex) else ("", "")
    if first != second:
        mark = "?"
        yield "conditions", latex.replace(first, mark).replace(second, first).replace(mark, second)
    pieces = CHAIN.split(latex.partition(r" \qquad")[0])
    for k in range(1, len(pieces) - 1, 2):
        if pieces[k] != "=":
            yield "sides", "".join([*pieces[: k - 1], pieces[k + 1], pieces[k], pieces[k - 1], *pieces[k + 2 :]])
    for k in range(1, len(pieces) - 3, 2):
        if pieces[k] != pieces[k + 2]:
            yield "signs", "".join([*pieces[:k], pieces[k + 2], pieces[k + 1], pieces[k], *pieces[k + 3 :]])


def printed(key):
    """LaTeX and form of a statement, or of what is true instead of it."""
    entry = ENTRIES[key.removesuffix(CORRECTED)]
    return (entry.corrected_latex, entry.corrected) if key.endswith(CORRECTED) else (entry.latex, entry.printed)


def unnoticed(key, changes):
    noticed = (changed for changed in changes if tie(changed, printed(key)[1], key) == Tie.WHOLE)
    return [changed for changed in noticed if SAYS_THE_SAME.get(key, "none") not in changed.replace(" ", "")]


def test_what_is_read_wholly_in_part_and_not_is_listed():
    assert set(DIGESTS) == set(ENTRIES)
    found = {key: how_read(entry) for key, entry in ENTRIES.items()}
    for sort in (Tie.WHOLE, Tie.PART):
        assert [key for key in found if found[key] == sort] == list(LEDGER[sort])
    counts = [len(READ[sort]) for sort in SORTS]
    page = (ROOT / "docs/certified.md").read_text()
    assert f"{counts[0]} of the {len(NUMBERED)} numbered equations\nwholly" in page
    assert f"{counts[1]} in part; the other {counts[2]}" in page
    assert f"all {len(ENTRIES)} statements" in page


@each("key", DIGESTS)
def test_latex_and_form_are_those_that_were_compared(key):
    assert digest(ENTRIES[key]) == DIGESTS[key], f"{key}: compare what is printed and the forms, then --compared"


def test_the_references_are_those_that_were_compared(monkeypatch):
    assert references() == LEDGER[REFERENCES]
    number, title, ids = FOLLOW_UPS[0]
    typo = number[:-2] + number[:-3:-1]  # the last two digits exchanged
    monkeypatch.setattr("paper_checks.reader.FOLLOW_UPS", ((typo, title, ids), *FOLLOW_UPS[1:]))
    assert typo != number and references() != LEDGER[REFERENCES]


@pytest.mark.parametrize("key", random.Random("reader").sample(WHOLE, 25))
def test_one_token_changed_in_the_latex_is_noticed(key):
    changes = list(altered(printed(key)[0]))
    assert unnoticed(key, random.Random(key).sample(changes, min(2, len(changes)))) == []


def test_the_left_side_a_limit_a_sign_and_a_word_are_read():
    key, latex = "lancaster2020:10", ENTRIES["lancaster2020:10"].latex
    for old, new in (
        (r"\int_0", r"\int_1"),
        ("A(t)", "B(t)"),
        (r"\neq 1", r"\neq 2"),
        (r"{1-\alpha} =", r"{2-\alpha} ="),
    ):
        assert tied(latex.replace(old, new), ENTRIES[key].printed, key)
        assert unnoticed(key, [latex.replace(old, new)]) == []
    assert unnoticed("lelas2024:21", [r"b \gg 2\sqrt{km}", r"b = 2\sqrt{km}", r"2\sqrt{km}"]) == []
    assert unnoticed("smith2012:29", [ENTRIES["smith2012:29"].latex.replace("t_-", "t_+")]) == []


@pytest.mark.parametrize(
    ("key", "kind"),
    [(f"smith2012:{n}", "conditions") for n in ("35", "36", "50", "52c", "63", "65")]
    + [(f"lelas2024:{n}", "sides") for n in (21, 33, 46, 50, 53)]
    + [(f"lancaster2020:{n}", "sides") for n in (3, 14, 15, 16, 22)]
    + [(f"lancaster2020:{n}", "signs") for n in (14, 15, 16)],
)
def test_conditions_sides_and_signs_exchanged_are_noticed(key, kind):
    changed = dict(exchanged(ENTRIES[key].latex))
    assert kind in changed
    assert unnoticed(key, [latex for name, latex in exchanged(ENTRIES[key].latex) if name == kind]) == []


@pytest.mark.slow
@pytest.mark.parametrize("key", WHOLE)
def test_every_token_changed_in_the_latex_is_noticed(key):
    assert unnoticed(key, altered(printed(key)[0])) == []


@pytest.mark.parametrize("latex", [r"\oint x", "x +", r"\frac{x}", "y", r"x_{", "(x", r"\sin x"])
def test_what_is_not_known_is_said(latex):
    with pytest.raises(UnreadableError):
        read(latex, {"x": sympy.Symbol("x")})


@pytest.mark.parametrize(
    ("key", "printed", "without"),
    [("lelas2024:22", "v_1", "v"), ("lelas2024:23", "v_2", "v"), ("lelas2024:34", "v_1", "v"),
     ("lelas2024:35", "v_2", "v"), ("lelas2024:22", "v_1", "v_2"), ("smith2012:72", "E_n", "E")],
)  # fmt: skip
def test_an_index_that_is_lost_is_noticed(key, printed, without):
    entry = ENTRIES[key]
    assert tie(entry.latex, entry.printed, key) == Tie.WHOLE
    assert tie(entry.latex.replace(printed, without), entry.printed, key) != Tie.WHOLE


def test_corrected_formulas_differ_from_the_printed_ones():
    for entry in NUMBERED:
        if entry.verdict in (Printed.MISPRINT, Printed.PARTLY):
            assert entry.corrected_latex != entry.latex


TYPOS = (  # planted by referees, who saw none noticed: the field, what is printed, what it became
    ("lelas2024:value.tau-a", "latex", "12.9", "12.8"),
    ("lelas2024:value.tau-a", "note", "12.8941", "12.8491"),
    ("lancaster2020:fn22", "latex", r"-\frac{c}{c'}", r"\frac{c}{c'}"),
    ("lancaster2020:table1.alpha2", "latex", "4b", "8b"),
    ("lancaster2020:claim.kappa-fig1", "latex", "0.042", "0.024"),
    ("lancaster2020:claim.large-b-agreement", "note", "87 %", "78 %"),
    ("smith2012:table1.S5", "note", "0.14158827", "0.14158872"),
    ("lelas2024:claim.better-approximation", "note", "0.1141", "0.1411"),
    ("lancaster2020:claim.kappa-fig1", "conditions", "0.0667", "0.0676"),
    ("smith2012:fig5", "note", "0.358", "0.385"),
    ("lancaster2020:fn22", "latex", r"1+\alpha-2", r"1-\alpha-2"),
    ("lancaster2020:table1.alpha3-2", "latex", r"{5\pi", r"{3\pi"),
    ("lancaster2020:claim.valid-for-any-b", "conditions", "6 %", "9 %"),
    ("lelas2024:claim.same-decay-friction", "corrected_latex", r"{2} - ", r"{2} + "),
)


@pytest.mark.parametrize(("key", "field", "right", "wrong"), TYPOS)
def test_a_typo_in_what_is_printed_is_noticed_by_the_run_and_named(key, field, right, wrong):
    entry = ENTRIES[key]
    assert getattr(entry, field).count(right) == 1
    changed = replace(entry, **{field: getattr(entry, field).replace(right, wrong)}, check=None)
    assert compared(entry) and not compared(changed)
    result = Entry(changed, {}, 0.0, compared=False)
    assert result.printed == Printed.OPEN and result.evidence == Evidence.NONE
    if "latex" not in field:
        assert untied(changed) == [text for text in quoted(texts(changed)) if wrong in text]


def test_what_is_shown_of_a_near_miss_in_words_is_compared(monkeypatch):
    entry = ENTRIES["lancaster2020:fig2"]
    monkeypatch.setitem(WORDS, entry.id, WORDS[entry.id].replace("1.99", "1.98"))
    assert not compared(entry) and compared(ENTRIES["lancaster2020:fig3"])


@pytest.mark.parametrize("change", [{"digits": 3}, {"order": "2"}, {"extent": "sampled: 9 points"}, {"slip": "none"}])
def test_what_is_shown_beside_a_statement_is_compared(change):
    assert not compared(replace(ENTRIES["lelas2024:value.tau-tilde-a"], **change))


@each("key", ENTRIES)
def test_every_number_in_a_note_is_the_statements_own_or_computed(key):
    assert untied(ENTRIES[key]) == []


def test_no_computed_number_is_left_over():
    for key, known in COMPUTED.items():
        assert set(known) <= set(quoted(texts(ENTRIES[key]))), key
