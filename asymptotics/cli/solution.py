"""The multiple-scale solution as functions of time: A(tau), phi(tau) and x(tau) of order N, as formulas and numbers.

  asymptotics solution --alpha 2 --epsilon 1/10 --order 3
  asymptotics solution --alpha 2 --epsilon 1/10 --order 3 --time 50 --bound
  asymptotics solution --alpha 3/2 --units kappa --order 4
  asymptotics solution --alpha 2 --mass 3/2 --stiffness 30 --damping 1/10 --x0 1/5 --order 3 --time 7
  asymptotics solution --alpha 2 --epsilon 1/10 --order 3 --time 100 --plot decay.svg --csv decay.csv
  asymptotics solution --alpha 2 --order 4 --latex > solution.tex
  asymptotics solution --law 1:1/10 --law 2:1/20 --order 2

One law: A and phi explicit in the slow time, x through order N (x(0) = 1, turning-point gauge); without a strength
the formulas alone.  Sums of laws and springs: tau(A) and phi(A), with the numeric inverse.  --units epsilon (default),
kappa = M_(alpha+1) epsilon (Lancaster 2020), or SI: t, m, k, b, x_0, the default where --damping, --mass or
--stiffness is given.  --time is in s there, else tau.  Proved are the line "proved" (valid_until in JSON: |x - x_N|
for all times, before rounding) and what --bound tells, |x - x_N| at T; the rest is an expansion.
--v0: a start in motion; the unit of length is sqrt(x0^2 + m v0^2/k) then, and x_0 in the formulas means it.
--latex prints a document that compiles, --fragment its formulas alone.
"""

import argparse
from collections.abc import Callable
from dataclasses import replace
from typing import Any

import numpy as np

from asymptotics.api.implicit import ImplicitSolution
from asymptotics.api.solution import MAX_DIGITS, MAX_ORDER, UNITS, Solution, solution
from asymptotics.ask.answers import read_points
from asymptotics.ask.forces import read_alpha
from asymptotics.ask.moving import OVERLAY, Given, add_oscillator, is_physical, overlaid, read_oscillator
from asymptotics.bounds.motion import proved_bound
from asymptotics.cli.answer import Answer, add_common, read_digits
from asymptotics.cli.files import Makers, add_files, picture_maker, read_files, write_files
from asymptotics.errors import InputError
from asymptotics.law import Oscillator
from asymptotics.motions.certify import time_of
from asymptotics.numbers.exact import ExactReal, parse_integer, parse_real
from asymptotics.present.inputs import csv_text

Found = Solution | ImplicitSolution


def configure(parser: argparse.ArgumentParser) -> None:
    """Declare the options."""
    add_oscillator(parser, springs=True)
    parser.add_argument("--order", default="3", metavar="N", help=f"1 to {MAX_ORDER} (default 3)")
    parser.add_argument("--time", metavar="T", help="the time in s (or tau) at which A, phi and x are wanted")
    parser.add_argument("--bound", action="store_true", help="with --time: a proved bound of |x - x_N| there")
    parser.add_argument("--units", metavar="U", help=", ".join(UNITS))
    parser.add_argument("--latex", action="store_true", help="print a LaTeX document instead of text")
    parser.add_argument("--fragment", action="store_true", help="print the formulas of that document alone")
    add_files(parser, "A(t) and x(t) from 0 to T", "t, amplitude, phase, x from 0 to T", overlay=OVERLAY)
    add_common(parser, MAX_DIGITS)


def run(options: argparse.Namespace) -> Answer:
    """Run the command."""
    order, digits = parse_integer(options.order, "--order", 1, MAX_ORDER), read_digits(options, MAX_DIGITS)
    # The units in which the numbers came are those in which the formulas are expected.
    units = options.units or ("SI" if is_physical(options) else "epsilon")
    if units not in UNITS:
        raise InputError("--units", f"{units!r:.40} is unknown", ", ".join(UNITS))
    time = None if options.time is None else time_of(parse_real(options.time, "--time"))
    files = read_files(options)
    if files and (time is None or not time > 0):
        raise InputError("--time", "there is no stretch of time to draw", "a time > 0 with --plot or --csv")
    if options.bound and time is None:
        raise InputError("--bound", "a bound belongs to a time", "--bound with --time T")
    given = _given(options)
    if given is None and time is not None:
        raise InputError("--epsilon", "is missing", "a strength with --time")
    # An exponent alone has formulas with a letter for the strength; an oscillator has numbers as well.
    found = solution(_exponent(options) if given is None else given.oscillator, order=order)
    found = found if given is None else replace(found, si=given.si)
    data = found.to_dict() | {"units": units} | _formulas(found, units)
    if given is not None and time is not None:
        data |= _values(found, given, time, digits, options.bound)
        makers: Makers = {
            "--plot": picture_maker(
                options, lambda: overlaid(options, found, given, _again(order, given.si)), until=time
            ),
            "--csv": lambda _: _table(found, given, time, read_points(options)),
        }
        data |= {"files": write_files(files, makers, options)}
    # LaTeX of a high order takes seconds: made only where it is shown.
    if options.json or options.latex or options.fragment:
        data["latex"] = found.latex(standalone=not options.fragment)
    text = data["latex"] if options.latex or options.fragment else _text(found, data, given)
    return Answer(data, text, options.json)


def _again(order: int, si: bool) -> Callable[[Oscillator], Found]:
    """The same for another law."""
    return lambda oscillator: replace(solution(oscillator, order=order), si=si)


def _given(options: argparse.Namespace) -> Given | None:
    """The oscillator; None where one exponent stands without a strength."""
    # One exponent without any number is the symbolic case; a sum without strengths has no explicit solution to show.
    alone = options.alpha is not None and options.law is None and options.spring is None
    if alone and options.epsilon is None and options.damping is None and not is_physical(options):
        return None
    if alone and options.alpha == "symbolic":
        raise InputError("--alpha", "a symbolic exponent has no numbers", "--alpha symbolic alone")
    return read_oscillator(options, "epsilon")


def _exponent(options: argparse.Namespace) -> str | ExactReal:
    return "symbolic" if options.alpha == "symbolic" else read_alpha(options.alpha, "--alpha")


def _formulas(found: Found, units: str) -> dict[str, str]:
    """A and phi in other units, where they are asked for."""
    if units == "epsilon" or isinstance(found, ImplicitSolution):
        return {}
    amplitude, phase = found.in_units(units)
    return {"amplitude_in_units": str(amplitude), "phase_in_units": str(phase)}


def _values(found: Found, given: Given, time: ExactReal, digits: int, bound: bool) -> dict[str, Any]:
    """A, phi and x at the time of the command, in its units; ``bound`` is of the x that is printed, in the same."""
    oscillator = given.oscillator
    point = found.at_time(oscillator, time, digits)
    data = {"time": str(time), **{f"{name}_value": text for name, text in point._asdict().items()}}
    return data | ({"bound": proved_bound(oscillator, point.x, time)} if bound else {})


def _table(found: Found, given: Given, time: ExactReal, points: int) -> str:
    header, unit = ["tau", "amplitude", "phase", "x"], given.oscillator.unit
    if given.si:
        header = ["t [s]", f"amplitude [{unit}]", "phase [rad]", f"x [{unit}]"]
    t = np.linspace(0.0, float(time.ball().mid()), points + 1)
    rows = zip(*found.columns(t))
    return csv_text(header, [[repr(float(c)) for c in row] for row in rows])


def _text(found: Found, data: dict[str, Any], given: Given | None) -> str:
    lines = [str(found)]
    if "amplitude_in_units" in data:
        meaning = {"kappa": "kappa = p_1 epsilon", "SI": "omega_0^2 = k/m; A in m, t in s"}[data["units"]]
        if data["units"] == "SI" and isinstance(found, Solution) and found.start is not None:
            meaning += f"; epsilon = {found.strength_in_SI}"
        lines += [
            f"A       = {data['amplitude_in_units']}",
            f"phi     = {data['phase_in_units']}",
            f"units   {meaning}",
        ]
    if given is not None and "time" in data:
        units = {"time": "s", "amplitude_value": "m", "phase_value": "rad", "x_value": "m", "bound": "m"}
        lines += [f"{n.removesuffix('_value'):10} {data[n]}{given.unit(u)}" for n, u in units.items() if n in data]
        lines += ["bound: proved, |x - x_N| is at most this"] if "bound" in data else []
        lines += data["files"]
    return "\n".join(lines)
