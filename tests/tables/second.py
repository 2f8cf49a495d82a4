"""The half-swing a second time, in doubles, by a route of its own: integrals over theta by the double exponential rule.

    d ln r/d theta = - sum_i rho_i s^(alpha_i+1)/D,    d tau/d theta = 1/D,    D = 1 - sum_i rho_i s^alpha_i c,

rho_i = delta_i r^(alpha_i - 1), from 0 to pi in one go: no power series in 1 - cos theta, no reversal, no log C.  The
substitution theta = pi/(1 + e^(-pi sinh t)) makes the powers of s at both ends harmless, and the indefinite integrals
are Stenger's: F(t_j) = h sum_k f(t_k) (1/2 + Si(pi (j - k))/pi).

Series are dictionaries from multi-indices to numbers (or to arrays over the nodes).
"""

from functools import lru_cache
from itertools import product
from math import factorial, pi

import numpy as np
from scipy.special import sici

_STEP, _SIDE = 0.03125, 110
_T = _STEP * np.arange(-_SIDE, _SIDE + 1)
_LEFT, _RIGHT = pi / (1 + np.exp(-pi * np.sinh(_T))), pi / (1 + np.exp(pi * np.sinh(_T)))  # theta, pi - theta
SIN = np.sin(np.minimum(_LEFT, _RIGHT))
COS = np.where(_T < 0, np.cos(_LEFT), -np.cos(_RIGHT))
_WEIGHT = _STEP * _LEFT * _RIGHT * np.cosh(_T)
_PLACES = np.arange(len(_T))
_BEFORE = 0.5 + sici(pi * (_PLACES[:, None] - _PLACES[None, :]))[0] / pi


def whole(f):
    """The integral of f over theta from 0 to pi."""
    return float(np.sum(f * _WEIGHT))


def running(f):
    """The integral from 0, at every node."""
    return _BEFORE @ (f * _WEIGHT)


def times(f, g, order):
    """The product of two series."""
    found = {}
    for (m, a), (n, b) in product(f.items(), g.items()):
        if sum(m) + sum(n) <= order:
            key = tuple(map(sum, zip(m, n)))
            found[key] = found.get(key, 0) + a * b
    return found


def plus(*series):
    found = {}
    for f in series:
        for n, c in f.items():
            found[n] = found.get(n, 0) + c
    return found


def by(f, factor):
    return {n: c * factor for n, c in f.items()}


def exponential(f, order):
    """exp of a series without a constant."""
    total = power = {tuple(0 for _ in next(iter(f))): 1.0}
    for k in range(1, order + 1):
        power = by(times(power, f, order), 1 / k)
        total = plus(total, power)
    return total


@lru_cache
def half_swing(alphas, order):
    """The coefficients of L and T through ``order``."""
    zero = tuple(0 for _ in alphas)
    units = [tuple(int(i == j) for j in range(len(alphas))) for i in range(len(alphas))]
    ln_r = {units[0]: np.zeros_like(SIN)}
    for _ in range(order):  # each round is right to one order more
        rho = [times({unit: 1.0}, exponential(by(ln_r, a - 1), order), order) for a, unit in zip(alphas, units)]
        small = plus(*(by(r, SIN**a * COS) for a, r in zip(alphas, rho)))
        inverse = power = {zero: np.ones_like(SIN)}
        for _ in range(order):
            power = times(power, small, order)
            inverse = plus(inverse, power)
        rate = times(plus(*(by(r, -(SIN ** (a + 1))) for a, r in zip(alphas, rho))), inverse, order)
        ln_r = {n: running(c) for n, c in rate.items()}
    return {n: whole(c) for n, c in rate.items()}, {n: whole(c) for n, c in inverse.items()}


@lru_cache
def flow(alphas, order):
    """U and W: the flow d ln A/d psi = U, d tau/d psi = W that over psi = pi makes L and T; order by order."""
    L, T = half_swing(alphas, order)
    U, W = {}, {}
    for k in range(order + 1):
        for made, wanted in ((U, L), (W, T)):
            reached = _over_pi(alphas, U, made, order)
            for n in wanted:
                if sum(n) == k:
                    made[n] = (wanted[n] - reached.get(n, 0.0)) / pi
    return U, W


def _over_pi(alphas, U, f, order):
    """The integral of f along the flow of U over psi = pi: sum pi^(j+1)/(j+1)! (U d/d ln A)^j f."""
    total, term = {}, f
    for j in range(order + 1):
        total = plus(total, by(term, pi ** (j + 1) / factorial(j + 1)))
        moved = {n: c * sum(k * (a - 1) for k, a in zip(n, alphas)) for n, c in term.items()}
        term = times(U, moved, order)
    return total


@lru_cache
def normal_form(alphas, order):
    """p = -U/W and Omega = 1/W - 1."""
    U, W = flow(alphas, order)
    zero = tuple(0 for _ in alphas)
    inverse = power = {zero: 1.0}
    for _ in range(order):
        power = times(power, by({n: c for n, c in W.items() if n != zero}, -1), order)
        inverse = plus(inverse, power)
    return times(by(U, -1), inverse, order), {n: c for n, c in inverse.items() if n != zero}


def swing_at(alphas, strengths):
    """(ratio of amplitudes, duration) of the half-swing from amplitude 1 at any strength; None if it does not turn.

    Dry friction shifts the centre; the rest is iterated on the integral equation of ln r.
    """
    friction = sum(e for a, e in zip(alphas, strengths) if a == 0)
    if friction >= 1:
        return None
    law = [(a, e * (1 - friction) ** (a - 1)) for a, e in zip(alphas, strengths) if a]
    ln_r, last, before = np.zeros_like(SIN), 0.0, 1.0
    for _ in range(400):
        rho = [(a, e * np.exp((a - 1) * ln_r)) for a, e in law]
        under = 1 - sum(r * SIN**a * COS for a, r in rho) + 0 * SIN
        if np.any(under <= 0):
            return None
        rate = -sum(r * SIN ** (a + 1) for a, r in rho) / under
        ln_r, before, last = running(rate), last, whole(rate)
        if abs(last - before) < 1e-15:
            break
    return float(np.exp(last)) * (1 - friction) - friction, whole(1 / under)
