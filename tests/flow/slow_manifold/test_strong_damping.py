"""Stiff laws with alpha > 1 slide between two barriers: against steps, a stiff integrator, Lambert's W."""

from dataclasses import replace
from random import Random

import mpmath
import pytest
from flint import arb
from scipy.integrate import solve_ivp

from asymptotics.errors import LimitError, UndecidedError
from asymptotics.flow.damping import Damping
from asymptotics.flow.linear_spring import linear_spring
from asymptotics.flow.linear_spring.linear_spring import Creep, LinearSpring
from asymptotics.flow.slow_manifold.slow_curve import SlowCurve, one_way
from asymptotics.flow.slow_manifold.slow_curve_series import summed, truncated
from asymptotics.flow.slow_manifold.strong_damping import strong_damping_strip
from asymptotics.flow.trajectory import ArrivedPiece, half_swing_pieces
from asymptotics.law import Law, Oscillator
from asymptotics.motions.reference import reference_motion
from asymptotics.numbers.context import ctx
from asymptotics.numbers.exact import parse_real
from asymptotics.turning.choose import turning_points
from tests.flow.forces import by_strength


def damping(alpha, epsilon):
    return Damping.of([(parse_real(epsilon, "e").ball(), parse_real(alpha, "a"))])


def turned(alpha, epsilon, bits):
    """(q, T) of the first half-swing as balls, and how many pieces and slides it took."""
    with ctx.workprec(bits):
        pieces = list(half_swing_pieces(LinearSpring(damping(alpha, epsilon)), arb(1), arb(0)))
        last = pieces[-1]
        assert isinstance(last, ArrivedPiece)
        return arb(-last.turn, last.miss), last.time, len(pieces), sum(isinstance(p, Creep) for p in pieces)


def entered(alpha, epsilon, bits, error=None):
    """A state on the way, and its slide."""
    with ctx.workprec(bits):
        law = damping(alpha, epsilon)
        before = None
        for piece in half_swing_pieces(LinearSpring(law), arb(1), arb(0)):
            if isinstance(piece, Creep):
                break
            before = piece
        y, w = (value.mid() for value in before.own(before.end))
        return law, y, w, strong_damping_strip(law, y, w, before.error if error is None else error)


@pytest.mark.parametrize(("alpha", "epsilon"), [("3/2", "100"), ("2", "300"), ("sqrt(3)", "200")])
def test_the_strip_ends_where_steps_do(alpha, epsilon, monkeypatch):
    """At 70 bits with a slide, at 140 by Taylor steps alone: place and time are held."""
    q, time, count, slides = turned(alpha, epsilon, 70)
    monkeypatch.setattr(linear_spring, "strong_damping_strip", lambda *_: None)
    exact, late, more, none = turned(alpha, epsilon, 140)
    assert slides == 1 and none == 0 and count < more
    assert q.contains(exact) and time.contains(late) and q.rad() < 1e-12


@pytest.mark.parametrize("epsilon", ["1e3", "1e5", "1e8"])
def test_quadratic_drag_by_lamberts_w(epsilon):
    """(1 + u) e^(-u) = (1 - v) e^v, u = 2 epsilon, v = 2 epsilon q."""
    q, *_ = turned("2", epsilon, 120)
    with mpmath.workdps(50):
        u = 2 * mpmath.mpf(epsilon)
        v = 1 + mpmath.lambertw(-(1 + u) * mpmath.exp(-1 - u)).real
        wanted = mpmath.nstr(v / u, 40)
    with ctx.workprec(160):
        assert abs(q - arb(wanted)) < arb(10) ** -27 and q.rad() < 1e-28


@pytest.mark.parametrize("seed", range(12))
def test_a_stiff_integrator_agrees(seed):
    """x at a random time, for a random law, to seven digits."""
    rng = Random(seed)
    alpha, epsilon = rng.choice(["5/4", "3/2", "7/4", "2", "5/2", "3"]), rng.choice([200, 1000, 5000, 20000])
    a = float(mpmath.mpf(parse_real(alpha, "a").rational.numerator) / parse_real(alpha, "a").rational.denominator)
    time = rng.uniform(0.1, 0.9) * epsilon ** (1 / a)
    found = reference_motion(Oscillator(Law({alpha: epsilon})), f"{time:.6f}", 10)
    truth = solve_ivp(
        lambda _, s: [s[1], -s[0] - epsilon * s[1] * abs(s[1]) ** (a - 1)],
        (0, float(f"{time:.6f}")), [1, 0], "Radau", rtol=1e-10, atol=1e-13,
    )  # fmt: skip
    assert found.certified and float(found.x) == pytest.approx(truth.y[0, -1], rel=1e-7)


def test_many_digits_of_a_stiff_law():
    table = turning_points(Law({"3/2": "1e4"}), 3, 25, times=True)
    weak = turning_points(Law({"3/2": "100"}), 3, 25)
    assert table.certified  # the start is forgotten: epsilon^2 x_1 is nearly the same for both
    assert weak.points[1].x.lstrip("-0.")[:15] == table.points[1].x.lstrip("-").replace(".", "")[:15]


def test_half_the_strip_is_not_proved():
    with ctx.workprec(120):
        series = replace(truncated(damping("3/2", "1e4"), 0, 6), cut=arb(0))
        end = arb(-14)
        least = summed(series.neglected, end) / series.alpha
        assert one_way(series, arb("1.1") * least, end) and not one_way(series, arb("0.9") * least, end)


@pytest.mark.parametrize("sign", [-1, 1])
@pytest.mark.parametrize(("alpha", "epsilon"), [("3/2", "1e4"), ("2", "1e3"), ("3", "1e6")])
def test_on_the_barriers_the_motion_crosses_as_proved(alpha, epsilon, sign):
    law, _, _, slide = entered(alpha, epsilon, 80)
    curve = slide.above if sign < 0 else slide.below
    with ctx.workprec(900):
        law = damping(alpha, epsilon)
        orders = (truncated(law, 0, n) for n in range(1, 99))
        series = next(s for s in orders if len(s.b) == len(curve.b) - 1)
        theta = curve.b[-1][0].mid()
        exact = SlowCurve(series.epsilon, series.alpha, (), (*series.b, (theta, arb(0))))
        for above in ("0.001", "0.1", "1", "5"):
            log_w = slide.most.mid() + arb(above)
            w = log_w.exp()
            y, slope = exact.place(log_w)
            assert sign * (-1 - slope / w * (y - law.resistance(w)) / w) > 0


def test_the_strip_holds_every_state_that_enters():
    """Twice what the state's error needs, no less."""
    law, y, w, slide = entered("3/2", "1e4", 120, arb("1e-9"))
    with ctx.workprec(120):
        e = arb("1e-9")
        height = slide.above.place(w.log())[0] - y
        assert slide.above.place((w - e).log())[0] - (y + e) > height / 3
        assert (y - e) - slide.below.place((w + e).log())[0] > height / 3


def test_a_strip_begins_at_every_height_of_the_state():
    law, y, w, slide = entered("3/2", "1e4", 120, arb("1e-9"))
    with ctx.workprec(120):
        found, speeds = slide.state(arb(0))
        for side in (1, -1):
            assert found.contains(y + side * arb("0.999e-9")) and not found.contains(y + side * arb("1.1e-9"))
        log_w = slide.starts[0].mid() - 1
        apart = (slide.above.place(log_w)[0] - slide.below.place(log_w)[0]) / slide.above.place(log_w)[1]
        blur = (slide._speed(log_w) * (-log_w).exp() - 1).upper()
        assert apart <= blur and float(blur / apart) < 4


def test_a_strip_ends():
    _, _, _, slide = entered("3/2", "1e4", 80)
    with ctx.workprec(80):
        assert slide.state(slide.length)[1] > 0
        assert slide.holds(slide.most + 1) and not slide.holds(slide.most - 1)
        with pytest.raises(UndecidedError):
            slide.state(2 * slide.length)


def test_next_to_linear_damping_a_half_swing_is_refused_at_once():
    with pytest.raises(LimitError, match="next to critical damping"):
        turning_points(Law({"1.00000000000000000001": 3}), 2, 10)


def test_what_the_strip_leaves_open_is_in_the_error_after_it():
    with ctx.workprec(70):
        pieces = list(half_swing_pieces(LinearSpring(damping("3/2", "100")), arb(1), arb(0)))
        i = next(i for i, piece in enumerate(pieces) if isinstance(piece, Creep))
        y, w = pieces[i].own(pieces[i].end)
        assert pieces[i + 1].error >= y.rad() + w.rad() > 0


def test_no_strip_below_the_exponent_1():
    with ctx.workprec(60):
        for alpha, held in (("1/2", False), ("3/2", True)):
            law, w = by_strength(("1e6", alpha)), arb("0.001" if alpha == "1/2" else 1).mid()
            found = strong_damping_strip(law, law.resistance(w).mid(), w, w * arb("1e-9"))
            assert (found is not None) is held
