"""How a driven response shows itself: text, table, LaTeX, and amplitude against frequency with the orbit's own."""

from math import nan, pi
from typing import Any

from flint import arb

from asymptotics.driven import first_order
from asymptotics.driven.drive import Drive
from asymptotics.driven.first_numbers import FirstOrder
from asymptotics.expansions.moments.certified import moment
from asymptotics.frames import Frame
from asymptotics.law import Oscillator
from asymptotics.numbers.context import ctx
from asymptotics.numbers.exact import ExactReal
from asymptotics.numbers.latex import latex
from asymptotics.present.drawn import Drawn
from asymptotics.present.inputs import csv_text
from asymptotics.present.shown import Page, Rows

_CURVE, _LOW = 120, 53  # points of a curve, and their bits


class ResponsePage(Drawn, Rows):
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
    frame: Frame

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
        return [(self._named(name), own or "", of_first or "") for name, own, of_first in rows if own or of_first]

    def _named(self, quantity: str) -> str:
        """A quantity with its unit; none of a law alone."""
        frame, kind = self.frame, quantity.split()[0]
        units = {"v0": frame.unit("v"), "phase": "rad", "energy": "J", "c_eq": frame.unit_of_loss("1"),
                 "omega": "rad/s", "Q_decay": "", "Q_width": ""}  # fmt: skip
        unit = units.get(kind, frame.x) if frame else ""
        return f"{quantity} [{unit}]" if unit else quantity

    def _table(self) -> dict[str, list[Any]]:
        quantities, own, of_first = ([*column] for column in zip(*self.rows()))
        numbers = {
            name: [float(text.split()[0]) if text else nan for text in texts]
            for name, texts in (("response", own), ("first order", of_first))
        }
        return {"quantity": quantities, **numbers, "response (digits)": own, "first order (digits)": of_first}

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

    def _equation(self) -> str:
        """The equation of motion, as LaTeX."""
        free = self.oscillator._formula().removesuffix(" = 0")
        return rf"{free} = {latex(self.force)} \cos(\Omega t),\quad \Omega = {latex(self.omega)}"

    def _letters(self) -> dict[str, str]:
        return {r"\Omega": "frequency of the force", "t": "time"}

    def _curve(self, axes: Any, **style: Any) -> None:
        """Amplitude and phase of first order against Omega, the backbone, and the response where it was asked."""
        drive = Drive(self.oscillator, self.force, self.omega)
        places = _places(drive)
        with ctx.workprec(_LOW):
            states = [first_order_at(drive, omega) for omega in places]
            largest = max(A for A, _ in states)
            heights = [largest * n / _CURVE for n in range(1, _CURVE + 1)]
            free = [backbone(drive, A) for A in heights]
        axes.plot(places, [A for A, _ in states], **{"label": "first order", **style})
        seen = [(omega, A) for omega, A in zip(free, heights) if places[0] <= omega <= places[-1]]
        if seen:
            axes.plot(*zip(*seen), "--", label="backbone: the free decay", linewidth=1)
        if self.amplitude is not None:
            own = float(self.omega.ball().mid()), float(self.amplitude)
            axes.plot(*([value] for value in own), "o", markersize=4, label="the response, certified")
        axes.set(xlabel="Omega (rad/s)" if self.frame else "Omega", ylabel=self.frame.axis("amplitude"))
        right = _right_of(axes)
        right.plot(places, [lag for _, lag in states], ":", color="gray", linewidth=1)
        right.set(ylabel="phase (dotted)", ylim=(0, pi))


def _right_of(axes: Any) -> Any:
    """The axes of the phase over the same frequencies: those of the result before, or new ones."""
    shared = axes.get_shared_x_axes().get_siblings(axes)
    return next((other for other in shared if other is not axes), None) or axes.twinx()


def _places(drive: Drive) -> list[float]:
    with ctx.workprec(_LOW):
        middle, here = drive.oscillator.omega_0(), drive.omega.ball()
        low, high = min(middle, here) / 2, max(middle, here) * 3 / 2
        return [float((low + (high - low) * n / _CURVE).mid()) for n in range(_CURVE + 1)]


def first_order_at(drive: Drive, omega: float) -> tuple[float, float]:
    """(amplitude, phase) of first order at another frequency, doubles that are drawn."""
    numerator, denominator = omega.as_integer_ratio()
    balls = Drive(drive.oscillator, drive.force, ExactReal(numerator) / denominator).balls()
    A = first_order.amplitude(balls)
    return float(A.mid()), float(first_order.phase(balls, A).mid())


def backbone(drive: Drive, amplitude: float) -> float:
    """omega of the free decay at that amplitude, to second order, a double that is drawn.

    omega_0 (1 - sum_ij alpha_i alpha_j/((alpha_i+1)(alpha_j+1)) M_(alpha_i+alpha_j) delta_i delta_j) with delta_i = b_i
    omega_0^alpha_i A^(alpha_i-1)/k.
    """
    omega_0, k = drive.oscillator.omega_0(), drive.oscillator.stiffness.ball()
    terms = [(t.velocity.ball(), t.strength.ball() * omega_0 ** t.velocity.ball() / k) for t in drive.losses]
    parts = [(a, a / (a + 1) * d * arb(amplitude) ** (a - 1)) for a, d in terms]
    return float((omega_0 * (1 - sum((p * q * moment(a + b) for a, p in parts for b, q in parts), arb(0)))).mid())


def _estimate(text: str | None) -> str | None:
    return f"{text} (estimate)" if text not in (None, "0") else text
