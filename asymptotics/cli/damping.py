"""Equivalent damping of a law at amplitudes: zeta, Q, decrement, energy loss, c_eq, half-life.

  asymptotics damping --alpha 2 --epsilon 1/10 --amplitudes 1/2,1
  asymptotics damping --law 1:0.1 --law 2:0.2 --mass 3/2 --stiffness 30 --amplitudes 0.2,0.1 --order 3
  asymptotics damping --law 1:1/50 --law 2:1/20 --spring pendulum --amplitudes 10,40 --unit deg --plot q.svg
  asymptotics damping --alpha symbolic
  asymptotics damping --from TABLE.csv --resolution 0.0002 --laws 1 2 1+2

Formulas of first order (one cycle without loss: zeta = Delta E/(4 pi E), Q = 2 pi E/Delta E, decrement
ln(A_n/A_(n+2)), c_eq = Delta E/closed integral of v dx, half-life from A to A/2), certified numbers of it, and of the
motion itself over one full swing from rest at A; with --order N the series, each number with its proved bound.
--from FILE is the inverse: columns A and zeta, Q or decrement (and resolution), to candidate laws with intervals.
Units are SI when --damping, --mass or --stiffness is given; a pendulum's amplitudes are in rad.
"""

import argparse
from pathlib import Path
from typing import Any

from asymptotics.api.damping import MAX_DIGITS, MAX_ORDER, damping
from asymptotics.api.damping_law import damping_law
from asymptotics.ask.forces import add_forces, read_law
from asymptotics.ask.moving import add_physical, read_oscillator
from asymptotics.ask.rows import asked_besides
from asymptotics.cli.answer import Answer, add_common, shortened
from asymptotics.cli.files import Makers, add_csv, add_plot, picture_maker, read_files, write_files
from asymptotics.cut_short import changed
from asymptotics.equivalent.result import EquivalentDamping
from asymptotics.equivalent.rows import QUANTITIES
from asymptotics.errors import InputError
from asymptotics.identification.found_law import DampingLaw
from asymptotics.law import PENDULUM, Law
from asymptotics.numbers.exact import parse_integer, parse_real
from asymptotics.present.inputs import csv_text, option_words, with_words
from asymptotics.records.units import ANGLES, LENGTHS

# The half-life is a time of first order only: there is no curve of the motion beside it.
_DRAWN = tuple(name for name in QUANTITIES if name != "half_life")


def configure(parser: argparse.ArgumentParser) -> None:
    """Declare the options."""
    add_forces(parser, "epsilon", "E", "its strength at A = 1, where m = k = 1")
    add_physical(parser)
    text = "turning amplitudes in m (rad of a pendulum), without SI units in the unit of the strengths (1,1/2,1/4,1/8)"
    parser.add_argument("--amplitudes", metavar="A,A,...", help=text)
    text = f"of the amplitudes: {', '.join(LENGTHS)} beside SI units; {', '.join(ANGLES)} of a pendulum"
    parser.add_argument("--unit", metavar="U", help=text)
    parser.add_argument("--order", metavar="N", help=f"the series of order N too, with its bound: 1 to {MAX_ORDER}")
    parser.add_argument(
        "--from", dest="table", metavar="FILE", help="columns A, zeta (Q, decrement), resolution: the law"
    )
    parser.add_argument("--resolution", metavar="S", help="with --from: the standard deviation of each value")
    parser.add_argument(
        "--laws", nargs="+", metavar="LAW", help="with --from: candidate laws, exponents: 1 1+2 0+2 ..."
    )
    text = "b under the names of ITTC, IMO, OpenFAST, OrcaFlex and of dampers; needs SI units"
    parser.add_argument("--conversions", action="store_true", help=text)
    parser.add_argument("--quantity", metavar="NAME", help=f"what --plot draws: {', '.join(_DRAWN)} (default Q)")
    parser.add_argument("--latex", action="store_true", help="print the formulas as LaTeX")
    add_plot(parser, "the curve against the amplitude")
    add_csv(parser, "all numbers, a row for each amplitude and order")
    add_common(parser, MAX_DIGITS, "12")


def run(options: argparse.Namespace) -> Answer:
    """Run the command."""
    files = read_files(options)
    if options.table is not None:
        return _inverse(options, files)
    for name in ("resolution", "laws"):
        if getattr(options, name) is not None:
            raise InputError(f"--{name}", "there is no table", "--from FILE with it")
    if options.quantity is not None and "--plot" not in files:
        raise InputError("--quantity", "there is no picture to draw it in", "--plot FILE with --quantity")
    if options.quantity is not None and options.quantity not in _DRAWN:
        raise InputError("--quantity", f"{options.quantity[:40]!r} is unknown", ", ".join(_DRAWN))
    found = _symbolic(options, files) if options.alpha == "symbolic" else _asked(options)
    return _answer(options, files, found)


def cut_short(options: argparse.Namespace, found: EquivalentDamping) -> Answer:
    """The rows that were done when the time was over."""
    asked = [] if options.amplitudes is None else options.amplitudes.split(",")[len(found.rows) :]
    missing = f"amplitudes {','.join(asked)}" if asked else "the smaller amplitudes"
    return shortened(_answer(options, read_files(options), found), len(found.rows), missing)


def _answer(options: argparse.Namespace, files: dict[str, Path], found: EquivalentDamping) -> Answer:
    """The answer that is printed, after its files are written."""
    makers: Makers = {
        "--csv": lambda _: found.to_csv(),
        "--plot": picture_maker(options, lambda: [found], quantity=options.quantity or "Q"),
    }
    written = write_files(files, makers, options, "damping")
    named = found.conversions() if options.conversions else ()
    data = {**found.to_dict(), **asked_besides(options, found.latex(), written)}
    data |= {"conversions": [c.to_dict() for c in named]} if named else {}
    text = "\n".join([str(found), *map(str, named), *written])
    return Answer(data, found.latex() if options.latex else text, options.json)


def _inverse(options: argparse.Namespace, files: dict[str, Path]) -> Answer:
    """The law behind a table."""
    path = Path(options.table)
    try:  # first: of a file that is not there no combination matters
        path.stat()
    except OSError as error:
        raise InputError("--from", f"cannot read {path.name[:80]}: {error.strerror}", "a file of data") from None
    # The law is what is looked for here, so that nothing may say it beforehand.
    refused = (
        "alpha",
        "law",
        "epsilon",
        "damping",
        "amplitudes",
        "unit",
        "order",
        "digits",
        "latex",
        "conversions",
        "quantity",
    )
    for name in refused:
        if getattr(options, name):
            raise InputError(f"--{name}", "cannot be combined with --from", "the table, --laws, --resolution, --spring")
    if "--plot" in files:
        raise InputError("--plot", "cannot be combined with --from", "--csv, or asymptotics damping of the law found")
    with changed(lambda _: None):  # what is done on the way to a law is no row of amplitudes
        found = law_behind(path, options, resolution=options.resolution, laws=options.laws)
    text = with_words(csv_text(LAW_HEAD, law_rows(found)), _law_words(found, options))
    written = write_files(files, {"--csv": lambda _: text})
    return Answer(
        {**found.to_dict(), **asked_besides(options, "", written)}, "\n".join([str(found), *written]), options.json
    )


def law_behind(table: Any, options: argparse.Namespace, **more: Any) -> DampingLaw:
    """The law behind a table: a file, or columns."""
    return damping_law(table, spring=_spring(options), mass=options.mass, stiffness=options.stiffness, **more)


LAW_HEAD = ("law", "grade", "alpha", "low", "strength", "high")


def law_rows(found: DampingLaw) -> list[tuple[Any, ...]]:
    """A row for each strength of each law."""
    return [(c.name, c.told(), s.alpha, s.low, s.estimate, s.high) for c in found.laws for s in c.strengths]


def _law_words(found: DampingLaw, options: argparse.Namespace) -> list[str]:
    """The request, with the numbers of the table in the place of its file."""
    laws = ",".join("+".join(alphas) for alphas in found.problem.candidates)
    table = {name: ",".join(map(repr, column)) for name, column in found.table.items()}
    given = {name: getattr(options, name) for name in ("spring", "mass", "stiffness")}
    return ["damping-law", *option_words({**table, "laws": laws, **given})]


def _spring(options: argparse.Namespace) -> Any:
    """The springs as a mapping, or the pendulum's name."""
    if options.spring is None:
        return None
    # The reader of laws wants a loss: one is put in, and only the springs are taken out again.
    terms = read_law(argparse.Namespace(**{**vars(options), "law": ["1:1"]}), "epsilon").springs
    if any(t.family for t in terms):
        return PENDULUM
    return {(t.position, t.velocity): t.strength for t in terms}


def _asked(options: argparse.Namespace) -> EquivalentDamping:
    """The numbers of a law."""
    given = read_oscillator(options, "epsilon")
    digits = 12 if options.digits is None else parse_integer(options.digits, "--digits", 1, MAX_DIGITS)
    order = None if options.order is None else parse_integer(options.order, "--order", 1, MAX_ORDER)
    if options.amplitudes is None and given.si:
        raise InputError("--amplitudes", "is missing", "turning amplitudes in m (rad of a pendulum), such as 0.2,0.1")
    amplitudes = options.amplitudes and [parse_real(text, "--amplitudes") for text in options.amplitudes.split(",")]
    # Without units the amplitudes are in the unit of the strengths, which a law alone says; an oscillator would mean m.
    law = given.oscillator if given.si else Law.from_terms(given.oscillator.law.terms)
    return damping(law, amplitudes, order=order, digits=digits, unit=options.unit or "")


def _symbolic(options: argparse.Namespace, files: object) -> EquivalentDamping:
    """The formulas with a symbol for the exponent."""
    names = ("law", "spring", "epsilon", "damping", "mass", "stiffness", "amplitudes", "order", "digits", "unit")
    for name in names:
        if getattr(options, name) is not None:
            raise InputError(f"--{name}", "cannot be combined with --alpha symbolic", "formulas of one law")
    if files:
        raise InputError("--csv", "cannot be combined with --alpha symbolic", "formulas of one law")
    return damping("symbolic")
