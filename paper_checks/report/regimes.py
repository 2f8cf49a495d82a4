"""The picture of the regimes: creep after finitely many swings for alpha < 1, endless swings for alpha > 1."""

from fractions import Fraction
from typing import Any

import numpy as np

from asymptotics.law import Law, Oscillator
from asymptotics.motions.reference import reference_states
from asymptotics.numbers.exact import ExactReal

CASES = (("1/2", "1", 30), ("1/2", "1/4", 30), ("3/2", "5", 30), ("2", "40", 40))
_POINTS, _DIGITS = 160, 8


def draw(axes: Any) -> None:
    """One panel for each case: X(tau) from rest at 1, with the law of creep beside it for alpha < 1."""
    figure = axes.figure
    axes.remove()
    panels = figure.subplots(1, len(CASES), sharey=True)
    for panel, (alpha, epsilon, tau_max) in zip(panels, CASES):
        tau = [Fraction(tau_max * k, _POINTS) for k in range(1, _POINTS + 1)]
        oscillator = Oscillator(Law({alpha: epsilon}), mass=1, stiffness=1, x0=1)
        states = reference_states(oscillator, [ExactReal(t) for t in tau], _DIGITS)
        x = np.array([1.0, *(float(x.mid()) for x in states.x)])
        times = np.array([0.0, *map(float, tau)])
        panel.plot(times, x, label="motion")
        if Fraction(alpha) < 1:
            panel.plot(times[10:], np.sign(x[-1]) * creep(alpha, epsilon, times[10:]), "--", label="law of creep")
            panel.legend(loc="upper right")
        panel.axhline(0, color="#6b7280", linewidth=0.8)
        panel.set_title(rf"$\alpha = {alpha},\ \varepsilon = {epsilon}$")
        panel.set_xlabel(r"$\tau = \omega_0 t$")
    panels[0].set_ylabel(r"$X = x/x_0$")
    panels[0].set_ylim(-0.85, 1.05)


def creep(alpha: str, epsilon: str, tau: Any) -> Any:
    """[alpha/(1-alpha)]^(alpha/(1-alpha)) epsilon^(1/(1-alpha)) tau^(-alpha/(1-alpha)) (derivation ``creep``)."""
    a = float(Fraction(alpha))
    power = a / (1 - a)
    return power**power * float(Fraction(epsilon)) ** (1 / (1 - a)) * np.asarray(tau) ** -power
