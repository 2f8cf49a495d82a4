"""A record of quadratic damping: ``identify``, which weighs all candidates, beside a fit of the one right law by lmfit.

lmfit is told the law and starts next to the truth; its model integrates the motion by DOP853 for every set of
parameters.  Both give 95 per cent of confidence; 1/50 is right.
"""

from time import process_time

import numpy as np

import asymptotics as asy
from benchmarks.decays import Array, motion
from benchmarks.peers import ask
from benchmarks.table import Table, seconds_text

PEERS = ("lmfit", "scipy")
EPSILON, OMEGA, NOISE = 0.02, 1.3, 1e-3
LMFIT = """
import lmfit, numpy
from scipy.integrate import solve_ivp
t, x = numpy.array(t), numpy.array(x)
def model(t, place, speed, omega, epsilon):
    law = lambda tau, y: (y[1], -y[0] - epsilon * y[1] * abs(y[1]))
    tau = omega * t
    return solve_ivp(law, (0, tau[-1]), (place, speed), t_eval=tau, method="DOP853", rtol=1e-8, atol=1e-10).y[0]
def fit():
    return lmfit.Model(model).fit(x, t=t, place=x[0], speed=0.0, omega=omega, epsilon=0.01)
seconds, found = best(fit, 1)
epsilon = found.params["epsilon"]
answer = {"seconds": seconds, "epsilon": epsilon.value, "error": epsilon.stderr}
"""


def record(rows: int) -> dict[str, Array]:
    """20 samples a period of X from rest at 1, with noise."""
    t = np.arange(rows) * 2 * np.pi / (20 * OMEGA)
    x, _ = motion(lambda x: x, [(2.0, EPSILON)], 1.0, OMEGA * t)
    return {"t": t, "x": x + NOISE * np.random.default_rng(rows).standard_normal(rows)}


def run(size: int = 1000) -> Table:
    """``size`` samples."""
    data = record(size)
    start = process_time()
    found = asy.identify(data)
    seconds = process_time() - start
    law = found.law("2").law.epsilon[0]
    rows = [("identify, all candidates", seconds_text(seconds), "1.0", _interval(law.low, law.high))]
    peer = ask(LMFIT, t=data["t"].tolist(), x=data["x"].tolist(), omega=1.001 * OMEGA)
    said, ratio = "-", "-"
    if "epsilon" in peer:
        wide = 1.96 * peer["error"]
        said, ratio = _interval(peer["epsilon"] - wide, peer["epsilon"] + wide), f"{peer['seconds'] / seconds:.2g}"
    rows.append(("lmfit, the right law", seconds_text(peer["seconds"]), ratio, said))
    return Table(f"The law of {size} samples", ("what", "seconds", "ratio", "strength"), tuple(rows))


def _interval(low: float, high: float) -> str:
    return f"{low:.5f} to {high:.5f}"
