r"""A referee's words, ranked: ``Lancaster eq. 13``, ``Smith Table I``, ``envelope for alpha = 3/2``, Greek or Latin.

A query is reduced to the name of a paper and words; a statement has a mark for each word, higher in its number than in
its title, its formula or its notes.  Those with every word come first.  The pages of the report do the same in
``search.js``, with the words of this file; a test holds both against each other.

>>> reduced("Smith Table I"), reduced("Lancaster eq. (13)"), reduced(chr(0x3BA) + ", Fig. 5")
((['smith2012'], ['table1']), (['lancaster2020'], ['13']), ([], ['kappa', 'fig5']))
>>> plain(r"\hat{S}_3 = \tfrac{3}{2} " + chr(0x3B1))
's_3=3/2 alpha'
"""

import re
from collections.abc import Iterable, Mapping
from dataclasses import dataclass

from asymptotics.papers.keywords import ALSO, ASKED, NAMED, SAID
from asymptotics.papers.statement import PaperStatement

GREEK = dict(zip(
    "\u03b1\u03b2\u03b3\u03b4\u03b5\u03b6\u03b7\u03b8\u03ba\u03bb\u03bc\u03bd\u03be\u03c0\u03c1\u03c3\u03c4\u03c6\u03c7\u03c8\u03c9\u0393\u0394\u03a9\u03a6\u03a8",
    ("alpha", "beta", "gamma", "delta", "epsilon", "zeta", "eta", "theta", "kappa", "lambda", "mu", "nu", "xi", "pi",
     "rho", "sigma", "tau", "phi", "chi", "psi", "omega", "gamma", "delta", "omega", "phi", "psi"),
))  # fmt: skip
ROMAN = {"i": "1", "ii": "2", "iii": "3", "iv": "4", "v": "5"}
AUTHORS = {"lancaster": "lancaster2020", "lelas": "lelas2024", "smith": "smith2012"}
YEARS = ("2012", "2020", "2024")
IDLE = ("a", "al", "an", "and", "are", "at", "be", "by", "do", "does", "eq", "eqn", "eqs", "equation", "et", "ever",
        "for", "formula", "how", "in", "is", "it", "no", "of", "on", "that", "the", "this", "to", "what", "when",
        "where", "which", "with")  # fmt: skip
MARKS = r"\\(hat|dot|ddot|tilde|bar|text|mathrm|left|right|quad|qquad)\b"


def plain(text: str) -> str:
    r"""Lower case without LaTeX: S_3 is found in \hat{S}_3, omega in \omega, 3/2 in \tfrac{3}{2}."""
    text = "".join(GREEK.get(letter, letter) for letter in text)
    text = re.sub(MARKS, "", text)
    text = re.sub(r"\\[td]?frac\{([^{}]*)\}\{([^{}]*)\}", r"\1/\2", text)
    return re.sub(r"\s*=\s*", "=", re.sub(r"[{}\\$]", "", text)).lower().strip()


def reduced(query: str) -> tuple[list[str], list[str]]:
    """(the papers that are named, the words): numbers of tables, figures and footnotes as in the ids."""
    text = plain(query)
    text = re.sub(r"\btable\.?\s*(i{1,3}|iv|v|\d+)\b", lambda m: "table" + ROMAN.get(m[1], m[1]), text)
    text = re.sub(r"\bfig(?:ure|\.)?\s*(\d)", r"fig\1", text)
    text = re.sub(r"\b(?:footnote|fn\.?)\s*(\d)", r"fn\1", text)
    text = re.sub(r"\b(?:eqs?|eqn|equation)\.?\s*\(?(\d)", r" \1", text)
    words = [word.strip(".,;:()?'\"") for word in re.split(r"[\s,;]+", text)]
    named = [AUTHORS[w.removesuffix("'s")] for w in words if w.removesuffix("'s") in AUTHORS]
    idle = (*IDLE, *AUTHORS, *(f"{author}'s" for author in AUTHORS), *(YEARS if named else ()))
    return named, [ALSO.get(w, w) for w in words if w and w not in idle]


def everyday(statement: str) -> str:
    """What a reader calls a statement, beside what it says itself."""
    return " ".join(
        words
        for start, words in SAID.items()
        if statement == start or start[-1] in ".-" and statement.startswith(start)
    )


@dataclass(frozen=True)
class Searched:
    """One entry as it is searched: its number, and its title, names, formula and notes, all ``plain``."""

    id: str
    title: str
    plain_words: str
    formula: str
    notes: str

    @classmethod
    def of(cls, s: PaperStatement) -> "Searched":
        """What is searched of a statement."""
        title, notes = plain(s.title), plain(" ".join((s.note, s.conditions, *s.methods)))
        said = [everyday(s.id), *(words for name, words in NAMED.items() if name in title), ASKED[s.printed]]
        return cls(s.id, title, " ".join(said), plain(f"{s.latex} {s.corrected or ''}"), notes)

    def marks(self, word: str) -> int:
        """How well a word fits, 0 if not at all."""
        own = self.id.partition(":")[2].lower()
        # The marks are an order of precedence, not a measure: the number itself before a part of it, a whole word in
        # the title before one in the formula, and those before parts of words and notes.  A formula that begins with
        # the word defines it.
        if own == word or self.id.lower() == word:
            return 100
        if own.startswith(f"{word}.") or own == f"claim.{word}":
            return 60
        lead = 6 if self.formula.startswith(word) else 0
        whole, titled, in_formula = rf"(?<![\w/]){re.escape(word)}(?![\w/])", word in self.title, word in self.formula
        if titled and re.search(whole, self.title) or word in self.plain_words.split():
            return 8 + lead
        if in_formula and re.search(whole, self.formula):
            return 4 + lead
        return 5 if titled else 2 if in_formula else 1 if word in self.notes or word in own else 0


def ranked(entries: Iterable[Searched], query: str) -> list[str]:
    """The ids that answer a query, best first; those with every word, else those with as many of them as any has."""
    named, words = reduced(query)
    chosen = [e for e in entries if not named or e.id.partition(":")[0] in named]
    if not words:
        return [e.id for e in chosen] if named else []
    found: list[tuple[int, int, str]] = []
    for place, entry in enumerate(chosen):
        marks = [entry.marks(word) for word in words]
        # 1000 is more than all marks of a word together (100), so that whoever has more of the words stands first.
        if any(marks):
            found.append((-sum(marks) - 1000 * sum(map(bool, marks)), place, entry.id))
    found.sort()
    most = max((-key[0] // 1000 for key in found), default=0)
    fullest = [key for key in found if -key[0] // 1000 == most]
    # Every word is the number itself: then nothing that only mentions it is shown.
    exact = [key for key in fullest if -key[0] >= 1100 * len(words)]
    return [key for *_, key in exact or fullest]


def words_for_pages() -> Mapping[str, object]:
    """The words of this file, for search.js."""
    return {"greek": GREEK, "roman": ROMAN, "authors": AUTHORS, "years": YEARS, "idle": IDLE, "marks": MARKS,
            "also": ALSO}  # fmt: skip
