"""How a driven response shows itself: text, table, LaTeX, and amplitude against frequency with the orbit's own."""

from typing import Any

from flint import arb

from asymptotics.driven import first_order
from asymptotics.driven.drive import Drive
from asymptotics.driven.first_numbers import FirstOrder
from asymptotics.law import Oscillator
from asymptotics.numbers.context import ctx
from asymptotics.numbers.exact import ExactReal
from asymptotics.present.drawn import Drawn
from asymptotics.present.inputs import csv_text
from asymptotics.present.shown import Page

_CURVE, _LOW = 120, 53  # points of a curve, and their bits


class ResponsePage(Drawn):
    """What is shown of a ``result.Response``."""

    oscillator: Oscillator
    force: ExactReal
    omega: ExactReal
    first_order: FirstOrder
    amplitude: str | None
    x0: str | None
    v0: str | None
    phase: str | None
    energy: str | None
    harmonics: dict[str, dict[str, str]] | None
    difference: dict[str, str] | None
    certified: bool
    method: str
    notes: tuple[str, ...]

    def rows(self) -> list[tuple[str, str, str]]:
        """(quantity, of the response, of first order), as far as there are."""
        first = self.first_order
        rows = [("amplitude", self.amplitude, first.amplitude), ("x0", self.x0, None), ("v0", self.v0, None),
                ("phase", self.phase, first.phase), ("energy per cycle", self.energy, None)]  # fmt: skip
        for name in ("amplitude", "phase"):
            label = f"{name} beyond first order"
            rows.append((label, (self.difference or {}).get(name), _estimate(first.errors().get(name))))
        for n, wave in (self.harmonics or {}).items():
            rows += [(f"{name} of harmonic {n}", value, None) for name, value in wave.items()]
        rows.append(("c_eq", None, first.c_eq))
        resonance = first.resonance or {}
        rows += [(f"{name} at omega_0", None, value) for name, value in resonance.items()]
        rows += [(f"{name} of the peak", None, value) for name, value in (first.peak or {}).items()]
        return [(name, own or "", of_first or "") for name, own, of_first in rows if own or of_first]

    def to_csv(self) -> str:
        """CSV text."""
        return csv_text(["quantity", "response", "first order"], self.rows())

    def latex(self) -> str:
        """The response, its first harmonic, or the first order where that is all there is."""
        A, lag = self.first_order.amplitude, self.first_order.phase
        if self.harmonics:
            A, lag = self.harmonics["1"].values()
        return rf"x \approx {A} \cos(\Omega t - {lag})"

    def _heading(self) -> str:
        left = str(self.oscillator).partition(" = 0, x(0)")[0]
        omega = "t" if self.omega == 1 else f"{self.omega} t"
        return f"{left} = {self.force} cos({omega})"

    def __str__(self) -> str:
        rows = [("", "response", "first order"), *self.rows()]
        widths = [max(map(len, column)) for column in zip(*rows)]
        lines = ["  ".join(cell.ljust(w) for cell, w in zip(row, widths)).rstrip() for row in rows]
        told = f"certified: {str(self.certified).lower()} ({self.method})"
        return "\n".join([self._heading(), *lines, told, *self.notes])

    def _page(self) -> Page:
        told = f"certified: {str(self.certified).lower()} ({self.method})"
        return Page(self._heading(), (told, *self.notes), ("", "response", "first order"), tuple(self.rows()))

    def _formula(self) -> str:
        return self.latex()

    def _letters(self) -> dict[str, str]:
        return {r"\Omega": "frequency of the force"}

    def _curve(self, axes: Any, **style: Any) -> None:
        """The amplitude of first order against Omega, and that of the response where it was asked."""
        drive = Drive(self.oscillator, self.force, self.omega)
        with ctx.workprec(_LOW):
            middle, here = self.oscillator.omega_0(), self.omega.ball()
            low, high = min(middle, here) / 2, max(middle, here) * 3 / 2
            places = [float((low + (high - low) * n / _CURVE).mid()) for n in range(_CURVE + 1)]
            curve = [float(_amplitude(drive, omega).mid()) for omega in places]
        axes.plot(places, curve, **{"label": "first order", **style})
        if self.amplitude is not None:
            label = "the response, certified"
            axes.plot([float(here.mid())], [float(self.amplitude)], "o", markersize=4, label=label)
        axes.set(xlabel="Omega", ylabel="amplitude")


def _estimate(text: str | None) -> str | None:
    return f"{text} (estimate)" if text not in (None, "0") else text


def _amplitude(drive: Drive, omega: float) -> arb:
    """First order at another frequency, a double that chooses and is drawn."""
    numerator, denominator = omega.as_integer_ratio()
    return first_order.amplitude(Drive(drive.oscillator, drive.force, ExactReal(numerator) / denominator).balls())
