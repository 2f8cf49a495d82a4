"""The average M_p of |sin|^p, which everything is made of: M_p = Gamma((p+1)/2) / (sqrt(pi) Gamma(p/2+1)).

asymptotics moment --p 5/2 --digits 40
"""

import argparse

from asymptotics.api.lookups import MAX_DIGITS, MAX_P, moment
from asymptotics.cli.answer import Answer, add_common, read_digits
from asymptotics.numbers.exact import parse_real


def configure(parser: argparse.ArgumentParser) -> None:
    """Declare the options."""
    parser.add_argument("--p", required=True, metavar="P", help=f"a real number above -1, at most {MAX_P}")
    parser.add_argument("--latex", action="store_true", help="print the closed form as LaTeX")
    add_common(parser, MAX_DIGITS)


def run(options: argparse.Namespace) -> Answer:
    """Run the command."""
    p = parse_real(options.p, "--p")
    found = moment(p, digits=read_digits(options, MAX_DIGITS))
    latex = rf"M_{{{p}}} = {found._formula()}"
    data = {"p": str(p), "value": found.value, "exact": found.exact, **({"latex": latex} if options.latex else {})}
    return Answer(data, latex if options.latex else f"M_{p} = {found.value} = {found.exact}", options.json)
