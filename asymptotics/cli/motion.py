"""Displacement and velocity at one time, for m x'' + k x + sum_i b_i x'|x'|^(alpha_i-1) = 0:

  asymptotics motion --alpha 3/2 --mass 3/2 --stiffness 30 --damping 1/10 --x0 1/5 --time 7
  asymptotics motion --alpha 3/2 --mass 3/2 --stiffness 30 --damping 1/10 --x0 1/5 --time 7 --reference --digits 40
  asymptotics motion --alpha 2 --damping 0.1 --spring 3:0.5 --x0 1 --time 7
  asymptotics motion --alpha 2 --epsilon 1/10 --time 7
  asymptotics motion --law 0:0.01 --law 2:0.3 --x0 1/5 --v0 -1 --time 10 --order 2 --plot motion.svg --csv motion.csv

The start is x(0) = x0, x'(0) = v0.  Units are SI when a mass, a stiffness, a start or --damping is given; otherwise
m = k = x0 = 1 and there are none.  --order N (default 3): p_k and Omega_k for k <= N and the waveform through
delta^(N-1); order 1 is x0 A(t) cos(omega_0 t).  `phase` is psi - omega_0 t, and `error` an estimate from the orders
N + 1 and N + 2; with --bound, `bound` is a proved bound of |x - x_N| at that time, rounded up, and `uniform_bound` one
for every t >= 0 (exponents below 1: up to that time), for powers of the velocity in the first gauge.  --reference:
every digit proved, for any powers of the velocity, whole powers of the place in springs and losses, the pendulum, from
any start (springs with |x'|^Q are for expand); closed forms where there are any, and for alpha = 1 a note whether
the motion is under-, critically or overdamped.

--best-order D says for one law where to stop at the local strength delta = D, and what is left, in half-swings.

--spring P:C adds C x|x|^(P-1) (C in N/m^P), pendulum has K sin x in place of K x (rad).
"""

import argparse
from typing import Any

from asymptotics.api.motions import Motion, Reference
from asymptotics.ask.moving import OVERLAY, Given, add_oscillator, overlaid, read_oscillator
from asymptotics.bounds.motion import proved_bound
from asymptotics.bounds.uniform import UniformBound, uniform_bound
from asymptotics.cli.answer import Answer, add_common, read_digits, read_max_seconds, shortened
from asymptotics.cli.files import Makers, add_files, picture_maker, read_files, read_points, write_files
from asymptotics.cli.motion_files import csv_of, reference_is_near
from asymptotics.cut_short import changed
from asymptotics.errors import InputError, LimitError, UndecidedError
from asymptotics.expansions.divergence.truncation import BestOrder
from asymptotics.expansions.equations.build import expand
from asymptotics.gauges import GAUGES, TURNING_POINT
from asymptotics.law import Oscillator
from asymptotics.motions.asymptotic import MAX_DIGITS as MAX_ASYMPTOTIC_DIGITS
from asymptotics.motions.asymptotic import MAX_ORDER, AsymptoticMotion
from asymptotics.motions.certify import time_of
from asymptotics.motions.reference import MAX_DIGITS, reference_motion
from asymptotics.motions.result import MotionPoint, MotionSamples
from asymptotics.numbers.exact import ExactReal, parse_integer, parse_real


def configure(parser: argparse.ArgumentParser) -> None:
    """Declare the options."""
    add_oscillator(parser, springs=True)
    parser.add_argument("--time", required=True, metavar="T", help="the time in s (or tau), >= 0")
    parser.add_argument("--order", metavar="N", help=f"order of the expansion, 1 to {MAX_ORDER} (default 3)")
    parser.add_argument(
        "--bound", action="store_true", help="with an order: a proved bound of the error of x at that time"
    )
    text = "for one law at the local strength D: the best order and the smallest error, in half-swings"
    parser.add_argument("--best-order", metavar="D", help=text)
    parser.add_argument("--reference", action="store_true", help="exact or high-precision motion instead")
    parser.add_argument("--gauge", metavar="G", help=f"one of {', '.join(GAUGES)} (default: the first)")
    parser.add_argument("--static", metavar="F", help="--reference, alpha = 0: static friction force in N, >= b")
    add_files(
        parser,
        "waveform, envelope and error curve from 0 to T",
        "t, x, v, amplitude, phase from 0 to T",
        overlay=OVERLAY,
    )
    add_common(parser, MAX_DIGITS, "30 with --reference, else what the error leaves")


def run(options: argparse.Namespace) -> Answer:
    """Run the command."""
    resting = _rests(options)
    # At rest at the centre there is no unit of length, and no oscillator can be made: another start stands in, so that
    # every other option is still read and refused as usual.
    given = read_oscillator(argparse.Namespace(**{**vars(options), **({"x0": "1"} if resting else {})}))
    oscillator, time, digits = (
        given.oscillator,
        time_of(parse_real(options.time, "--time")),
        read_digits(options, MAX_DIGITS),
    )
    (order, gauge), seconds = _order_and_gauge(options, digits), read_max_seconds(options)
    files = read_files(options)
    if resting:
        if files:
            raise InputError("--x0", "with x0 = 0 and v0 = 0 nothing moves: nothing to draw", "a start that moves")
        if options.static is not None:
            reference_motion(oscillator, 0, static=options.static)
        best = _best_order(oscillator, options, seconds)
        point = _rest(options.reference, order, gauge)
        return _answer(point, options, given, [], "0" if options.bound else None, best=best)
    if files and not time > 0:
        raise InputError("--time", "0 leaves nothing to draw or to tabulate", "a time > 0 with --plot or --csv")
    if options.reference:
        point = reference_motion(oscillator, time, digits, static=options.static, max_seconds=seconds)
    else:
        point = AsymptoticMotion.of(oscillator, order, gauge).at(time, digits)
        # Without --digits the expansion shows what its estimate of the error leaves, as ``Motion.at`` does.
        if options.digits is None:
            point = point.rounded_to_error()
    # Of the x that is printed, rounded as it is: the two stand side by side.
    proved = proved_bound(oscillator, point.x, time, max_seconds=seconds) if options.bound else None
    always = _uniform(oscillator, point, time) if options.bound else None
    best = _best_order(oscillator, options, seconds)
    makers = _makers(given, time, options, order, gauge)

    def kept(found: object) -> Answer | None:
        """The point, and the rows that were done when the time was over; None of a picture."""
        if not isinstance(found, MotionSamples):
            return None
        # Half a picture is none; half a table has right rows, and says where it ends.
        done = {name: file for name, file in files.items() if name == "--csv"}
        written = write_files(done, {"--csv": lambda _: found.to_csv()}, options)
        whole, rows = _answer(point, options, given, written, proved, always, best), len(found.t)
        name = "t" if given.si else "tau"
        missing = f"{name} > {float(found.t[-1])!r}{given.unit('s')} in {written[0]}"
        return shortened(whole, rows, missing)

    with changed(kept):
        written = write_files(files, makers, options)
    return _answer(point, options, given, written, proved, always, best)


def cut_short(_: argparse.Namespace, found: object) -> Answer | None:
    """What ``run`` has made of the rows that were done; None where the value itself was cut short."""
    return found if isinstance(found, Answer) else None


def _best_order(oscillator: Oscillator, options: argparse.Namespace, seconds: float) -> BestOrder | None:
    """Where the expansion of this law is best stopped, if that is asked for."""
    if options.best_order is None:
        return None
    return expand(oscillator, order=1).best_order(parse_real(options.best_order, "--best-order"), max_seconds=seconds)


def _uniform(oscillator: Oscillator, point: MotionPoint, time: ExactReal) -> UniformBound | None:
    """The bound for all times, or, for an exponent below 1, up to the time that is asked for, if there is one."""
    if point.gauge != TURNING_POINT or not oscillator.law.is_pure or point.order is None:
        return None
    # Below 1 the local strength grows and leaves the range of the theorem: a bound up to the time that is asked for may
    # exist where none for all times does.
    growing = any(term.velocity < 1 for term in oscillator.law.terms)
    try:
        return uniform_bound(oscillator, point.order, until=time if growing and time > 0 else None)
    except (LimitError, UndecidedError):  # x and its bound at this time are there all the same
        return None


def _rests(options: argparse.Namespace) -> bool:
    """x0 = 0 and v0 = 0: an answer, though no oscillator that moves."""
    starts = {name: getattr(options, name) for name in ("x0", "v0")}
    zero = {name for name, text in starts.items() if text is not None and parse_real(text, f"--{name}").is_zero}
    return "x0" in zero and ("v0" in zero or options.v0 is None)


def _order_and_gauge(options: argparse.Namespace, digits: int) -> tuple[int, str]:
    gauge = TURNING_POINT if options.gauge is None else options.gauge
    if gauge not in GAUGES:
        raise InputError("--gauge", f"no gauge {gauge!r}", ", ".join(GAUGES))
    if options.reference and (options.order is not None or options.gauge is not None):
        raise InputError("--reference", "it has neither order nor gauge", "--reference alone, or --order and --gauge")
    if options.reference and options.bound:
        raise InputError("--bound", "the reference motion is certified by itself", "--bound with --order N")
    if options.reference and options.best_order is not None:
        raise InputError("--best-order", "the reference motion has no order", "--best-order with --order N")
    if options.static is not None and not options.reference:
        raise InputError("--static", "the expansion knows no static friction", "--static with --reference")
    if not options.reference and digits > MAX_ASYMPTOTIC_DIGITS:
        raise InputError("--digits", f"{digits} is too large", f"at most {MAX_ASYMPTOTIC_DIGITS} for an expansion")
    return parse_integer("3" if options.order is None else options.order, "--order", 1, MAX_ORDER), gauge


def _rest(reference: bool, order: int, gauge: str) -> MotionPoint:
    """x0 = 0 and v0 = 0: nothing moves, whatever the law."""
    method = "rest: x0 = 0 and v0 = 0"
    if reference:
        return MotionPoint("0", "0", None, None, None, None, method, "0", True)
    return MotionPoint("0", "0", "0", None, order, gauge, method, "0", True)


def _makers(given: Given, time: ExactReal, options: argparse.Namespace, order: int, gauge: str) -> Makers:
    shown, points = None if options.reference else order, read_points(options)

    def again(oscillator: Oscillator) -> Motion | Reference:
        """The same for another law."""
        if options.reference:
            return Reference(oscillator, options.static, si=given.si)
        return Motion(oscillator, order, gauge, si=given.si)

    # Errors and velocities have axes below, for one law: several would lie over one another.
    alone = options.overlay is None
    more = "velocity" if options.reference else "errors"
    shows = alone and (options.reference or reference_is_near(given.oscillator, time))
    first = again(given.oscillator)
    style = {"until": time, **({more: True} if shows else {})}
    picture = picture_maker(options, lambda: overlaid(options, first, given, again), **style)
    return {"--plot": picture, "--csv": lambda _: csv_of(given, time, shown, gauge, options.static, points)}


def _answer(
    point: MotionPoint, options: argparse.Namespace, given: Given, written: list[str], proved: str | None = None,
    always: UniformBound | None = None, best: BestOrder | None = None,
) -> Answer:  # fmt: skip
    data: dict[str, Any] = {**point.to_dict(), "units": "SI" if given.si else None, "files": written}
    if proved is not None:
        data |= {"bound": proved, "uniform_bound": None if always is None else always.to_dict()}
    units = {"x": "m", "v": "m/s", "amplitude": "m", "phase": "rad", "error": "m"}
    lines = [f"{name:9}  {data[name]}{given.unit(unit)}" for name, unit in units.items() if data[name] is not None]
    lines += [f"bound      {proved}{given.unit('m')} (proved: |x - x_N| is at most this)"] if proved is not None else []
    lines += [f"proved for x_N before rounding: {always}"] if always is not None else []
    if best is not None:
        data["best_order"] = best.to_dict()
        lines.append(str(best))
    order = "" if point.order is None or options.reference else f", order {point.order}, gauge {point.gauge}"
    certified = f"certified: {str(point.certified).lower()}"
    lines += [f"{certified} ({point.method}{order})", *point.notes, *written]
    return Answer(data, "\n".join(lines), options.json)
