"""What a law means at the amplitudes of the record: Q at its beginning and its end, and the half-life.

To first order zeta(A) = sum_i <|cos|^m |sin|^(alpha+1)> epsilon_i A^(d_i-1), Q = 1/(2 zeta), and the half-life from A
is int_(A/2)^A da/(a zeta(a)) in units of 1/omega_0 (theory page ``equivalent_damping``).  Beside a pendulum what a
cycle loses is divided by 4 pi times the energy, and ln A falls by this loss over A V'(A) times the period.  All numbers
are doubles, computed from the estimates.

>>> zeta = equivalent_ratio([(1.0, 0, 0.02), (2.0, 0, 0.05)])
>>> round(float(zeta(1.0)), 6), round(half_life(equivalent_ratio([(1.0, 0, 0.02)]), 1.0), 6)
(0.031221, 69.314718)
"""

from collections.abc import Callable, Sequence
from math import gamma, pi
from typing import Any

import numpy as np
from scipy.special import ellipk

from asymptotics.decays.identification.forward.candidates import FREE
from asymptotics.decays.identification.judging.laws import Judged

_POINTS = 401
"""Of the trapezoidal rule over ln 2, for a smooth integrand: an error of about 1e-6, where three digits are told."""
_NODES = 64
"""Of Gauss and Legendre's rule over a quarter of a cycle, where the integrand is smooth but for a power of the cosine
at its end."""
Ratio = Callable[[Any], Any]


def equivalent_ratio(losses: Sequence[tuple[float, int, float]]) -> Ratio:
    """zeta(A) of the losses (alpha, m, epsilon)."""

    def mean(alpha: float, m: int) -> float:
        return gamma((m + 1) / 2) * gamma(alpha / 2 + 1) / (pi * gamma((m + alpha + 1) / 2 + 1))

    rows = [(mean(alpha, m) * epsilon, alpha + m - 1) for alpha, m, epsilon in losses]
    return lambda A: sum(c * np.asarray(A, dtype=float) ** w for c, w in rows)


def pendulum_ratios(losses: Sequence[tuple[float, int, float]], unit: float) -> tuple[Ratio, Ratio]:
    """zeta(A) beside a pendulum, and how fast ln A falls there; A in angles of ``unit`` radians.

    2 sin(x/2) = r sin(phi) and x' = r cos(phi) over a cycle without losses, r = 2 sin(A/2), k = sin(A/2).

    >>> zeta, rate = pendulum_ratios([(1.0, 0, 0.02)], 1.0)
    >>> round(0.5 / float(zeta(2.6)), 3), round(0.5 / float(zeta(1e-3)), 3), round(float(rate(1e-3)), 6)
    (41.212, 50.0, 0.01)
    """
    nodes, weights = np.polynomial.legendre.leggauss(_NODES)
    phi, weights = (nodes + 1) * pi / 4, weights * pi / 4

    def lost(A: Any) -> tuple[Any, Any]:
        k = np.sin(np.asarray(A, dtype=float) * unit / 2)
        r, sine = 2 * k / unit, k[..., None] * np.sin(phi)
        x, v = 2 * np.arcsin(sine) / unit, r[..., None] * np.cos(phi)
        force = sum(epsilon * x**m * v**alpha for alpha, m, epsilon in losses)
        return 4 * (force * v / np.sqrt(1 - sine**2)) @ weights, r

    def zeta(A: Any) -> Any:
        taken, r = lost(A)
        return taken / (2 * pi * r**2)

    def rate(A: Any) -> Any:
        period = 4 * ellipk(np.sin(np.asarray(A) * unit / 2) ** 2)
        return lost(A)[0] / (np.asarray(A) * np.sin(np.asarray(A) * unit) / unit * period)

    return zeta, rate


def half_life(falling: Ratio, amplitude: float) -> float:
    """omega_0 t from A to A/2, where ln A falls at this rate: zeta, beside a linear spring."""
    s = np.linspace(np.log(amplitude / 2), np.log(amplitude), _POINTS)
    rate = np.array(falling(np.exp(s)))
    # A loss that vanishes on the way never halves the amplitude.
    return float(np.trapezoid(1 / rate, s)) if (rate > 0).all() else np.inf


def equivalent(law: Judged, omega_0: float | None) -> dict[str, Any] | None:
    """Amplitudes, Q there, the half-life at the first; None beside springs but that of a pendulum, without a
    fit, and for printed tables."""
    losses, fit = _losses(law), law.fit
    # The formulas are those of a linear spring and of a pendulum, and printed decrements have no first amplitude.
    if losses is None or fit is None or not fit.model.alternating:
        return None
    size = np.abs(fit.model.seen.x - fit.rest)
    ends = [float(size[0]), float(size[-1])]
    zeta = rate = equivalent_ratio(losses)
    if fit.model.angle is not None:
        zeta, rate = pendulum_ratios(losses, fit.model.angle)
    ratios = [float(zeta(a)) for a in ends]
    if not all(np.isfinite(z) and z > 0 for z in ratios):
        return None
    life = half_life(rate, ends[0])
    found: dict[str, Any] = {"amplitudes": ends, "Q": [1 / (2 * z) for z in ratios], "zeta": ratios}
    # Without omega_0 a swing, 2 pi, is the unit of time.
    return found | {"half_life": life / (omega_0 or 2 * pi), "half_life_unit": "s" if omega_0 else "swings"}


def in_words(found: dict[str, Any] | None, unit: str) -> str:
    """One line: ``Q = 212 at 10 deg, 160 at 40 deg; half-life 31 s``."""
    if found is None:
        return ""
    told = ", ".join(f"{q:.3g} at {f'{a:.3g} {unit}'.strip()}" for q, a in zip(found["Q"], found["amplitudes"]))
    life = f"; half-life {found['half_life']:.3g} {found['half_life_unit']}" if np.isfinite(found["half_life"]) else ""
    return f"Q = {told}{life} (first order, of the first law)"


def _losses(law: Judged) -> list[tuple[float, int, float]] | None:
    """(alpha, m, epsilon) of each loss; None beside springs, or where the exponent is not known."""
    candidate = law.candidate
    if candidate.springs or len(law.epsilon) != len(candidate.losses):
        return None
    read = []
    for (name, _), element, epsilon in zip(candidate.losses, candidate.elements, law.epsilon):
        if name == FREE and law.alpha is None:
            return None
        alpha = law.alpha.estimate if name == FREE and law.alpha is not None else element.velocity
        read.append((float(alpha), int(element.position), float(epsilon.estimate)))
    return read
