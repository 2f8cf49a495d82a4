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
equations by at most amplitude delta^amplitude_power and frequency delta^frequency_power, for delta (of a sum: the sum
of all delta_i) up to delta_max.

delta = epsilon A^(alpha-1), for a spring c x|x|^(P-1) delta = c A^(P-1); amplitude holds p_k, frequency Omega_k, for
all k up to the order.  With several forces k has one index for each: losses, then springs, in the order given; a
pendulum counts powers of A^2.  Springs are always odd in x: P = 2 is x|x|, not x^2.

With --damping, --mass or --stiffness the equations are in SI: A in m, t in s, delta = b omega_0^alpha A^(alpha-1)/k.
"""

import argparse

import sympy

from asymptotics.ask.forces import GivenTerms, add_forces, read_terms
from asymptotics.ask.moving import PHYSICAL, add_physical, is_physical, read_oscillator
from asymptotics.ask.rows import local_strengths, order_of, row_text, rows_csv
from asymptotics.cli.answer import Answer, add_common, read_digits, read_max_seconds
from asymptotics.cli.files import add_csv, read_files, write_files
from asymptotics.errors import InputError
from asymptotics.expansions.equations.build import expand
from asymptotics.expansions.equations.result import Equations
from asymptotics.expansions.normal_form.closed_forms import (
    MAX_SYMBOLIC_ORDER,
    symbolic_coefficients,
    symbolic_with_spring,
)
from asymptotics.expansions.normal_form.results import Row, row_to_dict
from asymptotics.gauges import GAUGES, TURNING_POINT
from asymptotics.law import Law
from asymptotics.numbers.exact import parse_integer, parse_real

MAX_DIGITS, MAX_ORDER = 1000, 200


def configure(parser: argparse.ArgumentParser) -> None:
    """Declare the options."""
    add_forces(parser)
    add_physical(parser)
    add_csv(parser, "the coefficients: series, powers, digits, exact form")
    parser.add_argument("--order", default="4", metavar="N", help=f"the highest power of delta, 1 to {MAX_ORDER}")
    text = f"one of {', '.join(GAUGES)} (default: the first)"
    parser.add_argument("--gauge", default=TURNING_POINT, metavar="G", help=text)
    parser.add_argument("--exact", action="store_true", help="demand exact coefficients (integer exponents)")
    parser.add_argument("--latex", action="store_true", help="print the expansion as LaTeX")
    text = (
        "for one law at delta = D: the best order and the smallest error, predicted, measured, with exponentials added"
    )
    parser.add_argument("--best-order", metavar="D", help=text)
    text = "what the O() holds, proved: constants and the largest delta (turning-point gauge, powers of the velocity)"
    parser.add_argument("--bound", action="store_true", help=text)
    add_common(parser, MAX_DIGITS)


def run(options: argparse.Namespace) -> Answer:
    """Run the command."""
    if options.gauge not in GAUGES:
        raise InputError("--gauge", f"no gauge {options.gauge!r}", ", ".join(GAUGES))
    order = parse_integer(options.order, "--order", 1, MAX_ORDER)
    digits = read_digits(options, MAX_DIGITS)
    seconds = read_max_seconds(options)
    files = read_files(options)
    # Before any number is read: closed forms in alpha take none, and each option that needs one is refused by name.
    if options.alpha == "symbolic":
        if files:
            raise InputError("--csv", "a symbolic exponent has no numbers", "an exponent instead of --alpha symbolic")
        if options.law or options.exact:
            other = "--law" if options.law else "--exact"
            raise InputError(other, "cannot be combined with --alpha symbolic", "one law, in closed form")
        if options.best_order is not None:
            raise InputError("--best-order", "it needs a number", "an exponent instead of --alpha symbolic")
        if options.bound:
            raise InputError("--bound", "a bound needs a number", "an exponent instead of --alpha symbolic")
        # A strength with a symbol for the exponent would be read and then have no effect.
        for name in ("epsilon", *PHYSICAL):
            if getattr(options, name) is not None:
                raise InputError(f"--{name}", "closed forms take no numbers", "an exponent instead of --alpha symbolic")
        return _symbolic(options, order, digits)
    given = read_terms(options)
    # Strengths that were left out are 1: the coefficients do not depend on them, only the line ``delta = `` shows them.
    law = Law.from_terms(given.terms)
    oscillator = read_oscillator(options).oscillator if is_physical(options) else None
    found = expand(
        law if oscillator is None else oscillator,
        order=order, gauge=options.gauge, digits=digits, exact=options.exact, max_seconds=seconds,
    )  # fmt: skip
    head = {"alpha": given.shown, "terms": given.to_list(), "units": None if oscillator is None else "SI"}
    data = {**found.to_dict(), **head, "latex": found.latex(digits), "notes": list(given.notes)}
    deltas = _deltas(found, given, options)
    data["delta"] = [{"name": name, "force": force, "value": value} for name, force, value in deltas]
    data["files"] = write_files(files, {"--csv": lambda _: _table(found)}, options, "expand")
    text = found.latex(digits) if options.latex else _text(found, given, options)
    text = "\n".join([text, *data["files"]])
    if options.best_order is not None:
        best = found.best_order(parse_real(options.best_order, "--best-order"), max_seconds=seconds)
        data["best_order"], text = best.to_dict(), "\n".join([text, str(best)])
    if options.bound:
        if options.gauge != TURNING_POINT:
            raise InputError("--bound", f"it is not known in the gauge {options.gauge}", f"the gauge {TURNING_POINT}")
        # The bound is of the equations without units, whose delta is the same number as that of an oscillator in SI.
        from asymptotics.bounds.remainder import remainder  # noqa: PLC0415 (NumPy, which expand does not need)

        proved = remainder(law, order=order, max_seconds=seconds)
        data["bound"], text = proved.to_dict(), "\n".join([text, str(proved)])
    return Answer(data, text, options.json)


_LATEX = {"Omega": r"\Omega"}


def _symbolic(options: argparse.Namespace, order: int, digits: int) -> Answer:
    if order > MAX_SYMBOLIC_ORDER:
        reason = f"{order}: closed forms in alpha are known through order {MAX_SYMBOLIC_ORDER}"
        raise InputError("--order", reason, f"an integer from 1 to {MAX_SYMBOLIC_ORDER} with --alpha symbolic")
    if options.spring:
        found = symbolic_with_spring(_one_spring(options), order)
    else:
        found = symbolic_coefficients(order, options.gauge, digits)
    named = {"p": found.amplitude, r"Omega": found.frequency, "W": found.W}
    entries = [(name, k, c) for name, row in named.items() for k, c in row.items()]
    latex = "\n".join(rf"{_LATEX.get(name, name)}_{{{k}}} = {sympy.latex(c.expression)} \\" for name, k, c in entries)
    lines = [f"gauge {found.gauge}, symbolic", *(f"{name}_{k} = {c.exact}" for name, k, c in entries)]
    for name, entry in found.integrals.items():
        values = ", ".join(f"{name}({a}) = {v}" for a, v in entry["values"].items())
        lines += [f"{name}(alpha) = {entry['definition']}", f"  {values}"]
    rows = {"amplitude": found.amplitude, "frequency": found.frequency, "W": found.W}
    head = {"alpha": "symbolic", "gauge": found.gauge, "order": found.order}
    data = {**head, **{name: row_to_dict(row) for name, row in rows.items()}}
    data |= {"integrals": found.integrals, "latex": latex}
    return Answer(data, latex if options.latex else "\n".join(lines), options.json)


def _one_spring(options: argparse.Namespace) -> int:
    """P of the one spring x|x|^(P-1) that stands beside a symbolic exponent."""
    # ``read_terms`` would read the word symbolic as a number; what is left for it are the springs.
    options.alpha = None
    terms = read_terms(options).terms
    if len(terms) > 1 or terms[0].family or not terms[0].velocity.is_zero or options.gauge != TURNING_POINT:
        accepted = f"one --spring P in the gauge {TURNING_POINT}, through order 2"
        raise InputError("--spring", "with a symbolic exponent closed forms are known for one force of x", accepted)
    return terms[0].position


def _text(found: Equations, given: GivenTerms, options: argparse.Namespace) -> str:
    remainder = "a bound below" if options.bound else "no bound on the remainder"
    lines = [f"gauge {found.gauge}, {found.arithmetic}; formal ({remainder})"]
    deltas = _deltas(found, given, options)
    names = [name for name, _, _ in deltas]
    p, Omega = (_sum(name, row, names) for name, row in (("p", found.p.named()), ("Omega", found.Omega.named())))
    time, rate = ("t", "omega_0 ") if found.oscillator is not None else ("tau", "")
    phase = " + ".join(["1", *([Omega] if Omega else [])])
    lines += [f"dA/d{time} = -{rate}A ({p or 0})", f"dpsi/d{time} = {f'{rate}({phase})' if rate else phase}"]
    lines += [f"{name} = {value} for {force}" for name, force, value in deltas]
    lines += [f"A in m, t in s, {found.oscillator}"] if found.oscillator is not None else []
    lines += [*order_of(given), *row_text("p", found.p.named()), *row_text("Omega", found.Omega.named()), *given.notes]
    return "\n".join(lines)


def _table(found: Equations) -> str:
    """The coefficients p_k and Omega_k as CSV."""
    return rows_csv({"p": found.p.named(), "Omega": found.Omega.named()})


def _deltas(found: Equations, given: GivenTerms, options: argparse.Namespace) -> list[tuple[str, str, str]]:
    """(name, force, value) of each local strength; the letter epsilon where no strength was given, or several were."""
    if found.oscillator is not None:
        marks = [""] if len(given.terms) == 1 else [f"_{i}" for i in range(1, len(given.terms) + 1)]
        texts = found.strengths.texts()
        return [(f"delta{mark}", t.shape(), text) for mark, t, text in zip(marks, given.terms, texts)]
    return local_strengths(given)


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
