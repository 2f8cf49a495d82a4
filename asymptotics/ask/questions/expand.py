"""The amplitude and phase equations to any order, for any exponent or sum of laws."""

from dataclasses import dataclass
from importlib import import_module
from typing import TYPE_CHECKING, Annotated, Any

from asymptotics.ask.answers import Offers, Request
from asymptotics.ask.forces import GivenTerms
from asymptotics.ask.kinds import FLAG, REAL, SECONDS, choice, digits, whole
from asymptotics.ask.laws import SYMBOLIC, TERMS_IN_UNITS, TermsInUnits
from asymptotics.ask.pairs import excludes
from asymptotics.ask.question import question
from asymptotics.ask.rows import delta_meaning, local_strengths, order_of, row_text, rows_csv
from asymptotics.errors import InputError
from asymptotics.expansions.equations.build import MAX_DIGITS, MAX_ORDER
from asymptotics.expansions.equations.build import expand as equations_of
from asymptotics.expansions.equations.result import Equations
from asymptotics.expansions.normal_form.results import Coefficients, Row, row_to_dict
from asymptotics.gauges import GAUGES, TURNING_POINT
from asymptotics.law import Law, LawLike, Oscillator
from asymptotics.numbers.policy import Number

if TYPE_CHECKING:
    from asymptotics.expansions.divergence.truncation import BestOrder

_NUMBER = "an exponent instead of --alpha symbolic"
_OTHER_GAUGES = tuple(gauge for gauge in GAUGES if gauge != TURNING_POINT)


@dataclass(frozen=True)
class ExpandAnswer:
    """The equations, and what was asked besides: the best order at a local strength, the bound of what O() holds."""

    equations: Equations
    best: "BestOrder | None" = None
    remainder: Any = None


@dataclass(frozen=True)
class SymbolicExpansion:
    """The closed forms in a symbolic exponent."""

    found: Coefficients

    def _entries(self) -> list[tuple[str, str, Any]]:
        named = {"p": self.found.amplitude, "Omega": self.found.frequency, "W": self.found.W}
        return [(name, k, c) for name, row in named.items() for k, c in row.items()]

    def latex(self) -> str:
        """One line a coefficient."""
        return "\n".join(rf"{_LATEX.get(n, n)}_{{{k}}} = {c._formula()} \\" for n, k, c in self._entries())

    def __str__(self) -> str:
        lines = [f"gauge {self.found.gauge}, symbolic", *(f"{n}_{k} = {c.exact}" for n, k, c in self._entries())]
        for name, entry in self.found.integrals.items():
            values = ", ".join(f"{name}({a}) = {v}" for a, v in entry["values"].items())
            lines += [f"{name}(alpha) = {entry['definition']}", f"  {values}"]
        return "\n".join(lines)

    def to_dict(self) -> dict[str, Any]:
        """JSON-ready."""
        rows = {"amplitude": self.found.amplitude, "frequency": self.found.frequency, "W": self.found.W}
        head = {"alpha": SYMBOLIC, "gauge": self.found.gauge, "order": self.found.order}
        data = {**head, **{name: row_to_dict(row) for name, row in rows.items()}}
        return data | {"integrals": self.found.integrals, "latex": self.latex()}


_LATEX = {"Omega": r"\Omega"}
Found = ExpandAnswer | SymbolicExpansion


def _deltas(found: Equations, given: GivenTerms) -> list[tuple[str, str, str]]:
    """(name, force, value) of each local strength; the letter epsilon where no strength was given, or several were."""
    if found.oscillator is None:
        return local_strengths(given)
    marks = [""] if len(given.terms) == 1 else [f"_{i}" for i in range(1, len(given.terms) + 1)]
    texts = found.strengths.texts()
    return [(f"delta{mark}", t.shape(), text) for mark, t, text in zip(marks, given.terms, texts)]


def _data(found: Found, request: Request) -> dict[str, Any]:
    if isinstance(found, SymbolicExpansion):
        return found.to_dict()
    given, equations = request["law"].terms, found.equations
    units = None if equations.oscillator is None else "SI"
    head = {"alpha": given.shown, "terms": given.to_list(), "units": units}
    latex = {"latex": equations.latex(request["digits"]), "notes": list(given.notes)}
    data = {**equations.to_dict(), **head, **latex}
    data["delta"] = [{"name": name, "force": f, "value": value} for name, f, value in _deltas(equations, given)]
    data |= {} if found.best is None else {"best_order": found.best.to_dict()}
    return data | ({} if found.remainder is None else {"bound": found.remainder.to_dict()})


def _besides(found: Found, _: Request) -> str:
    asked = [] if isinstance(found, SymbolicExpansion) else [found.best, found.remainder]
    return "\n".join(str(part) for part in asked if part is not None)


def _text(found: Found, request: Request) -> str:
    if isinstance(found, SymbolicExpansion):
        return str(found)
    given, equations = request["law"].terms, found.equations
    remainder = "a bound below" if request["bound"] else "no bound on the remainder"
    lines = [f"gauge {equations.gauge}, {equations.arithmetic}; formal ({remainder})"]
    deltas, rows = _deltas(equations, given), (("p", equations.p.named()), ("Omega", equations.Omega.named()))
    p, Omega = (_sum(name, row, [delta for delta, _, _ in deltas]) for name, row in rows)
    time, rate = ("t", "omega_0 ") if equations.oscillator is not None else ("tau", "")
    phase = " + ".join(["1", *([Omega] if Omega else [])])
    lines += [f"dA/d{time} = -{rate}A ({p or 0})", f"dpsi/d{time} = {f'{rate}({phase})' if rate else phase}"]
    lines += [f"{name} = {value} for {force}" for name, force, value in deltas]
    lines += (
        [f"A in {equations.oscillator.unit}, t in s, {equations.oscillator}"]
        if equations.oscillator is not None
        else []
    )
    lines += [*order_of(given), *(line for name, row in rows for line in row_text(name, row)), *given.notes]
    return "\n".join(lines)


def _sum(name: str, row: Row, deltas: list[str]) -> str:
    """p_1 delta + p_3 delta^3: the terms that do not vanish."""
    terms = []
    for key, c in row.items():
        # "0" is written for zero by theorem alone; a coefficient that is small has digits.
        if c.value == "0":
            continue
        powers = [(delta, int(n)) for delta, n in zip(deltas, key.split(",")) if int(n)]
        terms.append(" ".join([f"{name}_{key}", *(d if n == 1 else f"{d}^{n}" for d, n in powers)]))
    return " + ".join(terms)


def _latex(found: Found, request: Request) -> str:
    return found.latex() if isinstance(found, SymbolicExpansion) else found.equations.latex(request["digits"])


def _letters(found: Found, request: Request) -> dict[str, str]:
    if isinstance(found, SymbolicExpansion):
        return {}
    return delta_meaning(_deltas(found.equations, request["law"].terms))


def _csv(found: Found, _: Request) -> str:
    assert isinstance(found, ExpandAnswer)  # a symbolic exponent has no file: refused before
    return rows_csv({"p": found.equations.p.named(), "Omega": found.equations.Omega.named()})


@question(
    Offers(
        latex="print the expansion as LaTeX",
        table="the coefficients: series, powers, digits, exact form",
        from_rest=True,
        always_files=True,
        own_latex=True,
        data=_data,
        text=_text,
        as_latex=_latex,
        as_csv=_csv,
        letters=_letters,
        besides=_besides,
        lacks={"plot": "equations are no curve; `motion` and `envelope` draw", "points": "there is no curve"},
    ),
    pairs=(
        excludes("csv", "alpha=symbolic", "a symbolic exponent has no numbers", _NUMBER),
        excludes("exact", "alpha=symbolic", accepted="one law, in closed form"),
        excludes("best-order", "alpha=symbolic", "it needs a number", _NUMBER),
        excludes("bound", "alpha=symbolic", "a bound needs a number", _NUMBER),
        excludes("epsilon damping mass stiffness", "alpha=symbolic", "closed forms take no numbers", _NUMBER),
        excludes(
            "bound",
            f"gauge={'|'.join(_OTHER_GAUGES)}",
            "it is not known in the gauge {value}",
            f"the gauge {TURNING_POINT}",
        ),
    ),
    swept=True,
    example="--alpha 2 --order 1 --digits 5",
    rests="formal series: whole exponents exact, others in balls (`quarter-swing-tail`)",
)
def expand(
    law: Annotated[LawLike | Oscillator, TERMS_IN_UNITS],
    *,
    order: Annotated[int, whole(1, MAX_ORDER)] = 4,
    gauge: Annotated[str, choice(*GAUGES, letter="G", of="gauge")] = TURNING_POINT,
    exact: Annotated[bool, FLAG] = False,
    best_order: Annotated[Number | None, REAL.called(letter="D", feeds={"delta": ("best_order",)})] = None,
    bound: Annotated[bool, FLAG] = False,
    digits: Annotated[int, digits(MAX_DIGITS)] = 30,
    max_seconds: Annotated[Number, SECONDS] = 60,
) -> Found:
    """The multiple-scale expansion of amplitude and phase, to any order, for any exponent or sum of laws:

      dA/dtau = -A (p_1 delta + p_3 delta^3 + ...),    dpsi/dtau = 1 + Omega_2 delta^2 + Omega_4 delta^4 + ...

      asymptotics expand --alpha 3/2 --order 6 --digits 40
      asymptotics expand --alpha 3 --order 5 --gauge no-first-harmonic --exact
      asymptotics expand --law 0:1/10 --law 1:1/5 --order 4
      asymptotics expand --alpha 2 --spring pendulum --order 4
      asymptotics expand --law 1:-1 --law 1,2:1 --order 6
      asymptotics expand --alpha symbolic --order 4 --latex
      asymptotics expand --alpha symbolic --spring 3 --order 2

    --best-order D says for one law where to stop at delta = D, and what is left, in half-swings.
    --bound adds what the O() holds, proved: on each half-swing ln(A'/A) and the time differ from those of the truncated
    equations by at most amplitude delta^amplitude_power and frequency delta^frequency_power, for delta (of a sum: the
    sum of all delta_i) up to delta_max.

    delta = epsilon A^(alpha-1), for a spring c x|x|^(P-1) delta = c A^(P-1); amplitude holds p_k, frequency Omega_k,
    for all k up to the order.  With several forces k has one index for each: losses, then springs, in the order given;
    a pendulum counts powers of A^2.  Springs are always odd in x: P = 2 is x|x|, not x^2.
    With --damping, --mass or --stiffness the equations are in SI: A in m, t in s, delta = b omega_0^alpha
    A^(alpha-1)/k.  In Python: ``asy.expand``, its ``best_order``, and ``asy.remainder``.

    Parameters
    ----------
    law
        an exponent (the coefficients need no strength), a law, or an oscillator
    order
        the highest power of delta
    gauge
        the gauge
    exact
        demand exact coefficients (integer exponents)
    best_order
        for one law at delta = D: the best order and the smallest error, predicted, measured, with exponentials added
    bound
        what the O() holds, proved: constants and the largest delta (turning-point gauge, powers of the velocity)
    digits
        significant digits, correctly rounded
    max_seconds
        the time the request may take, in seconds

    Raises
    ------
    InputError
        for what cannot be read, or combined
    LimitError
        with the estimate
    UndecidedError
        where balls cannot round a coefficient
    """
    given: Any = law
    assert isinstance(given, TermsInUnits)
    if isinstance(given.terms, str):
        return _symbolic(given, order, gauge, digits)
    # Strengths that were left out are 1: the coefficients do not depend on them, only the line ``delta = `` shows them.
    bare = Law.from_terms(given.terms.terms)
    found = equations_of(
        given.oscillator or bare, order=order, gauge=gauge, digits=digits, exact=exact, max_seconds=max_seconds
    )
    best = None if best_order is None else found.best_order(best_order, max_seconds=max_seconds)
    # The bound is of the equations without units, whose delta is the same number as that of an oscillator in SI; it
    # loads NumPy, which nothing else here needs.
    remainder = import_module("asymptotics.bounds.remainder").remainder if bound else None
    proved = None if remainder is None else remainder(bare, order=order, max_seconds=max_seconds)
    return ExpandAnswer(found, best, proved)


def _symbolic(given: TermsInUnits, order: int, gauge: str, digits: int) -> SymbolicExpansion:
    # SymPy, which takes longer to load than the expansion for a number takes.
    closed = import_module("asymptotics.expansions.normal_form.closed_forms")
    if order > closed.MAX_SYMBOLIC_ORDER:
        reason = f"{order}: closed forms in alpha are known through order {closed.MAX_SYMBOLIC_ORDER}"
        raise InputError("order", reason, f"an integer from 1 to {closed.MAX_SYMBOLIC_ORDER} with a symbolic exponent")
    if not given.springs:
        return SymbolicExpansion(closed.symbolic_coefficients(order, gauge, digits))
    spring, *others = given.springs
    if others or spring.family or not spring.velocity.is_zero or gauge != TURNING_POINT:
        accepted = f"one --spring P in the gauge {TURNING_POINT}, through order 2"
        raise InputError("spring", "with a symbolic exponent closed forms are known for one force of x", accepted)
    return SymbolicExpansion(closed.symbolic_with_spring(spring.position, order))
