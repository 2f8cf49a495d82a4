"""Turning points and times, to any number of certified digits."""

from dataclasses import dataclass
from functools import partial
from typing import Annotated, Any, cast

from asymptotics.ask.answers import Offers, Request
from asymptotics.ask.kinds import FLAG, SECONDS, TEXT, digits, whole
from asymptotics.ask.laws import MOVES
from asymptotics.ask.pairs import excludes
from asymptotics.ask.question import question
from asymptotics.curves.turning_points import (
    MotionTurningPoints,
    dimensionless,
    of_motion,
    started_in_motion,
    turning_points_in_units,
    with_notes,
    without_units,
)
from asymptotics.errors import LimitError
from asymptotics.law import Law, LawLike, Oscillator
from asymptotics.law_given import Given
from asymptotics.numbers.policy import Number
from asymptotics.present.inputs import csv_text
from asymptotics.running.cut_short import changed
from asymptotics.turning import table
from asymptotics.turning.choose import offers
from asymptotics.turning.result import TurningPoints
from asymptotics.turning.table import MAX_COUNT, MAX_DIGITS, MAX_START


@dataclass(frozen=True)
class Routes:
    """All routes for a request: name, seconds that it would take (or no), what it serves, and by what."""

    rows: tuple[tuple[str, str, str, str], ...]
    HEAD = ("name", "seconds", "serves", "by")

    def to_dict(self) -> dict[str, Any]:
        """JSON-ready."""
        return {"routes": [dict(zip(self.HEAD, row)) for row in self.rows]}

    def __str__(self) -> str:
        return _columns([("route", *self.HEAD[1:]), *self.rows], str.ljust)


def _columns(rows: list[tuple[str, ...]], align: Any) -> str:
    widths = [max(map(len, column)) for column in zip(*rows)]
    return "\n".join("  ".join(align(cell, width) for cell, width in zip(row, widths)).rstrip() for row in rows)


def _text(found: Any, request: Request) -> str:
    if isinstance(found, Routes) or found.oscillator is not None:
        return str(found)
    rows = [(str(p.n), p.x) + (() if p.time is None else (p.time,)) for p in found.points]
    if found.unit and rows:
        rows.insert(0, tuple(found.named_columns()[0][: len(rows[0])]))
    lines = [_columns(rows, str.rjust)] if rows else []
    lines += [line for line in (found.first_text, found.end_text) if line]
    return "\n".join([*lines, f"certified: {str(found.certified).lower()} ({found.method})"])


def _data(found: Any, request: Request) -> dict[str, Any]:
    data: dict[str, Any] = found.to_dict()
    if isinstance(found, Routes):
        return data
    moving = cast("Given", request["law"])
    return data | {"units": moving.frame.units, "x_unit": found.x_unit}


def _csv(found: TurningPoints, request: Request) -> str:
    return csv_text(*found.named_columns())


def _missing(found: TurningPoints, request: Request) -> tuple[int, str]:
    first, last = found.points[-1].n + 1, request["start"] + request["count"] - 1
    return len(found.points), f"n = {first} ... {last}"


def _certificate(found: Any, request: Request) -> Any:
    return found.certificate()


@question(
    Offers(
        latex="print the table as LaTeX",
        picture="|x_n| against n",
        table="n, x and the times",
        from_rest=True,
        always_files=True,
        own_latex=True,
        data=_data,
        text=_text,
        as_latex=lambda found, _: found._formula(),
        formula=lambda *_: "",  # its table has it all
        as_csv=_csv,
        certificate=_certificate,
        missing=_missing,
        lacks={"gauge": "what is observed is the same in every gauge", "points": "`--count` says how many"},
    ),
    pairs=(excludes("certificate", "route=help", "a list of routes has no digits", "a certificate of turning points"),),
    swept=True,
    example="--alpha 2 --epsilon 1/10 --count 2 --digits 5",
    rests="balls: `turning-point-majorant`, `taylor-residual`, `motions-never-part`; springs:"
    " `wells-majorant`, `wells-distance`",
)
def turning_points(
    law: Annotated[LawLike | Oscillator, MOVES],
    count: Annotated[int, whole(1, MAX_COUNT).called(needed=True)] = 10,
    *,
    digits: Annotated[int, digits(MAX_DIGITS)] = 30,
    start: Annotated[int, whole(0, MAX_START)] = 0,
    times: Annotated[bool, FLAG] = False,
    route: Annotated[str | None, TEXT] = None,
    max_seconds: Annotated[Number, SECONDS] = 60,
) -> MotionTurningPoints:
    """Turning points x_n (with their sign) and their times, for any alpha >= 0, and sums of laws.

      asymptotics turning-points --alpha 2 --epsilon 1 --count 6 --digits 60 --times
      asymptotics turning-points --alpha 2 --epsilon 1/3 --count 1 --start 1000000000 --digits 50
      asymptotics turning-points --law 0:1/20 --law 3/2:1/10 --count 10
      asymptotics turning-points --law 0:1/50 --law 2:1/10 --count 30 --digits 300 --route help
      asymptotics turning-points --law 2:1/10 --spring pendulum --x0 2.967 --count 10
      asymptotics turning-points --alpha 3/2 --mass 3/2 --stiffness 30 --damping 1/10 --x0 1/5 --count 10 --times

    X'' + X + sum_i epsilon_i X'|X'|^(alpha_i-1) = 0 starts from rest at X(0) = 1, which is turning point 0: x is in
    units of x0, and tau = omega_0 t.  With --damping, --mass or --stiffness (an Oscillator) everything is in SI, x in
    m, t in s; without them --x0 and --v0 start the same equation elsewhere.  All digits are proved, for any powers of
    the velocity, whole powers of the place in springs and losses, and the pendulum.  `ended` tells the last turning
    point there is, and why: sticks, creeps, overdamped, rotates or escapes.

    With --x0 the motion starts at X(0) = x0 (beside a spring: inside the well) and x is not divided by it: it is in the
    units in which the strengths are given, rad for a pendulum, and point 0 is x0 itself.  A header above the points
    says so, and `x_unit` in JSON: "x0", "m", "rad" or "strengths".  With --v0 (an oscillator with v0 != 0) n = 0 is
    the first turning point after the start, where the time counts from; x is in what x0 is in, and without units
    amplitude and time of that point are told below.

    The cheapest route is taken; --route NAME takes another one, and --route help lists them with what each would cost.

    Parameters
    ----------
    law
        a law or mapping exponent -> strength (epsilon) from rest, or an oscillator
    count
        how many points
    digits
        significant digits, correctly rounded
    start
        the first point
    times
        the times as well
    route
        the route to take instead of the cheapest; help lists them
    max_seconds
        the time the request may take, in seconds

    Raises
    ------
    InputError
        for anti-damping, values out of range and a route that does not serve
    LimitError
        with the estimate; ``asymptotics.running.cut_short.done(error)`` hands over the points that were done
    UndecidedError
        where balls cannot tell how it goes on

    Examples
    --------
    >>> turning_points({2: 1}, 2, digits=12).points[1].x                    # a law alone: units of x0
    '-0.410719686061'
    >>> found = turning_points(Oscillator({2: "1/10"}, mass="3/2", stiffness=30, x0="1/5"), 2, digits=12, times=True)
    >>> found.points[1].x, found.points[1].t, found.unit
    ('-0.196506443629', '0.702501924734', 'm')
    """
    moving = cast("Given", law)
    if route == "help":
        return cast("MotionTurningPoints", _routes(moving, count, digits, start, times))
    try:
        return _points(moving, count, digits=digits, start=start, times=times, route=route)
    except LimitError as error:
        if error.argument == "time":  # the integrator speaks of its own argument
            raise LimitError("epsilon", error.reason, "weaker damping") from error
        raise


def _points(moving: Given, count: int, **rest: Any) -> MotionTurningPoints:
    oscillator = moving.oscillator

    as_motion = partial(of_motion, oscillator)
    with changed(as_motion):
        if moving.frame:
            return as_motion(turning_points_in_units(oscillator, count, **rest))
        if not oscillator.v0.is_zero:
            return as_motion(started_in_motion(oscillator, count, **rest))
        # Powers of the velocity scale with the amplitude: the engine starts at 1, with strengths
        # epsilon_i x0^(alpha_i-1), and the places are multiplied by x0.  Beside springs and |x|^m it takes x0 itself.
        if oscillator.law.is_pure and oscillator.x0 != 1:
            return as_motion(without_units(oscillator, count, **rest))
        law, kick = _bare(oscillator)
        return as_motion(
            with_notes(law, count, rest.pop("digits"), rest.pop("start"), rest.pop("times"), **rest, **kick)
        )


def _bare(oscillator: Oscillator) -> tuple[Law, dict[str, Any]]:
    """The law, and the start, of an oscillator whose strengths have no units."""
    return Law.from_terms(oscillator.law.terms, oscillator.law.notes), {"x0": oscillator.x0, "v0": oscillator.v0}


def _routes(moving: Given, count: int, digits: int, start: int, times: bool) -> Routes:
    """All routes, and what each would cost for this request; none is taken."""
    # As it is computed: from 1, with strengths epsilon_i x0^(alpha_i-1), unless springs or a speed forbid it.
    pure = moving.oscillator.law.is_pure and moving.oscillator.v0.is_zero
    law, kick = dimensionless(moving.oscillator) if moving.frame or pure else _bare(moving.oscillator)
    offered = offers(table.PointsRequest.read(law, count, digits, start=start, times=times, **kick))
    return Routes(tuple((r.name, "no" if s is None else f"{s:.2g}", r.domain, r.way) for r, s in offered))
