"""The first-order envelope A(t) and phase phi(t): the formula where one is known, certified numbers, and the curve.

  asymptotics envelope --alpha 3/2 --epsilon 1/10
  asymptotics envelope --alpha 3/2 --mass 3/2 --stiffness 30 --damping 1/10 --x0 1/5 --time 7 --digits 20
  asymptotics envelope --law 2:1/20 --spring pendulum --x0 3 --time 40
  asymptotics envelope --law 0:0.01 --law 2:0.3 --time 40 --plot envelope.svg --csv envelope.csv

dA/dtau = -sum_i kappa_i A^alpha_i with kappa_i = M_(alpha_i+1) epsilon_i, tau = omega_0 t.  Every digit is proved
for this averaged law; how far it is from the motion, `motion` tells.  --squaring averages by the squaring trick.
With --spring 3:C or --spring pendulum the law is exact in the spring, for any amplitude inside the well (phase against
omega_0 t), and the period at the start, without loss, is told too.
Units are SI when --damping, --mass or --stiffness is given; otherwise there are none, and x0, v0 are those of X.
"""

import argparse
from typing import Any

import numpy as np
import sympy

from asymptotics.api.large import SpringEnvelope
from asymptotics.api.slow import MAX_DIGITS, Envelope, envelope
from asymptotics.api.slow_series import MAX_ORDER, EnvelopeSeries
from asymptotics.api.slowness import SlowPart
from asymptotics.cli.answer import Answer, add_digits, add_json, add_max_seconds, read_digits
from asymptotics.cli.files import Makers, add_files, read_files, read_points, write_files
from asymptotics.cli.quantities import Given, add_oscillator, read_oscillator
from asymptotics.envelopes.symbolic import MEAN, SQUARING
from asymptotics.errors import InputError
from asymptotics.motions.certify import time_of
from asymptotics.numbers.exact import ExactReal, parse_integer, parse_real
from asymptotics.present.figures import render

Curve = Envelope | SpringEnvelope


def configure(parser: argparse.ArgumentParser) -> None:
    """Declare the options."""
    add_oscillator(parser, springs=True)
    parser.add_argument("--time", metavar="T", help="the time in s (or tau) at which A and phi are wanted")
    parser.add_argument("--slow", metavar="ETA", help="tell where |dA/dt| <= ETA omega_0 A, in doubles")
    text = "one law: tau, phi and delta as series through order N, formal (see the docs on the command line)"
    parser.add_argument("--order", metavar="N", help=text)
    parser.add_argument("--squaring", action="store_true", help="average by the squaring trick of Lelas 2024")
    parser.add_argument("--latex", action="store_true", help="print the formula as LaTeX")
    add_files(parser, "A(t) and x = A cos(omega_0 t + phi) from 0 to T", "t, amplitude, phase from 0 to T")
    add_digits(parser, MAX_DIGITS)
    add_max_seconds(parser)
    add_json(parser)


def run(options: argparse.Namespace) -> Answer:
    """Run the command."""
    given, digits = read_oscillator(options), read_digits(options, MAX_DIGITS)
    time = None if options.time is None else time_of(parse_real(options.time, "--time"))
    files = read_files(options)
    if files and (time is None or not time > 0):
        raise InputError("--time", "there is no stretch of time to draw", "a time > 0 with --plot or --csv")
    found = envelope(given.oscillator, averaging=SQUARING if options.squaring else MEAN)
    if options.latex and found.formula is None:
        raise InputError("--latex", "no elementary form is known for this law", "the command without --latex")
    data = _data(found, time, digits)
    slow = None if options.slow is None else _slow(found, options.slow)
    series = None if options.order is None else _series(found, options.order, digits)
    data |= {"slow": None if slow is None else slow.to_dict(), "series": None if series is None else series.to_dict()}
    makers: Makers = {
        "--plot": lambda kind: _picture(found, given, time, kind),
        "--csv": lambda _: _table(found, given, time, options),
    }
    data |= {"units": "SI" if given.si else None, "files": write_files(files, makers), "notes": list(found.notes)}
    text = str(data["latex"]) if options.latex else _text(data, given)
    if slow is not None:
        text += "\n" + slow.told(given.unit("s" if slow.quantity == "time" else "m"))
    if series is not None:
        text += f"\n{series}"
    return Answer(data, text, options.json)


def _series(found: Curve, order: str, digits: int) -> EnvelopeSeries:
    """--order, for the linear spring."""
    number = parse_integer(order, "--order", 1, MAX_ORDER)
    if isinstance(found, SpringEnvelope):
        raise InputError("--order", "it is not known beside a spring", "one law alone")
    if found.averaging == SQUARING:
        raise InputError("--order", "the squaring trick has no higher orders", "the command without --squaring")
    return found.series(number, digits=digits)


def _slow(found: Curve, eta: str) -> SlowPart:
    """--slow, for the linear spring."""
    number = parse_real(eta, "--slow")
    if isinstance(found, SpringEnvelope):
        raise InputError("--slow", "it is not known beside a spring", "a law alone")
    return found.slow(number)


def _data(found: Curve, time: ExactReal | None, digits: int) -> dict[str, Any]:
    formula = found.formula
    return {
        "averaging": found.averaging,
        "family": None if formula is None else formula.family,
        "formula": None if formula is None else str(formula.expression),
        "latex": None if formula is None else rf"\frac{{A}}{{A(0)}} = {sympy.latex(formula.expression)}",
        "time_formula": None if found.time_formula is None else str(found.time_formula),
        **{name: _formula(found, name) for name in _ENDS},
        "kappas": list(found.kappas(digits=digits)),
        "period": _period(found, digits),
        "extinction": found.extinction_time(digits=digits),
        "time": None if time is None else str(time),
        "amplitude": None if time is None else found.amplitude(time, digits=digits),
        "phase": None if time is None or found.averaging == SQUARING else _phase(found, time, digits),
        "certified": True,
    }


_ENDS = {  # what is told beside A and tau(A)
    "phase_formula": "phi = {}",
    "total_lag": "phi -> -{} at long times",
    "long_time_formula": "A/A(0) -> {} at long times",
    "extinction_formula": "A = 0 from tau = {} on",
}


def _formula(found: Curve, name: str) -> str | None:
    """A formula of the linear spring as text."""
    expression = getattr(found, name, None)
    return None if expression is None else str(expression)


def _period(found: Curve, digits: int) -> str | None:
    """The period at the start without loss, where the spring makes it depend on the amplitude."""
    return found.period(abs(found.oscillator.x0), digits=digits) if isinstance(found, SpringEnvelope) else None


def _phase(found: Curve, time: ExactReal, digits: int) -> str | None:
    """phi, or None where the averaged amplitude is extinct: there is no phase without an amplitude."""
    return None if found.amplitude(time, digits=2) == "0" else found.phase(time, digits=digits)


def _text(data: dict[str, Any], given: Given) -> str:
    head = "A/A(0) has no elementary form" if data["formula"] is None else f"A/A(0) = {data['formula']}"
    if data["period"] is not None:
        head = "A/A(0) by 2F1, exact in the spring"
    lines = [f"{head}, tau = omega_0 t" if given.si else head]
    lines += [] if data["time_formula"] is None else [f"tau(A) = {data['time_formula']}, A in units of A(0)"]
    lines += [told.format(data[name]) for name, told in _ENDS.items() if data[name] is not None]
    lines += [f"kappa_{i}    {kappa}" for i, kappa in enumerate(data["kappas"], start=1)]
    units = {"period": "s", "extinction": "s", "time": "s", "amplitude": "m", "phase": "rad"}
    lines += [f"{name:10} {data[name]}{given.unit(unit)}" for name, unit in units.items() if data[name] is not None]
    return "\n".join([*lines, "certified: true (for the averaged law)", *data["notes"], *data["files"]])


def _table(found: Curve, given: Given, time: ExactReal | None, options: argparse.Namespace) -> str:
    t, A, phi = _columns(found, time, read_points(options))
    head = "t [s],amplitude [m],phase [rad]" if given.si else "tau,amplitude,phase"
    return "\n".join([head, *(",".join(repr(float(c)) for c in row) for row in zip(t, A, phi))]) + "\n"


def _columns(found: Curve, time: ExactReal | None, points: int) -> tuple[Any, Any, Any]:
    """Times, amplitudes and phases in doubles; NaN for a phase that is not known."""
    t = np.linspace(0.0, float((time or ExactReal(0)).ball().mid()), points + 1)
    return t, found.amplitudes(t), found.phases(t)


def _picture(found: Curve, given: Given, time: ExactReal | None, kind: str) -> bytes:
    t, A, phi = _columns(found, time, 2000)
    psi = t * float(given.oscillator.omega_0().mid()) + np.nan_to_num(phi)
    bent = isinstance(found, SpringEnvelope)
    x, label = (found.sample(t).x, "x") if bent else (A * np.cos(psi), r"$A\,\cos(\omega_0 t + \varphi)$")

    def draw(axes: Any) -> None:
        axes.plot(t, x, linewidth=0.9, label=label)
        for sign in (1, -1):
            axes.plot(t, sign * A, color="#c2410c", label="envelope" if sign > 0 else None)
        axes.set_xlabel(given.time_label)
        axes.set_ylabel(f"x{given.label('m')}")
        axes.legend(loc="lower right", bbox_to_anchor=(1.0, 1.0), ncols=2)

    return render(draw, kind=kind)
