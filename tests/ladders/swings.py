"""Ladders of half-swings beside the linear spring: pieces, sequences, dense states, series, jumps."""

from itertools import islice

from flint import arb, ctx

from asymptotics.decays.identification.certified_sets.certified_ratio import CertifiedRatio
from asymptotics.expansions.half_swings.certified import quarter_swing
from asymptotics.expansions.half_swings.certified_orders import elementary_series, sine_ratio_power
from asymptotics.expansions.half_swings.certified_zeros import certified_half_swing
from asymptotics.expansions.half_swings.node_transform import NodeTransform
from asymptotics.flow.balls import upper
from asymptotics.flow.damping import Damping
from asymptotics.flow.dense import states, states_from
from asymptotics.flow.linear_spring.expansion import TurningExpansion
from asymptotics.flow.linear_spring.linear import LinearSolution
from asymptotics.flow.linear_spring.linear_spring import LinearSpring
from asymptotics.flow.linear_spring.rows import rows_below
from asymptotics.flow.linear_spring.turning_point import arrive
from asymptotics.flow.sequence import first_from, sequence
from asymptotics.flow.slow_manifold.slow_curve_series import summed, truncated
from asymptotics.flow.taylor import GUARD, TaylorStep, coefficients
from asymptotics.flow.trajectory import half_swing_pieces
from asymptotics.flow.turning import at_rest
from asymptotics.law import Law
from asymptotics.numbers.exact import parse_real
from asymptotics.return_map.chebyshev import coefficients as chebyshev
from asymptotics.return_map.chebyshev import nodes
from asymptotics.return_map.coordinate import Coordinate
from asymptotics.return_map.half_swing_map import integrated
from asymptotics.terms import Term
from asymptotics.turning import energy_primitive
from asymptotics.turning.quadratic_duration import duration, elapsed
from asymptotics.turning.quadratic_map import amplitudes, next_amplitude
from tests.ladders.machine import Ladder

ROOT, SUM = (("3/2", "1/5"),), (("0", "1/50"), ("sqrt(2)", "1/7"), ("3", "1/3"))
SLOW, LINEAR = (("1/2", "1/9"), ("2", "1/3")), (("0", "1/50"), ("1", "1/3"))
SPRING, FLOW, RETURN = "asymptotics.flow.linear_spring.", "asymptotics.flow.", "asymptotics.return_map."
MANIFOLD = "asymptotics.flow.slow_manifold."
DEAR = {"rungs": (20, 40, 80), "truth": 120}


def law(pairs):
    """Strengths carry GUARD bits more, as wherever pieces are made."""
    with ctx.workprec(ctx.prec + GUARD):
        return Damping.of([(parse_real(e, "e").ball(), parse_real(a, "a")) for a, e in pairs])


def near(center, error):
    return center + arb(0, error)


def expanded(pairs, w="0.03125"):
    """At one speed, and as for many."""

    def value(x):
        found = TurningExpansion.at(law(pairs), x, arb(w))
        return [*found.state(arb(w)), *found.gathered.state(arb(w))]

    return value


def landed(x):
    """The turning point ahead: the guess is off by no more than its orbit misses the place."""
    w = arb("0.25")
    ahead = arrive(law(ROOT), x, w)
    place, _ = ahead.state(w)
    return [near(ahead.y0, upper(place - x))]


def stepped(pairs):
    def value(x):
        step = TaylorStep.at(law(pairs), x, arb("0.5"), arb(1), arb(1))
        return [near(c, step.residual) for c in step.state(min(step.length, arb(2) ** -6))]

    return value


def pieces(pairs, *times):
    """(y, w) of whatever pieces hold the times, within their errors."""

    def value(x):
        found: list[arb] = []
        for piece in half_swing_pieces(LinearSpring(law(pairs)), x, arb(0)):
            inside = [arb(t) for t in times if piece.begin <= arb(t) < piece.end]
            found += [near(c, piece.error) for t in inside for c in piece.own(t)]
        return found

    return value


def turnings(pairs, count=4):
    return lambda _: [
        c for p in islice(sequence(LinearSpring(law(pairs)), at_rest(arb(1))), count) for c in (p.x, p.tau)
    ]


def first(x):
    found = first_from(LinearSpring(law(ROOT)), arb("0.5"), x)
    return [found.x, found.tau]


def dense(pairs):
    times = [arb(1) / 4, arb(3) / 2, arb(5), arb(9)]
    return lambda x: [c for state in states(LinearSpring(law(pairs)), arb(1) / 2, x, times) for c in state]


def timed(x):
    return [c for state in states_from(LinearSpring(law(SUM)), at_rest(arb(1)), [x]) for c in state]


def swung(x):
    found = integrated(law(SUM), x)
    return [found.amplitude, found.duration]


def coordinate(pairs):
    def value(x):
        z = Coordinate.of([(parse_real(e, "e").ball(), parse_real(a, "a")) for a, e in pairs])
        return [z(x), *z.strengths(z(x)), *z.damping(z(x)).strengths]

    return value


def slow_curve(x):
    found = truncated(law((("1/2", "1"), ("3", "1/7"))), 0, 3)
    return [*(b for b, _ in found.b), summed(found.b, x)]


def rows(_):
    found = rows_below((parse_real("sqrt(2)", "a"),), (2, 3), 9, ctx.prec)
    return [c for _, y, s in found for part in (y, s) for c in part.coeffs()]


def orders(quarter):
    return [series[n] for series in (quarter.R, quarter.T_q) for n in ((1, 0), (0, 1), (2, 1), (1, 3))]


def series(_):
    return orders(quarter_swing([parse_real(a, "a") for a in ("1/2", "sqrt(3)")], 4))


def mapped(_):
    half = certified_half_swing([parse_real(a, "a") for a in ("1/2", "sqrt(3)")], 4)
    return [f[n] for f in (half.L, half.T) for n in ((2, 0), (1, 1), (1, 3))]


def transformed(count):
    """Sums of two columns; the values of each degree by itself."""

    def value(x):
        transform, powers = NodeTransform(count), [x ** (k + 1) for k in range(count)]
        sums = transform.sums([[c, 1 - c] for c in powers])
        alone = [[c if k == n else arb(0) for k, c in enumerate(powers)] for n in range(count)]
        return [c for part in (*sums, *map(transform.values, alone)) for c in part]

    return value


def ratio(x):
    return [CertifiedRatio.of((Term(1, 1), Term(1, 2))).at([x, x])]


def exact_work(x):
    spring = Law({0: "1/20", 2: "1/7"}, spring={3: "1/3"})
    return [energy_primitive.PrimitiveWell.of(spring).work(arb("-0.5"), x)]


def many(names, room=SPRING):
    return tuple(room + name for name in names.split())


LAW = many("damping.Damping.of damping.Damping.terms damping.Damping.resistance", FLOW)
EXPANSION, STEP = (
    many("expansion.TurningExpansion.at expansion.TurningExpansion.state expansion.TurningExpansion.gathered"),
    many("at shortened state", "asymptotics.flow.taylor.TaylorStep."),
)
OWN = (
    *many("DeparturePiece.own Step.own ArrivalPiece.own ArrivedPiece.time half_swing_pieces", FLOW + "trajectory."),
    *many("linear_spring.LinearSpring.expansion linear_spring.LinearSpring.arrive"),
    *many("expansion.TurningExpansion.acceleration expansion.TurningExpansion.moved"),
    *many("damping.Damping.restoring damping.Damping.drag", FLOW),
    "asymptotics.flow.times.at_time",
)
SEQUENCE = many(
    "sequence.sequence sequence.turning_by_pieces sequence.after_arrival turning.TurningState.x "
    "turning.TurningState.tau turning.at_rest",
    FLOW,
)
STATES, FROM = many("dense.states", FLOW), many("dense.states_from", FLOW)
MAP, DURATION = "asymptotics.turning.quadratic_map.", "asymptotics.turning.quadratic_duration."
EXACT = "asymptotics.turning.energy_primitive.PrimitiveWell."
ORDERS = "asymptotics.expansions.half_swings.certified_orders."
TRANSFORM = "asymptotics.expansions.half_swings.node_transform.NodeTransform."

PIECES = [
    Ladder(LAW, lambda x: [law(SUM).resistance(x), *law(SUM).terms(x)], stretch=4),
    *(Ladder(EXPANSION, expanded(p), lost=14, stretch=4, rungs=(10, 20, 40, 80), truth=120) for p in (ROOT, SUM, SLOW)),
    Ladder(many("turning_point.arrive"), landed, "-0.9", 14, 6, **DEAR),
    *(Ladder(STEP, stepped(p), lost=14) for p in (ROOT, SUM, SLOW)),
    *(
        Ladder(
            many("taylor.coefficients", "asymptotics.flow."),
            lambda x, p=p: [c for part in coefficients(law(p), x, arb("0.5"), 5) for c in part],
            lost=16,
            stretch=40,
        )
        for p in (ROOT, SUM)
    ),
    Ladder(
        many("linear.LinearSolution.of linear.LinearSolution.state"),
        lambda x: LinearSolution.of(law(LINEAR), arb("0.5"), arb("0.25")).state(x),
        "5",
        stretch=3,
    ),
    Ladder(
        many("linear.LinearSolution.turning"),
        lambda x: LinearSolution.of(law(LINEAR), x, arb("0.25")).turning(),
        stretch=4,
    ),
    *(Ladder(OWN, pieces(p, "0.0625", "1.25", "2.75"), "1", 16, least=20, **DEAR) for p in (ROOT, SLOW)),
    Ladder(many("linear_spring.LinearPiece.own"), pieces(LINEAR, "0.0625", "2.75"), "1", least=20, rungs=(20, 40, 80)),
]

SEQUENCES = [
    *(Ladder(SEQUENCE, turnings(p), lost=16, least=20, **DEAR) for p in (ROOT, LINEAR)),
    Ladder(
        many(
            "sequence.first_from sequence.turning_after_start trajectory.ArrivedPiece.late trajectory.ArrivedPiece.gap",
            FLOW,
        ),
        first,
        lost=14,
        stretch=6,
        least=20,
        **DEAR,
    ),
    Ladder(many("half_swing_map.integrated half_swing_map.of_arrival", RETURN), swung, lost=14, least=20, **DEAR),
    Ladder(STATES, dense(ROOT), lost=16, stretch=12, least=20, **DEAR),
    Ladder(FROM, timed, "5", 16, 12, 20, **DEAR),
    *(
        Ladder(
            many("coordinate.Coordinate.of coordinate.Coordinate.strengths coordinate.Coordinate.damping", RETURN),
            coordinate(p),
            lost=12,
            stretch=3,
        )
        for p in (ROOT, (("1/2", "1/9"), ("sqrt(3)", "1/7")))
    ),
    Ladder(many("slow_curve_series.truncated slow_curve_series.summed", MANIFOLD), slow_curve, "-8", 24, 2, 20),
    Ladder(many("rows.rows_below"), rows, lost=6),
    Ladder(
        many("chebyshev.nodes chebyshev.coefficients", RETURN),
        lambda x: [*nodes(5), *chebyshev([x * t for t in nodes(5)])],
        lost=6,
        stretch=4,
    ),
    Ladder((RETURN + "coordinate.Coordinate.__call__",), coordinate((("3", "1/7"),)), lost=12, stretch=5),
]

SERIES = [
    Ladder((ORDERS + "elementary_series",), lambda _: [c for f in elementary_series(9) for c in f.coeffs()]),
    Ladder((ORDERS + "sine_ratio_power",), lambda x: sine_ratio_power(x, 9).coeffs(), "2.3", stretch=2),
    Ladder(
        (
            "asymptotics.expansions.half_swings.certified.quarter_swing",
            ORDERS + "power_series_ring",
            ORDERS + "bound_ring",
        ),
        series,
        lost=6,
        rungs=(10, 20, 40, 80),
        truth=160,
    ),
    Ladder(
        ("asymptotics.expansions.half_swings.certified_zeros.certified_half_swing",),
        mapped,
        lost=8,
        rungs=(10, 20, 40, 80),
        truth=160,
    ),
    # An odd and an even number of nodes, with and without a node at 0; one alone has no odd degree.
    *(Ladder(many("sums values", TRANSFORM), transformed(count), lost=4, stretch=12) for count in (1, 2, 7)),
    Ladder(
        many("of at polynomial", "asymptotics.decays.identification.certified_sets.certified_ratio.CertifiedRatio."),
        ratio,
        "0.01",
        30,
        20,
        rungs=(20, 40),
        truth=70,
    ),
]

TURNING = [
    Ladder((MAP + "next_amplitude",), lambda x: [next_amplitude(x)], "0.125", stretch=1.1),
    Ladder((MAP + "amplitudes",), lambda x: list(islice(amplitudes(x), 5)), "2", 6, 1.1),
    Ladder((DURATION + "duration",), lambda x: [duration(x, next_amplitude(x))], "2", 20),
    Ladder(
        (DURATION + "elapsed",),
        lambda x: [elapsed(arb(2), next_amplitude(arb(2)), x)],
        "1",
        20,
        400,
        20,
        (10, 20, 40, 80),
        160,
    ),
    Ladder(many("of work", EXACT), exact_work, lost=18, stretch=300),
]

SWINGS = [*PIECES, *SEQUENCES, *SERIES, *TURNING]
