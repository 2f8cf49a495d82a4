"""Every derivation as LaTeX: a document that stands alone, whose specials are written out and whose groups close."""

import re
import shutil
import subprocess

import pytest
import sympy

from derivations.__main__ import derivation, main, names
from derivations.breaking import broken
from derivations.document import display, document
from derivations.pieces import parse, width
from derivations.steps import At, Derivation
from derivations.words import GREEK, formula, worded

ENGINE = shutil.which("pdflatex")
TOKEN = re.compile(r"\\begin\{(\w+\*?)\}(?:\{l\})?|\\end\{(\w+\*?)\}|\\[A-Za-z]+|\\.|[^\\]", re.DOTALL)
TEXT = {"section", "texttt", "emph", "quad", "dots", "allowbreak"}
PARTNER = {"}": "{", r"\]": r"\["}


def lexed(latex):
    """What is wrong with the body of a document: what does not close, and what a text has outside of a formula."""
    found, opened = [], []
    for token in TOKEN.finditer(latex):
        piece, begins, ends = token[0], token[1], token[2]
        if begins or piece in ("{", r"\["):
            opened.append(begins or piece)
        elif ends or piece in PARTNER:
            last = opened.pop() if opened else None
            if last != (ends or PARTNER[piece]):
                found.append(f"{piece} closes {last}")
        elif piece == "$":
            if "$" in opened:
                opened.remove("$")
            else:
                opened.append("$")
        text = not {"$", r"\[", "align*"} & set(opened)
        if text and not (begins or ends) and wrong_in_text(piece):
            found.append(f"{piece} in a text")
        elif not text and (piece in ("#", "%") or (piece == "&" and "align*" not in opened)):
            found.append(f"{piece} in a formula")
        elif not piece.isascii():
            found.append(piece)
    found += re.findall(r"\^\{(?:[^{}]|\{[^{}]*\})*\} *(?:_\{[^{}]*\} *)?['^]", latex)  # raised twice
    return found + [f"{one} is not closed" for one in opened]


def wrong_in_text(piece):
    return piece in tuple("_^&#%~<>|") or (piece.startswith("\\") and piece[1:].isalpha() and piece[1:] not in TEXT)


def body(latex):
    return latex.split(r"\begin{document}")[1].split(r"\end{document}")[0]


def compiled(latex, folder):
    """The log of a run; AssertionError where it ends with an error."""
    (folder / "one.tex").write_text(latex, encoding="utf-8")
    command = [ENGINE, "-draftmode", "-interaction=batchmode", "-halt-on-error", "one.tex"]
    ended = subprocess.run(command, cwd=folder, capture_output=True, timeout=100, check=False)
    log = (folder / "one.log").read_text(encoding="latin-1")
    assert ended.returncode == 0, log[-3000:]
    return log


@pytest.mark.parametrize("name", names())
def test_specials_are_written_out_and_groups_close(name):
    latex = body(derivation(name).latex())
    assert lexed(latex) == []
    for line in latex.splitlines():
        assert line.count(r"\left") == line.count(r"\right"), line
    formulas = r"\$[^$]*\$|\\\[.*?\\\]|\\begin\{align\*\}.*?\\end\{align\*\}|\\texttt\{[^}]*\}"
    prose = re.sub(formulas, " ", latex, flags=re.DOTALL)
    assert not re.search(rf"(?<![\w-])(?:{'|'.join(sorted(GREEK))})(?![\w-])|->|>=", prose)


@pytest.mark.parametrize("name", names())
def test_no_sign_is_doubled(name):
    for step in derivation(name).steps:
        assert not re.search(r"[+-] *(\\left\. *)?[+-]", step.latex()), step.reason


@pytest.mark.skipif(ENGINE is None, reason="no TeX engine")
def test_all_together_compile_and_no_line_is_too_wide(tmp_path):
    log = compiled(document(map(derivation, names())), tmp_path)
    assert re.findall(r"Overfull \\hbox \((\d{2,})", log) == []


@pytest.mark.slow
@pytest.mark.skipif(ENGINE is None, reason="no TeX engine")
@pytest.mark.parametrize("name", names())
def test_each_compiles_alone(name, tmp_path):
    compiled(derivation(name).latex(), tmp_path)


@pytest.mark.skipif(ENGINE is None, reason="no TeX engine")
def test_what_does_not_compile_or_is_too_wide_is_noticed(tmp_path):
    good = Derivation("good", "A sum", source="x_1")
    assert "Overfull" not in compiled(good.latex(), tmp_path)
    with pytest.raises(AssertionError, match="Missing"):
        compiled(good.latex().replace("$x_{1}$", "x_1"), tmp_path)
    wide = r"\[" + " + ".join(80 * ["a"]) + r"\]" + "\n" + r"\end{document}"
    assert "Overfull" in compiled(good.latex().replace(r"\end{document}", wide), tmp_path)


@pytest.mark.parametrize(
    "bad", ["a_1", "50 %", "$a", r"\[ a", "a}", r"\begin{align*} a", "é", r"\alpha", r"\[ a & b \]", "$a^{b}'$"]
)
def test_the_lexer_notices(bad):
    assert lexed(bad)
    assert not lexed(r"\emph{A} $a_{1}$, 50 \% \[ \alpha^{2} \] \begin{align*} & a \\ & b \end{align*}")


LONG = " + ".join(60 * ["a"])


@pytest.mark.parametrize(
    "latex", [LONG, rf"\left({LONG}\right) b", rf"\frac{{{LONG}}}{{2}}", rf"\left. b \right|_{{c = {LONG}}}"]
)
def test_a_wide_display_is_broken_at_every_level(latex):
    lines = broken(latex)
    assert len(lines) > 1 or r"\\" in lines[0]
    assert all(width(parse(line)) < 460 for line in lines if "subarray" not in line)
    assert len(re.findall(r"\ba\b", " ".join(lines))) == 60
    assert lexed(display(latex)) == []
    assert broken("a = b") == ["a = b"]


def test_formulas_in_plain_characters():
    assert formula("w^alpha_1/w^alpha") == r"w^{\alpha_{1}}/w^{\alpha}"
    assert formula("b' v^alpha' w'") == r"b' v^{\alpha'} w'"
    assert formula("sum_(n>=3) b_n") == r"\sum_{n \ge 3} b_{n}"
    assert worded("a term a w, a = 2, over D_3 a and (x = 1)") == "a term a $w$, $a = 2$, over $D_{3} a$ and $(x = 1)$"
    assert worded("half-swings of asymptotics.flow, 50 %") == (
        r"half-swings of \texttt{asymptotics.\allowbreak flow}, 50 \%"
    )


def test_the_command_prints_all(capsys):
    assert main(["--latex"]) == 0
    assert capsys.readouterr().out.count(r"\section*") == len(names())


def test_a_negative_term_at_a_place_stands_in_brackets():
    x = sympy.Symbol("x")
    assert r"- \left. \left(- \frac{x}{2}\right) \right|" in sympy.latex(1 - At(-x / 2, {x: 2}))
