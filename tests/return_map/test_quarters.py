"""Quarter-swings by collocation: closed forms are contained at every precision, every bound is held to its constant."""

from dataclasses import replace
from types import SimpleNamespace

import mpmath
import numpy as np
import pytest
from flint import arb, arb_mat, ctx, fmpq

from asymptotics.errors import UndecidedError
from asymptotics.flow.damping import Damping
from asymptotics.flow.linear_spring.expansion import TurningExpansion
from asymptotics.numbers.exact import parse_real
from asymptotics.return_map import hand_overs, quarters
from asymptotics.return_map.chebyshev import cut
from asymptotics.return_map.hand_overs import HAND_OVERS, Bundle, largest
from asymptotics.return_map.quarters import NodeGrid, Path, found, peak, quarter_swings
from asymptotics.return_map.spectral import analysis
from tests.flow.forces import by_strength
from tests.worlds import WORLDS


def damping(*pairs):
    with ctx.workprec(400):
        return Damping.of([(parse_real(e, "e").ball(), parse_real(a, "a")) for a, e in pairs])


def closed_form(alpha, delta):
    """(ln r, T) of the quarter at the signed strength delta: dry friction and linear damping; ln r for alpha = 2."""
    if alpha == "0":
        return (1 - 2 * delta).log() / 2, (-delta / (1 - delta)).acos()
    if alpha == "1":
        rate = (1 - delta**2 / 4).sqrt()
        time = (arb.pi() / 2 + (delta / (2 * rate)).atan()) / rate
        return -delta * time / 2, time
    square = (1 - (1 + 2 * delta) * (-2 * delta).exp()) / (2 * delta**2)  # w^2 where y = 0
    return square.log() / 2, None


@pytest.mark.parametrize("alpha", ["0", "1", "2"])
@pytest.mark.parametrize(("strength", "side"), [("1/7", 1), ("1/7", -1), ("1/1000", -1)])
def test_a_ladder_of_closed_forms(alpha, strength, side):
    law = damping((alpha, strength))
    with ctx.workprec(400):
        growth, time = closed_form(alpha, side * parse_real(strength, "e").ball())
    for bits in (8, 30, 53, 120):
        (quarter,) = quarter_swings([(law, side)], bits)
        assert quarter.ln_r.contains(growth) and (time is None or quarter.duration.contains(time)), bits
        assert max(quarter.ln_r.rad(), quarter.duration.rad()) < arb(2) ** (4 - bits)


def test_many_strengths_of_one_law_at_once_on_both_sides():
    laws = [(damping(("3", strength)), side) for strength in ("1/5", "1/50", "1/4000") for side in (1, -1)]
    together = quarter_swings(laws, 60)
    for law, one in zip(laws, together, strict=True):
        (sharp,) = quarter_swings([law], 130)
        assert one.ln_r.contains(sharp.ln_r) and one.duration.contains(sharp.duration)


@pytest.mark.parametrize("other", [(("3", "1/10"),), (("2", "1/10"), ("3", "0")), (("1", "1/10"), ("2", "1/10"))])
def test_laws_with_other_exponents_are_refused_unless_their_terms_vanish(other):
    """The columns share their exponents: one with a term more would be read without it."""
    laws = [(damping(("2", "1/10")), 1), (damping(*other), 1)]
    if other[-1][1] == "0":
        first, second = quarter_swings(laws, 40)
        assert first.ln_r.str(9) == second.ln_r.str(9)
    else:
        with pytest.raises(ValueError, match="different exponents"):
            quarter_swings(laws, 40)


# The bounds, each against an evaluation that shares nothing with it.

SIDES = {  # worlds, and whether the quarter is before or after the passage
    "another rational power": 1, "a sum of powers": -1, "cubic": 1, "dry friction beside a root": 1,
}  # fmt: skip
LAWS = {name: (WORLDS[name].pairs, side) for name, side in SIDES.items()}


def bundle_of(pairs, side, bits=60):
    with ctx.workprec(bits + 24):
        return Bundle.of([(damping(*pairs), side)])


def path_of(law, count, bits=60):
    with ctx.workprec(bits + 24):
        grid = NodeGrid.of(bundle_of(*law, bits=bits), count)
        return Path.along(grid, found(grid, bits))


def sampled(path, rim, count=60):
    """(|f|, |d tau/dt|, |c D|) on the rim by mpmath; G from its values in doubles."""
    bundle, in_doubles = path.grid.bundle, path.grid.bundle.in_doubles
    g = in_doubles.solved(path.grid.count)[:, 0]
    angles = np.pi * (2 * np.arange(len(g)) + 1) / (2 * len(g))
    b = [(1 + (k > 0)) / len(g) * np.sum(g * np.cos(k * angles)) for k in range(24)]
    terms = [(float(a.mid()), float(e.mid())) for a, e in zip(bundle.alphas, bundle.strengths[0], strict=True)]
    h, seen = float(bundle.h[0].mid()), []
    for angle in np.linspace(0, np.pi, count):
        u = rim * mpmath.expj(angle)
        s, c = (lambda z: (1 / mpmath.cosh(z), -mpmath.tanh(z)))(h * ((u + 1 / u) / 2 - 1))
        G = sum(x * (u**k + u**-k) / 2 for k, x in enumerate(b))
        drag = sum(e * s**a * mpmath.exp((a - 1) * G) for a, e in terms)
        seen.append([abs(x) for x in (h * s * s * drag / (1 - c * drag), h * s / (1 - c * drag), c * drag)])
    return [float(max(column)) for column in zip(*seen, strict=True)]


@pytest.mark.parametrize("law", LAWS.values(), ids=LAWS)
def test_the_bounds_on_the_ellipse(law):
    """The largest |f| and |d tau/dt| on the rim: the bounds exceed them by less than a factor of 3."""
    path = path_of(law, 40)
    with ctx.workprec(53):
        fast, slow = path.on_ellipse(arb("1.5"))
    truly_fast, truly_slow, _ = sampled(path, 1.5)
    assert truly_fast <= float(fast) <= 3 * truly_fast and truly_slow <= float(slow) <= 3 * truly_slow


def test_the_largest_ellipse_is_free_of_singularities():
    """|c D| < 1 on the last rim that is accepted; a little further out it is not, and Im z passes pi/2 elsewhere."""
    path, free = path_of(LAWS["cubic"], 40), path_of(((("2", "1/100000"),), 1), 40)
    with ctx.workprec(53):
        rims = [arb(1) + arb(k) / 20 for k in range(1, 60)]
        last, other = (float(max(R for R in rims if p.on_ellipse(R) is not None)) for p in (path, free))
    assert sampled(path, last)[2] < 1 < sampled(path, last + 0.4)[2]
    height = float(free.grid.bundle.h[0].mid()) * (other - 1 / other) / 2
    assert 1.4 < height < np.pi / 2


@pytest.mark.parametrize("alpha", [0.0, 0.5, 1.0, 3.0])
def test_the_peak_is_attained(alpha):
    seen = max(np.sin(t) ** alpha * np.cos(t) for t in np.linspace(0, np.pi / 2, 20001))
    assert seen <= float(peak(arb(alpha)).upper()) <= seen * (1 + 1e-6)


@pytest.mark.parametrize("law", LAWS.values(), ids=LAWS)
def test_the_error_is_made_of_its_parts(law):
    """Few nodes: e^K (start + 2 eta), K = sum |alpha_i - 1| drag_i/(1 - kappa)^2, and for the time K of it."""
    path, rim = path_of(law, 40), 1.6
    bundle, m = path.grid.bundle, path.grid.count
    (quarter,) = path.enclosed(rim)
    with ctx.workprec(53):
        fast, slow = path.on_ellipse(arb(rim))
        eta, time_cut = float(cut(fast, arb(rim), m) + path.differs), float(2 * cut(slow, arb(rim), m))
        drags = [float(d) for d in path.drags((path.sizes(arb(1)) + arb(2) ** -20).upper())]
    alphas = [float(a.mid()) for a in bundle.alphas]
    full = sum(d * float(peak(arb(a)).mid()) for d, a in zip(drags, alphas, strict=True))
    slope = sum(abs(a - 1) * d for d, a in zip(drags, alphas, strict=True))
    K = slope / (1 - full) ** 2
    off = np.exp(K) * 2 * eta
    assert float(quarter.ln_r.rad()) == pytest.approx(off, rel=1e-5)
    assert float(quarter.duration.rad()) == pytest.approx(time_cut + K * off, rel=1e-5)
    (sharp,) = quarter_swings([(damping(*law[0]), law[1])], 90)
    assert quarter.ln_r.contains(sharp.ln_r) and quarter.duration.contains(sharp.duration)


@pytest.mark.parametrize("law", LAWS.values(), ids=LAWS)
def test_a_hand_over_that_is_off_enters_by_its_own_rates(law):
    """(start + 2 eta) e^K and dz/(1 - kappa) more of the time, the start dg + dz sum drag_i/(1 - kappa)."""
    rim, dz, dg = 1.6, 2.0**-26, 2.0**-27
    exact = path_of(law, 40)
    bundle = replace(exact.grid.bundle, dz=arb(dz), dg=arb(dg))
    off = replace(exact, grid=replace(exact.grid, bundle=bundle))
    (quarter,), (sharp,) = off.enclosed(rim), exact.enclosed(rim)
    with ctx.workprec(53):
        drags = [float(d) for d in exact.drags((exact.sizes(arb(1)) + arb(2) ** -20).upper())]
    alphas = [float(a.mid()) for a in bundle.alphas]
    kappa = sum(d * float(peak(arb(a)).mid()) for d, a in zip(drags, alphas, strict=True))
    assert 0.01 < kappa < 0.9
    slope = sum(abs(a - 1) * d for d, a in zip(drags, alphas, strict=True))
    K = slope / (1 - kappa) ** 2
    start = dg + dz * sum(drags) / (1 - kappa)
    apart = float(quarter.ln_r.rad()) - float(sharp.ln_r.rad())
    assert apart == pytest.approx(np.exp(K) * start, rel=1e-5)
    late = float(quarter.duration.rad()) - float(sharp.duration.rad())
    assert late == pytest.approx(K * apart + dz / (1 - kappa), rel=1e-5)


def test_the_drags_are_those_on_the_orbit():
    """max |delta e^((alpha-1) g)| over a backward orbit, where g grows from 0 to ln r: at most a tenth more."""
    path = path_of(((("3/2", "1/5"),), -1), 40)
    with ctx.workprec(53):
        (load,) = path.drags(path.sizes(arb(1)))
    seen = 0.2 * np.exp(0.5 * float(path.ends[0].mid()))
    assert seen <= float(load) <= 1.1 * seen


def test_a_start_that_is_off_is_paid_for():
    """Nearly without damping g is off by as much at the end, and half of the bound is refuted."""
    e, weak = arb(2) ** -24, ((("2", "1/100000"),), 1)
    bundle = bundle_of(*weak)
    with ctx.workprec(84):
        grid = NodeGrid.of(replace(bundle, g0=(bundle.g0[0] + e,), dg=e), 60)
        (wide,) = Path.along(grid, found(grid, 50)).enclosed(1.5)
        missing = abs(wide.ln_r.mid() - quarter_swings([(damping(*weak[0]), 1)], 80)[0].ln_r)
        assert missing <= wide.ln_r.rad() and wide.ln_r.rad() / 2 < missing


def test_a_late_start_is_paid_for():
    """z_0 off by e: the time is off by less than e/(1 - kappa), g by less than e times the drags."""
    e, law = arb(2) ** -24, ((("3/2", "1/5"),), 1)
    bundle = bundle_of(*law)
    with ctx.workprec(84):
        grid = NodeGrid.of(replace(bundle, h=(bundle.h[0] + e / 2,), dz=e), 60)
        (wide,) = Path.along(grid, found(grid, 50)).enclosed(1.5)
        (sharp,) = quarter_swings([(damping(*law[0]), 1)], 80)
        assert wide.ln_r.contains(sharp.ln_r) and wide.duration.contains(sharp.duration)
        assert e <= wide.duration.rad() <= 1.2 * e + 2 * wide.ln_r.rad() and wide.ln_r.rad() <= e / 2


def test_rates_that_are_off_are_seen():
    """P off by e at one node: differs = sqrt(2m - 1) e; what that does to the end is within the radius."""
    e = arb(2) ** -26
    with ctx.workprec(84):
        grid = NodeGrid.of(bundle_of((("2", "1/100000"),), 1), 30)
        exact = found(grid, 60)
        rates = exact.table()
        rates[7][0] += e
        off, right = Path.along(grid, arb_mat(rates)), Path.along(grid, exact)
        assert e * arb(59).sqrt() <= off.differs * arb("1.001") and off.differs <= e * arb(59).sqrt() * arb("1.001")
        assert 0 < abs(off.ends[0] - right.ends[0]) < off.enclosed(1.5)[0].ln_r.rad()
        # e^K is 1 for so weak a loss: eta counts twice, and all that P differs by is in it.
        more = off.enclosed(1.5)[0].ln_r.rad() - right.enclosed(1.5)[0].ln_r.rad()
        assert float(more) == pytest.approx(float(2 * e * arb(59).sqrt()), rel=1e-2)


def test_uncertain_coefficients_count():
    """P is the polynomial of the midpoints: the radius of every kept coefficient is in what it differs by."""
    e, m = 2.0**-40, 30
    with ctx.workprec(84):
        grid = NodeGrid.of(bundle_of((("2", "1/100000"),), 1), m)
        exact = found(grid, 60)
        wide = Path.along(grid, arb_mat([[x + arb(0, e)] for (x,) in exact.table()]))
        radii = [float(row[0].rad()) for row in (analysis(m, 84) * arb_mat(m, 1, [arb(0, e)] * m)).table()]
    assert all(0.5 * e < r < 2 * e for r in radii)
    at_nodes = float(arb(2 * m - 1).sqrt()) * e
    assert float(wide.differs) == pytest.approx(at_nodes + sum(radii[: wide.sizes.degree()]), rel=1e-2)


def test_coefficients_that_are_dropped_count():
    """At 30 bits the last coefficients of P are dropped as negligible: their sum is in what P differs by."""
    with ctx.workprec(54):
        grid = NodeGrid.of(bundle_of((("3/2", "1/5"),), 1, bits=30), 60)
        rates = found(grid, 30)
        path = Path.along(grid, rates)
        b = [abs(float(row[0].mid())) for row in (analysis(60, 54) * rates).table()]
    kept = path.sizes.degree()
    assert 10 < kept < 60 and 0 < sum(b[kept:]) <= min(float(path.differs), 2.0**-30) < sum(b[kept - 1 :])


def test_largest_is_an_upper_bound():
    with ctx.workprec(200):
        values = [arb(1) / 3, -(arb(2) / 3), arb(1) / 7 + arb(0, arb(1) / 10)]
        assert abs(values[1]) <= largest(values) and largest(values) < arb("0.6667")


def test_an_exponent_that_no_ball_tells_from_1_counts(bits=40):
    """1 + 10^-40 in 64 bits: as exactly 1, and not as no loss at all."""
    with ctx.workprec(bits + 24):
        near, linear = (Damping.of([(arb(1), parse_real(a, "a"))]) for a in ("1." + 39 * "0" + "1", "1"))
        assert near.exponents[0].contains(1)
        (one, back), (other, _) = (quarter_swings([(law, 1), (law, -1)], bits) for law in (near, linear))
        angle = 2 * arb.pi() / 3  # tan(omega t) = -omega/(1/2)
        time = angle / (arb(3).sqrt() / 2)
    for quarter in (one, other):
        assert abs(quarter.duration - time) < 1e-11
        assert abs(quarter.ln_r + time / 2) < 1e-11
    assert abs(back.ln_r - time / 4) < 1e-11


@pytest.mark.parametrize("law", [(("3", "3"), -1), (("1000", "1/10"), 1), (("0", "2"), 1)])
def test_what_is_out_of_reach_is_undecided(law):
    pair, side = law
    with pytest.raises(UndecidedError):
        quarter_swings([(damping(pair), side)], 60)


def test_a_hand_over_behind_the_centre_is_undecided(monkeypatch):
    fake = SimpleNamespace(state=lambda _w: (arb("-0.1"), arb(1)))
    monkeypatch.setattr(hand_overs, "TurningExpansion", SimpleNamespace(at=lambda *_: fake))
    with ctx.workprec(60), pytest.raises(UndecidedError, match="hand-over"):
        Bundle.of([(by_strength(("1/10", "2")), 1)])


def test_a_hand_over_is_late_by_twice_what_half_of_its_place_is_off():
    with ctx.workprec(40):
        law, w = by_strength(("1/10", "2")), arb(HAND_OVERS[0])
        y, _ = TurningExpansion.at(law, arb(1), w).state(w)
        place = ((y * y + w * w).sqrt() + y) / w
        assert Bundle.of([(law, 1)]).dz >= place.log().rad() > 0


def test_the_arcs_of_the_ellipse_leave_no_gap(monkeypatch):
    """From the angle 0 to pi."""
    path, arcs = path_of(LAWS["another rational power"], 40), []

    class Recording:
        pi, union, sin_pi = staticmethod(arb.pi), staticmethod(arb.union), staticmethod(arb.sin_pi)

        def __call__(self, *given):
            return arb(*given)

        def cos_pi(self, angle):
            arcs.append((angle.lower(), angle.upper()))
            return angle.cos_pi()

    monkeypatch.setattr(quarters, "arb", Recording())
    with ctx.workprec(53):
        path.on_ellipse(arb("1.5"))
    assert arcs[0][0] <= 0 and arcs[-1][1] >= 1
    assert all(high >= low for (_, high), (low, _) in zip(arcs, arcs[1:]))


def test_the_load_on_the_ellipse_is_counted_whole():
    """One law: |f| is at most h max |s^2 D|/(1 - kappa), where kappa is at least |c D| at a place of the rim."""
    path, rim = path_of(LAWS["cubic"], 40), arb("1.5")
    with ctx.workprec(53):
        fast, slow = path.on_ellipse(rim)
        drags = path.drags((path.sizes(rim) + path.sizes(1 / rim)) / 2)
        h, (a, b) = path.grid.bundle.h[0], ((rim + 1 / rim) / 2, (rim - 1 / rim) / 2)
        load, slowest = arb(0), arb(0)
        for k in range(257):
            angle = arb(fmpq(k, 256))
            x, y = h * (a * angle.cos_pi() - 1), h * b * angle.sin_pi()
            under = x.sinh() ** 2 + y.cos() ** 2
            drag = sum((d * under ** (-e / 2) for d, e in zip(drags, path.grid.bundle.alphas)), arb(0))
            load = load.max(drag * ((x.sinh() ** 2 + y.sin() ** 2) / under).sqrt())
            slowest = slowest.max(h / under.sqrt())
        assert slow >= slowest / (1 - load) * arb("0.9999") and fast > 0


def test_strengths_beyond_polar_coordinates_are_undecided(monkeypatch):
    path = path_of(LAWS["cubic"], 40)
    monkeypatch.setattr(Path, "on_ellipse", lambda *_: (arb(1), arb(1)))
    with pytest.raises(UndecidedError, match="too large for polar"):
        replace(path, loads=tuple(1000 * load for load in path.loads)).enclosed(1.5)
