"""Turning points x_n (units of x0, with their sign) and times tau_n = omega_0 t for X'' + X + epsilon X'|X'| = 0.

  asymptotics turning-points --alpha 2 --epsilon 1 --count 6 --digits 60 --times
  asymptotics turning-points --alpha 2 --epsilon 1/3 --count 1 --start 1000000000 --digits 50

The motion starts from rest at X(0) = 1, which is turning point 0.
"""

import argparse
import sys

from tqdm import tqdm

from asymptotics.cli.answer import Answer, add_digits, add_json, read_digits
from asymptotics.errors import InputError
from asymptotics.numbers.exact import parse_integer, parse_real
from asymptotics.turning_points.quadratic import (
    MAX_COUNT,
    MAX_DIGITS,
    MAX_START,
    TurningPoints,
    quadratic_turning_points,
)


def configure(parser: argparse.ArgumentParser) -> None:
    """Declare the options."""
    parser.add_argument("--alpha", required=True, metavar="A", help="the exponent of the damping law (2)")
    parser.add_argument("--epsilon", required=True, metavar="E", help="b omega_0^alpha x0^(alpha-1) / k, e.g. 1/3")
    parser.add_argument("--count", required=True, metavar="N", help=f"how many points (1 to {MAX_COUNT})")
    parser.add_argument("--start", default="0", metavar="N", help="the first point (default 0)")
    parser.add_argument("--times", action="store_true", help="the times as well")
    add_digits(parser, MAX_DIGITS)
    add_json(parser)


def run(options: argparse.Namespace) -> Answer:
    """Run the command."""
    alpha = parse_real(options.alpha, "--alpha")
    if not alpha.is_rational or alpha.rational != 2:
        raise InputError("--alpha", f"{alpha} has no turning points here yet", "2")
    epsilon = parse_real(options.epsilon, "--epsilon")
    count = parse_integer(options.count, "--count", 1, MAX_COUNT)
    start = parse_integer(options.start, "--start", 0, MAX_START)
    digits = read_digits(options, MAX_DIGITS)
    with tqdm(total=count, unit="point", leave=False, disable=not sys.stderr.isatty(), delay=1) as bar:
        result = quadratic_turning_points(
            epsilon, count, digits, start=start, times=options.times, progress=lambda done: bar.update(done - bar.n)
        )
    return Answer(result.to_dict(), _text(result), options.json)


def _text(result: TurningPoints) -> str:
    rows = [(str(p.n), p.x) + (() if p.tau is None else (p.tau,)) for p in result.points]
    widths = [max(map(len, column)) for column in zip(*rows)]
    lines = ["  ".join(cell.rjust(width) for cell, width in zip(row, widths)) for row in rows]
    return "\n".join([*lines, f"certified: {str(result.certified).lower()} ({result.method})"])
