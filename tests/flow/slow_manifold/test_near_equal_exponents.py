"""Nearly equal exponents, a standing random class: they cost what one law costs, and creep beside one curve.

Against Taylor steps, against one law of the strengths together, and with the barriers moved.
"""

from itertools import islice, pairwise, product
from random import Random

import mpmath
import pytest
from flint import arb, arb_poly, ctx

from asymptotics.errors import UndecidedError
from asymptotics.flow import dense
from asymptotics.flow.damping import Damping
from asymptotics.flow.linear_spring import linear_spring
from asymptotics.flow.linear_spring.linear_spring import Creep, LinearSpring
from asymptotics.flow.sequence import sequence
from asymptotics.flow.slow_manifold import near_equal_exponents
from asymptotics.flow.slow_manifold.near_equal_exponents import (
    FencedStretch,
    extend,
    grouped,
    groups,
    one_way,
    residual,
    stretch,
)
from asymptotics.flow.slow_manifold.slow_curve import solve
from asymptotics.flow.slow_manifold.slow_curve_series import lower_set
from asymptotics.flow.trajectory import half_swing_pieces
from asymptotics.flow.turning import at_rest
from asymptotics.numbers.exact import parse_real
from asymptotics.numbers.precision import at_growing_precision
from tests.worlds import NEAR_EQUAL

BITS, LATE, MANY = 90, 1000, 40
BASES = ["1", "1/5", "1/3", "1", "1/2", "7/10", "4/5", "sqrt(1/2)", "1", "4/3", "3/2", "sqrt(5)"]


def drawn(seed, low=9, high=40):
    """Two or three exponents 10^-low to 10^-high beside a base, on either side and, every other time, on both; base and
    terms, and the terms of one law that holds all strengths, with the least and with the greatest exponent."""
    random = Random(seed)
    base, count = BASES[seed % len(BASES)], random.choice((2, 3))
    signs = [random.choice((-1, 1)) for _ in range(count)]
    if seed % 2 == 0:
        signs[:2] = [1, -1]
    here = parse_real(base, "alpha")
    gaps = [sign * parse_real(f"1e-{random.randint(low, high)}", "d").rational for sign in signs]
    terms = [(arb(random.randint(4, 30)) / 20, here + d) for d in gaps]
    total = sum((e for e, _ in terms), arb(0))
    return terms, *([(total, here + pick(gaps))] for pick in (min, max))


def state_at(law, time, monkeypatch):
    """The state at a time, from rest at 9/10, and how many pieces it took, whether or not the motion turns before."""
    made = []

    def counted(*given, **named):
        for piece in half_swing_pieces(*given, **named):
            made.append(piece)
            yield piece

    monkeypatch.setattr(dense, "half_swing_pieces", counted)
    begin = parse_real("9/10", "x").ball().mid()
    return dense.states(LinearSpring(law), begin, arb(0), [arb(time)])[0], len(made)


@pytest.mark.parametrize("seed", range(16))
def test_nearly_equal_exponents_cost_what_one_law_costs_and_move_like_it(seed, monkeypatch):
    """Creep to a late time, and motions that turn a dozen times."""

    def both(bits):
        with ctx.workprec(bits):
            near, one, _ = (Damping.of(terms) for terms in drawn(seed))
            time = LATE if near.exponents[0] < 0.9 else MANY
            return [state_at(law, time, monkeypatch) for law in (near, one)]

    (state, pieces), (alone, single) = at_growing_precision(both, 9, BITS, max_bits=2 * BITS)
    with ctx.workprec(BITS):
        size = abs(alone[0]).max(abs(alone[1])).mid()
        assert pieces <= 3 * single
        assert all(abs(x - a) < 1e-6 * size for x, a in zip(state, alone)) and size > 0


@pytest.mark.parametrize("seed", [s for s in range(24) if BASES[s % len(BASES)] in ("1", "4/3", "3/2")])
def test_turning_points_lie_between_those_of_one_law_on_either_side(seed):
    """Below the speed 1 a greater exponent brakes less: every amplitude lies between those of the two single laws."""
    with ctx.workprec(BITS):
        laws = [Damping.of(terms) for terms in drawn(seed)]
        total = sum(laws[0].strengths, arb(0))
        runs = [islice(sequence(LinearSpring(law), at_rest(arb(1))), 7) for law in laws]
        if total < arb("1.99"):
            for near, strong, weak in zip(*runs, strict=True):
                near, strong, weak = (arb(p.amplitude, p.amplitude_error) for p in (near, strong, weak))
                assert not near < strong and not near > weak


def creeping(terms, bits=BITS):
    """The first stretch of a creep from rest."""
    with ctx.workprec(bits):
        law = Damping.of(terms())
        begin = parse_real("9/10", "x").ball().mid()
        found = (
            p
            for p in half_swing_pieces(LinearSpring(law), begin, arb(0))
            if isinstance(p, Creep) and isinstance(p.strip, FencedStretch)
        )
        return law, next(found)


def of(*pairs):
    return lambda: [(arb(e), parse_real(a, "alpha")) for a, e in pairs]


LAWS = {name: of(*world.pairs) for name, world in NEAR_EQUAL.items()}
ALL = [pytest.param(law, id=name) for name, law in LAWS.items()]


@pytest.mark.parametrize("law", ALL[:-1])
def test_taylor_steps_pass_between_the_barriers(law, monkeypatch):
    _, piece = creeping(law)
    monkeypatch.setattr(linear_spring, "caught", lambda *_: None)
    monkeypatch.setattr(linear_spring, "stretch", lambda *_: None)
    inside = 0
    with ctx.workprec(240):
        for count, step in enumerate(
            half_swing_pieces(LinearSpring(Damping.of(law())), parse_real("9/10", "x").ball().mid(), arb(0))
        ):
            if step.begin > piece.begin:
                state = step.own(step.begin)
                with ctx.workprec(BITS):
                    assert all(map(arb.contains, piece.own(step.begin), state))
                    assert all(x.rel_accuracy_bits() > 40 for x in piece.own(step.begin))
                    inside += 1
            if count > 130 or inside > 5:
                break
    assert inside > 5


@pytest.mark.parametrize("law", ALL)
def test_the_motion_crosses_the_barriers_inwards_on_all_the_stretch(law):
    _, piece = creeping(law)
    strip = piece.strip
    with ctx.workprec(400):
        exact = Damping.of(law())
        for part in range(1, 12):
            log_w = (strip.least + (strip.starts[0].mid() - strip.least) * part / 12).mid()
            for curve, sign in ((strip.above, -1), (strip.below, 1)):
                w, (y, slope) = log_w.exp(), curve.place(log_w)
                with ctx.workprec(BITS):
                    assert slope > 0
                rate = sign * (-1 - slope / w * (y - exact.resistance(w)) / w)
                assert rate.mid() > 0 or rate.contains(0)


@pytest.mark.parametrize("bits", [20, 30, 53, 90])
def test_no_speed_of_a_stretch_lies_beyond_the_one_on_which_its_sums_are_bounded(bits):
    """t <= 1 up to ln w = most, exactly: a centre rounded to the nearest lets every other stretch exceed it."""
    with ctx.workprec(bits):
        damping = Damping.of(of(("1/2", "1"), ("0.51", "1"))())
        stretches = [(grouped(damping, groups(damping), most).scale, most) for k in range(16) if (most := arb(k).exp())]
    with ctx.workprec(400):
        tops = [(most.upper() - scale.centre) / scale.reach for scale, most in stretches]
        assert all(arb(1) - arb(2) ** (4 - bits) * 2**20 < top <= 1 for top in tops)


@pytest.mark.parametrize("law", ALL[1:4])
def test_a_barrier_within_what_is_left_is_not_proved(law):
    with ctx.workprec(120):
        damping = Damping.of(law())
        laws = grouped(damping, groups(damping), arb("1e-3").log())
        b = {}
        extend(laws, b, lower_set(tuple(float(d.mid()) for d in laws.powers), 3))
        left = residual(laws, b)
        least = (left + 1.5 * laws.alpha * laws.lost) / laws.alpha
        assert one_way(laws, b, left, 4 * least)
        assert not one_way(laws, b, left, least)


@pytest.mark.parametrize("law", ALL[1:4])
def test_what_is_left_is_the_residual_of_the_curve(law):
    """At one w, from the derivatives of B itself: between a quarter of the bound and the bound."""
    with ctx.workprec(200):
        damping = Damping.of(law())
        laws = grouped(damping, groups(damping), arb("1e-3").log())
        b = {}
        extend(laws, b, lower_set(tuple(float(d.mid()) for d in laws.powers), 4))
        found = []
        for share in ("0.999", "0.9", "0.5", "0"):
            log_w = laws.scale.centre + laws.scale.reach * arb(share)
            t = laws.scale.t(log_w)
            terms = [(p, key, 1) for key, p in laws.parts.items()] + [(p, key, -1) for key, p in b.items()]
            A = sum((s * laws.slope(p, k)(t) * (laws.exponent(k) * log_w).exp() for p, k, s in terms), arb(0))
            B = sum((p(t) * (laws.exponent(k) * log_w).exp() for k, p in b.items()), arb(0))
            found.append(abs(A * B - (laws.powers[0] * log_w).exp() / laws.epsilon**2))
        bound = residual(laws, b)
        assert all(x < bound for x in found) and found[0] > bound / 4


def test_what_is_cut_off_the_sums_is_bounded(monkeypatch):
    """After t^3, at the end of the stretch: less than the bound, and more than half of it."""
    monkeypatch.setattr(near_equal_exponents, "_degree", lambda _: 3)
    with ctx.workprec(200):
        damping = Damping.of(LAWS["a third twice beside a square"]())
        laws = grouped(damping, groups(damping), arb("1e-3").log())
        for t in (-1, arb("0.3"), 1):
            log_w = laws.scale.centre + laws.scale.reach * t
            size = laws.epsilon * (damping.exponents[0] * log_w).exp()
            kept = sum((p(arb(t)) * (laws.exponent(key) * log_w).exp() for key, p in laws.parts.items()), arb(0))
            off = abs(damping.resistance(log_w.exp()) / size - kept)
            assert off < laws.lost
        assert off > laws.lost / 2 and laws.size(arb_poly([1, -2]), (0, 0)) >= 3


def entered(law=LAWS["a root and a little more"], error="1e-12"):
    """A state on the curve that B begins with, its error, and the strip that it enters."""
    damping, y = Damping.of(law()), arb("0.001")
    w = solve(lambda v: (damping.resistance(v.exp()) - v.exp() ** 2, damping.resistance(v.exp())), y, arb(-14)).exp()
    w = w.mid()
    y, error = (damping.resistance(w) * (1 - w / 2)).mid(), arb(error)
    return damping, (y, w, error), stretch(damping, y, w, error)


@pytest.mark.parametrize("error", ["1e-14", "1e-13", "1e-12", "1e-11", "1e-10", "1e-9", "1e-8"])
def test_every_state_that_enters_lies_between_the_barriers(error):
    with ctx.workprec(100):
        damping, (y, w, error), strip = entered(error=error)
        for dy, dw in product((-1, 1), repeat=2):
            log_w = (w + dw * error).log()
            assert strip.below.place(log_w)[0] < y + dy * error < strip.above.place(log_w)[0]
        high, low = (curve.place(at)[0] for curve, at in zip((strip.above, strip.below), strip.starts))
        assert high.contains(y + error) and low.contains(y - error)
        epsilon = sum(e * (a - damping.exponents[0]) * 0 + e for e, a in zip(damping.strengths, damping.exponents))
        parts = [curve.parts[-1][0][0] for curve in (strip.above, strip.below)]
        assert strip.share > arb("0.9") * 4 * (parts[0] - parts[1]) / 2 / epsilon / damping.exponents[0]


def test_a_stretch_ends():
    with ctx.workprec(100):
        _, _, strip = entered()
        assert strip.holds(strip.least + 1) and not strip.holds(strip.least - 1) and not strip.holds(strip.most + 1)
        strip.state(strip.length)
        with pytest.raises(UndecidedError):
            strip.state(2 * strip.length)


def test_a_curve_that_is_not_checked_where_it_starts_is_none():
    with ctx.workprec(100):
        damping, (y, w, error), _ = entered()
        for shift, found in ((0, True), (-1, False)):
            laws = grouped(damping, groups(damping), (arb("1.01") * w).log() + shift)
            b = {}
            extend(laws, b, lower_set(tuple(float(d.mid()) for d in laws.powers), 3))
            strip = near_equal_exponents._between(laws, (b, residual(laws, b)), (damping, y, w, error), arb(1))
            assert (strip is not None) is found


def test_the_slope_of_the_curve_is_at_least_half_of_that_of_the_law():
    """alpha = 1/2 and B = b w on a stretch: 3/2 b w < 1/4."""
    with ctx.workprec(60):
        scale = near_equal_exponents.Scale(arb(0), arb(1))
        laws = near_equal_exponents.Grouped(scale, arb(0), arb(1), arb("0.5"), (arb(1),), {(0,): arb_poly([1])}, arb(0))
        for b, holds in (("0.166", True), ("0.168", False)):
            assert one_way(laws, {(1,): arb_poly([arb(b)])}, arb(0), arb("1e-9")) is holds


def test_the_time_where_no_exponent_is_small():
    scale = near_equal_exponents.Scale(arb(0), arb(8))
    assert near_equal_exponents._integral(arb_poly([1, 2]), arb(1), scale)[0].overlaps(1 - arb(2) / 8)


@pytest.mark.parametrize("d", ["0", "1/64", "-1/64", "1e-10", "-1e-30"])
def test_the_time_where_an_exponent_is_0_or_small(d):
    """q(t) e^(d r t) from 0 to t is the integral of p(t) e^(d r t) r, by mpmath, to nearly all bits."""
    scale, p = near_equal_exponents.Scale(arb(0), arb(8)), [3, -1, 2]
    with ctx.workprec(BITS), mpmath.workdps(50):
        d = parse_real(d, "d").ball()
        q = near_equal_exponents._integral(arb_poly(p), d, scale)
        rate = mpmath.mpf(str((8 * d).mid().str(45, radius=False)))
        for t in (-1, -0.3, 1):
            exact = mpmath.quad(lambda x: 8 * mpmath.polyval(p[::-1], x) * mpmath.exp(rate * x), [0, t])
            found = q(arb(t)) * (8 * d * arb(t)).exp()
            assert abs(found - arb(mpmath.nstr(exact, 45))) < arb(2) ** (12 - BITS) and found.rad() < arb(2) ** (
                12 - BITS
            )
            assert (found - arb(mpmath.nstr(exact, 45))).overlaps(arb(0, 1e-40))


@pytest.mark.parametrize("d", ["1/64", "-1/64"])
def test_what_a_time_leaves_out_is_bounded(d, monkeypatch):
    """With as many powers as p has: less than the bound, and more than half of it."""
    monkeypatch.setattr(near_equal_exponents, "_more", lambda *_: 0)
    scale, n = near_equal_exponents.Scale(arb(0), arb(8)), 6
    with ctx.workprec(BITS):
        d = parse_real(d, "d").ball()
        monomial = arb_poly([0] * (n - 1) + [1])
        short = near_equal_exponents._integral(monomial, d, scale)
        monkeypatch.setattr(near_equal_exponents, "_more", lambda *_: 40)
        long = near_equal_exponents._integral(monomial, d, scale)
        off, bound = abs(long(arb(1)) - arb_poly([0, *short.coeffs()[1:]])(arb(1))), arb(short[0].rad())
        assert off < bound and off > bound / 2


@pytest.mark.parametrize("law", ALL)
def test_a_ladder_of_precisions(law):
    bits = 60
    (_, piece), (_, sharper) = creeping(law, bits), creeping(law, 2 * bits)
    begin, last = piece.begin.max(sharper.begin), piece.end.min(sharper.end).min(arb(10) ** 30)
    for share in ("0.001", "0.1", "0.9"):
        time = (begin + (last - begin) * arb(share)).mid()
        with ctx.workprec(2 * bits):
            exact = sharper.own(time)
        with ctx.workprec(bits):
            found = piece.own(time)
            assert all(map(arb.contains, found, exact))
            assert found[0].rad() < abs(found[0]) * arb(2) ** (40 - bits)


def test_the_stretches_join():
    """A time that needs several stretches: as by the law's own slow curve, where the exponents are far enough apart."""
    with ctx.workprec(BITS):
        law = Damping.of(of(("1/2", "2"), ("0.55", "1"))())
        pieces = [
            p
            for p, _ in zip(
                half_swing_pieces(LinearSpring(law), parse_real("9/10", "x").ball().mid(), arb(0)), range(110)
            )
        ]
        stretches = [p for p in pieces if isinstance(getattr(p, "strip", None), FencedStretch)]
        assert len(stretches) > 2
        for before, after in pairwise(p for p in pieces if not isinstance(p, Creep) or p in stretches):
            if before.end == after.begin:
                apart = zip(before.own(before.end), after.own(after.begin))
                assert all((x + arb(0, before.error)).overlaps(z + arb(0, after.error)) for x, z in apart)


def test_one_law_alone_and_laws_far_apart_have_no_stretch():
    with ctx.workprec(BITS):
        for law in (of(("1/2", "1")), of(("1/2", "1"), ("1", "1")), of(("3/2", "1"), ("1.5000001", "1"))):
            assert stretch(Damping.of(law()), arb("0.01"), arb("0.0001"), arb("1e-20")) is None
