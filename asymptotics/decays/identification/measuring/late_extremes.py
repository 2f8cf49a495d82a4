"""By how much a local polynomial finds an extreme too late: a loss has no Taylor series at a turning point.

About a positive extreme at angle u = 0, a term |x|^p v|v|^(q-1) of local strength delta gives, to first order,

    x/A = cos u + delta sgn(u) g(|u|),        g(u) = integral over s in [0, u] of sin(u - s) sin(s)^q cos(s)^p,

of which dry friction (q = 0) has g = 1 - cos u, a jump of the second derivative.  The polynomial of least squares over
the samples of a window gives that a slope b delta at u = 0, where there is none, and its extreme lies at u = b delta:
late at every extreme, the more the smaller the amplitude is.  The next order is delta^3, as t -> -t with
delta -> -delta is a symmetry.

>>> window = Window((tuple(np.linspace(-0.7, 0.7, 71)),))
>>> [round(window.lateness(q), 5) for q in (0.0, 0.5, 2.0)]
[0.07312, 0.01062, -0.0009]
>>> abs(window.lateness(1.0)) < 1e-5             # a linear drag has a Taylor series
True
"""

from dataclasses import dataclass

import numpy as np

from asymptotics.decays.identification.forward.coefficients import Array
from asymptotics.numbers.context import lru_cache

DEGREE = 6
"""Of the local polynomials (``extraction``): seven coefficients, and nine samples are asked for."""
_FEW, _TYPICAL = 50, 4
"""Of windows with fewer samples the edges differ by their share in one step: several are averaged.  A choice."""
_NODES = 40
"""Of the integral; with s = u r^3 the fractional powers are smooth enough for 1e-10."""
LINE_LATENESS = {(1,): 1 / np.pi, (1, 3): 1 / (2 * np.pi)}
"""The same of a smooth line (``demodulation``) of these harmonics, for dry friction: of its force -sgn(sin u) delta the
line does not have the sines k = 5, 7, ..., which are (4/pi) delta cos(k u)/(k^2 - 1) in x'/A: at u = 0 the sum of
1/(k^2 - 1) over odd k > 3 is 1/8, over those > 1 it is 1/4."""
_STEP = 1e-4
"""Of the exponent, for a derivative by differences: their error is its square."""


@dataclass(frozen=True)
class Window:
    """Where the samples of typical local fits lie about their extremes, in radians of the motion."""

    places: tuple[tuple[float, ...], ...]

    @classmethod
    def of(cls, t: Array, times: Array, half: float, omega: float) -> "Window":
        """The windows within ``half`` about the ``times``: some of them, or one of many samples."""
        low, high = np.searchsorted(t, times - half), np.searchsorted(t, times + half)
        wanted = _TYPICAL if np.median(high - low) < _FEW else 1
        chosen = np.unique(np.linspace(0, len(times) - 1, wanted + 2).astype(int)[1:-1])
        return cls(tuple(tuple((omega * (t[low[i] : high[i]] - times[i])).tolist()) for i in chosen))

    def lateness(self, velocity: float, position: int = 0) -> float:
        """b: the angle by which an extreme is found too late, over the local strength of |x|^position v|v|^(q-1)."""
        return _lateness(self, velocity, position)

    def by_exponent(self, velocity: float, position: int = 0) -> float:
        """The derivative of ``lateness`` by the exponent of the velocity."""
        low, high = max(velocity - _STEP, 0.0), velocity + _STEP
        return (self.lateness(high, position) - self.lateness(low, position)) / (high - low)


@lru_cache(maxsize=4096)
def _lateness(window: Window, velocity: float, position: int) -> float:
    r, weight = np.polynomial.legendre.leggauss(_NODES)
    r, weight = (r + 1) / 2, weight / 2
    found = []
    for places in window.places:
        u = np.array(places)
        s = np.abs(u)[:, None] * r**3
        forced = np.sin(np.abs(u)[:, None] - s) * np.sin(s) ** velocity * np.abs(np.cos(s)) ** position
        g = (forced * 3 * r**2) @ weight * np.abs(u)
        half = float(np.abs(u).max())
        columns = np.vander(u / half, DEGREE + 1, increasing=True)
        found.append(np.linalg.lstsq(columns, np.sign(u) * g, rcond=None)[0][1] / half)
    return float(np.mean(found))
