"""A figure for each theory page, drawn when the docs are made, with the law and the numbers of the page.

``docs/theory/figures/NAME.svg`` is written once for each version of this file; the picture is looked at like those of
the gallery (``picture_faults``).
"""

from fractions import Fraction
from pathlib import Path

import numpy as np
from picture_faults import faults

import asymptotics as asy
from asymptotics.certificates.of_results import of_turning_points
from asymptotics.decays.identification.identifiability import swings_needed
from asymptotics.present.drawn import head
from asymptotics.present.figures import render

TAU = np.linspace(0, 40, 801)


def values(texts):
    """Exact texts as doubles, for an axis."""
    return [float(Fraction(text)) for text in texts]


def half_swing(axes):
    """A'/A of one half-swing against its strength: certified numbers, and the series through delta^3."""
    delta = np.linspace(0, 1.5, 61)
    for i, alpha in enumerate(("0", "1", "3/2", "2")):
        if alpha != "0":
            row = asy.half_swing(alpha, order=3).log_ratio
            series = np.exp(sum(float(c.value) * delta ** int(k) for k, c in row.items()))
            axes.plot(delta, series, ":", color=f"C{i}", linewidth=1)
        places = [d for d in ("1/10", "3/10", "1/2", "4/5", "6/5", "3/2") if alpha != "0" or d in ("1/10", "3/10")]
        exact = [float(asy.half_swing(alpha, delta=d, digits=6).amplitude) for d in places]
        axes.plot(values(places), exact, "o", color=f"C{i}", markersize=4, label=f"α = {alpha}")
    axes.set(xlabel="local strength δ", ylabel="A′/A", ylim=(0, 1.02))


def gauges(axes):
    """The slow amplitude of one motion in the three gauges, minus the motion's own envelope."""
    law = {2: "3/10"}
    base = asy.motion(law, order=4).sample(TAU).amplitude
    for gauge in ("turning-point", "averaging", "no-first-harmonic"):
        found = asy.motion(law, order=4, gauge=gauge).sample(TAU).amplitude
        axes.plot(TAU, found - base, label=gauge)
    axes.set(xlabel="τ = ω₀ t", ylabel="A − A (turning-point)")


def springs(axes):
    """The half-swing of a pendulum in air: how the spring changes the loss with the amplitude."""
    amplitudes = [0.2, 0.6, 1, 1.4, 1.8, 2.2, 2.6, 2.9]
    for name, spring in (("pendulum", "pendulum"), ("linear spring", None)):
        lost = []
        for a in amplitudes:
            motion = asy.turning_points(asy.Oscillator({2: "1/10"}, spring=spring, x0=str(a)), 2, digits=8)
            lost.append(-np.log(abs(float(motion.points[1].x)) / a))
        axes.plot(amplitudes, lost, "o-", markersize=4, label=name)
    axes.set(xlabel="amplitude (rad)", ylabel="ln(A / A′)")


def closed_forms(axes):
    """p_1 and -Omega_2 as functions of the exponent, and what the squaring trick takes for p_1."""
    x = [k / 4 for k in range(21)]
    first = [float(asy.moment(str(a + 1), digits=8)) for a in x]
    second = [(a / (a + 1)) ** 2 * float(asy.moment(str(2 * a), digits=8)) for a in x]
    axes.plot(x, first, label="p₁ = M(α+1)")
    axes.plot(x, [2 ** (-(a + 1) / 2) for a in x], "--", label="squaring trick")
    axes.plot(x, second, label="−Ω₂ = (α/(α+1))² M(2α)")
    axes.set(xlabel="exponent α", ylabel="coefficient", ylim=(0, None))


def slow_flow(axes):
    """The averaged amplitude of four laws of one strength, and of two together."""
    tau = np.linspace(0, 60, 601)
    for name, law in {
        "α = 0": {0: "1/50"},
        "α = 1": {1: "1/20"},
        "α = 2": {2: "1/20"},
        "1 and 2": {1: "1/20", 2: "1/20"},
    }.items():
        axes.plot(tau, asy.envelope(law).amplitudes(tau), label=name)
    axes.set(xlabel="τ = ω₀ t", ylabel="A / A(0)", ylim=(0, 1.02))


def multiple_scales(axes):
    """The error of the expansion, order by order, against the reference motion."""
    law, tau = {3: "1/5"}, np.linspace(0.1, 20, 400)
    truth = asy.reference(law).sample(tau).x
    for order in (1, 2, 3, 4):
        error = np.abs(asy.motion(law, order=order).sample(tau).x - truth)
        axes.plot(tau, np.maximum.accumulate(error), label=f"order {order}")
    axes.set(xlabel="τ = ω₀ t", ylabel="largest |x − x_N| so far", yscale="log")


def equivalent_damping(axes):
    """Q against the amplitude: first order, and the motion itself."""
    amplitudes = [0.05, 0.1, 0.2, 0.4, 0.8, 1.6]
    for i, (name, law) in enumerate({"α = 0": {0: "1/100"}, "α = 1": {1: "1/50"}, "α = 2": {2: "1/20"}}.items()):
        rows = asy.damping(law, [str(a) for a in amplitudes], digits=5).rows
        axes.loglog(amplitudes, [float(r.first.Q) for r in rows], color=f"C{i}", label=name)
        axes.loglog(amplitudes, [float(r.motion.Q) for r in rows], "o", color=f"C{i}", markersize=4)
    axes.set(xlabel="amplitude A", ylabel="Q (dots: of the motion itself)")


def finite_strength(axes):
    """What the three kinds of laws do at a strength of 1/2: stick, creep, go on."""
    tau = np.linspace(0, 25, 501)
    for name, law in {
        "α = 0 sticks": {0: "1/8"},
        "α = 1/2 creeps": {"1/2": "1/2"},
        "α = 2 goes on": {2: "1/2"},
    }.items():
        axes.plot(tau, asy.reference(law).sample(tau).x, label=name)
    axes.set(xlabel="τ = ω₀ t", ylabel="x / x₀")


def error_bounds(axes):
    """A proved bound of |x - x_N| at a time, beside the error that there is."""
    law, times = {2: "1/20"}, ["2", "5", "10", "20", "40"]
    for i, order in enumerate((1, 2, 3)):
        motion, truth = asy.motion(law, order=order), asy.reference(law)
        bound = [float(motion.bound(t)) for t in times]
        error = [abs(float(motion.at(t, digits=15).x) - float(truth.at(t, digits=15).x)) for t in times]
        axes.semilogy([float(t) for t in times], bound, "-", color=f"C{i}", label=f"order {order}, proved")
        axes.semilogy([float(t) for t in times], error, "o", color=f"C{i}", markersize=4)
    axes.set(xlabel="τ = ω₀ t", ylabel="|x − x_N| (dots: what there is)")


def large_orders(axes):
    """The terms of the series of p against their order: they fall, and then grow for ever."""
    row, orders = asy.expand(3, order=25).p, range(1, 26, 2)
    for delta in (0.2, 0.4, 0.8):
        axes.semilogy(orders, [abs(float(row[k])) * delta**k for k in orders], "o-", markersize=3, label=f"δ = {delta}")
    axes.set(xlabel="order k", ylabel="|p_k| δ^k")


def why_the_series_diverge(axes):
    """What is left where the series is best stopped, as measured, beside |c_1| exp(-action/delta)."""
    constants, equations = asy.stokes(2, digits=8), asy.expand(2, order=1)
    delta, texts = np.linspace(0.16, 0.36, 76), ("1/6", "1/5", "1/4", "1/3")
    wave = abs(float(constants.c(1))) * np.exp(-float(constants.action) / delta)
    axes.semilogy(1 / delta, wave, label="|c₁| exp(−2π|c|/δ)")
    left = [equations.best_order(text).errors[0] for text in texts]
    axes.semilogy([1 / d for d in values(texts)], left, "o", markersize=4, label="measured at the best order")
    axes.set(xlabel="1/δ", ylabel="error in half-swings")


def identifiability(axes):
    """Half-swings needed to tell a law from none, against the noise."""
    noise = [1e-4, 3e-4, 1e-3, 3e-3, 1e-2]
    for name, law, strengths in (("α = 2", "2", [0.02]), ("α = 1", "1", [0.005]), ("1 beside 2", "1+2", [0.002, 0.03])):
        axes.loglog(
            noise, [swings_needed(law, strengths, term=0, noise=s) for s in noise], "o-", markersize=4, label=name
        )
    axes.set(xlabel="noise / first amplitude", ylabel="half-swings needed")


def certificates(axes):
    """The size of a certificate of one half-swing, by the digits it proves."""
    digits = (5, 10, 20, 30, 40, 50)
    for law in ({2: "1/10"}, {"3/2": "1/5"}, {0: "1/50", 2: "1/10"}):
        oscillator = asy.Oscillator(law)
        tables = [asy.turning_points(oscillator, 2, digits=d, times=True) for d in digits]
        sizes = [len(of_turning_points(oscillator, table).to_json()) / 1000 for table in tables]
        axes.plot(digits, sizes, "o-", markersize=4, label=str(oscillator.law))
    axes.set(xlabel="digits", ylabel="size (kB)")


FIGURES = (
    half_swing, gauges, springs, closed_forms, slow_flow, multiple_scales, equivalent_damping, finite_strength,
    error_bounds, certificates, large_orders, why_the_series_diverge, identifiability,
)  # fmt: skip


def written(folder):
    """Draw what is not there yet; ValueError for a picture with a fault."""
    folder.mkdir(exist_ok=True)
    for figure in FIGURES:
        path = folder / f"{figure.__name__}.svg"
        if path.exists() and path.stat().st_mtime > Path(__file__).stat().st_mtime:
            continue

        def draw(axes, figure=figure):
            figure(axes)
            head(axes, [])
            found = faults(axes.figure)
            if found:
                raise ValueError(f"the figure {figure.__name__}: {'; '.join(found)}")

        path.write_bytes(render(draw, size=(6.4, 3.4), title=(figure.__doc__ or "").split("\n")[0]))


def setup(app):
    """Before Sphinx looks for pictures."""
    app.connect("builder-inited", lambda app: written(Path(app.srcdir) / "theory/figures"))
    return {"parallel_read_safe": True, "parallel_write_safe": True}
