"""The picture of the README: four laws with the same decrement at the start, each with its amplitude.

python docs/picture.py        writes docs/decay.svg, the same bytes each time
"""

from pathlib import Path

import numpy as np

import asymptotics as asy
from asymptotics.present.figures import render

LAWS = {"dry friction, α = 0": {0: "0.0234"}, "α = 1/2": {"1/2": "0.028"}, "viscous, α = 1": {1: "0.03"}}
LAWS |= {"air, α = 2": {2: "0.0353"}}


def draw(axes):
    """x(t) of the viscous oscillator behind the amplitudes of all four."""
    tau = np.linspace(0, 90, 1801)
    axes.plot(tau, asy.motion(LAWS["viscous, α = 1"]).sample(tau).x, color="#d1d5db", linewidth=0.8)
    for name, law in LAWS.items():
        axes.plot(tau, asy.envelope(law).amplitudes(tau), label=name)
    axes.set(xlabel="τ = ω₀ t", ylabel="x / x₀", xlim=(0, 90), ylim=(-1, 1.02))
    axes.legend(ncols=4, loc="lower center", bbox_to_anchor=(0.5, 1.0))


if __name__ == "__main__":
    (Path(__file__).parent / "decay.svg").write_bytes(render(draw, size=(7.2, 3.2)))
