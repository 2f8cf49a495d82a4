"""A decay of too few turning points, by its samples: a damped cosine about a base line that may be inclined.

    x(t) = base + drift s + A(s) (cos psi + sum_k d_k z_k(psi)),    psi = omega s + phi,    s = t - t_0,
    d ln A/ds = -sum_k g_k (A/A_0)^k,    A(0) = A_0,    d_k = g_k (A/A_0)^k/(omega <|sin|^(k+2)>),

with one or two of k = -1, 0, 1, 2 (dry friction, viscous drag, drag in v^2 and in v^3) is fitted to the samples by
least squares; z_k is what the loss does to the shape of a swing, to first order, which is seen where Q is 3.  What ln A
falls by in a half-swing at an amplitude a is pi sum_k g_k (a/A_0)^k/omega.  Its 95 % interval is that of all choices of
k whose criterion of Akaike is near that of the best, on as many data as the memory of the residuals leaves; the period
is one for all amplitudes.

>>> t = np.arange(0, 10, 0.1)
>>> found = damped_cosine(t, np.exp(-0.3 * t) * np.cos(3 * t), 3.1, 0.2)
>>> f"{found.fall(0.5)['estimate']:.4f} of {0.1 * np.pi:.4f}", f"{2 * np.pi / found.omega['estimate']:.5f}"
('0.3142 of 0.3142', '2.09440')
"""

from collections.abc import Callable
from dataclasses import dataclass
from functools import lru_cache
from itertools import combinations

import numpy as np
from scipy.optimize import least_squares
from scipy.special import gamma, rgamma, stdtrit

from asymptotics.decays.identification.forward.coefficients import Array

Ends = dict[str, float]
_POWERS, _OTHERS, _NEAR = (-1, 0, 1, 2), 5, 4.0
"""Of A/A_0 in the rate of decay; what is fitted beside the rates: ln A_0, phi, omega, base, drift; and the criterion
above the best up to which a choice of powers is believed too."""
FEWEST_SAMPLES = _OTHERS + 4
"""Two rates are fitted too, and two samples are left for the noise."""
_LEAST, _MEMORY = 1e-4, 0.9
"""The share of A_0 at which an amplitude ends, as that of dry friction does; and the greatest correlation of
neighbours that is allowed for: at 0.9 a standard error is 4.4 times that of white noise."""
_FASTER, _STARTS = 1.4, (np.geomspace(0.5, 2, 15), (0.5, 1.0, 2.0))
"""How many times faster or slower than where its search begins a swing may be, with a Q above 1/2, or it is none; and
the frequencies and rates, as multiples of those that are given, of which the best begins the search."""
_LEVELS = np.linspace(0.0, np.log(_LEAST), 400)
"""Of ln A/A_0, from level to level of which the time is summed: linear between them, to 7e-5 of A."""
_RAISED = {k: np.exp(k * _LEVELS) for k in _POWERS}
_PLACES, _OVERTONES = np.linspace(0.0, 2 * np.pi, 721), np.arange(3, 60, 2)
"""Of psi in a period, and the overtones that make up the shape: they fall at least like 1/n^3."""


@dataclass(frozen=True)
class DampedCosine:
    """``omega``: in rad/s, with its interval; ``fall``: what ln A loses in a half-swing at an amplitude;
    ``size``: the amplitude of the motion at a time, by the best choice of powers; ``phase``: psi of the samples at the
    first of them; ``residual``: what is left, and ``memory``, the correlation of neighbours in it."""

    omega: Ends
    fall: Callable[[float], Ends]
    size: Callable[[Array], Array]
    phase: float
    residual: Array
    memory: float


@dataclass(frozen=True, eq=False)
class _Fit:
    """``c``: what was fitted, the rates last; the inverse of its normal matrix, what is left and its sum of squares,
    and the correlation of neighbours in it: noise that remembers, or no damped cosine."""

    powers: tuple[int, ...]
    c: Array
    inverse: Array
    residual: Array
    left: float
    memory: float


def damped_cosine(t: Array, x: Array, omega: float, rate: float, derivative: int = 0) -> DampedCosine | None:
    """Fitted to samples from about ``omega`` and ``rate``; None where no fit is found, or nothing is left for noise.

    ``derivative``: of the motion, which the samples are; amplitudes are those of the motion.
    """
    if len(t) < FEWEST_SAMPLES:
        return None
    omega, rate = _begun(t - t[0], x, omega, max(rate, 1e-3 * omega))
    sets = [c for count in (1, 2) for c in combinations(_POWERS, count)]
    tried = [_fitted(t - t[0], x, powers, omega, rate, derivative == 0) for powers in sets]
    found = [fit for fit in tried if fit is not None]
    if not found:
        return None
    memory = min(found, key=lambda fit: fit.left).memory
    # Residuals that remember tell as much as fewer that do not.
    data = len(t) * (1 - memory) / (1 + memory)
    criteria = {fit: data * np.log(fit.left) + 2 * len(fit.powers) for fit in found}
    found.sort(key=lambda fit: criteria[fit])
    best = found[0]
    near = [fit for fit in found if criteria[fit] < criteria[best] + _NEAR]

    def error(fit: _Fit, slope: Array) -> float:
        freedom = max(data - len(fit.c), 1.0)
        return float(
            stdtrit(freedom, 0.975) * np.sqrt(max(float(slope @ fit.inverse @ slope), 0.0) * fit.left / freedom)
        )

    def united(values: list[tuple[float, Array]]) -> Ends:
        each = [(value, error(fit, slope)) for fit, (value, slope) in zip(near, values, strict=True)]
        return {"low": min(v - e for v, e in each), "estimate": each[0][0], "high": max(v + e for v, e in each)}

    def size(at: Array) -> Array:
        shape = _shape(best.powers, best.c[_OTHERS:], at - t[0])
        return np.asarray(np.exp(best.c[0]) * shape / best.c[2] ** derivative)

    frequency = united([(float(fit.c[2]), np.eye(len(fit.c))[2]) for fit in near])
    fall = lambda a: united([_fall(fit, a, derivative) for fit in near])  # noqa: E731
    return DampedCosine(frequency, fall, size, float(best.c[1]), best.residual, best.memory)


def _fall(fit: _Fit, amplitude: float, derivative: int) -> tuple[float, Array]:
    """pi sum g (a/A_0)^k/omega, and its slopes; A_0 of a derivative is omega^derivative times that of the motion."""
    omega, k, g = fit.c[2], np.array(fit.powers), fit.c[_OTHERS:]
    by = np.pi / omega * (amplitude * omega**derivative / np.exp(fit.c[0])) ** k.astype(float)
    h = float(by @ g)
    along = float(by @ (k * g))
    return h, np.array([-along, 0.0, (derivative * along - h) / omega, 0.0, 0.0, *by])


def _shape(powers: tuple[int, ...], g: Array, s: Array) -> Array:
    """A(s)/A_0, no less than the least share; of one power in closed form."""
    if powers == (0,):
        return np.asarray(np.exp(-g[0] * s))
    if len(powers) == 1:
        return np.asarray(np.clip(1 + powers[0] * g[0] * s, _LEAST, 1 / _LEAST) ** (-1 / powers[0]))
    return _from_times(s, _times(powers, g, s)[1])


def _from_times(s: Array, times: Array) -> Array:
    """A(s)/A_0 by when each level is reached."""
    return np.asarray(np.exp(np.interp(s, times, _LEVELS)))


def _summed(f: Array) -> Array:
    """The integral of f over ln A, from level to level down."""
    return np.concatenate([[0.0], np.cumsum((f[1:] + f[:-1]) / 2 * -np.diff(_LEVELS))])


def _times(powers: tuple[int, ...], g: Array, s: Array) -> tuple[Array, Array]:
    """One over the rate of decay at each level of ln A/A_0, and when it is reached."""
    rate = sum(gk * _RAISED[k] for k, gk in zip(powers, g))
    # Where the rates of two powers cancel, the amplitude stays.
    slow = 1 / np.maximum(rate, 1e-6 / max(float(s[-1]), 1e-300))
    return slow, _summed(slow)


def _mean_power(k: int) -> float:
    """<|sin|^(k+2)>, by which the loss of power k + 1 of the velocity takes from ln A."""
    return float(gamma((k + 3) / 2) / (np.sqrt(np.pi) * gamma((k + 2) / 2 + 1)))


def _bent(k: int) -> Array:
    """z_k at the places: z'' + z is the loss |sin|^(k+1) sgn sin without its first harmonic, and psi = 0 turns."""
    n, a = _OVERTONES, k + 1
    sine = (-1.0) ** ((n - 1) // 2) * 2.0 ** (1 - a) * gamma(a + 1) * rgamma((a + n) / 2 + 1) * rgamma((a - n) / 2 + 1)
    each = sine / (n**2 - 1)
    return np.asarray((_mean_power(k) + n @ each) * np.sin(_PLACES) - each @ np.sin(np.outer(n, _PLACES)))


_SHAPES = {k: _bent(k) / _mean_power(k) for k in _POWERS}
_SLOPES = {k: np.gradient(z, _PLACES) for k, z in _SHAPES.items()}


def _linear(s: Array, x: Array, omega: float, shape: Array) -> tuple[Array, float]:
    """(cosine, sine, base, drift) where frequency and amplitude are known, and the sum of squares that is left."""
    V = np.stack([shape * np.cos(omega * s), -shape * np.sin(omega * s), np.ones(len(s)), s / s[-1]], axis=1)
    c = np.asarray(np.linalg.lstsq(V, x, rcond=None)[0])
    return c, float(((x - V @ c) ** 2).sum())


def _begun(s: Array, x: Array, omega: float, rate: float) -> tuple[float, float]:
    """The frequency and the rate near these that fit best, of viscous drag: a few turning points tell them badly."""
    tried = [(float(w * omega), float(r * rate)) for w in _STARTS[0] for r in _STARTS[1]]
    return min(tried, key=lambda start: _linear(s, x, start[0], np.exp(-start[1] * s))[1])


def _falling(powers: tuple[int, ...], g: Array, s: Array) -> tuple[Array, list[Array]]:
    """A(s)/A_0, and the slopes of its logarithm in each rate: of one -s (A/A_0)^k, until the amplitude ends; of two by
    the integral of (A/A_0)^j/rate^2 over ln A, times the rate."""
    if len(powers) == 1:
        moving, size = 1 + powers[0] * g[0] * s, _shape(powers, g, s)
        inside = (moving > _LEAST) & (moving < 1 / _LEAST)
        return size, [np.where(inside, -s * size ** powers[0], 0.0)]
    slow, times = _times(powers, g, s)
    each = [slow**2 * _RAISED[k] for k in powers]
    return _from_times(s, times), [-np.interp(s, times, _summed(one) / slow, right=0.0) for one in each]


def _waves(c: Array, powers: tuple[int, ...], s: Array, bent: bool) -> tuple[Array, Array]:
    """The samples that these numbers foretell, and their slopes in each of them."""
    g, omega = c[_OTHERS:], c[2]
    (size, falls), psi = _falling(powers, g, s), omega * s + c[1]
    swing, ahead, weighed = np.cos(psi), -np.sin(psi), np.cos(psi)
    beside = [np.zeros(len(s))] * len(powers)
    for n, (k, gk) in enumerate(zip(powers, g)) if bent else ():
        z, dz = (np.interp(psi % (2 * np.pi), _PLACES, table[k]) for table in (_SHAPES, _SLOPES))
        beside[n] = size**k / omega * z
        swing, weighed = swing + gk * beside[n], weighed + (k + 1) * gk * beside[n]
        ahead = ahead + gk * size**k / omega * dz
    wave, u = np.exp(c[0]) * size, s / s[-1]
    turned = s * ahead - sum(gk * one for gk, one in zip(g, beside)) / omega
    rates = [fall * weighed + one for fall, one in zip(falls, beside)]
    slopes = [wave * swing, wave * ahead, wave * turned, np.ones(len(s)), u, *(wave * one for one in rates)]
    return np.asarray(wave * swing + c[3] + c[4] * u), np.stack(slopes, axis=1)


def _fitted(s: Array, x: Array, powers: tuple[int, ...], omega: float, rate: float, bent: bool) -> _Fit | None:
    rates = np.full(len(powers), rate / len(powers))
    a, b, base, drift = _linear(s, x, omega, _shape(powers, rates, s))[0]
    start = [np.log(max(float(np.hypot(a, b)), 1e-300)), np.arctan2(b, a), omega, base, drift, *rates]
    told = lru_cache(maxsize=1)(lambda c: _waves(np.frombuffer(c), powers, s, bent))  # the slopes are asked for next
    wave, slopes = (lambda c: told(c.tobytes())[0] - x), (lambda c: told(c.tobytes())[1])
    found = least_squares(wave, start, slopes, x_scale="jac", max_nfev=200)
    normal = found.jac.T @ found.jac
    scale = np.sqrt(np.diag(normal))
    if not found.success or not (np.isfinite(scale) & (scale > 0)).all():
        return None
    swings = 1 / _FASTER < found.x[2] / omega < _FASTER and found.x[_OTHERS:].sum() < found.x[2]
    if not swings:
        return None
    inverse = np.linalg.pinv(normal / np.outer(scale, scale)) / np.outer(scale, scale)
    r = np.asarray(found.fun)
    left = max(float(r @ r), 1e-24 * float(x @ x), 1e-300)  # what fits exactly has a logarithm still
    memory = float(np.clip(r[1:] @ r[:-1] / left, 0, _MEMORY))
    return _Fit(powers, np.asarray(found.x), np.asarray(inverse), r, left, memory)
