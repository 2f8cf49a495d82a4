"""Two modes near each other: a beat, whose nodes are no releases and whose rises are no touch.

Windows of a period have the complex amplitudes z_k of the motion (``repairs.swings``).  Two modes make them a sum of
two falling exponentials, z_k = c_1 p_1^k + c_2 p_2^k: the matrix pencil of the z_k has the p (Hua and Sarkar 1990, IEEE
Trans. Acoust. Speech Signal Process. 38, 814-824), from which the two waves

    x(t) = base + drift u + sum over j of e^(-g_j t) (a_j cos w_j t + b_j sin w_j t)

are fitted to the samples, linear in all but w_j and g_j.  What was released or knocked is no such sum.

>>> t = np.arange(0, 400, 0.25)
>>> found = near_modes(t, np.exp(-0.004 * t) * np.cos(t) + 0.8 * np.exp(-0.006 * t) * np.cos(1.06 * t))
>>> [round(v, 4) for v in (*found.omega, *found.rate)]
[1.0, 1.06, 0.004, 0.006]
>>> near_modes(t, np.exp(-0.004 * t) * np.cos(t)) is None
True
"""

from dataclasses import dataclass

import numpy as np
from scipy.optimize import least_squares

from asymptotics.decays.identification.forward.coefficients import Array
from asymptotics.decays.records.repairs import NOISE, Swings, swings, swings_of
from asymptotics.present.percent import percent

_RISE, _MOST, _SAMPLES = 1.1, 400, 3000
"""By how much a swing exceeds one before it, beside ``NOISE`` times the noise of an amplitude, where two modes are
looked for; windows, and samples, that the two fits are given."""
_LEAST, _TURN, _WILD, _CANCEL = 0.2, 0.5, 30.0, 1.2
"""The weaker mode has at least this share of the stronger, root mean squares over the record; the record holds this
much of a beat; no mode falls by more powers of e in it; and none is larger than so much of half the record's range."""
_STRONG = 0.4
"""From this share on no law of one mode is fitted to the swings.  A choice."""
_APART = 1.5
"""Frequencies by more than this factor apart are no beat in words: what swells and fades is no slower than both.  A
choice."""
_DEPENDENT = 1e-10
"""Singular values below this share are those of columns that are the same in doubles."""
_DEGREE, _LEFT, _ERRORS = 4, 0.06, 4.0
"""The modes of other losses than linear ones are modulated: with polynomials of this degree on both, what they leave
swings nowhere by more than this share of the largest swing, beside so many errors of an amplitude.  Of 111 beats
(linear ones; pairs of decays of alpha = 0, 1, 2; two coupled bodies) it is 0.049 at most; of 388 records with two or
three releases 0.072 at least.  A choice."""
_LOUD = 4.0
"""The rise of a beat exceeds so many times the median of these swings: of noise alone the largest of a hundred is
about 2.7 times their median (Rayleigh's distribution)."""


@dataclass(frozen=True)
class NearModes:
    """``omega`` and ``rate`` of decay of two modes, the stronger one first; ``share`` of the weaker, root mean squares
    over the record; ``lines``: what each of them is at the samples."""

    omega: tuple[float, float]
    rate: tuple[float, float]
    share: float
    lines: tuple[Array, Array]

    @property
    def is_strong(self) -> bool:
        """Whether the swings are those of no mode."""
        return self.share > _STRONG

    @property
    def in_words(self) -> str:
        """What the record does."""
        first, second = self.omega
        near = "beats: two modes near each other" if max(self.omega) < _APART * min(self.omega) else "has two modes"
        return f"{near}, at {first:.4g} and {second:.4g} rad/s, the second {percent(self.share)} of the first"


def near_modes(t: Array, x: Array) -> NearModes | None:
    """The two modes of a record that beats; None where nothing rises, or two modes do not explain it."""
    seen = swings_of(t, x)
    if seen is None or not _rises(seen):
        return None
    few = slice(None, None, -(-len(seen.size) // _MOST))
    poles = _poles((seen.size * np.exp(1j * seen.phase))[few])
    step = float(seen.centres[few][1] - seen.centres[few][0])
    span, u = float(t[-1] - t[0]), (t - t[0]) / (t[-1] - t[0])
    y = x - np.polynomial.Polynomial.fit(t, x, 1)(t)
    fall, turn = _nearest(u, y, (np.log(np.maximum(np.abs(poles), 1e-300)) + 1j * np.angle(poles)) / step * span
                          + 2j * np.pi / seen.period * span)  # fmt: skip
    waves = _waves(u, fall, turn)
    c = np.linalg.lstsq(waves, y, rcond=_DEPENDENT)[0]
    lines = waves[:, 2:4] @ c[2:4], waves[:, 4:] @ c[4:]
    size = [float(np.sqrt(np.mean(line**2))) for line in lines]
    strong, weak = (0, 1) if size[0] >= size[1] else (1, 0)
    # As in ``second_mode``: waves larger than the record are two that cancel.
    if max(float(np.abs(line).max()) for line in lines) > _CANCEL * float(np.ptp(x)) / 2:
        return None
    if size[weak] < _LEAST * size[strong] or abs(turn[0] - turn[1]) < 2 * np.pi * _TURN:
        return None
    left = _unexplained(t, y, waves, seen.period)
    if float(left.max()) > _LEFT * float(seen.size.max()) + _ERRORS * seen.noise:
        return None
    # Noise that remembers swings at the frequency of the motion more than the samples scatter, and no less where that
    # is at rest: then it rises, and a decay that ends is half a beat.
    if _rise(seen) < _LOUD * float(np.median(left)):
        return None
    g, w = fall / span, turn / span
    return NearModes(
        (float(w[strong]), float(w[weak])), (float(g[strong]), float(g[weak])), size[weak] / size[strong],
        (lines[strong], lines[weak]),
    )  # fmt: skip


def _rises(seen: Swings) -> bool:
    """Whether the swings fall and rise again: what only rises before it falls may be driven, then let go."""
    lowest = _lowest(seen)
    return bool((seen.size > _RISE * lowest + NOISE * seen.noise).any())


def _rise(seen: Swings) -> float:
    """By how much they do."""
    return float((seen.size - _lowest(seen)).max())


def _lowest(seen: Swings) -> Array:
    """The least swing up to each window, of those that have fallen; infinite before."""
    size = seen.size
    fallen = _RISE * size + NOISE * seen.noise < np.maximum.accumulate(size)
    return np.asarray(np.minimum.accumulate(np.where(fallen, size, np.inf)))


def _poles(z: Array) -> Array:
    """p_1, p_2 of z_k = c_1 p_1^k + c_2 p_2^k, by least squares."""
    rows = np.lib.stride_tricks.sliding_window_view(z, len(z) // 2)
    span = np.linalg.svd(rows, full_matrices=False)[2][:2].T
    return np.asarray(np.linalg.eigvals(np.linalg.lstsq(span[:-1], span[1:], rcond=None)[0]))


def _nearest(u: Array, y: Array, rates: Array) -> tuple[Array, Array]:
    """(g, w) of the two waves nearest to the samples y over u from 0 to 1, begun at the complex ``rates`` -g + i w."""
    some = slice(None, None, -(-len(u) // _SAMPLES))

    def left(at: Array) -> Array:
        Q = np.linalg.qr(_waves(u[some], at[:2], at[2:]))[0]
        return np.asarray(y[some] - Q @ (Q.T @ y[some]))

    start = np.concatenate([np.clip(-rates.real, -_WILD, _WILD), rates.imag])
    found = least_squares(left, start, max_nfev=60).x
    return found[:2], found[2:]


def _waves(u: Array, fall: Array, turn: Array) -> Array:
    """Base, drift, and cosine and sine of each falling wave, as columns."""
    sizes = [np.exp(-np.clip(g, -_WILD, _WILD) * u) for g in fall]
    each = [size * f(w * u) for size, w in zip(sizes, turn, strict=True) for f in (np.cos, np.sin)]
    return np.stack([np.ones(len(u)), u, *each], axis=1)


def _unexplained(t: Array, y: Array, waves: Array, period: float) -> Array:
    """The swings of what the two modes leave, each of them modulated."""
    slow = np.polynomial.chebyshev.chebvander(2 * (t - t[0]) / (t[-1] - t[0]) - 1, _DEGREE)
    columns = np.concatenate([waves[:, :2], (waves[:, 2:, None] * slow[:, None, :]).reshape(len(t), -1)], axis=1)
    left = y - columns @ np.linalg.lstsq(columns, y, rcond=_DEPENDENT)[0]
    return swings(t, left, period)[1]
