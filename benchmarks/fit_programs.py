"""What other programs are asked in ``fits``: code that runs in their environment, one process for each program.

Each goes through ``records``: columns t and x; ``line``, the start (A, g, omega, p, c) of one exponential near its
optimum; ``noise``; ``law`` and ``strengths``, the true ones; ``at``, three amplitudes.  It leaves in ``answer`` for
each record ``seconds``, and ``failed``, an error's text, or what it says: ``quality`` (low, estimate, high at each
amplitude), ``strengths`` (low, high), whether its model is ``refuted``.  95 % intervals are 1.96 standard errors; a
record has 10 s of processor time.
"""

_EACH = """
import numpy, signal
from math import gamma, pi, sqrt
def fall(alpha):
    return sqrt(pi) * gamma(alpha / 2 + 1) / gamma((alpha + 3) / 2)
def too_long(*_):
    raise TimeoutError("10 s of processor time")
signal.signal(signal.SIGVTALRM, too_long)
def all_records(work):
    found = []
    for record in records:
        record = {**record, "t": numpy.array(record["t"]), "x": numpy.array(record["x"])}
        start = process_time()
        signal.setitimer(signal.ITIMER_VIRTUAL, 10)
        try:
            said = work(record)
        except Exception as error:
            said = {"failed": repr(error)}
        finally:
            signal.setitimer(signal.ITIMER_VIRTUAL, 0)
        found.append({"seconds": process_time() - start, **said})
    return {"seconds": sum(one["seconds"] for one in found), "found": found}
"""
_LINE = """
def line(t, A=1.0, g=1.0, w=1.0, p=0.0, c=0.0):
    return A * numpy.exp(-g * t) * numpy.cos(w * t + p) + c
NAMES = ("A", "g", "w", "p", "c")
def one_quality(g, error, w, at):
    ends = sorted([w / (2 * (g - 1.96 * error)), w / (2 * (g + 1.96 * error))])
    if g - 1.96 * error <= 0:
        ends = [ends[1], None]
    return [[ends[0], w / (2 * g), ends[1]] for _ in at]
"""
LMFIT_LINE = (
    _EACH
    + _LINE
    + """
import lmfit
def work(record):
    t = record["t"] - record["t"][0]
    found = lmfit.Model(line).fit(record["x"], t=t, **dict(zip(NAMES, record["line"])))
    g, w = found.params["g"], found.params["w"]
    return {"quality": one_quality(g.value, g.stderr, w.value, record["at"])}
answer = all_records(work)
"""
)
KAFE2_LINE = (
    _EACH
    + _LINE
    + """
from kafe2 import XYContainer, XYFit
def work(record):
    rows = slice(None, None, max(len(record["t"]) // 400, 1))
    data = XYContainer(record["t"][rows] - record["t"][0], record["x"][rows])
    data.add_error("y", record["noise"])
    found = XYFit(data, line)
    found.set_parameter_values(**dict(zip(NAMES, record["line"])))
    found.do_fit()
    value, error = (dict(zip(found.parameter_names, part)) for part in (found.parameter_values, found.parameter_errors))
    quality = one_quality(float(value["g"]), float(error["g"]), float(value["w"]), record["at"])
    return {"quality": quality, "refuted": bool(found.chi2_probability < 1e-3)}
answer = all_records(work)
"""
)
LMFIT_LAW = (
    _EACH
    + """
import lmfit
from scipy.integrate import solve_ivp
def work(record):
    t, size = record["t"] - record["t"][0], abs(record["line"][0])
    A, g, w, p, c = record["line"]
    def model(t, place, speed, omega, offset, **weights):
        pairs = [(alpha, weights[f"e{i}"]) for i, alpha in enumerate(record["law"])]
        law = lambda tau, y: (y[1], -y[0] - sum(e * numpy.sign(y[1]) * abs(y[1]) ** alpha for alpha, e in pairs))
        tau = omega * t
        return offset + solve_ivp(
            law, (0, tau[-1]), (place, speed), t_eval=tau, method="DOP853", rtol=1e-7, atol=1e-9 * size
        ).y[0]
    start = {f"e{i}": 1.2 * e for i, e in enumerate(record["strengths"])}
    speed = -A * numpy.sin(p) - g / w * A * numpy.cos(p)
    first = {"place": record["x"][0] - c, "speed": speed, "omega": w, "offset": c, **start}
    parameters = lmfit.Parameters()
    for name, value in first.items():
        parameters.add(name, value=value)
    # Differences of steps of 1e-4: smaller ones would see the steps of the integrator.
    fitting = {"epsfcn": 1e-8}
    found = lmfit.Model(model, independent_vars=["t"]).fit(record["x"], t=t, params=parameters, fit_kws=fitting)
    strengths = [found.params[name] for name in start]
    pairs = list(zip(record["law"], strengths))
    falls = [sum(fall(alpha) * e.value * amplitude ** (alpha - 1) for alpha, e in pairs) for amplitude in record["at"]]
    return {
        "quality": [[None, pi / (2 * one), None] for one in falls],
        "strengths": [[e.value - 1.96 * e.stderr, e.value + 1.96 * e.stderr] for e in strengths],
    }
answer = all_records(work)
"""
)
ROLLDECAY = (
    _EACH
    + """
import pandas
from rolldecayestimators.direct_estimator_cubic import EstimatorQuadraticB
def work(record):
    t, x = record["t"], record["x"] - record["line"][4]
    speed = numpy.gradient(x, t)
    data = pandas.DataFrame({"phi": x, "phi1d": speed, "phi2d": numpy.gradient(speed, t)}, index=t)
    found = EstimatorQuadraticB(fit_method="derivation")
    found.fit(data)
    if method == "integration":
        found = EstimatorQuadraticB(fit_method=method, p0={k: max(v, 1e-9) for k, v in found.parameters.items()})
        found.fit(data)
    B1, B2, C1 = (found.parameters[name] for name in ("B_1A", "B_2A", "C_1A"))
    falls = [fall(1.0) * B1 / sqrt(C1) + fall(2.0) * B2 * amplitude for amplitude in record["at"]]
    return {"quality": [[None, pi / (2 * one), None] for one in falls]}
answer = all_records(work)
"""
)
