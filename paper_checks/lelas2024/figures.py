"""The figures of Lelas 2024 regenerated, with the exact motions beside the paper's approximations.

m = 1.5 kg, k = 30 N/m, x0 = 0.2 m, g = 9.81 m/s^2; friction mu = 0.01 and 0.03, drag C = 0.2 and 2 N s^2/m^2.  The
range of times is not in the text: up to just after the stop in Fig. 1, ten seconds in Fig. 2.
"""

from collections.abc import Callable
from fractions import Fraction
from functools import partial
from math import pi, sqrt
from typing import Any

import numpy as np
from flint import arb
from numpy.typing import NDArray

from asymptotics.numbers.context import ctx
from asymptotics.turning.quadratic_duration import duration, elapsed
from asymptotics.turning.quadratic_map import amplitudes
from paper_checks.lelas2024.model import half_swings
from paper_checks.lelas2024.section_5 import PANELS, rest, strength
from paper_checks.lelas2024.section_6 import DRAG, air_strength

Array = NDArray[np.float64]
OMEGA, X0 = sqrt(20), 0.2
LONGEST = 10.0  # seconds, Fig. 2
PHASES = 24
OURS, AVERAGED, EXACT, STOP = "#c2410c", "#1f4e9c", "#111827", "#15803d"


def friction(axes: Any, *, mu: Fraction) -> None:
    """Fig. 1: (47), (48) and the exact motion (49), which stays where it stops."""
    eps, swings = float(strength(mu)), half_swings(strength(mu))
    stop, place = swings * pi / OMEGA, float(rest(mu)) * X0
    t = np.linspace(0, 1.1 * stop, 1500)
    axes.plot(*_until_zero(t, 1 - eps * OMEGA * t / sqrt(2)), color=OURS, label="(47), squaring trick")
    axes.plot(*_until_zero(t, 1 - 2 * eps * OMEGA * t / pi), "-.", color=AVERAGED, label="(48), averaging")
    axes.plot(t, X0 * _friction_motion(OMEGA * t, eps, swings), "--", color=EXACT, label="exact, (49)", linewidth=1.2)
    axes.plot([stop], [place], "o", color=STOP, markersize=5, label=f"rest: {stop:.2f} s, ${place / X0:+.3f}\\,x_0$")
    axes.set_ylim(-0.2, 0.3)
    _labels(axes)


def _until_zero(t: Array, amplitude: Array) -> tuple[Array, Array]:
    """A motion with a linear amplitude, up to the end of its validity."""
    moving = amplitude >= 0
    return t[moving], X0 * amplitude[moving] * np.cos(OMEGA * t[moving])


def _friction_motion(tau: Array, eps: float, swings: int) -> Array:
    n = np.minimum(np.floor(tau / pi), swings - 1)
    return np.asarray((1 - (2 * n + 1) * eps) * np.cos(np.minimum(tau, swings * pi)) + eps * (-1) ** n)


def air(axes: Any, *, drag: Fraction) -> None:
    """Fig. 2: (51), (52) and the exact motion by quadrature, with its turning points."""
    eps = float(air_strength(drag))
    t = np.linspace(0, LONGEST, 1500)
    axes.plot(t, X0 * np.cos(OMEGA * t) / (1 + eps * OMEGA * t / sqrt(8)), color=OURS, label="(51), squaring trick")
    averaged = X0 * np.cos(OMEGA * t) / (1 + 4 * eps * OMEGA * t / (3 * pi))
    axes.plot(t, averaged, "-.", color=AVERAGED, label="(52), averaging")
    time, place = _air_motion(air_strength(drag))
    shown = time <= OMEGA * LONGEST
    axes.plot(time[shown] / OMEGA, X0 * place[shown], "--", color=EXACT, label="exact, by quadrature", linewidth=1.2)
    turning = np.flatnonzero(shown)[::PHASES]
    axes.plot(time[turning] / OMEGA, X0 * place[turning], "o", color=STOP, markersize=3.5, label="turning points")
    axes.set_ylim(-0.22, 0.34)
    _labels(axes)


def _air_motion(eps: Fraction) -> tuple[Array, Array]:
    """omega_0 t and x/x0 at PHASES points of each half-swing, up to LONGEST."""
    with ctx.workprec(64):
        start = 2 * arb(eps.numerator) / eps.denominator
        sizes = amplitudes(start)
        p, begin, sign = next(sizes), 0.0, 1
        times, places = [], []
        while begin <= OMEGA * LONGEST:
            q = next(sizes)
            for j in range(PHASES):
                chi = arb.pi() * j / PHASES
                times.append(begin + float(elapsed(p, q, chi).mid()))
                places.append(sign * float(((p - (p + q) * (1 - chi.cos()) / 2) / start).mid()))
            begin, p, sign = begin + float(duration(p, q).mid()), q, -sign
        return np.array(times), np.array(places)


def _labels(axes: Any) -> None:
    axes.axhline(0, color="#6b7280", linewidth=0.8)
    axes.set_xlabel(r"$t$ / s")
    axes.set_ylabel(r"$x$ / m")
    axes.set_xlim(left=0)
    axes.legend(loc="upper right", ncol=2)


FIGURES: dict[str, tuple[str, Callable[[Any], None]]] = {
    "fig1a": ("Fig. 1(a) Sliding friction, μ = 0.01", partial(friction, mu=PANELS[0])),
    "fig1b": ("Fig. 1(b) Sliding friction, μ = 0.03", partial(friction, mu=PANELS[1])),
    "fig2a": ("Fig. 2(a) Air resistance, C = 0.2 N s²/m²", partial(air, drag=DRAG["2a"])),
    "fig2b": ("Fig. 2(b) Air resistance, C = 2 N s²/m²", partial(air, drag=DRAG["2b"])),
}
