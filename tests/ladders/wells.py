"""Ladders of half-swings beside any spring, with losses that depend on the place."""

from itertools import islice

from flint import arb

from asymptotics.flow.dense import states
from asymptotics.flow.sequence import first_from, sequence, turning_by_pieces
from asymptotics.flow.taylor import TaylorStep, coefficients
from asymptotics.flow.trajectory import half_swing_pieces
from asymptotics.flow.turning import at_rest
from asymptotics.flow.wells.even_well import EvenWell
from asymptotics.flow.wells.expansion import WellExpansion
from asymptotics.flow.wells.force import WellForce
from asymptotics.flow.wells.turning_point import arrive
from asymptotics.law import Law
from tests.ladders.machine import Ladder
from tests.ladders.swings import DEAR, many, near

PENDULUM = ({"3/2": "1/10"}, "pendulum")
DUFFING = ({0: "1/20", (2, 1): "1/7", "1/2": "1/9"}, {3: "1/3"})
KINKED = ({(0, 2): "1/20", 1: "1/7", (2, 1): "1/9"}, {2: "1/3"})
EXPONENTS = ({"sqrt(2)": "1/10", 3: "1/7"}, {3: "1/3"})


def force(given):
    losses, spring = given
    return WellForce.of(Law(losses, spring=spring).terms)


def forces(given):
    def value(x):
        F, w = force(given), arb("0.5")
        powers = [c for c, *_ in (*F.restoring_powers(1), *F.loss_powers(1))]
        return [
            F.spring_force(x),
            F.dry_friction(x),
            F.restoring(x),
            F.drag(x, w),
            F.acceleration(x, w),
            F.potential(x),
            F.viscous,
            *powers,
        ]

    return value


def expanded(given):
    return lambda x: WellExpansion.at(force(given), x, arb("0.03125")).state(arb("0.03125"))


def landed(given):
    return lambda x: arrive(force(given), x, arb("0.25")).state(arb("0.25"))


def stepped(given):
    """At a time that every step reaches, within the growth of the residual (the step is short, the factor below 2)."""

    def value(x):
        step = TaylorStep.at(force(given), x, arb("0.5"), arb(1), arb(1))
        step = step.shortened(min(step.length, arb(2) ** -6))
        u, w = step.state(step.length)
        return [near(c, 2 * step.residual) for c in (u, w)]

    return value


def grown(given):
    return lambda x: [c for part in coefficients(force(given), x, arb("0.5"), 5) for c in part]


def pieces(given, *times):
    def value(x):
        found: list[arb] = []
        for piece in half_swing_pieces(EvenWell(force(given)), x, arb(0)):
            inside = [arb(t) for t in times if piece.begin <= arb(t) < piece.end]
            for u, w in map(piece.own, inside):
                local = piece.errors.local
                found += [near(u, local / piece.unit), near(w, local)]
        return [*found, near(piece.clock, piece.late(arb(0))), near(piece.turn, piece.gap(arb(0)))]

    return value


def turnings(given, count=3):
    return lambda x: [c for p in islice(sequence(EvenWell(force(given)), at_rest(x)), count) for c in (p.x, p.tau)]


def by_pieces(x):
    there, _ = turning_by_pieces(EvenWell(force(DUFFING)), at_rest(x))
    return [there.x, there.tau]


def kicked(x):
    found = first_from(EvenWell(force(PENDULUM)), arb("0.5"), x)
    return [found.x, found.tau]


def dense(given):
    times = [arb(1) / 4, arb(3) / 2, arb(5)]
    return lambda x: [c for state in states(EvenWell(force(given)), arb(1) / 2, x, times) for c in state]


WELLS_ROOM, FLOW = "asymptotics.flow.wells.", "asymptotics.flow."
FORCE = many(
    "of spring_force dry_friction restoring drag acceleration potential viscous restoring_powers loss_powers",
    WELLS_ROOM + "force.WellForce.",
)
EXPANSION, LANDING = (
    many("expansion.WellExpansion.at expansion.WellExpansion.state", WELLS_ROOM),
    many("turning_point.arrive", WELLS_ROOM),
)
STEP = many("at shortened state", "asymptotics.flow.taylor.TaylorStep.")
OWN = (
    *many("half_swing_pieces DeparturePiece.own Step.own ArrivalPiece.own", FLOW + "trajectory."),
    *many("expansion arrive", WELLS_ROOM + "even_well.EvenWell."),
    *many("WellExpansion.acceleration WellExpansion.moved", WELLS_ROOM + "expansion."),
    "asymptotics.flow.times.at_time",
)
SEQUENCE = (*many("sequence next_turning after_arrival", FLOW + "sequence."), FLOW + "turning.at_rest")

WELLS = [
    *(Ladder(FORCE, forces(given), lost=12, stretch=4) for given in (PENDULUM, DUFFING, KINKED)),
    *(
        Ladder(EXPANSION, expanded(given), lost=14, stretch=4, rungs=(10, 20, 40), truth=72)
        for given in (PENDULUM, DUFFING, KINKED, EXPONENTS)
    ),
    *(Ladder(LANDING, landed(given), "-0.9", 30, rungs=(20, 40, 80), truth=120) for given in (PENDULUM, DUFFING)),
    *(
        Ladder(STEP, stepped(given), lost=14, rungs=(10, 20, 40, 80), truth=120)
        for given in (PENDULUM, DUFFING, KINKED)
    ),
    *(
        Ladder(many("taylor.coefficients", "asymptotics.flow."), grown(given), lost=16, stretch=40)
        for given in (PENDULUM, DUFFING)
    ),
    *(
        Ladder(OWN, pieces(given, "0.0625", "1.25", "2.75"), "0.75", 18, least=20, **DEAR)
        for given in (PENDULUM, KINKED)
    ),
    Ladder(SEQUENCE, turnings(PENDULUM), "0.75", 18, 20, 20, wide=(-20,), **DEAR),
    Ladder(("asymptotics.flow.sequence.turning_by_pieces",), by_pieces, "0.75", 18, least=20, rungs=(20, 40), truth=72),
    Ladder(
        many("first_from turning_after_start start_in_motion", FLOW + "sequence."),
        kicked,
        "0.75",
        18,
        20,
        20,
        wide=(-20,),
        **DEAR,
    ),
    Ladder((FLOW + "dense.states",), dense(PENDULUM), "0.25", 20, 20, 20, wide=(-20,), **DEAR),
]
