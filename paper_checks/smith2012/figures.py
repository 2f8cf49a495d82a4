"""The figures of Smith 2012 regenerated: u = gamma x, w = gamma v / omega, three cycles from u_0 = 1.

Each function draws on matplotlib axes; positions are enclosed by balls and drawn at their midpoints.
"""

from collections.abc import Callable
from dataclasses import dataclass
from functools import cache
from itertools import islice
from math import log, pi, sqrt
from typing import Any

import numpy as np
from flint import arb
from numpy.typing import NDArray

from asymptotics.numbers.context import ctx
from asymptotics.turning.quadratic_duration import duration, elapsed
from asymptotics.turning.quadratic_map import amplitudes

Array = NDArray[np.float64]
HALF_CYCLES = 6
_POINTS = 48
GREY = "#6b7280"
FIRST_ORDER = r"to first order in $\gamma v/\omega$, (69) and (71)"


@dataclass(frozen=True)
class HalfCycle:
    """One half-swing sampled from its turning point on: angles chi, positions u, velocities w, times tau."""

    tau: Array
    u: Array
    w: Array

    def first_order_time(self) -> Array:
        """Time since the turning point by (69): theta + (2/3) w sin^2(theta), tan(theta) = w/(w^2 - |u|) continued.

        Only the falling branch is written down; the rising one is its mirror image.
        """
        sign = np.sign(self.u[0])
        u, w = sign * self.u, -np.abs(self.w)
        theta = np.arctan2(-w, u - w**2)
        return np.asarray(theta + 2 / 3 * w * np.sin(theta) ** 2)


@cache
def half_cycles(cycles: int = HALF_CYCLES) -> tuple[tuple[float, HalfCycle], ...]:
    """(starting time, half-swing) for the first half-swings, exact to plotting accuracy."""
    with ctx.workprec(64):
        p = list(islice(amplitudes(arb(2)), cycles + 1))
        starts = np.cumsum([0.0] + [float(duration(a, b).mid()) for a, b in zip(p, p[1:])])
        return tuple((float(starts[n]), _sample(p[n], p[n + 1], n)) for n in range(cycles))


def _sample(p: arb, q: arb, n: int) -> HalfCycle:
    chi = [arb.pi() * k / _POINTS for k in range(_POINTS + 1)]
    tau = np.array([float(elapsed(p, q, c).mid()) for c in chi])
    t = np.array([float(((p + q) * (1 - c.cos()) / 2).mid()) for c in chi])
    p0 = float(p.mid())
    speed = np.sqrt(np.maximum(0, ((1 + p0) * -np.expm1(-t) - t) / 2))
    sign = -1 if n % 2 else 1
    return HalfCycle(tau, sign * (p0 - t) / 2, -sign * speed)


def constants_at_one_value(axes: Any) -> None:
    """Fig. 1: S^- and S^+ over a half-cycle each, at the same value: the arcs do not meet on the u axis."""
    _, half = half_cycles()[0]
    axes.plot(half.u, half.w, label=r"$\hat S^-$, $w<0$")
    axes.plot(-half.u, -half.w, "--", label=r"$\hat S^+$, $w>0$")
    axes.plot([half.u[0], half.u[-1], -half.u[0], -half.u[-1]], [0] * 4, "o", color=GREY, markersize=4)
    _phase_axes(axes)
    axes.set_xlim(-1.15, 1.15)
    axes.legend(loc="upper right")


def closed_curve(axes: Any) -> None:
    """Fig. 4: the periodic function y(t), whose falling half is the motion, the rising half its mirror image."""
    _, half = half_cycles()[0]
    axes.plot(half.u, half.w, label="falling half, the motion")
    axes.plot(half.u[::-1], -half.w[::-1], "--", label="mirror image in time")
    _phase_axes(axes)
    axes.set_ylim(-0.75, 0.75)
    axes.legend(loc="lower center", bbox_to_anchor=(0.5, 1.0), ncol=2)


def exponential_envelope(axes: Any) -> None:
    """Fig. 6: the curve of Fig. 5, to first order, and the exponential that meets it at omega t = 0 and 2 pi."""
    tau, u = first_order_motion()
    axes.plot(tau, u, label=FIRST_ORDER)
    halves = [half for _, half in half_cycles()]
    decay = log(halves[0].u[0] / halves[2].u[0]) / (2 * pi)
    for sign in (1, -1):
        axes.plot(tau, sign * np.exp(-decay * tau), "--", color="#c2410c", label="exponential" if sign > 0 else None)
    axes.plot([0, 2 * pi], [halves[0].u[0], halves[2].u[0]], "o", color=GREY, markersize=4)
    axes.set_xlabel(r"$\omega t$")
    axes.set_ylabel(r"$u = \gamma x$")
    axes.legend(loc="upper right")


def three_oscillators(axes: Any) -> None:
    """Fig. 7: quadratic damping, linear damping through the same maxima of the first cycle, no damping."""
    halves = [half for _, half in half_cycles()]
    axes.plot(np.concatenate([h.u for h in halves]), np.concatenate([h.w for h in halves]), label="quadratic damping")
    per_turn = log(halves[0].u[0] / halves[2].u[0])
    beta = per_turn / sqrt(4 * pi**2 + per_turn**2)  # u'' + 2 beta u' + u = 0 loses this ratio in a period
    frequency = sqrt(1 - beta**2)
    tau = np.linspace(0, 6 * pi / frequency, 600)
    decay = np.exp(-beta * tau)
    place = decay * (np.cos(frequency * tau) + beta / frequency * np.sin(frequency * tau))
    axes.plot(place, -decay * np.sin(frequency * tau) / frequency, ":", label="linear damping")
    angle = np.linspace(0, 2 * pi, 200)
    axes.plot(np.cos(angle), np.sin(angle), "--", color=GREY, linewidth=1, label="no damping")
    axes.plot([halves[0].u[0], halves[2].u[0]], [0, 0], "o", color=GREY, markersize=4)
    _phase_axes(axes)
    axes.set_xlim(-1.08, 1.08)
    axes.set_ylim(-1.08, 1.08)
    axes.legend(loc="lower center", bbox_to_anchor=(0.5, 1.0), ncol=3)


def one_cycle(axes: Any) -> None:
    """Fig. 2: one full cycle in phase space, the first constant made continuous at the turning point."""
    names = (r"$\hat S^-$, $w<0$", r"$\hat S^+ + \hat S_1$, $w>0$")
    for name, style, (_, half) in zip(names, ("-", "--"), half_cycles()[:2]):
        axes.plot(half.u, half.w, style, label=name)
    _phase_axes(axes)
    axes.legend(loc="upper right")


def three_cycles(axes: Any) -> None:
    """Fig. 3: three full cycles in phase space, with the turning points of Table I."""
    halves = [half for _, half in half_cycles()]
    axes.plot(np.concatenate([h.u for h in halves]), np.concatenate([h.w for h in halves]))
    turning = [h.u[0] for h in halves]
    axes.plot(turning, np.zeros(len(turning)), "o", markersize=4, label=r"$u_0, \ldots, u_5$ (Table I)")
    _phase_axes(axes)
    axes.legend(loc="upper right")


def first_order_motion() -> tuple[Array, Array]:
    """(omega t, u) by (69), the half-cycles mated every pi as in (71)."""
    halves = [half for _, half in half_cycles()]
    tau = np.concatenate([n * np.pi + half.first_order_time() for n, half in enumerate(halves)])
    return tau, np.concatenate([half.u for half in halves])


def motion(axes: Any) -> None:
    """Fig. 5: the exact motion beside the paper's first order in gamma v/omega, half-cycles joined every pi."""
    exact = half_cycles()
    axes.plot(
        np.concatenate([start + h.tau for start, h in exact]),
        np.concatenate([h.u for _, h in exact]),
        label="exact (certified quadrature)",
    )
    axes.plot(*first_order_motion(), "--", label=FIRST_ORDER)
    axes.set_xlabel(r"$\omega t$")
    axes.set_ylabel(r"$u = \gamma x$")
    axes.legend(loc="upper right")


def _phase_axes(axes: Any) -> None:
    axes.axhline(0, color="#6b7280", linewidth=0.8)
    axes.axvline(0, color="#6b7280", linewidth=0.8)
    axes.set_xlabel(r"$u = \gamma x$")
    axes.set_ylabel(r"$w = \gamma v/\omega$")
    axes.set_xlim(-0.7, 1.15)
    axes.set_aspect("equal")  # a circle is a circle


FIGURES: dict[str, tuple[str, Callable[[Any], None]]] = {
    "fig1": ("The constants of the falling and the rising half-cycle at one value, u₀ = 1", constants_at_one_value),
    "fig2": ("One full cycle of the quadratically damped oscillator in phase space, u₀ = 1", one_cycle),
    "fig3": ("Three full cycles in phase space, u₀ = 1, with the six turning points of Table I", three_cycles),
    "fig4": ("The phase space plot of y(t), u₀ = 1", closed_curve),
    "fig5": ("Three full cycles: the paper's first order beside the exact motion", motion),
    "fig6": ("The exponential that meets the curve of Fig. 5 at both ends of its first period", exponential_envelope),
    "fig7": ("Three cycles in phase space: quadratic damping, linear damping, no damping", three_oscillators),
}
