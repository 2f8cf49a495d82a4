"""What a law means at the amplitudes of the record: Q at its beginning and its end, and the half-life, as numbers.

To first order zeta(A) = sum_i <|cos|^m |sin|^(alpha+1)> epsilon_i A^(d_i-1), Q = 1/(2 zeta), and the half-life from A
is int_(A/2)^A da/(a zeta(a)) in units of 1/omega_0 (theory page ``equivalent_damping``).  Beside a pendulum or springs
what a cycle loses is divided by 4 pi times the energy, and ln A falls by this loss over A V'(A) times the period.  All
numbers are doubles, computed from the estimates.

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


def spring_ratios(
    losses: Sequence[tuple[float, int, float]], springs: Sequence[tuple[int, float]]
) -> tuple[Ratio, Ratio]:
    """zeta(A) beside springs (p, c), and how fast ln A falls there; nan where the spring does not bring x back.

    x = A sin(phi) and x' = A cos(phi) g over a cycle without losses, g^2 = 2 (V(A) - V(x))/(A cos(phi))^2.

    >>> zeta, rate = spring_ratios([(1.0, 0, 0.02)], [(3, 0.5)])
    >>> round(0.5 / float(zeta(1e-3)), 3), round(float(rate(1e-3)), 6), round(0.5 / float(zeta(1.0)), 4)
    (50.0, 0.01, 54.5696)
    """
    nodes, weights = np.polynomial.legendre.leggauss(_NODES)
    phi, weights = (nodes + 1) * pi / 4, weights * pi / 4
    sine, cosine = np.sin(phi), np.cos(phi)

    def energy(A: Any) -> Any:
        return A**2 / 2 + sum(c * A ** (p + 1) / (p + 1) for p, c in springs)

    def cycle(A: Any) -> tuple[Any, Any]:
        size = np.asarray(A, dtype=float)[..., None]
        squares = 1 + sum(2 * c / (p + 1) * size ** (p - 1) * (1 - sine ** (p + 1)) / cosine**2 for p, c in springs)
        g = np.sqrt(np.where(squares > 0, squares, np.nan))
        v = size * cosine * g
        force = sum(epsilon * (size * sine) ** m * v**alpha for alpha, m, epsilon in losses)
        return 4 * (force * size * cosine) @ weights, 4 / g @ weights

    def zeta(A: Any) -> Any:
        return cycle(A)[0] / (4 * pi * energy(np.asarray(A, dtype=float)))

    def rate(A: Any) -> Any:
        lost, period = cycle(A)
        pull = np.asarray(A) * (np.asarray(A) + sum(c * np.asarray(A) ** p for p, c in springs))
        return lost / (pull * period)

    return zeta, rate


def half_life(falling: Ratio, amplitude: float) -> float:
    """omega_0 t from A to A/2, where ln A falls at this rate: zeta, beside a linear spring."""
    s = np.linspace(np.log(amplitude / 2), np.log(amplitude), _POINTS)
    rate = np.array(falling(np.exp(s)))
    # A loss that vanishes on the way never halves the amplitude.
    return float(np.trapezoid(1 / rate, s)) if (rate > 0).all() else np.inf


def ratios(law: Judged) -> tuple[Ratio, Ratio] | None:
    """zeta(A) of a fitted law, and how fast ln A falls, as ``half_life`` wants it; None without its strengths."""
    losses, fits = _losses(law), law.fits
    # Printed decrements have no first amplitude; runs whose strengths differ have no Q together.
    if losses is None or not fits or not all(fit.model.alternating for fit in fits):
        return None
    if law.evidence.outside or law.intervals.apart:
        return None
    if fits[0].model.angle is not None:
        return pendulum_ratios(losses, fits[0].model.angle)
    if law.candidate.springs:
        return spring_ratios(losses, [(p, c.estimate) for p, c in zip(law.candidate.springs, law.springs)])
    zeta = equivalent_ratio(losses)
    return zeta, zeta


def measured_ends(law: Judged) -> tuple[float, float]:
    """The first and the last amplitude that was measured, as the law has them; of several runs the largest and the
    smallest of these."""
    ends = []
    for fit in law.fits:
        size = fit.model.amplitudes(fit.theta)[0][fit.model.seen.n[fit.model.seen.inside]]
        ends.append((float(size[0]), float(size[-1])))
    return max(first for first, _ in ends), min(last for _, last in ends)


def equivalent(law: Judged, omega_0: float | None) -> dict[str, Any] | None:
    """Amplitudes, Q there, the half-life at the first; None without a fit or a physical loss, and for printed tables.

    ``omega_0``: where the law has no times of its own.
    """
    known = ratios(law)
    if known is None:
        return None
    zeta, rate = known
    ends = list(measured_ends(law))
    found = [float(zeta(a)) for a in ends]
    if not all(np.isfinite(z) and z > 0 for z in found):
        return None
    life, omega = half_life(rate, ends[0]), omega_of(law) or omega_0
    told: dict[str, Any] = {"amplitudes": ends, "Q": [1 / (2 * z) for z in found], "zeta": found}
    # Without omega_0 a swing, 2 pi, is the unit of time.
    return told | {"half_life": life / (omega or 2 * pi), "half_life_unit": "s" if omega else "swings"}


def omega_of(law: Judged) -> float | None:
    """omega_0 that the times give the law; the mean of several runs."""
    found = [float(np.exp(fit.theta[-2])) for fit in law.fits if fit.model.seen.has_times]
    return float(np.mean(found)) if found else None


def equivalent_texts(law: Judged, omega_0: float | None) -> dict[str, Any] | None:
    """What ``equivalent`` says, as JSON: numbers are strings."""
    found = equivalent(law, omega_0)
    if found is None:
        return None
    rows = {name: [number_text(x) for x in found[name]] for name in ("amplitudes", "Q", "zeta")}
    return rows | {"half_life": number_text(found["half_life"]), "half_life_unit": found["half_life_unit"]}


def number_text(value: float) -> str | None:
    """A number as JSON has it: eight digits, null without a limit."""
    return f"{value:.8g}" if np.isfinite(value) else None


def shares(law: Judged, amplitude: float) -> list[float] | None:
    """Which part of the loss at an amplitude each term takes, to first order; None where one of them gives."""
    losses = _losses(law)
    whole = ratios(law)
    if losses is None or whole is None or any(e <= 0 for _, _, e in losses):
        return None
    parts = [_alone(law, one)(amplitude) for one in losses]
    return [float(p) / float(whole[0](amplitude)) for p in parts]


def _alone(law: Judged, one: tuple[float, int, float]) -> Ratio:
    """zeta of one of the losses beside the spring of the law."""
    angle = law.fits[0].model.angle
    if angle is not None:
        return pendulum_ratios([one], angle)[0]
    if law.candidate.springs:
        return spring_ratios([one], [(p, c.estimate) for p, c in zip(law.candidate.springs, law.springs)])[0]
    return equivalent_ratio([one])


def _losses(law: Judged) -> list[tuple[float, int, float]] | None:
    """(alpha, m, epsilon) of each loss; None where a strength or the exponent is not known."""
    candidate = law.candidate
    if len(law.epsilon) != len(candidate.losses) or len(law.springs) != len(candidate.springs):
        return None
    read = []
    for (name, _), element, epsilon in zip(candidate.losses, candidate.elements, law.epsilon):
        if name == FREE and law.alpha is None:
            return None
        alpha = law.alpha.estimate if name == FREE and law.alpha is not None else element.velocity
        read.append((float(alpha), int(element.position), float(epsilon.estimate)))
    return read
