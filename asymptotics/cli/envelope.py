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
from dataclasses import replace
from typing import Any

import mpmath
import numpy as np
import sympy
from numpy.typing import NDArray

from asymptotics.api.large import SpringEnvelope
from asymptotics.api.slow import MAX_DIGITS, Envelope, acting_term, envelope
from asymptotics.api.slow_series import MAX_ORDER, EnvelopeSeries
from asymptotics.api.slowness import SlowPart
from asymptotics.ask.answers import read_points
from asymptotics.ask.moving import OVERLAY, Given, add_oscillator, overlaid, read_oscillator
from asymptotics.cli.answer import Answer, add_common, read_digits
from asymptotics.cli.files import Makers, add_files, picture_maker, read_files, write_files
from asymptotics.envelopes.slow_time import epsilon
from asymptotics.envelopes.symbolic import MEAN, SQUARING, tau
from asymptotics.errors import InputError
from asymptotics.law import Oscillator
from asymptotics.motions.certify import time_of
from asymptotics.numbers.bridge import from_sympy
from asymptotics.numbers.context import ctx
from asymptotics.numbers.exact import ExactReal, parse_integer, parse_real
from asymptotics.present.inputs import csv_text

Curve = Envelope | SpringEnvelope


def configure(parser: argparse.ArgumentParser) -> None:
    """Declare the options."""
    add_oscillator(parser, springs=True)
    parser.add_argument("--time", metavar="T", help="the time in s (or tau) at which A and phi are wanted")
    parser.add_argument("--slow", metavar="ETA", help="tell where |dA/dt| <= ETA omega_0 A, in doubles")
    text = "one law from rest: A and phi of order N, explicit in the slow time, and their series in delta; formal"
    parser.add_argument("--order", metavar="N", help=text)
    parser.add_argument("--squaring", action="store_true", help="average by the squaring trick of Lelas 2024")
    parser.add_argument("--latex", action="store_true", help="print the formula as LaTeX")
    add_files(
        parser, "A(t) and x = A cos(omega_0 t + phi) from 0 to T", "t, amplitude, phase from 0 to T", overlay=OVERLAY
    )
    add_common(parser, MAX_DIGITS)


def run(options: argparse.Namespace) -> Answer:
    """Run the command."""
    given, digits = read_oscillator(options), read_digits(options, MAX_DIGITS)
    files = read_files(options)
    time = _time(options)
    if files and (time is None or not time > 0):
        raise InputError("--time", "there is no stretch of time to draw", "a time > 0 with --plot or --csv")
    found = _curve(options, given)
    # Refused before the numbers are computed, as all that can be known beforehand is.
    if options.latex and found.formula is None and options.order is None:
        raise InputError("--latex", "no elementary form is known for this law", "the command without --latex")
    data = _data(found, time, digits)
    slow = None if options.slow is None else _slow(found, options.slow)
    series = None if options.order is None else _series(found, options.order, digits)
    if series is not None:
        data |= _of_order(series, given, time, digits)
    data |= {"slow": None if slow is None else slow.to_dict(), "series": None if series is None else series.to_dict()}
    more: dict[str, Any] = {} if series is None else {"order": series.order}

    def again(oscillator: Oscillator) -> Curve:
        """The same for another law."""
        return replace(envelope(oscillator, averaging=found.averaging), si=given.si)

    makers: Makers = {
        "--plot": picture_maker(options, lambda: overlaid(options, found, given, again), until=time, **more),
        "--csv": lambda _: _table(found, time, options, series),
    }
    data |= {
        "units": "SI" if given.si else None,
        "files": write_files(files, makers, options, "envelope"),
        "notes": list(found.notes),
    }
    text = str(data["latex"]) if options.latex else _text(data, given, series)
    if slow is not None and not options.latex:
        text += "\n" + slow.told(given.unit("s" if slow.quantity == "time" else "m"))
    if series is not None and not options.latex:
        text += f"\n{series}"
    return Answer(data, text, options.json)


def _time(options: argparse.Namespace) -> ExactReal | None:
    return None if options.time is None else time_of(parse_real(options.time, "--time"))


def _curve(options: argparse.Namespace, given: Given) -> Curve:
    return replace(envelope(given.oscillator, averaging=SQUARING if options.squaring else MEAN), si=given.si)


def asked(options: argparse.Namespace) -> tuple[Curve, ExactReal]:
    """The curve of these options, and the end of its table; InputError without a time > 0."""
    found, time = _curve(options, read_oscillator(options)), _time(options)
    if time is None or not time > 0:
        raise InputError("--time", "there is no stretch of time", "a time > 0")
    return found, time


def _series(found: Curve, order: str, digits: int) -> EnvelopeSeries:
    """--order, for the linear spring."""
    number = parse_integer(order, "--order", 1, MAX_ORDER)
    if isinstance(found, SpringEnvelope):
        raise InputError("--order", "it is not known beside a spring", "one law alone")
    if found.averaging == SQUARING:
        raise InputError("--order", "the squaring trick has no higher orders", "the command without --squaring")
    if not found.oscillator.v0.is_zero:
        raise InputError("--order", "it starts at rest", "the command without --v0; other starts: motion --order N")
    return found.series(number, digits=digits)


def _of_order(series: EnvelopeSeries, given: Given, time: ExactReal | None, digits: int) -> dict[str, Any]:
    """The formulas of that order, and A and phi at the time, in the place of the first order's."""
    oscillator, (amplitude, phase) = given.oscillator, series.explicit
    data: dict[str, Any] = {
        "order": series.order,
        "family": "power",
        "formula": str(amplitude),
        "latex": rf"\frac{{A}}{{A(0)}} = {sympy.latex(amplitude)},\quad \phi = {sympy.latex(phase)}",
        "time_formula": None,
        **dict.fromkeys(_ENDS),
        "phase_formula": str(phase),
        "extinction": None,
        "certified": False,
    }
    if time is not None:
        # Four bits a digit are more than log2(10), and 128 bits are thirty digits more with room: the decimals handed
        # to SymPy are right to their last digit but the formula is truncated, so that nothing here is certified.
        with ctx.workprec(4 * digits + 128):
            strength = acting_term(oscillator).strength.ball()
            values = {tau: (time.ball() * oscillator.omega_0()).mid(), epsilon: strength.mid()}
            numbers = {s: sympy.Float(v.str(digits + 30, radius=False), digits + 30) for s, v in values.items()}
            length = sympy.Float(oscillator.length().mid().str(digits + 30, radius=False), digits + 30)
        _require_before_extinction(series, numbers)
        for name, form in (("amplitude", length * amplitude.subs(numbers)), ("phase", phase.subs(numbers))):
            # Ten digits more than are shown; SymPy raises its own precision where terms cancel.
            value = sympy.N(form, digits + 10)
            data[name] = mpmath.nstr(mpmath.mpf(value), digits, strip_zeros=False) if value else "0"
    return data


def _require_before_extinction(series: EnvelopeSeries, numbers: dict[sympy.Symbol, sympy.Float]) -> None:
    # Beyond the extinction of the truncated series 1 + (alpha-1) p_1 epsilon tau is negative, and its power complex.
    if series.alpha < 1:
        end = series.extinction_time(ExactReal(from_sympy(sympy.Rational(numbers[epsilon]))))
        if not float(numbers[tau]) < end:
            raise InputError("--time", f"the averaged amplitude is extinct from tau = {end:.6g} on", "an earlier time")


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
    # "0" is exact here: from the extinction time on.  Two digits tell it.
    return None if found.amplitude(time, digits=2) == "0" else found.phase(time, digits=digits)


def _text(data: dict[str, Any], given: Given, series: EnvelopeSeries | None) -> str:
    head = "A/A(0) has no elementary form" if data["formula"] is None else f"A/A(0) = {data['formula']}"
    if data["period"] is not None:
        head = "A/A(0) by 2F1, exact in the spring"
    lines = [f"{head}, tau = omega_0 t" if given.si else head]
    lines += [] if data["time_formula"] is None else [f"tau(A) = {data['time_formula']}, A in units of A(0)"]
    lines += [told.format(data[name]) for name, told in _ENDS.items() if data[name] is not None]
    lines += [f"kappa_{i}    {kappa}" for i, kappa in enumerate(data["kappas"], start=1)]
    units = {"period": "s", "extinction": "s", "time": "s", "amplitude": "m", "phase": "rad"}
    lines += [f"{name:10} {data[name]}{given.unit(unit)}" for name, unit in units.items() if data[name] is not None]
    claim = "certified: true (for the averaged law)"
    if series is not None:
        lines.append(f"epsilon    {acting_term(given.oscillator).strength}")
        claim = f"certified: false (order {series.order}, explicit in the slow time, error O(epsilon**{series.order}))"
    return "\n".join([*lines, claim, *data["notes"], *data["files"]])


def _table(found: Curve, time: ExactReal | None, options: argparse.Namespace, series: EnvelopeSeries | None) -> str:
    times = table_times(time or ExactReal(0), options)
    t, A, phi = found.columns(times, order=None if series is None else series.order)
    return csv_text(table_head(found), ([repr(float(c)) for c in row] for row in zip(t, A, phi)))


def table_head(found: Curve) -> tuple[str, str, str]:
    """The names of the columns of --csv."""
    if not found.si:
        return ("tau", "amplitude", "phase")
    return ("t [s]", f"amplitude [{found.oscillator.unit}]", "phase [rad]")


def table_times(time: ExactReal, options: argparse.Namespace) -> NDArray[np.float64]:
    """The times of its rows."""
    # In one place: ``compare`` makes the same doubles again to find the rows of an exported envelope.
    return np.linspace(0.0, float(time.ball().mid()), read_points(options) + 1)


def certified_at(found: Curve, time: str, digits: int) -> tuple[str, str]:
    """A and phi of one row, certified for the averaged law; nan where the table has no phase: extinct, or squaring."""
    amplitude = found.amplitude(time, digits=digits)
    phase = None if found.averaging == SQUARING or amplitude == "0" else found.phase(time, digits=digits)
    return amplitude, "nan" if phase is None else phase
