"""A record of a swing or two: whether it swings at all, and the damped cosine that says how fast and how it falls.

Of fewer than one and a half periods a smooth line of any modulation (``demodulation``) is no line, and no law can be
told from another; a damped cosine has its period and its loss still.  That it swings is told by what does not: a motion
that creeps home without a turn,

    x(t) = base + drift s + a e^(-p s) + b e^(-q s),    p, q > 0    (b s e^(-p s) where p = q),

and a polynomial of degree 5 have as many numbers as the damped cosine, and must explain the samples worse beyond doubt.
Of half a period both explain as much, and so they do of noise.

>>> s = np.linspace(0, 1.2, 80)
>>> noise = 0.01 * np.random.default_rng(0).standard_normal(80)
>>> line, periods = swings(s, np.exp(-0.3 * s) * np.cos(2 * np.pi * s) + noise)
>>> f"{periods:.1f} periods of {2 * np.pi / line.omega['estimate']:.2f}"
'1.2 periods of 1.00'
>>> swings(s, np.exp(-3 * s) + noise) is None, swings(s, noise) is None
(True, True)
"""

from dataclasses import replace

import numpy as np

from asymptotics.decays.identification.forward.coefficients import Array
from asymptotics.decays.identification.measuring.criteria import memory_factor
from asymptotics.decays.identification.measuring.damped_cosine import DampedCosine, damped_cosine
from asymptotics.decays.identification.measuring.observations import Observations, Samples
from asymptotics.errors import InputError
from asymptotics.numbers.context import lru_cache
from asymptotics.present.counts import many

ENOUGH_PERIODS, _MOST = 1.5, 400
"""Periods from which on laws are told apart: base, drift and a line of degree 2 fit anything shorter.  And samples of
so few of them that are enough: more are averaged in groups."""
_PERIODS, _RATES = np.geomspace(0.4, 10.0, 64), (0.01, 0.03, 0.1, 0.2, 0.4)
"""Periods in the record, of which most may be rest, and rates of decay beside the frequency; the best begins the
fit."""
_CREEPING, _DEGREE = np.geomspace(0.3, 60.0, 20), 5
"""p and q, in units of one over the length of the record; and the degree of the polynomial."""
_DOUBT = 25.0
"""By how much -2 ln(likelihood) of what does not swing must be larger: chi-squared for four numbers has p = 1e-3 at
18.5, and about ten frequencies that are tried raise it by twice their logarithm."""
_LEAST, _CLEAR, _POOR = 0.85, 0.99, 0.1
"""Periods that must be seen, by the lower end of their interval; the correlation of neighbours up to which noise is
believed to remember; and what may be left that remembers, as a share of the amplitude: more is no damped cosine."""
_BENT, _SLOW, _LINE = 6, 0.2, 7.0
"""A polynomial of degree 6, which follows one and a half periods, or what creeps leaves so small a share of the
variance of a record that has no more; and a line in what is left is no noise (p = e^-7)."""


def observations_of_few_swings(
    t: Array, x: Array, *, unit: str, name: str, notes: tuple[str, ...] = (), derivative: int = 0
) -> Observations:
    """The turning points of the damped cosine through a record that can tell no law; InputError where none swings."""
    return _observed(t, x, swings(t, x, derivative), unit=unit, name=name, notes=notes, derivative=derivative)


def _observed(
    t: Array,
    x: Array,
    found: tuple[DampedCosine, float] | None,
    *,
    unit: str,
    name: str,
    notes: tuple[str, ...],
    derivative: int,
) -> Observations:
    if found is None:
        reason = f"{name} shows no swing beyond doubt: a motion without a turn, or noise, is as near as a damped cosine"
        raise InputError("FILE", reason, f"at least {_LEAST} periods of a free decay that stand out of their noise")
    line, periods = found
    omega = line.omega["estimate"]
    # Of a derivative the phase is ahead of that of the motion by a quarter of a period each.
    first = line.phase - derivative * np.pi / 2
    k = np.arange(np.ceil(first / np.pi - 1e-9), np.floor((first + omega * (t[-1] - t[0])) / np.pi + 1e-9) + 1)
    times = t[0] + (k * np.pi - first) / omega
    noise = float(np.sqrt(_square(line.residual) / len(line.residual)))
    samples = Samples(t, x, noise, float(len(t)), line.memory, derivative)
    said = f"{periods:.2g} periods in {many(len(t), 'sample')}: a damped cosine through all of them; noise {noise:.3g}"
    values = line.size(times) * np.where(k % 2, -1.0, 1.0)
    seen = Observations.of(k.astype(int), values, times, unit=unit, name=name, notes=(*notes, said))
    shown = f"{periods:.2g} periods" + (" in such noise" if periods >= ENOUGH_PERIODS else "")
    return replace(seen, x=values, samples=samples, no_law=f"{shown} tell no law from another")


def of_a_short_record(
    t: Array, x: Array, *, unit: str, name: str, notes: tuple[str, ...] = (), derivative: int = 0
) -> Observations | None:
    """What a record of less than one and a half periods shows; None where it has more; InputError where it moves
    without a swing."""
    if not _is_slow(t, x):
        return None
    few = averaged(t, x)
    line = _line(*few, derivative)
    found = _beyond_doubt(*few, line)
    if found is None and _has_line(*few, line) or found is not None and found[1] >= ENOUGH_PERIODS:
        return None
    return _observed(t, x, found, unit=unit, name=name, notes=notes, derivative=derivative)


def _is_slow(t: Array, x: Array) -> bool:
    """Whether all that moves may be a swing or two."""
    t, x = averaged(t, x)
    if len(t) < _BENT + 2:
        return False
    bent = np.polynomial.chebyshev.chebvander(2 * (t - t[0]) / (t[-1] - t[0]) - 1, _BENT)
    left = min(_square(_residual(x, *bent.T)), _square(_creeping(t - t[0], x)))
    return bool(left < _SLOW * _square(x - x.mean()))


def _has_line(t: Array, x: Array, line: DampedCosine | None) -> bool:
    """Whether something swings beside what swings once or not at all (Fisher's test of the largest line)."""
    left = [_without_swing(t, x), *([] if line is None else [line.residual])]
    power = np.abs(np.fft.rfft(min(left, key=_square)))[1:] ** 2
    return bool(power.max() > (np.log(len(power)) + _LINE) * power.mean())


def swings(t: Array, x: Array, derivative: int = 0) -> tuple[DampedCosine, float] | None:
    """The damped cosine of few periods and how many they are; None where nothing swings beyond doubt."""
    t, x = averaged(t, x)
    return _beyond_doubt(t, x, _line(t, x, derivative))


def _line(t: Array, x: Array, derivative: int) -> DampedCosine | None:
    """The damped cosine through all samples: what decides about a short record is told of it again."""
    return _kept_line(np.asarray(t, dtype=float).tobytes(), np.asarray(x, dtype=float).tobytes(), derivative)


@lru_cache(maxsize=8)
def _kept_line(t: bytes, x: bytes, derivative: int) -> DampedCosine | None:
    times, values = np.frombuffer(t), np.frombuffer(x)
    return damped_cosine(times, values, *begun(times, values), derivative)


def _beyond_doubt(t: Array, x: Array, line: DampedCosine | None) -> tuple[DampedCosine, float] | None:
    if line is None or not line.omega["low"] * (t[-1] - t[0]) > 2 * np.pi * _LEAST:
        return None
    r, left = line.residual, max(_square(line.residual), 1e-300)
    if memory_factor(r) > 1 and left > len(t) * (_POOR * np.ptp(x) / 2) ** 2:
        return None
    memory = float(np.clip(r[1:] @ r[:-1] / left, 0, _CLEAR))
    data = len(t) * (1 - memory) / (1 + memory)
    if data * np.log(_square(_without_swing(t, x)) / left) < _DOUBT:
        return None
    return line, line.omega["estimate"] * float(t[-1] - t[0]) / (2 * np.pi)


def averaged(t: Array, x: Array) -> tuple[Array, Array]:
    """As many means of neighbours as are enough."""
    step = -(-len(t) // _MOST)
    count = len(t) // step * step
    return t[:count].reshape(-1, step).mean(axis=1), x[:count].reshape(-1, step).mean(axis=1)


def _residual(x: Array, *columns: Array) -> Array:
    V = np.stack(columns, axis=1)
    return np.asarray(x - V @ np.linalg.lstsq(V, x, rcond=None)[0])


def _square(r: Array) -> float:
    return float(r @ r)


def begun(t: Array, x: Array) -> tuple[float, float]:
    """The frequency and the rate of viscous drag that fit a few periods best, of a grid."""
    s, one = t - t[0], np.ones(len(t))
    tried = [(2 * np.pi * periods / s[-1], rate) for periods in _PERIODS for rate in _RATES]

    def misfit(start: tuple[float, float]) -> float:
        wave = np.exp((-start[1] + 1j) * start[0] * s)
        return _square(_residual(x, wave.real, wave.imag, one, s / s[-1]))

    omega, rate = min(tried, key=misfit)
    return float(omega), float(rate * omega)


def _without_swing(t: Array, x: Array) -> Array:
    """What the better one of a creeping motion and a polynomial leaves."""
    smooth = _residual(x, *np.polynomial.chebyshev.chebvander(2 * (t - t[0]) / (t[-1] - t[0]) - 1, _DEGREE).T)
    return min(_creeping(t - t[0], x), smooth, key=_square)


def _creeping(s: Array, x: Array) -> Array:
    """What the best motion without a turn leaves: base and drift, then one fall and every other one beside it."""
    u = s / s[-1]
    falls = np.exp(-u[:, None] * _CREEPING)
    base = np.linalg.qr(np.stack([np.ones(len(u)), u], axis=1))[0]
    y, columns = _without(base, x), _without(base, np.concatenate([falls, u[:, None] * falls], axis=1))
    best, least = y, np.inf
    for place in range(len(_CREEPING)):
        one = columns[:, [place]] / np.linalg.norm(columns[:, place])
        left, beside = _without(one, y), _without(one, columns[:, place + 1 : len(_CREEPING) + place + 1])
        along = (beside.T @ left) / np.maximum((beside**2).sum(axis=0), 1e-300)
        tried = left[:, None] - beside * along
        squares = (tried**2).sum(axis=0)
        if squares.min() < least:
            best, least = tried[:, int(squares.argmin())], float(squares.min())
    return np.asarray(best)


def _without(unit: Array, y: Array) -> Array:
    """What is orthogonal to orthonormal columns."""
    return np.asarray(y - unit @ (unit.T @ y))
