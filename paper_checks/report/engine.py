"""The report's page on the engine: coefficients for many exponents, each verified, in the three gauges."""

from functools import cache
from math import isnan
from typing import Any

from asymptotics.bounds.local import local_bounds
from asymptotics.expansions.half_swings.certified import quarter_swing
from asymptotics.expansions.normal_form.coefficients import expansion_coefficients
from asymptotics.expansions.normal_form.expansion import Expansion, exact_expansion, expansion_of
from asymptotics.gauges import GAUGES
from asymptotics.numbers.context import ctx
from asymptotics.numbers.exact import ExactReal, parse_real
from asymptotics.present.figures import render
from paper_checks.report import regimes, stokes_curve, validity_map
from paper_checks.report.expansion_errors import stored
from paper_checks.report.growth import growth_ratios
from paper_checks.report.measured_errors import measured_errors
from paper_checks.report.verification import exact_reference, verify

EXPONENTS = ("0", "1/2", "3/4", "1", "3/2", "5/3", "2", "5/2", "3", "4", "5", "7", "sqrt(2)")
LAWS = (["0"], ["1/2"], ["3/2"], ["2"], ["3"], ["1", "2"])
ORDER, DIGITS = 4, 12
DRAWN = ("1/10", "1/2", "9/10", "11/10", "3/2", "2", "5/2", "3", "4", "6")
BOUNDED = [([alpha], range(1, 7)) for alpha in ("1/2", "3/2", "2", "5/2", "3")]
BOUNDED += [(laws, range(1, 3)) for laws in (["0", "1"], ["1", "2"], ["1", "3"])]
AT_ONE_TIME = "{error} / {estimate} / {bound}"
GAUGE_USERS = {
    "turning-point": "this package's default; Lancaster's initial condition φ(0) = 0, A(0) = x0",
    "averaging": "direct complex normal form (z = X − iX'); the complex form of `oscilate`; Maxima's averaging",
    "no-first-harmonic": "Krylov–Bogoliubov–Mitropolsky; textbook multiple scales; oscillator form of `oscilate`",
}


@cache
def engine_data() -> dict[str, Any]:
    """All tables of the page, as text."""
    found = {"coefficients": _coefficients(), "gauges": _gauges(), "growth": _growth(), "stokes": _stokes()}
    cells = {"at_one_time": AT_ONE_TIME, "everywhere": "{all turning points}", "always": "{all times}"}
    compared = {name: _compared(cell) for name, cell in cells.items()}
    return {**found, "accuracy": _accuracy(), "bounds": _bounds(), **compared}


@cache
def validity_picture() -> str:
    """Where each order is good to 10 %, 1 % and 0.1 %, as SVG."""
    return render(validity_map.draw, size=(11, 10)).decode()


@cache
def regimes_picture() -> str:
    """Creep for alpha < 1, slow starts without overdamping for alpha > 1, as SVG."""
    return render(regimes.draw, size=(11, 3)).decode()


@cache
def stokes_picture() -> str:
    """c_1 and d_1 against alpha, and how they beat towards alpha = 1, as SVG."""
    return render(stokes_curve.draw, size=(11, 4)).decode()


def _stokes() -> list[dict[str, str]]:
    """Some rows of the stored curve."""
    found = {row["alpha"]: row for row in stokes_curve.stored()}
    return [{"alpha": alpha, "c_1": found[alpha]["c_1"], "d_1": found[alpha]["d_1"]} for alpha in DRAWN]


def _coefficients() -> list[dict[str, str]]:
    rows = []
    for text in EXPONENTS:
        alpha = parse_real(text, "alpha")
        found = expansion_coefficients([alpha], ORDER, DIGITS)
        checked = _verify(alpha)
        values = {f"p_{k}": found.amplitude[k].value for k in ("1", "3")}
        values |= {f"Omega_{k}": found.frequency[k].value for k in ("2", "4")}
        order = f"{checked.measured_order:.2f}"
        rows.append({"alpha": text, **values, "residual": str(checked.residual), "measured": order})
    return rows


def _verify(alpha: ExactReal) -> Any:
    """The expansion against an independent half-swing: exact exponents exactly, the others in balls and numerically."""
    if alpha.is_rational and alpha.rational.denominator == 1:
        integers = (int(alpha.rational),)
        return verify(exact_expansion(integers, ORDER), exact_reference(integers, ORDER))
    with ctx.workprec(150):
        return verify(_certified(alpha))


def _certified(alpha: ExactReal) -> Expansion:
    return expansion_of(quarter_swing([alpha], ORDER), arithmetic="certified")


def _accuracy() -> list[dict[str, str]]:
    """sup |X_N - X_ref| at four kappas and the fitted order, for the orders 1 to 3."""
    rows = []
    for laws in LAWS:
        for m in measured_errors(laws, (1, 2, 3), points=20):
            fitted = "exact" if isnan(m.fitted_order) else f"{m.fitted_order:.2f}"
            errors = {f"kappa = {float(k):g}": f"{e:.1e}" for k, e in zip(m.kappas, m.errors)}
            rows.append({"alpha": ", ".join(laws), "order": str(m.order), **errors, "fitted order": fitted})
    return rows


def _bounds() -> list[dict[str, str]]:
    """What the O() of each order holds on a half-swing: constants and range, proved and rounded up."""
    rows = []
    for laws, orders in BOUNDED:
        for order in orders:
            found = local_bounds([parse_real(text, "alpha") for text in laws], order).to_dict()
            amplitude = f"{found['amplitude']} δ^{found['amplitude_power']}"
            time = f"{found['frequency']} δ^{found['frequency_power']}"
            row = {"alpha": ", ".join(laws), "order": str(order), "δ up to": found["delta_max"]}
            rows.append({**row, "|L − L_N| at most": amplitude, "|T − T_N| at most": time})
    return rows


def _compared(cell: str) -> list[dict[str, str]]:
    """One row for each law and order, one column for each strength."""
    rows: dict[tuple[str, str], dict[str, str]] = {}
    for one in stored():
        row = rows.setdefault((one["alpha"], one["order"]), {"alpha": one["alpha"], "order": one["order"]})
        row[f"ε = {one['epsilon']}"] = cell.format_map(one)
    return list(rows.values())


def _gauges() -> list[dict[str, str]]:
    rows = []
    for gauge in GAUGES:
        found = expansion_coefficients([parse_real("3", "alpha")], 3, DIGITS, gauge)
        p_3, Omega_2 = found.amplitude["3"].exact, found.frequency["2"].exact
        rows.append({"gauge": gauge, "p_3": str(p_3), "Omega_2": str(Omega_2), "users": GAUGE_USERS[gauge]})
    return rows


def _growth() -> list[dict[str, str]]:
    """V_(k+2)/V_k against the predicted -k^2 (|alpha-1| p_1/2)^2, heuristic: the ratio tends to 1 like 1 - 3/k."""
    rows = []
    for alpha in (2, 3):
        ratios = dict(growth_ratios(exact_expansion((alpha,), 31)))
        rows += [{"alpha": str(alpha), "k": str(k), "ratio": f"{ratios[k]:.4f}"} for k in (10, 20, 28)]
    return rows
