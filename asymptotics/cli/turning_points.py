"""Turning points x_n (units of x0, with their sign) and times tau_n = omega_0 t for any alpha >= 0, and sums of laws.

  asymptotics turning-points --alpha 2 --epsilon 1 --count 6 --digits 60 --times
  asymptotics turning-points --alpha 2 --epsilon 1/3 --count 1 --start 1000000000 --digits 50
  asymptotics turning-points --law 0:1/20 --law 3/2:1/10 --count 10

  asymptotics turning-points --law 2:1/10 --spring pendulum --x0 2.967 --count 10

X'' + X + sum_i epsilon_i X'|X'|^(alpha_i-1) = 0 starts from rest at X(0) = 1, which is turning point 0.  All digits are
proved, whatever the law.  `ended` tells the last turning point there is, and why: sticks, creeps, overdamped, rotates
or escapes.

With --spring, or a loss --law A,M:E that depends on the place, the motion starts at X(0) = x0 inside the well, and from
rest x is in the units in which the strengths are given: rad for a pendulum.
"""

import argparse

from asymptotics.cli.answer import Answer, add_digits, add_json, add_max_seconds, read_digits, read_max_seconds
from asymptotics.cli.forces import add_forces, read_law
from asymptotics.errors import LimitError
from asymptotics.law import Law
from asymptotics.numbers.exact import parse_integer, parse_real
from asymptotics.turning.general import turning_points
from asymptotics.turning.quadratic import MAX_COUNT, MAX_DIGITS, MAX_START, TurningPoints


def configure(parser: argparse.ArgumentParser) -> None:
    """Declare the options."""
    add_forces(parser, "epsilon", "E", "b omega_0^alpha x0^(alpha-1) / k, e.g. 1/3")
    parser.add_argument("--count", required=True, metavar="N", help=f"how many points (1 to {MAX_COUNT})")
    parser.add_argument("--start", default="0", metavar="N", help="the first point (default 0)")
    parser.add_argument("--times", action="store_true", help="the times as well")
    parser.add_argument("--x0", default="1", metavar="X", help="X(0), with --v0 or --spring (default 1)")
    parser.add_argument("--v0", default="0", metavar="V", help="X'(0): then n = 0 is the first turning point")
    add_max_seconds(parser)
    add_digits(parser, MAX_DIGITS)
    add_json(parser)


def run(options: argparse.Namespace) -> Answer:
    """Run the command."""
    law = read_law(options, "epsilon")
    count = parse_integer(options.count, "--count", 1, MAX_COUNT)
    start = parse_integer(options.start, "--start", 0, MAX_START)
    digits = read_digits(options, MAX_DIGITS)
    try:
        result = _computed(options, law, count, digits, start)
    except LimitError as error:
        if error.argument == "time":  # the integrator speaks of its own argument
            raise LimitError("--epsilon", error.reason, "weaker damping") from error
        raise
    return Answer(result.to_dict(), _text(result), options.json)


def _computed(options: argparse.Namespace, law: Law, count: int, digits: int, start: int) -> TurningPoints:
    x0, v0 = (parse_real(getattr(options, name), f"--{name}") for name in ("x0", "v0"))
    seconds = read_max_seconds(options)
    return turning_points(law, count, digits, start=start, times=options.times, x0=x0, v0=v0, max_seconds=seconds)


def _text(result: TurningPoints) -> str:
    rows = [(str(p.n), p.x) + (() if p.tau is None else (p.tau,)) for p in result.points]
    widths = [max(map(len, column)) for column in zip(*rows)]
    lines = ["  ".join(cell.rjust(width) for cell, width in zip(row, widths)) for row in rows]
    if result.first is not None:
        lines.append("turning point 0 has the amplitude {amplitude}, at tau = {tau}".format_map(result.first))
    if result.ended is not None:
        last, reason = result.ended["n"], result.ended["reason"]
        where = f"turning point {last} is the last" if last >= 0 else "there is no turning point"
        lines.append(f"ended: {where}: the motion {_WORDS[reason]}")
    return "\n".join([*lines, f"certified: {str(result.certified).lower()} ({result.method})"])


_WORDS = {"sticks": "sticks there", "creeps": "creeps from there on", "overdamped": "is overdamped"}
_WORDS |= {"rotates": "goes over the top and rotates", "escapes": "leaves its well and escapes"}
