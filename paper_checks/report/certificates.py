"""Certificates beside the report, with the page that checks them: numbers of the papers that anybody can prove again.

>>> certificates_of("smith2012:table1.u3"), certificates_of("lelas2024:value.rest-b")
(('certificate-smith2012-table1.json',), ('certificate-lelas2024-fig1b.json',))
>>> certificates_of("smith2012:43")
()
"""

from collections.abc import Callable
from dataclasses import dataclass
from functools import cache, partial

from asymptotics.certificates.certificate import CHECKER, Certificate
from asymptotics.certificates.of_results import of_turning_points
from asymptotics.curves.turning_points import turning_points_in_units
from asymptotics.law import Law, LawLike, Oscillator
from asymptotics.tables.certified import CLAIMS as TABLES
from asymptotics.tables.registry import build, description
from asymptotics.turning.choose import turning_points
from paper_checks.lancaster2020.figures import EPSILON_3, KAPPA_1, KAPPA_2
from paper_checks.lelas2024.section_5 import PANELS, strength
from paper_checks.lelas2024.section_6 import DRAG

CHECKER_LINES = len(CHECKER.read_text(encoding="utf-8").splitlines())
DIGITS = 20
TABLE_DIGITS = 30  # of ``make tables``
_LELAS = {"mass": "3/2", "stiffness": 30, "x0": "1/5"}


@dataclass(frozen=True)
class Proved:
    """A file beside the report: what it is of, how it is made, and the statements whose numbers it proves."""

    file: str
    title: str
    make: Callable[[], Certificate]
    statements: tuple[str, ...] = ()


def turned(law: LawLike, count: int, digits: int = DIGITS) -> Certificate:
    """Of turning points with times: a law alone in units of the start, an oscillator in m and s."""
    if isinstance(law, Oscillator):
        return of_turning_points(law, turning_points_in_units(law, count, digits=digits, times=True))
    return of_turning_points(law, turning_points(Law.read(law), count, digits, times=True))


def _friction(panel: int) -> Oscillator:
    """The mass of Fig. 1 of Lelas, b = mu m g in N."""
    return Oscillator({0: strength(PANELS[panel]) * 30 / 5}, **_LELAS)


PROVED = (
    Proved(
        "certificate-smith2012-table1.json", "Smith 2012, Table I: the turning points u_0 to u_5, with their times",
        partial(turned, Law({2: 1}), 6), tuple(f"smith2012:table1.u{n}" for n in range(6)),
    ),
    Proved(
        "certificate-three-halves.json", "alpha = 3/2, epsilon = 1/10: five half-swings to 30 digits",
        partial(turned, Law({"3/2": "1/10"}), 6, 30),
    ),
    Proved(
        "certificate-lancaster2020-fig1.json", "Lancaster 2020, Fig. 1: every turning point, and the stop",
        partial(turned, Law({0: KAPPA_1}), 10),
        ("lancaster2020:fig1", "lancaster2020:claim.kappa-fig1", "lancaster2020:claim.gradual-breakdown"),
    ),
    Proved(
        "certificate-lancaster2020-fig2.json", "Lancaster 2020, Fig. 2: the turning points up to omega_0 t = 32",
        partial(turned, Law({"3/2": KAPPA_2}), 11),
        ("lancaster2020:fig2", "lancaster2020:claim.kappa-fig2", "lancaster2020:claim.long-times-good"),
    ),
    Proved(
        "certificate-lancaster2020-fig3.json", "Lancaster 2020, Fig. 3: the turning points up to omega_0 t = 44",
        partial(turned, Law({1: EPSILON_3, 2: EPSILON_3}), 15), ("lancaster2020:fig3",),
    ),
    Proved(
        "certificate-lelas2024-fig1a.json", "Lelas 2024, Fig. 1(a): every turning point in m and s, and the stop",
        partial(turned, _friction(0), 22),
        ("lelas2024:value.tau-exact-a", "lelas2024:value.rest-a", "lelas2024:fig1"),
    ),
    Proved(
        "certificate-lelas2024-fig1b.json", "Lelas 2024, Fig. 1(b): every turning point in m and s, and the stop",
        partial(turned, _friction(1), 9), ("lelas2024:value.tau-exact-b", "lelas2024:value.rest-b", "lelas2024:fig1"),
    ),
    *(
        Proved(
            f"certificate-lelas2024-fig{panel}.json", f"Lelas 2024, Fig. {panel[0]}({panel[1]}): 10 s, in m and s",
            partial(turned, Oscillator({2: drag}, **_LELAS), 15), ("lelas2024:fig2",),
        )
        for panel, drag in DRAG.items()
    ),
    *(
        Proved(
            f"certificate-table-{name}.json", f"table {name}: {description(name)['title']}",
            lambda name=name: build(name, TABLE_DIGITS).certificate(),
        )
        for name in TABLES
    ),
)  # fmt: skip


def certificates_of(statement: str) -> tuple[str, ...]:
    """The files that prove the numbers of a statement."""
    return tuple(each.file for each in PROVED if statement in each.statements)


def certificate_of_table(name: str) -> str | None:
    """The file that proves the turning points and times of a table."""
    return f"certificate-table-{name}.json" if name in TABLES else None


@cache
def made() -> dict[str, Certificate]:
    """Each file and its certificate, made once."""
    return {each.file: each.make() for each in PROVED}


def certificate_files() -> dict[str, str]:
    """The checker as it is, and each certificate."""
    files = {name: each.to_json() + "\n" for name, each in made().items()}
    return {CHECKER.name: CHECKER.read_text(encoding="utf-8"), **files}


def listed() -> list[dict[str, object]]:
    """What the page tells of each file: its name, title, number of claims, size in kB, what is left."""
    return [
        {
            "file": each.file, "title": each.title, "left": made()[each.file].left,
            "claims": sum(len(one["claims"]) for one in made()[each.file].content),
            "size": f"{len(made()[each.file].to_json()) / 1000:.0f}",
        }
        for each in PROVED
    ]  # fmt: skip
