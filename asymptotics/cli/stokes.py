"""Why the series diverge: the Stokes constants of the half-swing of one law, certified.

c_k belong to the amplitude and d_k to the time: in front of the factorial growth of p_k stands c_1 + d_1/pi, of Omega_k
d_1, and a truncated expansion at the local strength delta leaves about |c_1| e^(-2 pi |c|/delta).

asymptotics stokes --alpha 2
asymptotics stokes --alpha 3/2 --count 2 --digits 20

alpha > 0 other than 1 (at 0 all vanish); near 1 the work grows like 1/|alpha - 1| and is refused by its estimate.
"""

import argparse

from asymptotics.api.divergence import stokes
from asymptotics.cli.answer import Answer, add_common, read_digits
from asymptotics.cli.files import Makers, add_csv, add_plot, picture_maker, read_files, write_files
from asymptotics.cli.rows import asked_besides
from asymptotics.expansions.divergence.result import MAX_COUNT, MAX_DIGITS
from asymptotics.numbers.exact import parse_integer, parse_real
from asymptotics.present.inputs import csv_text


def configure(parser: argparse.ArgumentParser) -> None:
    """Declare the options."""
    parser.add_argument("--alpha", required=True, metavar="A", help="the exponent, 0 or more, not 1")
    parser.add_argument("--count", default="1", metavar="K", help=f"how many constants, 1 to {MAX_COUNT} (default 1)")
    parser.add_argument("--latex", action="store_true", help="print the constants as LaTeX")
    add_plot(parser, "|c_k| and |d_k|")
    add_csv(parser, "k, c_k, d_k")
    add_common(parser, MAX_DIGITS, "17")


def run(options: argparse.Namespace) -> Answer:
    """Run the command."""
    files = read_files(options)
    alpha, count = parse_real(options.alpha, "--alpha"), parse_integer(options.count, "--count", 1, MAX_COUNT)
    found = stokes(alpha, count=count, digits=read_digits(options, MAX_DIGITS))
    makers: Makers = {"--csv": lambda _: csv_text(["k", "c_k", "d_k"], found.rows())}
    written = write_files(files, makers | {"--plot": picture_maker(options, lambda: [found])}, options, "stokes")
    data = {**found.to_dict(), **asked_besides(options, found.latex(), written)}
    return Answer(data, found.latex() if options.latex else "\n".join([str(found), *written]), options.json)
