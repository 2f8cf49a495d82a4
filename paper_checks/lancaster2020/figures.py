"""The figures of Lancaster 2020 regenerated: x/x0 against omega_0 t, from rest.

The numerical solution is computed half-swing by half-swing with the sign of v fixed on each, so that the mass stops
exactly; beside the paper's A cos(omega_0 t) stands the same amplitude with the phase of second order (turning-point
gauge), d phi/d tau = - sum_ij alpha_i alpha_j M_(alpha_i+alpha_j) delta_i delta_j/((alpha_i+1)(alpha_j+1)).

>>> run = Run.of({"3/2": "0.4152"}, 20)
>>> late = run.tau > 10
>>> paper, ours = (abs(run.exact - curve)[late].max() for curve in (run.paper, run.second_order))
>>> round(run.kappas[0], 4), bool(ours < paper / 2)
(0.19, True)
"""

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray
from sympy import Rational

from asymptotics.envelopes.numeric import NumericEnvelope
from asymptotics.expansions.moments.certified import moment
from asymptotics.numbers.exact import parse_real
from paper_checks.lancaster2020.model import exact_states

Array = NDArray[np.float64]
KAPPA_1, KAPPA_2 = "0.0659734", "0.4152"  # epsilon = pi kappa/2 for kappa = 0.042; epsilon = kappa/M_(5/2) for 0.19
EPSILON_3 = "0.1"
_PER_UNIT = 12


@dataclass(frozen=True, eq=False)
class Run:
    """One motion with its approximations on a grid of times: heuristic floats, for plotting."""

    tau: Array
    exact: Array
    alphas: tuple[float, ...]
    strengths: tuple[float, ...]

    @classmethod
    def of(cls, laws: Mapping[str, str], end: int) -> "Run":
        """From {alpha: epsilon} up to omega_0 t = end."""
        times = [Rational(n, _PER_UNIT) for n in range(end * _PER_UNIT + 1)]
        pairs = tuple((alpha, str(Rational(epsilon))) for alpha, epsilon in laws.items())
        states = exact_states(pairs, tuple(map(str, times)))
        alphas, strengths = (tuple(float(Rational(value)) for value in column) for column in zip(*pairs))
        return cls(np.array([float(time) for time in times]), np.array([x for x, _ in states]), alphas, strengths)

    @cached_property
    def kappas(self) -> tuple[float, ...]:
        """M_(alpha+1) epsilon for each law."""
        return tuple(_moment(a + 1) * e for a, e in zip(self.alphas, self.strengths))

    @cached_property
    def amplitude(self) -> Array:
        """The averaged amplitude (13) or (21); for alpha = 0 the straight line of Table I, also below zero."""
        if self.alphas == (0.0,):
            return np.asarray(1 - self.kappas[0] * self.tau)
        return NumericEnvelope.of(zip(self.alphas, self.kappas)).amplitude(self.tau)

    @property
    def paper(self) -> Array:
        """A(t) cos(omega_0 t)."""
        return np.asarray(self.amplitude * np.cos(self.tau))

    @property
    def second_order(self) -> Array:
        """A(t) cos(omega_0 t + phi(t))."""
        return np.asarray(self.amplitude * np.cos(self.tau + self.phase))

    @cached_property
    def phase(self) -> Array:
        """phi by the trapezoidal rule."""
        laws = [(a / (a + 1) * e * self.amplitude ** (a - 1), a) for a, e in zip(self.alphas, self.strengths)]
        rate = -sum((_moment(a + c) * f * g for f, a in laws for g, c in laws), np.zeros_like(self.tau))
        steps = np.diff(self.tau) * (rate[1:] + rate[:-1]) / 2
        return np.concatenate([[0.0], np.cumsum(steps)])


def _moment(p: float) -> float:
    return float(moment(parse_real(str(Rational(p)), "p").ball()).mid())


def dry_friction(axes: Any) -> None:
    """Fig. 1: the mass stops away from equilibrium; Table I goes on and grows again."""
    run, epsilon = Run.of({"0": KAPPA_1}, 36), float(KAPPA_1)
    axes.axhspan(-epsilon, epsilon, color="#fde68a", alpha=0.6, linewidth=0, label=r"friction holds, $|x| \leq b/k$")
    _curves(axes, run, ["numerical", "paper"])
    turning = 1 - 2 * epsilon * np.arange(9)
    axes.plot(np.pi * np.arange(9), turning * (-1.0) ** np.arange(9), "o", color="#15803d", markersize=4,
              label=r"exact: $(-1)^n(x_0 - 2nb/k)$, stop at $n = 8$")  # fmt: skip
    axes.set_ylim(-1.05, 1.55)
    axes.legend(loc="upper right", ncols=2, fontsize=9)


def three_halves(axes: Any) -> None:
    """Fig. 2: alpha = 3/2."""
    _curves(axes, Run.of({"3/2": KAPPA_2}, 32), ["numerical", "paper", "second"])
    axes.set_ylim(-0.75, 1.05)
    axes.legend(loc="upper right", fontsize=9)


def two_laws(axes: Any) -> None:
    """Fig. 3: alpha = 1 and alpha' = 2 with b = omega_0 x0 b', and the long-time limit (22)."""
    run = Run.of({"1": EPSILON_3, "2": EPSILON_3}, 44)
    _curves(axes, run, ["numerical", "paper", "second"])
    late = np.exp(-run.kappas[0] * run.tau) / (1 + run.kappas[1] / run.kappas[0])
    axes.plot(run.tau, late * np.cos(run.tau), ":", color="#7e22ce", label="long-time limit (22)")
    axes.set_ylim(-0.85, 1.05)
    axes.legend(loc="upper right", fontsize=9)


LABELS: dict[str, tuple[str, str, Callable[[Run], Array], dict[str, Any]]] = {
    "numerical": ("numerical, half-swing by half-swing", "-", lambda run: run.exact, {"color": "#1f4e9c"}),
    "paper": (r"paper: $A(t)\,\cos(\omega_0 t)$", "--", lambda run: run.paper, {"color": "#c2410c"}),
    "second": (
        r"with the second-order phase: $A(t)\,\cos(\omega_0 t + \varphi)$", "-.", lambda run: run.second_order,
        {"color": "#15803d"},
    ),
}  # fmt: skip


def _curves(axes: Any, run: Run, names: list[str]) -> None:
    for name in names:
        label, style, values, options = LABELS[name]
        axes.plot(run.tau, values(run), style, label=label, **options)
    axes.axhline(0, color="#6b7280", linewidth=0.8)
    axes.set_xlim(0, run.tau[-1])
    axes.set_xlabel(r"$\omega_0 t$")
    axes.set_ylabel(r"$x/x_0$")


FIGURES: dict[str, tuple[str, Callable[[Any], None]]] = {
    "fig1": ("Dry friction, κ = 0.042: the mass stops at x = −0.056 x₀, the approximation goes on", dry_friction),
    "fig2": ("α = 3/2, κ = 0.19: amplitude right to 0.02 %, the phase corrected in second order", three_halves),
    "fig3": ("Viscous and quadratic drag, b = ω₀x₀b′ = mω₀/10: (21) and its long-time limit (22)", two_laws),
}
