"""A printed formula taken apart: its members in their order, the signs between them, and what stands beside each.

>>> list(displays_of(r"A(t) \\simeq \\int_0^t v\\,dt'", "", Reading()))
[([('A', []), ('\\\\int v 1', ['\\\\int_0^t', "dt'"])], ['\\\\simeq'])]
"""

import re
from collections.abc import Iterator

from paper_checks.readings import PAPERS, Reading

RELATION = re.compile(r"\\simeq|\\approx|\\sim|\\ll|\\gg|\\propto|\\ge|\\to|[=<>]")
MODULUS = re.compile(r"\|([^|]+)\|")
LIMITS = re.compile(
    r"\\int(?:_\{[^{}]*(?:\{[^{}]*\})?[^{}]*\}|_[a-z0-9])?(?:\^\{[^{}]*(?:\{[^{}]*\})?[^{}]*\}|\^[a-z0-9])?"
)
BOUNDARY = re.compile(r"(?:\\Big\||\\bigg\||\\right\|)_\{[^{}]*\}\^(?:\{[^{}]*\}|[a-z])|\\left\.")
WORDS = re.compile(r"\\text\{[^{}]*\}")
TAIL = re.compile(r",? *\\qquad.*|, \\quad.*")
DIFFERENTIAL = re.compile(r"(?:\\,)?(?<![A-Za-z_\\])d[vxtA]'?(?![A-Za-z])")
SUMS = re.compile(r"\\sum(?:_\{[^{}]*\})?(?:\^\{[^{}]*(?:\{[^{}]*\}[^{}]*)*\})?")
ACCENT = re.compile(r"\\(dot|ddot|tilde|hat)\{? *([A-Za-z])\}?")
CASE = re.compile(r",? *&.*?(?=\\\\|\\end)")
BRANCH = re.compile(r"(\\hatS|S) *\^\{?([-+])\}?")
PRIVATE = re.compile("[\ue000-\uf8ff]")
ARROW = re.compile(r"\\xrightarrow\{(.*?) \\gg 1\}")
BETA = re.compile(r"B\\left[(\[](.*?),(.*?)\\right[)\]]")
HYPER = re.compile(r"\{\}_2F_1\\left\((.*?),(.*?);(.*?);(.*?)\\right\)")

Display = tuple[list[tuple[str, list[str]]], list[str]]
"""Members, each with what stands beside it (limits, words, a condition), and the relation signs between them."""


def displays_of(latex: str, key: str, reading: Reading) -> Iterator[Display]:
    """The chain of members and relation signs, for both double signs; what stands beside a member stays with it."""
    aside = _Aside()
    text = MODULUS.sub(r"\\abs{\1}", aside.set(BOUNDARY, "", latex).replace(r"\left|", "|").replace(r"\right|", "|"))
    text = text.replace("(t)", "").replace(r"\mathrm{sgn}", r"\sgn").replace(r"\cdot", "")
    for before, after in (*PAPERS.get(key.partition(":")[0], ()), *reading.letters):
        text = re.sub(" +", " ", text.replace(before, f" {after}"))
    text = ACCENT.sub(r"\\\1\2 ", text)
    kept = () if reading.differentials else ((DIFFERENTIAL, " 1 "),)
    for pattern, instead in ((CASE, ""), (WORDS, "="), (LIMITS, r"\int "), (SUMS, r"\int "), *kept, (TAIL, "")):
        text = aside.set(pattern, instead, text)
    text = BETA.sub(r"\\B{\1}{\2}", ARROW.sub(r"\\to \1 \\to", HYPER.sub(r"\\hyper{\1}{\2}{\3}{\4}", text)))
    text = re.sub(r"\\begin\{cases\}|\\end\{cases\}|\\\\", "=", text)
    for upper, lower in (("-", "+"), ("+", "-")) if re.search(r"\\(mp|pm)", text) else (("-", "+"),):
        signed = BRANCH.sub(_branch, text.replace(r"\mp", upper).replace(r"\pm", lower))
        yield [aside.part(member) for member in RELATION.split(signed)], RELATION.findall(signed)


class _Aside:
    """What is taken out of a text, each piece with a mark (a private character) in its place."""

    first = 0xE000

    def __init__(self) -> None:
        self.pieces: list[str] = []

    def set(self, pattern: re.Pattern[str], instead: str, text: str) -> str:
        """The text with something else in the place of what the pattern finds, marked where that says anything."""

        def marked(match: re.Match[str]) -> str:
            said = match[0].replace(" ", "").removeprefix(r"\,")
            piece = PRIVATE.sub(lambda mark: self.pieces[ord(mark[0]) - self.first], said)
            if piece in (r"\int", r"\left."):
                return instead
            self.pieces.append(piece)
            return chr(self.first + len(self.pieces) - 1) + instead

        return pattern.sub(marked, text)

    def part(self, member: str) -> tuple[str, list[str]]:
        """A member without its marks, and the pieces for which they stand."""
        beside = [self.pieces[ord(mark) - self.first] for mark in PRIVATE.findall(member)]
        return re.sub(" +", " ", PRIVATE.sub("", member)).strip().rstrip(",;"), beside


def _branch(match: re.Match[str]) -> str:
    r"""S^+ and S^-, \hat S^+ and \hat S^- as letters with an index."""
    return f"{match[1]}_{{{'plus' if match[2] == '+' else 'minus'}}}"
