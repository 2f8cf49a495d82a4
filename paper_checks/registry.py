"""Entries: what a paper says, as data, with the check that evaluates exactly that data.

An entry is written in one place, in reading order: the statement, then the check that could refute it.

    @statement(
        id="smith2012:45", kind=Kind.IDENTITY, verdict=Printed.HOLDS, evidence=Evidence.PROVED,
        title="Velocity at the first passage through equilibrium",
        latex=r"w = -\\sqrt{(1 - e^{-2u_0}(2u_0+1))/2}", conditions="u_0 > 0",
        printed=-sqrt((1 - exp(-2*u0)*(2*u0 + 1))/2), near_miss=..., methods=("first integral",),
    )
    def velocity_at_equilibrium(form):
        return vanishes(first_integral(u=0, w=form) - first_integral(u=u0, w=0))

The check takes a *form* and answers an Outcome: CONFIRMED, REFUTED or UNDECIDED.  It is run on the printed form, on the
corrected form if there is one, and on the near miss, a nearby false variant.  The recorded verdict stands only if

======================================  ===========  ===========  ===========
recorded verdict                        printed      corrected    near miss
======================================  ===========  ===========  ===========
holds                                   CONFIRMED    (none)       REFUTED
misprint, transcription, partly         REFUTED      CONFIRMED    REFUTED
refuted                                 REFUTED      CONFIRMED *  REFUTED
definition                              (no check needed; if there is one, as for holds)
open                                    nothing is claimed
======================================  ===========  ===========  ===========

(* where the true statement is known).  Anything else, UNDECIDED included, makes the entry a disagreement: it is
reported as open and the run ends with exit code 1.
"""

import inspect
import sys
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field, replace
from enum import StrEnum
from functools import partial
from importlib import import_module
from typing import Any

from derivations.steps import Step
from paper_checks.dimensions import dimensionally_false
from paper_checks.evidence import Difference, Marks
from paper_checks.forms import guarded
from paper_checks.verdict import Evidence, Kind, Outcome, Printed

Check = Callable[[Any], Outcome]

PAPERS = {
    "lancaster2020": (
        "J. L. Lancaster, Slow-dissipation limit of the harmonic oscillator with general power-law damping,"
        " Am. J. Phys. 88, 1151 (2020)",
        (),
    ),
    "lelas2024": ("K. Lelas, Decay of amplitude of a harmonic oscillator with weak nonlinear damping (2024)", ()),
    "smith2012": ("B. R. Smith, Jr., The quadratically damped oscillator, Am. J. Phys. 80, 816 (2012)", ()),
}
IDENTIFIERS = {  # as in CITATION.cff, which a test compares
    "lancaster2020": {"doi": "10.48550/arXiv.1811.02953", "arxiv": "1811.02953"},
    "lelas2024": {"doi": "10.48550/arXiv.2411.15588", "arxiv": "2411.15588"},
    "smith2012": {"doi": "10.1119/1.4729440", "arxiv": ""},
}
FOLLOW_UPS = (  # later papers of the authors: arXiv number, title, and the statements on which they bear
    ("2502.07458", "K. Lelas and R. Pezer, The amplitude decay of a harmonic oscillator damped simultaneously by weak"
     " linear and nonlinear damping forces (2025)", ("lancaster2020:20", "lelas2024:54")),
    ("2512.23590", "New approach to approximate analytical solutions of a harmonic oscillator with weak to moderate"
     " nonlinear damping: Part I (2025)", ("lelas2024:49", "lelas2024:52", "smith2012:43")),
    ("2602.19725", "R. Pezer and K. Lelas, Damped harmonic oscillator revisited: a new approach to energy decay in the"
     " case of Coulomb, Stokes, and Newton damping (2026)", ("lelas2024:7", "lelas2024:claim.energy-decreases")),
)  # fmt: skip
SECTIONS = {
    "lancaster2020": (
        "section_1_linear",
        "section_2_energy",
        "section_3_amplitude",
        "section_3_table",
        "section_4_validity",
        "section_4_conditions",
        "section_5_figures",
        "section_6_two_laws",
        "section_7_late_times",
    ),
    "lelas2024": (
        "section_1",
        "section_2",
        "section_2_trick",
        "section_3",
        "section_4",
        "section_5",
        "section_6",
        "section_7",
    ),
    "smith2012": (
        "section_1",
        "section_1_time",
        "section_2",
        "section_3_law",
        "section_3_orbit",
        "section_3_table",
        "section_4_quadrature",
        "section_4_series",
        "section_4_coefficients",
        "section_4_sums",
        "section_4_motion",
    ),
}


class Shortfall(StrEnum):
    """In which way a statement is but partly true."""

    CONDITION = "true under an omitted condition"
    CONSEQUENCE = "does not follow"
    RANGE = "false in a stated range"


@dataclass(frozen=True, kw_only=True)
class Statement:
    """One statement of a paper: LaTeX for the reader, forms for the check.

    ``latex`` and ``printed`` are what the paper prints; ``corrected_latex`` and ``corrected`` what is true instead;
    ``near_miss`` a nearby false form.  ``conditions`` are sufficient for the true form; "none" is written out.
    ``derivation`` names a script of ``derivations/`` to read beside it, and ``line`` a line of it, which must say why:
    that it proves the statement (``proves``; the derivation must run), or that it has what is true instead of one that
    fails (``corrects``; it lifts no label).  ``extent`` says how far a sample reaches.
    ``digits`` counts certified digits where a number is stated; ``order`` is the order of convergence of an
    approximation ("0" if its error does not vanish).  ``premises`` are the places of a form that say what is asked, not
    what is claimed: a form with another premise is about something else.  ``paraphrase`` marks a LaTeX that says in our
    words what the paper says in its own; ``shortfall`` is how a statement is partly true; ``slip`` is a slip of the
    paper that leaves the statement as it is.
    """

    id: str
    kind: Kind
    title: str
    latex: str
    verdict: Printed
    evidence: Evidence
    conditions: str
    variables: str = ""
    printed: Any = None
    corrected: Any = None
    near_miss: Any = None
    corrected_latex: str | None = None
    note: str = ""
    derivation: str | None = None
    line: int | None = None
    paraphrase: bool = False
    shortfall: Shortfall | None = None
    slip: str = ""
    extent: str = ""
    premises: tuple[int, ...] = ()
    digits: int | None = None
    order: str | None = None
    methods: tuple[str, ...] = ()
    check: Check | None = field(default=None, compare=False)

    @property
    def paper(self) -> str:
        """The paper's key, the part of the id before the colon."""
        return self.id.partition(":")[0]


_REGISTRY: dict[str, Statement] = {}


def statement(**data: Any) -> Callable[[Check], Check]:
    """Register an entry whose check is the decorated function; ValueError for an id that is taken."""

    def register(check: Check) -> Check:
        add(Statement(check=check, **data))
        return check

    return register


def add(entry: Statement) -> None:
    """Register an entry; one without a check must be a definition or open."""
    if entry.id in _REGISTRY:
        raise ValueError(f"two entries with the id {entry.id}")
    if (entry.verdict == Printed.PARTLY) != (entry.shortfall is not None):
        raise ValueError(f"{entry.id}: a statement that is partly true, and no other, says in which way")
    if entry.check is None and entry.verdict not in (Printed.DEFINITION, Printed.OPEN):
        raise ValueError(f"{entry.id}: the verdict {entry.verdict} needs a check")
    other = partial(dimensionally_false, entry.id, model=confirmed_form(entry))
    check = entry.check and guarded(entry.check, own_forms(entry), entry.premises, other)
    _REGISTRY[entry.id] = replace(entry, check=check)


def own_forms(entry: Statement) -> list[Any]:
    """The forms that a statement states: as printed, corrected, and its near miss."""
    return [entry.printed] + [form for form in (entry.corrected, entry.near_miss) if form is not None]


def confirmed_form(entry: Statement) -> Any:
    """The form that the check confirms: the printed one, or the corrected one where that is true instead."""
    return entry.printed if entry.verdict in (Printed.HOLDS, Printed.DEFINITION) else entry.corrected


def _section(name: str) -> None:
    """A module of statements, whole or not at all: a time that is over on the way leaves no half of it registered."""
    entries, known = dict(_REGISTRY), {*sys.modules}
    try:
        import_module(name)
    except BaseException:
        for module in {*sys.modules} - known:
            if module.startswith("paper_checks."):
                del sys.modules[module]
        _REGISTRY.clear()
        _REGISTRY.update(entries)
        raise


def load(paper: str | None = None) -> dict[str, Statement]:
    """All entries of a paper (of all papers without an argument), in reading order.

    The order is that of SECTIONS, then that of the file, whichever module happened to be imported first; decorators
    stacked on one check are applied from the bottom up, so entries that share a check are turned round.
    """
    for name in [paper] if paper else SECTIONS:
        for section in SECTIONS[name]:
            _section(f"paper_checks.{name}.{section}")
    modules = [f"paper_checks.{name}.{section}" for name, sections in SECTIONS.items() for section in sections]
    place = {module: position for position, module in enumerate(modules)}
    first_seen: dict[Any, int] = {}

    def reading_order(numbered: tuple[int, Statement]) -> tuple[int, int, int]:
        number, entry = numbered
        stack = first_seen.setdefault(inspect.unwrap(entry.check) if entry.check else entry.id, number)
        return place.get(getattr(entry.check, "__module__", ""), len(place)), stack, -number

    ordered = sorted(enumerate(_REGISTRY.values()), key=reading_order)
    return {entry.id: entry for _, entry in ordered if paper in (None, entry.paper)}


def named_line(s: Statement) -> Step | None:
    """The line of a derivation, which is run, that the statement names; None if there is none."""
    if s.derivation is None or s.line is None:
        return None
    steps = import_module("derivations." + s.derivation.replace("-", "_")).derivation.steps
    return steps[s.line - 1] if 1 <= s.line <= len(steps) else None


def proved_by_line(s: Statement) -> bool:
    """Whether the named line of the named derivation, which is run, says that it proves the statement."""
    step = named_line(s)
    return step is not None and s.id in step.proves


def corrected_by_line(s: Statement) -> bool:
    """Whether that line has what is true instead of the statement: says so, or proves that the statement fails thus."""
    step = named_line(s)
    return step is not None and s.id in step.proves + step.corrects


@dataclass(frozen=True)
class Entry:
    """The result of running one statement's check: the verdict with its outcomes, or a disagreement.

    ``apart``: the two sides at the near miss, where the check has told them apart; ``compared``: whether what is
    printed of it stands as it was when it was compared with its forms (``reader``).
    """

    statement: Statement
    outcomes: dict[str, Outcome]
    seconds: float
    marks: Marks | None = None
    apart: Difference | None = None
    compared: bool = True

    @property
    def agrees(self) -> bool:
        """Whether the outcomes bear the recorded verdict out, for what is printed."""
        return self.compared and self.outcomes == expected_outcomes(self.statement)

    @property
    def evidence(self) -> Evidence:
        """What the verdict rests on: the weakest evidence that the check used, or a derivation that proves it."""
        s = self.statement
        if not self.agrees or s.verdict == Printed.OPEN:
            return Evidence.NONE
        return s.evidence if self.marks is None or self.derived else self.marks.weakest

    @property
    def derived(self) -> bool:
        """Whether a line of a derivation proves the statement, however far the check reaches."""
        return proved_by_line(self.statement)

    @property
    def extent(self) -> str:
        """How far a sample reaches; empty for what is proved for all values, or about nothing else."""
        return "" if self.marks is None or self.derived else self.marks.extent

    @property
    def order_by(self) -> str | None:
        """Whether the order of an approximation was measured by the check, or is argued in its note."""
        if self.statement.order is None or self.marks is None:
            return None
        return "measured" if Evidence.MEASURED in self.marks.evidence else "argued"

    @property
    def printed(self) -> Printed:
        """The verdict that may be reported: the recorded one if borne out, otherwise open."""
        return self.statement.verdict if self.agrees else Printed.OPEN

    def to_dict(self) -> dict[str, Any]:
        """The entry as the JSON of the command line; the time it took is left out, so that two runs are alike."""
        s = self.statement
        return {
            "id": s.id,
            "kind": str(s.kind),
            "printed": str(self.printed),
            "evidence": str(self.evidence),
            "extent": self.extent,
            "corrected": s.corrected_latex,
            "digits": s.digits,
            "order": s.order,
            "order_by": self.order_by,
            "methods": list(s.methods),
            "title": s.title,
            "latex": s.latex,
            "conditions": s.conditions,
            "note": s.note,
            "derivation": s.derivation,
            "line": s.line,
            "derived": self.derived,
            "paraphrase": s.paraphrase,
            "shortfall": s.shortfall and str(s.shortfall),
            "slip": s.slip,
            "recorded": str(s.verdict),
            "agrees": self.agrees,
            "outcomes": {name: str(outcome) for name, outcome in self.outcomes.items()},
        }


def forms(entry: Statement) -> Iterator[tuple[str, Any]]:
    """The forms that the check is run on: printed, corrected (if any), near miss (if any)."""
    if entry.check is None:
        return
    yield "printed", entry.printed
    if entry.corrected is not None:
        yield "corrected", entry.corrected
    if entry.near_miss is not None:
        yield "near miss", entry.near_miss


def expected_outcomes(entry: Statement) -> dict[str, Outcome]:
    """The outcomes that bear out the recorded verdict (the table of the module's docstring)."""
    holds = entry.verdict in (Printed.HOLDS, Printed.DEFINITION)
    wanted = {
        "printed": Outcome.CONFIRMED if holds else Outcome.REFUTED,
        "corrected": Outcome.CONFIRMED,
        "near miss": Outcome.REFUTED,
    }
    if entry.verdict == Printed.OPEN:
        wanted["printed"] = Outcome.UNDECIDED
    return {name: wanted[name] for name, _ in forms(entry)}
