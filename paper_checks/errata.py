r"""The errata of each paper on one sheet: place, printed, corrected, why in one line, and whether a result changes.

The formulas are those of the statements; here stands what a sheet says beside them.  ``origin`` tells slips of the
print from slips of the text at hand, where the text decides.

>>> sheet = sheets()["smith2012"]
>>> [len(found) for found in sheet.values()], sheet[PRINT][0].place, sheet[PRINT][0].effect
([13, 4, 2], 'Text above (38a)', 'nothing: (50) has it right')
"""

from dataclasses import dataclass
from functools import cache

from paper_checks.registry import PAPERS, Statement, load
from paper_checks.verdict import Printed


@dataclass(frozen=True)
class Origin:
    """Where a slip is from, as far as the text decides."""

    title: str


PRINT = Origin("Slips of the paper")
UNDECIDED = Origin("Print or transcription: the text does not decide")
GARBLED = Origin("Garbled in the text at hand")
ORIGINS = (PRINT, UNDECIDED, GARBLED)
WRONG = (Printed.MISPRINT, Printed.REFUTED, Printed.TRANSCRIPTION)
NONE = "none"
RIGHT_IN_50, UNSEEN = "nothing: (50) has it right", "nothing: the turning points do not see it"


@dataclass(frozen=True)
class Erratum:
    """One entry of a sheet."""

    statement: Statement
    place: str
    why: str
    effect: str
    origin: Origin


# id: place, why in one line, what changes, origin
LINES: dict[str, tuple[str, str, str, Origin]] = {
    "lancaster2020:claim.velocity-sign": (
        "Text above (19)", "(9) has the minus sign.", "nothing: only even powers of it enter (18)", PRINT),
    "lancaster2020:claim.slow-dissipation": (
        "Text below (5)", "The dot is lost; the text has A' there.", NONE, GARBLED),
    "lancaster2020:claim.energy-derivative": ("Text below (6)", "Two dots are lost; (8) has them.", NONE, GARBLED),
    "lancaster2020:table1.alpha3": (
        "Table I, exponent 3", "The left member is a remnant of the entry above; the right one is (13).", NONE,
        GARBLED),
    "lancaster2020:claim.weak-equals-slow": (
        "Text below (13)", "The middle of the sentence is lost.", NONE, GARBLED),
    "lelas2024:claim.number-of-sections": ("Section I", "The paragraph itself goes on to section VII.", NONE, PRINT),
    "lelas2024:10": (
        "Eq. (10)", "The derivative of (8) has a minus inside the bracket.", "nothing: the term is dropped in (12)",
        PRINT),
    "lelas2024:claim.force-of-47": ("Text above (47)", "(2) is viscous damping, (3) friction.", NONE, PRINT),
    "lelas2024:value.tau-tilde-a": (
        "Section V, first panel", "Computed from the rounded 12.9 s.", "the last digit of this time", PRINT),
    "lelas2024:value.tau-tilde-b": (
        "Section V, second panel", "Computed from the rounded 4.3 s.", "the last digit of this time", PRINT),
    "lelas2024:value.tau-exact-b": (
        "Section V, second panel", "Seven half periods; the paper reads it from its graph.",
        "the last digit of this time",
        PRINT),
    "lelas2024:claim.figure-of-section-6": (
        "Section VI", "The panels that differ in C are those of Fig. 2.", NONE, PRINT),
    "lelas2024:claim.integral-of-sin-cubed": (
        "Section VI", "Over a period sin^3 integrates to 0; the loss needs |sin|^3.",
        "nothing: (52) has the right average", PRINT),
    "lelas2024:claim.slope-small": (
        "Text below (11)", "The dot is lost; two lines earlier it is there.", NONE, GARBLED),
    "lelas2024:claim.integrated-rate": ("Text below (31)", "A fraction with a root was read twice.", NONE, GARBLED),
    "lelas2024:claim.slope-of-line": ("Text below (32)", "A fraction with a root was read twice.", NONE, GARBLED),
    "lelas2024:claim.stop-time-section-3": ("Text below (33)", "The root has lost its extent.", NONE, GARBLED),
    "lelas2024:claim.stop-time-section-5": ("Section V", "The root has lost its extent.", NONE, GARBLED),
    "smith2012:34": (
        "Eq. (34)", "With this sign (32) and (33) are not constant: damping lowers the frequency.",
        "the sign, wherever (34) is used", UNDECIDED),
    "smith2012:claim.integrating-factors": (
        "Text above (38a)", "The upper sign belongs to v < 0, as (38a) prints it.", RIGHT_IN_50, PRINT),
    "smith2012:38b": ("Eq. (38b)", "The two signs are exchanged against (36) and (38a).", RIGHT_IN_50, PRINT),
    "smith2012:40": ("Eq. (40)", "The two signs are exchanged, as in (38b).", RIGHT_IN_50, PRINT),
    "smith2012:48": (
        "Eq. (48)", "(50) at w = 0 and (49) have the other sign.", "nothing: (49) and (50) are right in it", UNDECIDED),
    "smith2012:49": (
        "Eq. (49)", "The second term is (42), with +1/4.", "nothing: Table I is computed with +1/4", PRINT),
    "smith2012:51": ("Eq. (51)", "The factor 1/4 of (42) and (48) is lost.", UNSEEN, PRINT),
    "smith2012:52a": ("Eq. (52a)", "The factor -1/4 of (42) is lost.", UNSEEN, PRINT),
    "smith2012:52b": ("Eq. (52b)", "The factor 1/4 of (48) is lost.", UNSEEN, PRINT),
    "smith2012:table1.S3": (
        "Table I, S_3", "A difference of two constants that were rounded before.", "the sixth decimal", PRINT),
    "smith2012:table1.S5": (
        "Table I, S_5", "A difference of two constants that were rounded before.", "the sixth decimal", PRINT),
    "smith2012:54": (
        "Eq. (54)", "A factor 2 is lost, which (72) has; and v < 0 gives the minus.",
        "the quadrature, if it is used as printed", PRINT),
    "smith2012:55": ("Eq. (55)", "A factor 2 is lost, as in (54).", "the period, if it is computed from it", PRINT),
    "smith2012:62b": (
        "Eq. (62b)", "k = 1 must come with a plus, as (62a) has it; (60b) is 2/3.",
        "the sign of every coefficient, if computed from it", UNDECIDED),
    "smith2012:63": (
        "Eq. (63)", "The superscript on the left must be n: 2m+1 is never even.", "nothing: the values are right",
        UNDECIDED),
    "smith2012:claim.not-identifiable": (
        "Text below (68)", "Every column sums to rational functions and one arctangent.",
        "the conclusion: the sums are elementary for every i", PRINT),
    "smith2012:72": (
        "Eq. (72)", "The factor 3 is 4, and both terms change sign, since v < 0 on these half-cycles.",
        "the curve of Fig. 5, if it is drawn from (72)", PRINT),
    "smith2012:56b": ("Eq. (56b)", "Two lines ran into each other.", NONE, GARBLED),
    "smith2012:56c": ("Eq. (56c)", "The numerators before the integrals are lost.", NONE, GARBLED),
}  # fmt: skip


@cache
def sheets() -> dict[str, dict[Origin, tuple[Erratum, ...]]]:
    """The sheet of each paper: its errata in reading order, by their origin."""
    made = {}
    for key in PAPERS:
        wrong = [entry for entry in load(key).values() if entry.verdict in WRONG]
        errata = [Erratum(entry, *LINES[entry.id]) for entry in wrong]
        by_origin = {origin: tuple(e for e in errata if e.origin == origin) for origin in ORIGINS}
        made[key] = {origin: found for origin, found in by_origin.items() if found}
    return made


def harmless(key: str) -> list[Statement]:
    """The statements of a paper with a slip that changes nothing."""
    return [entry for entry in load(key).values() if entry.slip]
