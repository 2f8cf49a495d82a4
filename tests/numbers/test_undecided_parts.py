"""Conditions of exact and certified answers that every ordinary call meets: each refused where it fails."""

from fractions import Fraction
from types import SimpleNamespace

import pytest
from flint import arb, ctx, fmpq_poly

from asymptotics.envelopes import certified
from asymptotics.errors import UndecidedError
from asymptotics.expansions.half_swings.certified_zeros import is_pure_at
from asymptotics.flow.wells.expansion import WellExpansion
from asymptotics.flow.wells.force import WellForce
from asymptotics.law import Law
from asymptotics.limit_cycles.series import _positive_roots
from asymptotics.motions import quadratic
from asymptotics.numbers.exact import ExactReal
from asymptotics.turning.routes.dry import _first_amplitude


def test_an_inversion_that_fails_says_all_that_is_known(monkeypatch):
    monkeypatch.setattr(certified, "_inverse", lambda *_: None)
    laws = [(ExactReal(1), arb(1)), (ExactReal(2), arb(1))]
    found = certified.amplitude(laws, arb(1))
    assert found.contains(arb(0)) and found.contains(arb(1))


def test_a_double_root_of_the_balance_has_no_series():
    assert _positive_roots(fmpq_poly([-2, 1])) == [2]
    with pytest.raises(UndecidedError, match="double root"):
        _positive_roots(fmpq_poly([4, -4, 1]))


def test_a_force_that_is_no_loss_of_the_velocity_is_not_pure():
    def forces(sign, weight):
        return SimpleNamespace(signs=(sign,), weights=(ExactReal(weight),), velocities=(ExactReal(2),))

    assert is_pure_at(forces(-1, 1), (1,))
    assert not is_pure_at(forces(1, 1), (1,)) and not is_pure_at(forces(-1, 2), (1,))


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


def test_a_start_that_dry_friction_holds_has_no_first_amplitude():
    """R = 1/2 about the shifted place of rest, and the friction is 1/2."""
    speed = ExactReal(Fraction(3, 10))

    def request(c, x0):
        return SimpleNamespace(alone=(0, ExactReal(c)), place=ExactReal(x0), speed=speed)

    assert _first_amplitude(request(Fraction(1, 2), Fraction(-9, 10))) is None
    assert _first_amplitude(request(Fraction(1, 10), Fraction(-1, 2))) == Fraction(4, 10)


def test_a_force_sorts_its_terms_and_is_as_strong_as_all_of_them():
    """Losses, springs that harden or soften, and which loss is linear."""
    with ctx.workprec(60):
        force = WellForce.of(Law({2: "1/2", 1: "1/3", "1/2": 1}, spring={3: "-1/4"}).terms)
        assert len(force.losses) == 3 and len(force.springs) == 1 and not force.grips
        assert force.viscous.overlaps(arb(1) / 3) and force.viscous < arb("0.34")
        assert force.strongest(arb(1), arb(1)) >= arb("0.75") + arb("1.8333")


def test_an_expansion_begins_where_the_mass_moves():
    with ctx.workprec(60):
        force = WellForce.of(Law({0: "1/2", 2: 1}, spring={3: 1}).terms)
        assert WellExpansion.at(force, arb(1)).reach > 0
        with pytest.raises(UndecidedError, match="holds the mass here"):
            WellExpansion.at(force, arb(0, "0.9"))
