"""The limit cycle of x'' + x + mu sum_i E_i |x|^M_i x'|x'|^(A_i-1) = 0, where gains and losses of energy balance:

turning amplitude and frequency as series in mu, the common factor of the laws, exactly; the multiplier of a small
departure per period, and its logarithm.  With --mu the cycle itself at that number: turning amplitude, period,
frequency and multiplier, certified by interval Newton.

  asymptotics limit-cycle --law 1:-1 --law 1,2:1 --order 8             van der Pol
  asymptotics limit-cycle --law 1:-1 --law 3:1 --order 8 --mu 1/2      Rayleigh

  asymptotics limit-cycle --law 1:-1 --law 1,2:1 --spring 3:1/2 --mu 1 a cubic spring beside x, at a number
  asymptotics limit-cycle --law 1:1 --law 1,2:-5 --law 1,4:1 --near 4  the outer of two cycles

The laws must be polynomials in x and x': M even, A odd, and their strengths rational for the series.  Springs x^P x'^Q
(P odd, Q even) are not multiplied by mu; beside them there is no series, and --mu is needed.  |mu| is in 1e-100 .. 20:
stronger relaxation oscillations are left out, and cycles whose multiplier is 1 to a hundred digits.
"""

import argparse

from asymptotics.cli.answer import Answer, add_common, read_digits
from asymptotics.cli.files import Makers, add_csv, add_plot, picture_maker, read_files, write_files
from asymptotics.cli.forces import add_forces, read_law
from asymptotics.cli.rows import asked_besides, row_text, rows_csv, rows_latex
from asymptotics.errors import InputError
from asymptotics.limit_cycles.result import LimitCycle, limit_cycle
from asymptotics.limit_cycles.series import MAX_ORDER
from asymptotics.numbers.exact import parse_integer, parse_real
from asymptotics.numbers.policy import exact_double
from asymptotics.present.inputs import csv_text

MAX_DIGITS = 200


def configure(parser: argparse.ArgumentParser) -> None:
    """Declare the options."""
    add_forces(parser, "epsilon", "E", "its strength, negative for a gain")
    parser.add_argument("--order", default="8", metavar="N", help=f"the highest power of mu, 0 to {MAX_ORDER}")
    parser.add_argument("--mu", metavar="M", help="a number: the cycle there as well, certified")
    parser.add_argument("--near", metavar="A", help="the amplitude of the cycle that is meant, if there are several")
    parser.add_argument("--latex", action="store_true", help="print the series, or the numbers, as LaTeX")
    add_plot(parser, "amplitude and frequency against mu")
    add_csv(parser, "the coefficients; beside springs the numbers at mu")
    add_common(parser, MAX_DIGITS)


def run(options: argparse.Namespace) -> Answer:
    """Run the command."""
    files = read_files(options)
    law = read_law(options, "epsilon", negative=True)
    order = parse_integer(options.order, "--order", 0, MAX_ORDER)
    digits = read_digits(options, MAX_DIGITS)
    mu = None if options.mu is None else parse_real(options.mu, "--mu")
    near = None if options.near is None else exact_double(options.near, "--near")
    if near is not None and not near > 0:
        raise InputError("--near", f"{options.near[:40]} is not positive", "an amplitude > 0")
    found = limit_cycle(law, order, digits, mu, near)
    latex = _latex(found, digits)
    makers: Makers = {"--csv": lambda _: _table(found), "--plot": picture_maker(options, lambda: [found])}
    written = write_files(files, makers, options, "limit-cycle")
    data = {**found.to_dict(), **asked_besides(options, latex, written)}
    return Answer(data, latex if options.latex else "\n".join([_text(found), *written]), options.json)


_NUMBERS = {"amplitude": "A", "period": "T", "frequency": r"\omega", "multiplier": r"\rho"}


def _latex(found: LimitCycle, digits: int) -> str:
    """The series, and the numbers at mu."""
    rows = {"A": found.amplitude, r"\omega": found.frequency, r"\log\rho": found.log_multiplier}
    series = rows_latex({name: row for name, row in rows.items() if row}, (r"\mu",), digits)
    if found.at is None:
        return series
    numbers = [rf"{letter}({found.at.mu}) = {getattr(found.at, name)}" for name, letter in _NUMBERS.items()]
    return " \\\\\n".join([*([series] if series else []), *numbers])


def _table(found: LimitCycle) -> str:
    """The coefficients as CSV, or (beside springs) the numbers at mu."""
    if found.at is not None and not found.amplitude:
        return csv_text(["quantity", "value"], [(name, getattr(found.at, name)) for name in _NUMBERS])
    names = ("amplitude", "frequency", "multiplier", "log_multiplier")
    return rows_csv({name: getattr(found, name) for name in names})


def _text(found: LimitCycle) -> str:
    lines = [f"x'' + x + mu ({found.law}) = 0, {found.arithmetic}; powers of mu"]
    # Beside springs there is no series in mu, whose first term would be the linear frequency 1.
    if not found.frequency:
        springs, losses = ("".join(f" + {t}" for t in terms) for terms in (found.law.springs, found.law.losses))
        lines = [f"x'' + x{springs} + mu ({losses[3:]}) = 0".replace("+ -", "- ")]
    lines += [*row_text("A", found.amplitude), *row_text("omega", found.frequency)]
    lines += row_text("log multiplier", found.log_multiplier)
    if found.at is not None:
        # ``stable`` is None where the ball of the multiplier holds 1: neither is proved.
        names = ("amplitude", "period", "frequency", "multiplier")
        kind = {True: "stable", False: "unstable", None: "stability undecided"}[found.at.stable]
        lines += [f"at mu = {found.at.mu}: certified, {kind}"]
        lines += [f"{name:10}  {getattr(found.at, name)}" for name in names]
    return "\n".join(lines)
