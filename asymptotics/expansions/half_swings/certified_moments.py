"""The waveform moments K_k of a quarter swing (`quarter`) in the arithmetic of `certified_orders`.

With the notation of `certified_orders`, D = d tau/d theta = 1 + c Y, and w = e^{R + i(theta−tau)} obeys

    theta dw/d theta = −i theta e^{−i theta} Y w,      K_k = ∫_0^{pi/2} tau^k · e^{−i theta} c · w D d theta,

because R' + i(1 − D) = −(s + ic) Y = −i e^{−i theta} Y and e^{−i tau} r = e^{−i theta} w.  Order by order w = sum
deltaⁿ theta^{n·alpha} w_n(u), where w_n = a_n(t) + i u b_n(t) has real a_n, b_n (theta = (pi/2) u, t = u²): the
reflection u → −u is complex conjugation for all functions here.  With (A, B) = sum_m y_m (a, b)_{n−m} and kappa = pi/2,

    −i theta e^{−i theta} = −(g + i kappa u c):   a_n = −I_n[ g A − kappa t c B ],   b_n = −I'_n[ g B + kappa c A ],

where I'_n divides by n·alpha + 1 + 2j.  Likewise tau = theta sum deltaⁿ theta^{n·alpha} tau_n with tau_0 = 1, tau_n =
I'_n[c y_n], and the last factor is e^{−i theta} c = c² − i u (c s/u).  Multiplying by tau/theta once more for each k, a
term theta^{n·alpha+k} (a_j + i u b_j) t^j of the integrand contributes (pi/2)^{n·alpha+k+1} (a_j/(n·alpha+k+1+2j) + i
b_j/(n·alpha+k+2+2j)) to the moment.

**Bounds** in the supremum norm over |u| < √varrho: |theta e^{−i theta}| ≤ theta_varrho e^{theta_varrho}, |e^{−i theta}
c| = |1 + e^{−2i theta}|/2 ≤ (1 + e^{2 theta_varrho})/2; dividing the coefficients of u^j by n·alpha + j, j ≥ 1, of a
function that vanishes at u = 0 divides its bound by n·alpha + 1 (item 3 of `certified_orders`, in u), and so does I'_n
for a function of t, which need not vanish.  The even and the odd part of a function of u are bounded like the function;
the coefficients of u^{2j}, or of u^{2j+1}, from j = K on have a sum of moduli of at most |f| varrho^{−K}/(1 −
1/varrho).
"""

from collections.abc import Mapping, Sequence
from typing import Any

from flint import arb, arb_poly

from asymptotics.expansions.half_swings.certified_orders import Ring, convolve, dot
from asymptotics.series import Key

Orders = dict[Key, Any]


def divide(f: arb_poly, exponent: arb, start: int) -> arb_poly:
    """Divide the coefficient of t^j by ``exponent`` + ``start`` + 2j."""
    return arb_poly([x / (exponent + (start + 2 * j)) for j, x in enumerate(f.coeffs())])


def duration_orders(ring: Ring, y: Mapping[Key, arb_poly]) -> Orders:
    """tau_n, n ≠ 0: the orders of tau/theta."""
    return {n: divide(ring.cut(ring.cosine * f), dot(n, ring.velocities), 1) for n, f in y.items()}


def moment_orders(
    ring: Ring, sine_ratio: arb_poly, y: Mapping[Key, arb_poly], order: int
) -> list[tuple[Orders, Orders]]:
    """(Re K_k, Im K_k) for k = 0 … order, through order − k, without their tails."""
    real, imaginary = _waveform(ring, sine_ratio, y)
    tau: Orders = {(0,) * len(ring.velocities): arb(1), **duration_orders(ring, y)}
    kappa = arb.pi() / 2
    moments = []
    for k in range(order + 1):
        # Each moment has tau/theta once more than the one before, and is needed through one order less.
        if k:
            real, imaginary = (
                {n: ring.cut(convolve(tau, f, n)) for n in f if sum(n) <= order - k} for f in (real, imaginary)
            )
        parts = ((real, 0), (imaginary, 1))
        re, im = (_values(f, ring.velocities, kappa, k + 1, odd) for f, odd in parts)
        moments.append((re, im))
    return moments


def _values(f: Orders, velocities: Sequence[arb], kappa: arb, power: int, odd: int) -> Orders:
    """∫ of theta^{n·alpha + power − 1} u^odd f_n(t) d theta up to u = 1, without tails."""
    values = {}
    for n, series in f.items():
        exponent = dot(n, velocities)
        total = sum(divide(series, exponent, power + odd).coeffs(), arb(0))
        values[n] = total * kappa ** (exponent + power)
    return values


def _waveform(ring: Ring, sine_ratio: arb_poly, y: Mapping[Key, arb_poly]) -> tuple[Orders, Orders]:
    """The orders of e^{−i theta} c · w D: (even part, odd part divided by i u)."""
    zero, kappa, cut = (0,) * len(ring.velocities), arb.pi() / 2, ring.cut
    cosine = kappa * ring.cosine
    a: Orders = {zero: arb_poly([1])}
    b: Orders = {zero: arb_poly()}
    for n in y:
        A, B = cut(convolve(y, a, n)), cut(convolve(y, b, n))
        exponent = dot(n, ring.velocities)
        # -(g + i kappa u c)(A + i u B): u^2 = t is the shift, and
        # the recursion of a_n, b_n in the module docstring follows.
        even = cut(ring.turn * A) - cut((cosine * B).left_shift(1))
        a[n] = -ring.integrate(even, exponent)
        b[n] = -divide(cut(ring.turn * B + cosine * A), exponent, 1)
    d: Orders = {zero: arb(1), **{n: cut(ring.cosine * f) for n, f in y.items()}}
    even, odd = cut(ring.cosine * ring.cosine), cut(cosine * sine_ratio)
    real, imaginary = {}, {}
    for n in a:
        A, B = cut(convolve(d, a, n)), cut(convolve(d, b, n))
        # (even - i u odd)(A + i u B) with u^2 = t.
        real[n] = cut(even * A + (odd * B).left_shift(1))
        imaginary[n] = cut(even * B - odd * A)
    return real, imaginary


def moment_bounds(velocities: Sequence[arb], y: Mapping[Key, arb], radius: arb | int, order: int) -> list[Orders]:
    """For k = 0 … order: bounds of the integrand orders theta^{−n·alpha−k} (tau^k e^{−i theta} c w D)_n on |u| <
    √radius."""
    theta = arb.pi() / 2 * arb(radius).sqrt()
    zero = (0,) * len(velocities)
    w: Orders = {zero: arb(1)}
    tau: Orders = {zero: arb(1)}
    d: Orders = {zero: arb(1)}
    for n, bound in y.items():
        # Together I_n and I'_n divide the coefficient of u^j by n.alpha + j, j >= 1: one bound does for a_n + i u b_n.
        w[n] = theta * theta.exp() * convolve(y, w, n) / (dot(n, velocities) + 1)
        d[n] = theta.cosh() * bound
        tau[n] = d[n] / (dot(n, velocities) + 1)
    last = {n: (1 + (2 * theta).exp()) / 2 * convolve(d, w, n) for n in w}
    bounds = [last]
    for k in range(1, order + 1):
        last = {n: convolve(tau, last, n) for n in last if sum(n) <= order - k}
        bounds.append(last)
    return bounds
