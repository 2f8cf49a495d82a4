"""A limit cycle for people and for JSON: rows of coefficients in mu, and what is proved at a number mu.

>>> found = limit_cycle(Law({1: -1, (1, 2): 1}), 4, 12)
>>> found.amplitude["2"], found.frequency["4"]
(Coefficient(value='0.0104166666667', expression=1/96), Coefficient(value='0.00553385416667', expression=17/3072))
>>> found.multiplier["1"].exact
'-2*pi'
"""

from dataclasses import dataclass
from fractions import Fraction
from typing import Any, NoReturn

import numpy as np
import sympy
from flint import arb, fmpq

from asymptotics.errors import AbsentError
from asymptotics.expansions.half_swings.pi_decimals import exact_coefficient
from asymptotics.expansions.half_swings.pi_ring import PI
from asymptotics.expansions.normal_form.results import Coefficient, Row, row_to_dict
from asymptotics.expansions.normal_form.show import sum_latex
from asymptotics.law import Law
from asymptotics.limit_cycles.certified import CertifiedCycle, certified_limit_cycle
from asymptotics.limit_cycles.series import LimitCycleSeries, balanced_square, limit_cycle_series, require_polynomial
from asymptotics.numbers.bridge import to_sympy
from asymptotics.numbers.decimals import bits_for, certified_decimal, decimal_of_ball
from asymptotics.numbers.exact import ExactReal
from asymptotics.numbers.precision import at_growing_precision
from asymptotics.numbers.value import coefficient_columns
from asymptotics.present.drawn import Drawn
from asymptotics.present.shown import Page, Rows
from asymptotics.series import Series
from asymptotics.terms import signed_sum

_POINTS = 401


@dataclass(frozen=True, repr=False)
class LimitCycle(Rows, Drawn):
    """Series in mu through ``order``: turning amplitude, frequency, multiplier of a period and its logarithm.

    Amplitude and frequency are even in mu, the logarithm is odd; ``at_mu`` is what was proved at a number mu.
    """

    law: Law
    order: int
    arithmetic: str
    amplitude: Row
    frequency: Row
    log_multiplier: Row
    multiplier: Row
    at_mu: CertifiedCycle | None = None

    @property
    def at(self) -> NoReturn:
        """AbsentError: the former name of ``at_mu``; of every other result ``at`` is a method."""
        raise AbsentError("at", "a limit cycle has no such field", ".at_mu, the certified cycle at the number mu")

    def to_dict(self) -> dict[str, Any]:
        """The result as a JSON-ready mapping: numbers are strings."""
        names = ("amplitude", "frequency", "multiplier", "log_multiplier")
        head = {"law": str(self.law), "equation": self.equation, "order": self.order, "arithmetic": self.arithmetic}
        rows = {name: row_to_dict(getattr(self, name)) for name in names}
        return {**head, **rows, "at": None if self.at_mu is None else self.at_mu.to_dict()}

    def _named(self) -> list[tuple[str, str, Coefficient]]:
        names = ("amplitude", "frequency", "multiplier", "log_multiplier")
        return [(name, key, c) for name in names for key, c in getattr(self, name).items()]

    def _page(self) -> Page:
        proved = () if self.at_mu is None else (self.at_mu._page().title + " (certified)",)
        worth = f"{self.arithmetic} coefficients of powers of mu, through order {self.order}; no bound on the remainder"
        rows = tuple((name, key, c, c.exact or "") for name, key, c in self._named() if not c.is_zero)
        lines = (*proved, worth) if rows else proved
        head = ("series", "power of mu", "value", "exact") if rows else ()
        return Page(f"limit cycle of {self.equation}", lines, head, rows)

    @property
    def equation(self) -> str:
        """The equation of motion as text: mu multiplies the losses, springs stand beside x."""
        springs = [str(t) for t in self.law.springs]
        beside = "".join(f" - {t[1:]}" if t.startswith("-") else f" + {t}" for t in springs)
        return f"x'' + x{beside} + mu ({signed_sum(self.law.losses)}) = 0"

    def _curve(self, axes: Any, **style: Any) -> None:
        """Amplitude (over that at mu = 0) and frequency against mu, the certified cycle as points."""
        rows = {"amplitude": self.amplitude, "frequency": self.frequency}
        last = style.pop("until", None) or (1.0 if self.at_mu is None else 1.2 * abs(float(Fraction(self.at_mu.mu))))
        mu = np.linspace(0.0, float(last), _POINTS)
        for name, row in rows.items():
            start = float(row["0"].text()) if row else 1.0
            scale, told = (start, f"amplitude / {start:g}") if name == "amplitude" else (1.0, name)
            if row:
                value = sum((float(c.text()) * mu ** int(key) for key, c in row.items()), 0.0 * mu)
                axes.plot(mu, value / scale, **{"label": told, **(style if name == "amplitude" else {})})
            if self.at_mu is not None:
                color = axes.lines[-1].get_color() if row else None
                point = [abs(float(Fraction(self.at_mu.mu)))], [float(getattr(self.at_mu, name)) / scale]
                axes.plot(*point, "o", color=color, label=f"{told}, certified")
        axes.set(xlabel=r"$\mu$", ylabel="series through order " + str(self.order) if self.amplitude else "certified")

    def _table(self) -> dict[str, list[Any]]:
        named = self._named()
        columns: dict[str, list[Any]] = {
            "series": [name for name, _, _ in named],
            "power": [int(key) for _, key, _ in named],
        }
        return columns | coefficient_columns([c for _, _, c in named])

    def _formula(self) -> str:
        if not self.amplitude and self.at_mu is not None:
            return self.at_mu._formula()
        a, w = (_latex(row) for row in (self.amplitude, self.frequency))
        return rf"A = {a},\quad \omega = {w}"

    def _letters(self) -> dict[str, str]:
        return {
            "A": "turning amplitude of the cycle", "T": "its period, in units of 1/omega_0",
            r"\rho": "its multiplier: what a small departure is multiplied by in a period",
            r"\omega": "its frequency, in units of omega_0",
        }  # fmt: skip


def limit_cycle(
    law: Law, order: int, digits: int, mu: ExactReal | None = None, near: float | None = None
) -> LimitCycle:
    """The limit cycle of x'' + x + mu (law) = 0 through mu^order, and at the number ``mu`` if it is given.

    ``near``: the amplitude of the cycle that is meant, if there are several.  Springs x^p x'^q in the law stand beside
    x and are not multiplied by mu: then there is the cycle at the number mu alone, and no series.
    Raises InputError for a law without a limit cycle, with several, or that is no polynomial, and as
    `certified_limit_cycle`.
    """
    springs = any(t.sign > 0 for t in law.terms)
    if springs and mu is not None:
        require_polynomial(law, springs=True)
        guess = near or float(arb(balanced_square(law.losses)).sqrt().mid())
        return LimitCycle(law, order, "certified", {}, {}, {}, {}, certified_limit_cycle(law, mu, digits, guess))
    series = limit_cycle_series(law, order, near)
    at = None
    if mu is not None:
        at = certified_limit_cycle(law, mu, digits, float(arb(series.square).sqrt().mid()))
    if series.is_exact:
        return LimitCycle(law, order, "exact", *_exact_rows(series, digits), at)
    return LimitCycle(law, order, "certified", *_ball_rows(law, order, digits, near), at)


def _exact_rows(series: LimitCycleSeries, digits: int) -> tuple[Row, Row, Row, Row]:
    root = sympy.sqrt(to_sympy(series.square))

    def amplitude(c: Any) -> Coefficient:
        if root.is_rational:
            return exact_coefficient(c * fmpq(int(root.p), int(root.q)), digits)
        value = certified_decimal(lambda: arb(c) * arb(series.square).sqrt(), digits) if c != 0 else "0"
        return Coefficient(value, to_sympy(c) * root)

    logs = {k: PI * c for k, c in series.log_multiplier.items()}
    power = Series({(k,): c for k, c in logs.items()}, 1, series.order).exp()
    amplitudes = {str(k): amplitude(c) for k, c in series.amplitude.items()}
    rows: tuple[dict[int, Any], ...] = (series.frequency, logs, {k: power[k] for k in range(series.order + 1)})
    frequency, logarithm, multiplier = ({str(k): exact_coefficient(c, digits) for k, c in row.items()} for row in rows)
    return amplitudes, frequency, logarithm, multiplier


def _ball_rows(law: Law, order: int, digits: int, near: float | None) -> tuple[Row, Row, Row, Row]:
    """Digits from balls; the precision grows until all are rounded."""

    def attempt(_bits: int) -> tuple[Row, Row, Row, Row] | None:
        series = limit_cycle_series(law, order, near)
        root, pi = arb(series.square).sqrt(), arb.pi()
        logs = {k: c * pi for k, c in series.log_multiplier.items()}
        power = Series({(k,): c for k, c in logs.items()}, 1, order).exp()
        rows: list[dict[int, Any]] = [
            {k: c * root for k, c in series.amplitude.items()}, series.frequency, logs,
            {k: power[k] for k in range(order + 1)},
        ]  # fmt: skip
        texts = [{k: decimal_of_ball(arb(c), digits) for k, c in row.items()} for row in rows]
        if not all(text for row in texts for text in row.values()):
            return None
        made = [{str(k): Coefficient(text, None) for k, text in row.items()} for row in texts]
        return made[0], made[1], made[2], made[3]

    # The recurrence divides and cancels at each order: sixteen bits an order to begin with, and more if a coefficient
    # is not rounded.
    bits = bits_for(digits, 16 * order + 64)
    return at_growing_precision(attempt, digits, bits, max_bits=32 * bits)


def _latex(row: Row) -> str:
    return sum_latex({(int(key),): c for key, c in row.items()}, (r"\mu",))
