"""Products that grow by blocks: against the whole product of polynomials, and in the coefficients of a Taylor step."""

import pytest
from flint import arb, arb_poly, ctx, fmpz, fmpz_poly

from asymptotics.flow import growing_product, taylor
from asymptotics.flow.growing_product import GrowingProduct, block_for
from asymptotics.flow.taylor import GUARD, TaylorStep, coefficients, order_for
from tests.each import each
from tests.flow.forces import FORCES


def grown(A, B, block, kind=GrowingProduct):
    """The product of lists that are handed over one coefficient after the other."""
    a, b = [], []
    product, found = kind(a, b, len(A), block), []
    for x, y in zip(A, B):
        a.append(x)
        b.append(y)
        found.append(product.last())
    return found


@each("block", [1, 2, 3, 7, 20, 50])
@each("order", [1, 6, 20, 41])
def test_every_pair_is_in_the_product_once(order, block):
    """Whole numbers so large that no pair is missed or counted twice without a trace."""
    a, b = ([fmpz(10) ** (20 * k + shift) + k for k in range(order)] for shift in (3, 11))
    whole = (fmpz_poly(a) * fmpz_poly(b)).coeffs()[:order]
    with ctx.workprec(20000):
        assert [c.unique_fmpz() for c in grown(list(map(arb, a)), list(map(arb, b)), block)] == whole


def test_wide_balls_give_balls_that_hold_every_product():
    """Factors at the ends of their balls; what forgets the older blocks does not hold their product."""
    a, b = ([arb(k + s).sqrt() + arb(0, 0.01) for k in range(30)] for s in (2, 5))
    ends = [[x.upper() if k % 2 else x.lower() for k, x in enumerate(c)] for c in (a, b)]
    inside = (arb_poly(ends[0]) * arb_poly(ends[1])).coeffs()
    assert all(x.contains(y) and x.rad() < 5 for x, y in zip(grown(a, b, 6), inside))

    class Forgets(GrowingProduct):
        def _complete(self):
            self.later = arb_poly([])
            super()._complete()

    lost = grown(a, b, 6, Forgets)
    assert lost[17].contains(inside[17]) and not any(lost[k].overlaps(inside[k]) for k in (18, 20, 24, 29))


@pytest.mark.parametrize("name", ["sum", "place"])
def test_blocks_and_sums_give_the_same_coefficients(name, monkeypatch):
    """Two orders of summation at 160 bits, both about those of 500; a strength that is off by 2^-90 is noticed."""
    u, w, order = arb("0.5"), arb("0.75"), order_for(160)

    def found(bits, block, off=0):
        monkeypatch.setattr(growing_product, "block_for", block)
        monkeypatch.setattr(taylor, "block_for", block)
        with ctx.workprec(bits):
            pairs = coefficients(Stronger(FORCES[name], off), u, w, order)
        return [c for part in pairs for c in part]

    blocks, sums = found(160, block_for), found(160, lambda order: order)
    truth, near = found(500, lambda order: order), found(500, lambda order: order, arb(2) ** -90)
    assert block_for(order) < order / 5
    assert all(x.overlaps(y) and x.overlaps(z) and y.overlaps(z) for x, y, z in zip(blocks, sums, truth))
    assert not all(x.overlaps(y) for x, y in zip(blocks, near))


class Stronger:
    """A force whose losses are a little stronger."""

    def __init__(self, force, share):
        self.force, self.share = force, share

    def __getattr__(self, name):
        return getattr(self.force, name)

    def loss_powers(self, side):
        return [(d * (1 + self.share), m, a) for d, m, a in self.force.loss_powers(side)]


@pytest.mark.parametrize("bits", [300, 600])
def test_fewer_bits_for_later_coefficients_cost_the_state_none(bits, monkeypatch):
    """What they round off stays below a unit of the last place; of twice as many bits fewer it does not."""

    def widest():
        with ctx.workprec(bits):
            step = TaylorStep.at(FORCES["sum"], arb("0.5"), arb("0.75"), arb(1), arb(1))
        with ctx.workprec(bits + GUARD):
            return max((x.rad() for x in step.state(step.length)), key=float) * arb(2) ** bits, step.ws[-1]

    (rad, last), usual = widest(), taylor._bits_for
    # The second half has the bits of its first coefficient.
    assert rad < arb(2) ** -10 and last.rel_accuracy_bits() < bits / 2 + GUARD
    monkeypatch.setattr(taylor, "_bits_for", lambda k, order, full: max(GUARD, 2 * usual(k, order, full) - full))
    assert widest()[0] > 1


def test_a_block_is_as_long_as_there_are_blocks():
    assert [block_for(n) for n in (1, 39, 59, 60, 132, 426)] == [1, 39, 59, 8, 12, 21]
