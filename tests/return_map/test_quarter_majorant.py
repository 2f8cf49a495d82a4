"""Quarter-swings at complex strengths: below the bounds, not far below, and the bounds end where the motion does."""

import numpy as np
import pytest
from flint import arb
from scipy.integrate import solve_ivp

from asymptotics.expansions.half_swings.finite_majorant import majorant
from asymptotics.return_map import quarter_majorant as module
from asymptotics.return_map.quarter_majorant import quarter_majorant

LAWS = {
    "3/2": ([1.5], [1.0]),
    "2": ([2.0], [1.2]),
    "5": ([5.0], [0.45]),
    "1 and 2": ([1.0, 2.0], [0.4, 0.7]),
    "3/2 and 3": ([1.5, 3.0], [0.3, 0.5]),
}


def bound_of(name, share=1.0):
    alphas, radii = LAWS[name]
    return quarter_majorant([arb(a) for a in alphas], [arb(r * share) for r in radii])


def complex_quarter(alphas, deltas, end=np.pi / 2):
    """(R, T_q - the angle) at complex strengths by an ordinary integrator."""

    def slope(t, state):
        load = sum(d * np.exp((a - 1) * state[0]) * np.sin(t) ** a for a, d in zip(alphas, deltas, strict=True))
        room = 1 - load * np.cos(t)
        return [-load * np.sin(t) / room, 1 / room - 1]

    return solve_ivp(slope, (0, end), [0j, 0j], rtol=1e-9, atol=1e-10).y[:, -1]


@pytest.mark.parametrize("name", LAWS)
def test_quarter_swings_at_complex_strengths_obey_the_bounds_and_not_half_of_them(name):
    alphas, radii = LAWS[name]
    bound, largest = bound_of(name, 0.5), [0.0, 0.0]
    for angle in np.linspace(0, np.pi, 9):
        for other in np.linspace(0, 2 * np.pi, 9)[: 9 if len(alphas) > 1 else 1]:
            turns = [angle, angle + other][: len(alphas)]
            deltas = [r / 2 * np.exp(1j * turn) for r, turn in zip(radii, turns, strict=True)]
            seen = np.abs(complex_quarter(alphas, deltas))
            largest = [max(pair) for pair in zip(largest, seen, strict=True)]
    for seen, limit in zip(largest, (bound.growth, bound.excess), strict=True):
        assert seen < float(limit) < 2 * seen


@pytest.mark.parametrize("name", LAWS)
def test_the_real_part_grows_most_backwards_in_time(name):
    """No complex strengths of these sizes let r grow more than those of -rho."""
    alphas, radii = LAWS[name]
    backwards = complex_quarter(alphas, [-r for r in radii])[0].real
    others = [
        complex_quarter(alphas, [r * np.exp(1j * (np.pi + k * turn)) for k, r in enumerate(radii, 1)])[0].real
        for turn in np.linspace(0.2, 3, 12)
    ]
    assert max(others) < backwards


def swell(alpha, rho, monkeypatch):
    """H at the end of each piece."""
    found, honest = [], module._Piece.end
    monkeypatch.setattr(module._Piece, "end", lambda *given: found.append(honest(*given)) or found[-1])
    assert quarter_majorant([arb(alpha)], [arb(rho)]) is not None
    monkeypatch.undo()
    return [float(h) for h in found]


@pytest.mark.parametrize(("alpha", "rho"), [(1.5, 1.0), (1.5, 1.9), (2.0, 1.2), (3.0, 0.8)])
def test_H_is_above_the_quarter_swing_backwards_and_not_far_above(alpha, rho, monkeypatch):
    found = swell(alpha, rho, monkeypatch)
    for j in (31, 127, 255):
        truth = complex_quarter([alpha], [-rho], np.pi / 2 * (j + 1) / module.PIECES)[0].real
        assert truth < found[j] < 1.1 * truth


def test_there_is_no_bound_where_polar_coordinates_end():
    """At the radius 2.2 of 3/2 some C reaches 1; by the modulus no more than 1.08 is seen."""
    assert quarter_majorant([arb("1.5")], [arb("2.2")]) is None
    assert quarter_majorant([arb("1.5")], [arb(2)]) is not None
    assert majorant([arb("1.5")], [arb("1.1")]) is None


@pytest.mark.parametrize(("alpha", "rho"), [(1.5, 1.0), (2.0, 0.8), (4.0, 0.3)])
def test_the_inverse_of_the_strength_changes_by_the_gains_at_most_and_by_more_than_half(alpha, rho):
    """1/u - 1/delta = (alpha - 1) int s^(alpha+1)/(1 - C), largest at rho."""
    there = complex_quarter([alpha], [rho])[0].real
    changed = np.exp(-(alpha - 1) * there) / rho - 1 / rho
    most = (alpha - 1) * float(quarter_majorant([arb(alpha)], [arb(rho)]).gains[0])
    assert changed < most < 2 * changed


def test_an_exponent_below_one_is_refused():
    with pytest.raises(ValueError, match="below 1"):
        quarter_majorant([arb("0.99"), arb(2)], [arb("0.1"), arb("0.1")])


def test_an_end_is_proved_or_there_is_none():
    """The fixed point of h = length e^h: 0.1118 for 0.1, none for 0.4, as h e^-h <= 1/e."""
    piece = module._Piece((arb(1),), (arb(0),), arb(0))
    found = piece.end(arb(0), arb("0.1"), [arb(1)], [arb(1)])
    assert 0.1118 < found < 0.122 and (found / 2).exp() * 0.1 > found / 2
    assert piece.end(arb(0), arb("0.4"), [arb(1)], [arb(1)]) is None


def pieces(alpha):
    return module._pieces(((alpha.mid().man_exp(), alpha.rad().man_exp()),))


def test_the_factors_of_a_piece_are_the_worst_on_it():
    # The uncertain exponent may be nearly 1.49.
    for j, (piece, wide, worst) in enumerate(zip(*map(pieces, (arb("1.5"), arb("1.5", "0.01"), arb("1.4901"))))):
        at = np.pi / 2 * (j + np.linspace(0, 1, 21)[1:]) / module.PIECES
        s, c = np.sin(at), np.cos(at)
        assert max(s**2.5) <= float(piece.sines[0]) * (1 + 1e-12)
        assert max(s**1.5 * c) <= float(piece.products[0]) * (1 + 1e-12)
        assert float(piece.cot) <= min(c / s) + 1e-12
        assert wide.sines[0].upper() >= worst.sines[0] and wide.products[0].upper() >= worst.products[0]
