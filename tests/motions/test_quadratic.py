"""Quadratic drag."""

import pytest
from flint import arb, ctx

from asymptotics.errors import UndecidedError
from asymptotics.motions import quadratic


@pytest.mark.parametrize("side", [-1, 1])
def test_a_place_is_enclosed_from_both_sides_or_not_at_all(side, monkeypatch):
    """The time at the middle is right; on one side of it nothing is known."""
    middle = []

    def elapsed(_p, _q, chi):
        middle[:] = middle or [chi]
        return chi + arb(0, 9 if side * (chi - middle[0]) > 0 else 0)

    monkeypatch.setattr(quadratic, "elapsed", elapsed)
    with ctx.workprec(60), pytest.raises(UndecidedError, match="not enclosed"):
        quadratic._angle(arb("0.5"), arb("0.4"), arb.pi() / 2)
