"""The average M_p of |sin|^p, which everything is made of: M_p = Gamma((p+1)/2) / (sqrt(pi) Gamma(p/2+1)).

asymptotics moment --p 5/2 --digits 40
"""

import argparse

from asymptotics.cli.answer import Answer, add_digits, add_json, read_digits
from asymptotics.errors import InputError
from asymptotics.moments.certified import moment as moment_ball
from asymptotics.moments.symbolic import moment
from asymptotics.numbers.bridge import to_sympy
from asymptotics.numbers.decimals import certified_decimal
from asymptotics.numbers.exact import REAL_FORMS, parse_real

MAX_DIGITS, MAX_P = 10_000, 10_000


def configure(parser: argparse.ArgumentParser) -> None:
    """Declare the options."""
    parser.add_argument("--p", required=True, metavar="P", help=f"a real number above -1, at most {MAX_P}")
    add_digits(parser, MAX_DIGITS)
    add_json(parser)


def run(options: argparse.Namespace) -> Answer:
    """Run the command."""
    p = parse_real(options.p, "--p")
    if not p > -1 or p > MAX_P:
        reason = "the average diverges" if not p > -1 else "is out of range"
        raise InputError("--p", f"{p}: {reason}", f"a real number above -1, at most {MAX_P}: {REAL_FORMS}")
    value = certified_decimal(lambda: moment_ball(p.ball()), read_digits(options, MAX_DIGITS))
    exact = str(moment(to_sympy(p)))
    return Answer({"p": str(p), "value": value, "exact": exact}, f"M_{p} = {value} = {exact}", options.json)
