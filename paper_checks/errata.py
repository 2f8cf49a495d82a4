r"""The errata of each paper on one sheet: place, printed, corrected, why in one line, and whether a result changes.

The formulas are those of the statements; here stands what a sheet says beside them.  ``origin`` tells slips of the
print from slips of the text at hand, where the text decides.

>>> sheet = sheets()["smith2012"]
>>> [len(found) for found in sheet.values()], sheet[PRINT][0].place, sheet[PRINT][0].effect
([13, 4, 2], 'Text above (38a)', 'No result changes: (50) has the right exponents.')
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
SAME = "No result changes"
RIGHT_IN_50 = f"{SAME}: (50) has the right exponents."
OTHERS_TELL = f"{SAME} if the last two members are equated; the first alone gives wrong turning points."


@dataclass(frozen=True)
class Erratum:
    """One entry of a sheet; ``effect`` says whether a result changes."""

    statement: Statement
    place: str
    why: str
    effect: str
    origin: Origin


# id: place, why in one line, whether a result changes, origin
LINES: dict[str, tuple[str, str, str, Origin]] = {
    "lancaster2020:claim.slow-dissipation": (
        "Text above (9)", "The dot is lost, which stands below (5); (14) has the modulus too.", f"{SAME}.", GARBLED),
    "lancaster2020:claim.energy-derivative": (
        "Text above (8)", "Two dots are lost; (7) and (8) have them.", f"{SAME}.", GARBLED),
    "lancaster2020:table1.alpha3": (
        "Table I, exponent 3", "The left member is a remnant of the entry above; the right one is (13).", f"{SAME}.",
        GARBLED),
    "lancaster2020:claim.weak-equals-slow": (
        "Text below (13) and (14)", "The halves of the sentence stand apart, and what joined them is lost.", f"{SAME}.",
        GARBLED),
    "lancaster2020:claim.velocity-sign": (
        "Text below (19)", "The derivative of A cos has the minus sign, as (9).", f"{SAME}: (18) is even in x'.",
        PRINT),
    "lelas2024:claim.number-of-sections": (
        "Section I", "The same paragraph goes on to describe section VII.", f"{SAME}.", PRINT),
    "lelas2024:10": (
        "Eq. (10)", "The derivative of (8) has a minus inside the bracket.", f"{SAME}: the term is dropped in (12).",
        PRINT),
    "lelas2024:claim.slope-small": (
        "Text below (11)", "The dot is lost, which the sentence before has.", f"{SAME}.", GARBLED),
    "lelas2024:claim.integrated-rate": (
        "Text below (31)", "A fraction with a root was read twice.", f"{SAME}: (32) is right.", GARBLED),
    "lelas2024:claim.slope-of-line": (
        "Text below (32)", "A fraction with a root was read twice.", f"{SAME}: (33) is right.", GARBLED),
    "lelas2024:claim.stop-time-section-3": (
        "Text below (32)", "The root has lost its extent: over everything it gives no time.",
        f"{SAME}: 12.9 s has the root over 2.", GARBLED),
    "lelas2024:claim.force-of-47": (
        "Text above (47)", "(2) is viscous damping; mu and g belong to (3), friction.", f"{SAME}.", PRINT),
    "lelas2024:claim.stop-time-section-5": (
        "Text below (50)", "The root has lost its extent: over everything it gives no time.",
        f"{SAME}: 12.9 s has the root over 2.", GARBLED),
    "lelas2024:value.tau-tilde-a": (
        "Section V, mu = 0.01", "14.3217 s; the printed digits follow from the rounded 12.9 s.",
        "Changes the last digit of this time.", PRINT),
    "lelas2024:value.tau-tilde-b": (
        "Section V, mu = 0.03", "4.7739 s; the printed digits follow from the rounded 4.3 s.",
        "Changes the last digit of this time.", PRINT),
    "lelas2024:value.tau-exact-b": (
        "Section V, mu = 0.03", "Seven half periods, 4.9174 s; the paper reads the time from its graph.",
        "Changes the last digit of this time.", PRINT),
    "lelas2024:claim.figure-of-section-6": (
        "Section VI", "The panels that differ in C are those of Fig. 2.", f"{SAME}.", PRINT),
    "lelas2024:claim.integral-of-sin-cubed": (
        "Section VI", "Over a period sin^3 integrates to 0; the loss needs |sin|^3.",
        f"{SAME}: (52) has the right mean.", PRINT),
    "smith2012:34": (
        "Eq. (34)", "With this sign (32) and (33) are not constant; damping lowers the frequency.",
        "Changes the frequency of the viscous example; nothing later uses it.", UNDECIDED),
    "smith2012:claim.integrating-factors": (
        "Text above (38a)", "The upper sign belongs to v < 0, as (38a) prints it.", RIGHT_IN_50, PRINT),
    "smith2012:38b": ("Eq. (38b)", "The signs of the exponent are exchanged against (38a).", RIGHT_IN_50, PRINT),
    "smith2012:40": (
        "Eq. (40)", "The signs of the exponent are exchanged, as in (38b).", RIGHT_IN_50, PRINT),
    "smith2012:48": (
        "Eq. (48)", "(50) at w = 0 and the first term of (49) have the other sign.",
        f"{SAME}: (49) and (50) have the right sign.", UNDECIDED),
    "smith2012:49": (
        "Eq. (49)", "The second term is (42), with + 1/4.", f"{SAME}: Table I is computed with + 1/4.", PRINT),
    "smith2012:51": (
        "Eq. (51)", "The factor 1/4 of (42) and (48) is lost.",
        "Changes u_2: as printed it gives 0.460, and Table I has 0.263568.", PRINT),
    "smith2012:52a": ("Eq. (52a)", "The factor -1/4 of (42) is lost.", OTHERS_TELL, PRINT),
    "smith2012:52b": ("Eq. (52b)", "The factor 1/4 of (48) is lost.", OTHERS_TELL, PRINT),
    "smith2012:table1.S3": (
        "Table I, S_3", "The printed digits are the difference of 0.235335 and 0.101501, both rounded.",
        "Changes the sixth decimal.", PRINT),
    "smith2012:table1.S5": (
        "Table I, S_5", "The printed digits are the difference of 0.243090 and 0.101501, both rounded.",
        "Changes the sixth decimal.", PRINT),
    "smith2012:54": (
        "Eq. (54)", "A factor 2 is lost, which (72) has; and v < 0 gives the minus.",
        "Changes every time: as printed the radicand is negative at the turning points.", PRINT),
    "smith2012:55": (
        "Eq. (55)", "A factor 2 is lost, as in (54).",
        "Changes the period: as printed the radicand is negative at both ends.", PRINT),
    "smith2012:62b": (
        "Eq. (62b)", "k = 1 comes with a plus, as (62a) has it: by (60b) the first value is + 2/3.",
        "Changes the sign of each column, computed from the one before.", UNDECIDED),
    "smith2012:63": (
        "Eq. (63)", "The superscript on the left must be n: 2m+1 is never even.", f"{SAME}: the values are right.",
        UNDECIDED),
    "smith2012:claim.not-identifiable": (
        "Text below (68)", "Each column sums to a rational function and one times an arctangent.",
        "Changes the conclusion: the sums are elementary for every i.", PRINT),
    "smith2012:72": (
        "Eq. (72)", "The factor 3 is 4, and both terms change sign, since v < 0 on these half-cycles.",
        "Changes the curve: as printed it runs backwards in time.", PRINT),
    "smith2012:56b": ("Eq. (56b)", "The denominator of the integral stands in the next line.", f"{SAME}.", GARBLED),
    "smith2012:56c": ("Eq. (56c)", "Of (56b) the denominators stand here without numerators.", f"{SAME}.", GARBLED),
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
