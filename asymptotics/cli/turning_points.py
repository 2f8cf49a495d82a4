"""Turning points x_n (with their sign) and their times, for any alpha >= 0, and sums of laws.

  asymptotics turning-points --alpha 2 --epsilon 1 --count 6 --digits 60 --times
  asymptotics turning-points --alpha 2 --epsilon 1/3 --count 1 --start 1000000000 --digits 50
  asymptotics turning-points --law 0:1/20 --law 3/2:1/10 --count 10
  asymptotics turning-points --law 0:1/50 --law 2:1/10 --count 30 --digits 300 --route help
  asymptotics turning-points --law 2:1/10 --spring pendulum --x0 2.967 --count 10
  asymptotics turning-points --alpha 3/2 --mass 3/2 --stiffness 30 --damping 1/10 --x0 1/5 --count 10 --times

X'' + X + sum_i epsilon_i X'|X'|^(alpha_i-1) = 0 starts from rest at X(0) = 1, which is turning point 0: x is in units
of x0, and tau = omega_0 t.  With --damping, --mass or --stiffness everything is in SI, x in m, t in s; without them
--x0 and --v0 start the same equation elsewhere.  All digits are
proved, for any powers of the velocity, whole powers of the place in springs and losses, and the pendulum.  `ended`
tells the last turning point there is, and why: sticks, creeps, overdamped, rotates or escapes.

With --x0 the motion starts at X(0) = x0 (beside a spring: inside the well) and x is not divided by it: it is in the
units in which the strengths are given, rad for a pendulum, and point 0 is x0 itself.
A header above the points says so, and `x_unit` in JSON: "x0", "m", "rad" or "strengths".  With --v0 point 0 is 1, and
its amplitude is told below.

The cheapest route is taken; --route NAME takes another one, and --route help lists them with what each would cost.
"""

import argparse
from dataclasses import replace
from pathlib import Path
from typing import Any

from asymptotics.api.turning_points import OscillatorTurningPoints, dimensionless
from asymptotics.api.turning_points import turning_points as in_si
from asymptotics.cli.answer import Answer, add_common, read_digits, read_max_seconds, shortened
from asymptotics.cli.files import Makers, add_csv, add_plot, picture_maker, read_files, write_files
from asymptotics.cli.forces import add_forces, read_law
from asymptotics.cli.quantities import add_physical, add_start, is_physical, read_oscillator
from asymptotics.cut_short import changed
from asymptotics.errors import LimitError
from asymptotics.law import PENDULUM, Oscillator
from asymptotics.numbers.exact import ExactReal, parse_integer, parse_real
from asymptotics.present.inputs import csv_text
from asymptotics.turning.choose import offers, turning_points
from asymptotics.turning.result import TurningPoints
from asymptotics.turning.table import MAX_COUNT, MAX_DIGITS, MAX_START, Request


def configure(parser: argparse.ArgumentParser) -> None:
    """Declare the options."""
    add_forces(parser, "epsilon", "E", "b omega_0^alpha x0^(alpha-1) / k, e.g. 1/3")
    add_physical(parser)
    parser.add_argument("--count", required=True, metavar="N", help=f"how many points (1 to {MAX_COUNT})")
    parser.add_argument("--start", default="0", metavar="N", help="the first point (default 0)")
    parser.add_argument("--times", action="store_true", help="the times as well")
    add_start(parser)
    parser.add_argument("--route", metavar="NAME", help="the route to take instead of the cheapest; help lists them")
    parser.add_argument("--latex", action="store_true", help="print the table as LaTeX")
    add_plot(parser, "|x_n| against n")
    add_csv(parser, "n, x and the times")
    add_common(parser, MAX_DIGITS)


def run(options: argparse.Namespace) -> Answer:
    """Run the command."""
    files = read_files(options)
    count = parse_integer(options.count, "--count", 1, MAX_COUNT)
    start = parse_integer(options.start, "--start", 0, MAX_START)
    digits = read_digits(options, MAX_DIGITS)
    if options.route == "help":
        return _routes(options, count, digits, start)
    # The routes know their parameters and not the options that set them.
    try:
        result = _computed(options, count, digits, start)
    except LimitError as error:
        if error.argument == "time":  # the integrator speaks of its own argument
            raise LimitError("--epsilon", error.reason, "weaker damping") from error
        raise
    return _answer(options, files, result)


def cut_short(options: argparse.Namespace, result: TurningPoints | OscillatorTurningPoints) -> Answer:
    """The points that were done when the time was over."""
    first, last = result.points[-1].n + 1, int(options.start) + int(options.count) - 1
    return shortened(_answer(options, read_files(options), result), len(result.points), f"n = {first} ... {last}")


def _answer(
    options: argparse.Namespace, files: dict[str, Path], result: TurningPoints | OscillatorTurningPoints
) -> Answer:
    """The answer that is printed, after its files are written."""
    data, si = result.to_dict(), isinstance(result, OscillatorTurningPoints)
    unit = _unit(options)
    makers: Makers = {"--csv": lambda _: _table(result, unit), "--plot": picture_maker(options, lambda: [result])}
    data |= {
        "units": "SI" if si else None,
        "x_unit": unit,
        "files": write_files(files, makers, options, "turning-points"),
    }
    text = result._formula() if options.latex else str(result) if si else _text(result, unit)
    return Answer(data, "\n".join([text, *data["files"]]), options.json)


def _computed(
    options: argparse.Namespace, count: int, digits: int, start: int
) -> TurningPoints | OscillatorTurningPoints:
    if is_physical(options):
        return in_si(
            read_oscillator(options).oscillator,
            count,
            digits=digits,
            start=start,
            times=options.times,
            route=options.route,
        )
    law = read_law(options, "epsilon")
    x0, v0 = _start(options)
    # Powers of the velocity scale with the amplitude: the engine starts at 1, with strengths epsilon_i x0^(alpha_i-1),
    # and the places are multiplied by x0.  Beside springs and |x|^m it takes x0 itself.
    if law.is_pure and v0.is_zero and x0 != 1:
        return _undivided(Oscillator(law, x0=x0), count, digits, start, options)
    seconds = read_max_seconds(options)
    chosen: dict[str, Any] = {"times": options.times, "route": options.route, "max_seconds": seconds}
    return turning_points(law, count, digits, start=start, x0=x0, v0=v0, **chosen)


def _routes(options: argparse.Namespace, count: int, digits: int, start: int) -> Answer:
    """All routes, and what each would cost for this request; none is taken."""
    kick: dict[str, Any]
    if is_physical(options):
        law, kick = dimensionless(read_oscillator(options).oscillator)
    else:
        (x0, v0), law = _start(options), read_law(options, "epsilon")
        kick = {"x0": x0, "v0": v0}
        if law.is_pure and v0.is_zero:
            # As it is computed: from 1, with strengths epsilon_i x0^(alpha_i-1).
            law, kick = dimensionless(Oscillator(law, x0=x0))
    offered = offers(Request.read(law, count, digits, start=start, times=options.times, **kick))
    rows = [(r.name, "no" if s is None else f"{s:.2g}", r.domain, r.way) for r, s in offered]
    head = ("route", "seconds", "serves", "by")
    widths = [max(map(len, column)) for column in zip(head, *rows)]
    lines = ["  ".join(cell.ljust(width) for cell, width in zip(row, widths)).rstrip() for row in (head, *rows)]
    routes = [dict(zip(("name", "seconds", "serves", "by"), row)) for row in rows]
    return Answer({"routes": routes}, "\n".join(lines), options.json)


def _start(options: argparse.Namespace) -> tuple[ExactReal, ExactReal]:
    """(x0, v0), by default (1, 0)."""
    given = (("x0", options.x0, "1"), ("v0", options.v0, "0"))
    x0, v0 = (parse_real(default if text is None else text, f"--{name}") for name, text, default in given)
    return x0, v0


def _undivided(
    oscillator: Oscillator, count: int, digits: int, start: int, options: argparse.Namespace
) -> TurningPoints:
    """From rest at another place than 1, m = k = 1: as in SI, but nothing has a unit."""
    rest = {"times": options.times, "route": options.route}
    strengths = ",".join(str(t.strength) for t in oscillator.law.terms)

    def bare(found: OscillatorTurningPoints) -> TurningPoints:
        inner = found.dimensionless
        # m = k = 1: seconds are tau, and metres the unit in which the strengths were given.
        points = tuple(replace(q, x=p.x, tau=p.t) for p, q in zip(found.points, inner.points, strict=True))
        return replace(inner, epsilon=strengths, digits=digits, points=points)

    with changed(bare):
        found = in_si(oscillator, count, digits=digits, start=start, **rest)
    assert isinstance(found, OscillatorTurningPoints)
    return bare(found)


def _unit(options: argparse.Namespace) -> str:
    """What x counts: metres, point 0 itself, radians, or the length in which the strengths are given."""
    springs = options.spring or []
    if is_physical(options):
        return "rad" if PENDULUM in springs else "m"
    x0, v0 = _start(options)
    if not v0.is_zero:
        return "x0"
    if PENDULUM in springs:
        return "rad"
    # A,M:E is a loss |x|^M: its strength belongs to a length, as that of a spring does.
    placed = any("," in text.partition(":")[0] for text in options.law or [])
    return "strengths" if springs or placed or x0 != 1 else "x0"


_HEADS = {"x0": None, "rad": "x [rad]", "strengths": "x [units of the strengths]"}


def _text(result: Any, unit: str) -> str:
    rows = [(str(p.n), p.x) + (() if p.tau is None else (p.tau,)) for p in result.points]
    if _HEADS[unit] and rows:
        rows.insert(0, ("n", str(_HEADS[unit]), "tau")[: len(rows[0])])
    widths = [max(map(len, column)) for column in zip(*rows)]
    lines = ["  ".join(cell.rjust(width) for cell, width in zip(row, widths)) for row in rows]
    if result.first is not None:
        lines.append("turning point 0 has the amplitude {amplitude}, at tau = {tau}".format_map(result.first))
    if result.ended is not None:
        last, reason = result.ended["n"], result.ended["reason"]
        where = f"turning point {last} is the last" if last >= 0 else "there is no turning point"
        where += " in the well" if reason in ("rotates", "escapes") else ""
        lines.append(f"ended: {where}: the motion {_WORDS[reason]}")
    return "\n".join([*lines, f"certified: {str(result.certified).lower()} ({result.method})"])


def _table(result: TurningPoints | OscillatorTurningPoints, unit: str) -> str:
    """The points as CSV, with units in the header."""
    if isinstance(result, OscillatorTurningPoints):
        return csv_text(["n", f"x [{result.unit}]", "t [s]"], [(p.n, p.x, p.t) for p in result.points])
    return csv_text(["n", _HEADS[unit] or "x", "tau"], [(p.n, p.x, p.tau) for p in result.points])


_WORDS = {"sticks": "sticks there", "creeps": "creeps from there on", "overdamped": "is overdamped"}
_WORDS |= {"rotates": "goes over the top and rotates", "escapes": "leaves its well and escapes"}
