"""Ladders of what is computed by formulas: numbers, laws, moments, wells, envelopes, Smith's constants."""

import sympy
from flint import arb, fmpq

from asymptotics.envelopes import certified as envelope
from asymptotics.envelopes.first_order import FirstOrderEnvelope, start_phase
from asymptotics.envelopes.large import SlowFlow
from asymptotics.errors import UndecidedError
from asymptotics.expansions.half_swings.symbolic import nested_integral, nested_integral_exact
from asymptotics.expansions.moments.certified import moment, squaring_ratio
from asymptotics.expansions.straightening.wells import Loss, Well
from asymptotics.law import Oscillator
from asymptotics.limit_cycles.half_cycle import half_cycle
from asymptotics.motions.admission import local_strength
from asymptotics.motions.invariants import certified as constants
from asymptotics.motions.invariants.symbolic import generating_function
from asymptotics.numbers.bridge import closed_form_ball
from asymptotics.numbers.exact import parse_real
from asymptotics.numbers.gamma_sums import gamma
from asymptotics.terms import Term
from tests.ladders.machine import Ladder

MASS = Oscillator({"3/2": "1/10", 0: "1/7"}, mass="3/2", stiffness="29/10", x0="-1/3", v0="1/5")
ENVELOPE = FirstOrderEnvelope(Oscillator({"3/2": "1/10", 1: "1/30"}, mass="3/2", stiffness="29/10", x0="1/3"))
SQUARED = FirstOrderEnvelope(ENVELOPE.oscillator, "squaring")


def laws(*pairs):
    return [(parse_real(alpha, "alpha"), parse_real(kappa, "kappa").ball()) for alpha, kappa in pairs]


ONE, TWO = (("3/2", "1/7"),), (("1", "1/30"), ("2", "1/7"))
ENDING, IRRATIONAL = (("1/2", "1/7"), ("3", "1/5")), (("1/3", "1/9"), ("sqrt(2)", "1/7"))
THREE, DYING = (("1", "1/9"), ("3/2", "1/30"), ("3", "1/7")), (("0", "1/9"), ("1", "1/30"), ("2", "1/7"))


def flow(kind, *losses):
    well = getattr(Well, kind)(arb(3) / 7)
    return SlowFlow(well, tuple(Loss(arb(e) / 100, arb(a) / 2, m) for e, a, m in losses), arb(3) / 2)


AIR, DUFFING, DRY = ("pendulum", (7, 4, 0)), ("duffing", (7, 3, 0), (3, 2, 1)), ("pendulum", (7, 0, 0), (3, 2, 0))
NEAR, FLOW = "asymptotics.expansions.straightening.wells.", "asymptotics.envelopes.large.SlowFlow."
CERTIFIED, SMITH = "asymptotics.envelopes.certified.", "asymptotics.motions.invariants.certified."


def slow(name, kind, at, **more):
    return Ladder((FLOW + name,), lambda x: [getattr(flow(*kind), name)(x)], at, **more)


def end(kind):
    return Ladder(
        (FLOW + "extinction_time", NEAR + "Well.near_zero", NEAR + "Well.theta_near_zero"),
        lambda _: [flow(*kind).extinction_time()],
        lost=18,
        least=20,
        rungs=(10, 20, 40, 80),
        truth=160,
    )


NUMBERS = [
    Ladder(
        ("asymptotics.numbers.exact.ExactReal.ball",),
        lambda _: [(parse_real("sqrt(2)", "x") - parse_real("1/7", "x")).ball(), parse_real("1/7", "x").ball()],
    ),
    Ladder(
        ("asymptotics.numbers.bridge.closed_form_ball",),
        lambda _: [closed_form_ball(sympy.exp(sympy.sqrt(2)) / 7 + sympy.cos(3) * sympy.pi ** sympy.Rational(1, 3))],
    ),
    Ladder(
        ("asymptotics.numbers.gamma_sums.GammaSum.ball", "asymptotics.numbers.gamma_text.value"),
        lambda _: [(2 * gamma(fmpq(7, 4)) / gamma(fmpq(9, 4)) - gamma(fmpq(1, 2)) ** 3 / 7).ball()],
    ),
    Ladder(
        ("asymptotics.expansions.half_swings.pi_ring.PiNumber.ball",),
        lambda _: [nested_integral_exact(3).ball()],
        lost=20,
    ),
    Ladder(("asymptotics.expansions.moments.certified.moment",), lambda x: [moment(x)], "2.3", stretch=2),
    Ladder(
        ("asymptotics.expansions.moments.certified.squaring_ratio",), lambda x: [squaring_ratio(x)], "2.3", stretch=3
    ),
    Ladder(
        ("asymptotics.expansions.half_swings.symbolic.nested_integral",),
        lambda x: [nested_integral(x)],
        "2.3",
        20,
        200,
        rungs=(10, 20, 40, 80),
        truth=160,
    ),
    Ladder(
        ("asymptotics.motions.invariants.symbolic.GeneratingFunction.scaled_at",),
        lambda x: [generating_function(2).scaled_at(x)],
        "1.2",
        14,
        40,
    ),
]

LAWS = [
    Ladder(
        tuple(f"asymptotics.law.Oscillator.{name}" for name in ("omega_0", "length", "epsilons", "kappas"))
        + ("asymptotics.terms.Units.omega_0", "asymptotics.terms.Units.length", "asymptotics.terms.Scaled.ball"),
        lambda _: [MASS.omega_0(), MASS.length(), *MASS.epsilons(), *MASS.kappas()],
    ),
    Ladder(("asymptotics.law.Oscillator.deltas", "asymptotics.terms.Term.delta"), MASS.deltas, stretch=2),
    Ladder(("asymptotics.law.Oscillator.to_si",), lambda x: MASS.to_si(x, x), stretch=2),
    Ladder(("asymptotics.motions.admission.local_strength",), lambda _: [local_strength(MASS)]),
    Ladder(("asymptotics.envelopes.first_order.start_phase",), lambda _: [start_phase(MASS)]),
    Ladder(
        tuple(f"asymptotics.envelopes.first_order.FirstOrderEnvelope.{name}" for name in ("laws", "rates")),
        lambda _: [*(k for _, k in ENVELOPE.laws()), *ENVELOPE.rates(), *SQUARED.rates()],
    ),
    Ladder(
        tuple(f"asymptotics.envelopes.first_order.FirstOrderEnvelope.{name}_ball" for name in ("amplitude", "lag")),
        lambda x: [ENVELOPE.amplitude_ball(x), ENVELOPE.lag_ball(x)],
        "5",
        16,
        2,
        least=20,
    ),
]

ENVELOPES = [
    *(
        Ladder((CERTIFIED + "time", CERTIFIED + "F"), lambda x, p=p: [envelope.time(laws(*p), x)], "0.6", 20, 60)
        for p in (ONE, TWO, ENDING, IRRATIONAL, THREE)
    ),
    *(
        Ladder((CERTIFIED + "amplitude",), lambda x, p=p: [envelope.amplitude(laws(*p), x)], "3", 20, 2, least=20)
        for p in (ONE, TWO, ENDING, IRRATIONAL)
    ),
    *(
        Ladder(
            (CERTIFIED + "amplitude",),
            lambda x, p=p: [envelope.amplitude(laws(*p), x)],
            "3",
            20,
            2,
            least=20,
            rungs=(10, 20, 40, 80),
            truth=160,
        )
        for p in (THREE, DYING)
    ),
    *(
        Ladder(
            (CERTIFIED + "extinction_time",),
            lambda _, p=p: [envelope.extinction_time(laws(*p))],
            lost=20,
            rungs=(10, 20, 40, 80),
            truth=120,
        )
        for p in (ENDING, IRRATIONAL, DYING)
    ),
    *(
        Ladder(
            (CERTIFIED + "phase",),
            lambda x, p=p: [envelope.phase(laws(*p), [arb(1) / 7, arb(1) / 9, arb(1) / 30][: len(p)], x)],
            "0.6",
            20,
            4,
            rungs=(10, 20, 40, 80),
            truth=160,
        )
        for p in (ONE, TWO, DYING)
    ),
    Ladder(
        (FLOW + "s_0", NEAR + "Well.xi", NEAR + "Well.pendulum", NEAR + "Well.duffing"),
        lambda _: [flow(*AIR).s_0, flow(*DUFFING).s_0],
    ),
    Ladder(
        (NEAR + "Loss.mean", NEAR + "Loss.weight"),
        lambda x: [v for m in (0, 1, 2) for v in (Loss(arb(1), x, m).mean, Loss(arb(1), x, m).weight)],
        "1.3",
        stretch=2,
    ),
    *(
        slow(name, kind, "0.5", lost=18, stretch=400, rungs=(10, 20, 40, 80), truth=160)
        for name in ("time", "angle")
        for kind in (AIR, DUFFING)
    ),
    *(
        slow(name, kind, "5", lost=18, stretch=8, least=20, rungs=(10, 20, 40), truth=100)
        for name in ("amplitude", "phase", "xi")
        for kind in (AIR, DUFFING)
    ),
    end(DRY),
]


def smith(name, *arguments, at="0.3", **more):
    return Ladder((SMITH + name,), lambda x: [getattr(constants, name)(*arguments, x)], at, **more)


def turn(x):
    found = half_cycle((Term(-1, 1), Term(1, 1, 2)), arb(1), x)
    if found is None:
        raise UndecidedError("too few bits")
    return [found.q, found.T, found.J]


INVARIANTS = [
    smith("first_constant", arb("0.25"), at="-0.3", stretch=2),
    smith("last_turning_point", arb("0.25"), at="-0.3", lost=14, stretch=20),
    smith("since_turning_point", arb("0.25"), at="-0.3", lost=24, stretch=700, least=20, wide=(-20,)),
    Ladder(
        (SMITH + "second_constant",),
        lambda x: [constants.second_constant(arb("0.25"), x, arb(3))],
        "-0.3",
        24,
        700,
        20,
        wide=(-20,),
    ),
    smith("series_radius", lost=14, stretch=60),
    smith("absolute_radius", lost=14, stretch=20),
    Ladder(("asymptotics.limit_cycles.half_cycle.half_cycle",), turn, "2", 28, None, 40, (20, 40, 80), 120),
]

ELEMENTARY = [*NUMBERS, *LAWS, *ENVELOPES, *INVARIANTS]
