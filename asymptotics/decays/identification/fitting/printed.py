"""Decrements as printed in tables: mean amplitude a = (A + A')/2 and decrement D = A - A' of a half-swing.

Given the law, D is a function of a: with u = D/(2a) the two turning points are a(1 + u) and a(1 - u), so

    L(ln a + ln(1 + u)) + 2 artanh(u) = 0,

which increases with u (the next amplitude increases with this one: paths in the plane do not cross) and is solved for
all rows at once by Newton's iteration, with exact derivatives by the parameters.

>>> from asymptotics.decays.identification.forward.coefficients import loss
>>> table = Decrements(np.array([1.0, 0.5]), np.array([0.2, 0.2]))
>>> DecrementModel(HalfSwingModel((loss(0.0),)), table).predict(np.array([0.1]))[0]       # dry friction: D = 2 epsilon
array([0.2, 0.2])
"""

from dataclasses import dataclass, replace

import numpy as np

from asymptotics.decays.identification.fitting.model import Model
from asymptotics.decays.identification.forward.coefficients import Array
from asymptotics.decays.identification.forward.quadrature import TooStrongError
from asymptotics.decays.identification.forward.swing import HalfSwingModel
from asymptotics.decays.identification.measuring.observations import Observations
from asymptotics.numbers.alike import Alike


@dataclass(frozen=True, eq=False)
class Decrements(Alike):
    """Mean amplitudes and decrements of half-swings; ``resolution``: half a unit of the last printed digit;
    ``written``: the unit of the file where it is none of those that are known, such as V."""

    amplitude: Array
    decrement: Array
    resolution: Array | None = None
    unit: str = ""
    name: str = ""
    notes: tuple[str, ...] = ()
    written: str = ""

    @property
    def shown_unit(self) -> str:
        """The unit of x as it is told: one that is known, or the one that the file writes."""
        return self.unit or self.written

    @property
    def reference(self) -> float:
        """The largest amplitude."""
        return float(self.amplitude.max())

    def between(self, low: float, high: float) -> "Decrements":
        """The rows with low <= amplitude <= high."""
        keep = (self.amplitude >= low) & (self.amplitude <= high)
        resolution = None if self.resolution is None else self.resolution[keep]
        return replace(self, amplitude=self.amplitude[keep], decrement=self.decrement[keep], resolution=resolution)


class DecrementModel(Model):
    """Predicted decrements at the printed amplitudes; the parameters are those of the law alone."""

    alternating = False

    def __init__(self, swing: HalfSwingModel, table: Decrements) -> None:
        seen = Observations.of([0], [table.reference], unit=table.unit, name=table.name)
        super().__init__(swing, seen, offset=False)
        self.law, self.after, self.size = slice(0, swing.parameters), swing.parameters, swing.parameters
        self.groups, self.kinds = [slice(0, len(table.decrement))], ["x"]
        self.data, self.shape = table.decrement, np.ones(len(table.decrement))
        self.table = table

    def smooth_columns(self) -> dict[str, tuple[Array, Array]]:
        """A decrement is a smooth function of the amplitude."""
        return {"x": (self.table.amplitude, self.table.decrement)}

    def predict(self, theta: Array) -> tuple[Array, Array]:
        """The decrements and their derivatives (rows, parameters); TooStrongError outside the model's domain."""
        a = np.log(self.table.amplitude / self.table.reference)
        u = np.zeros(len(a))
        # The derivatives below belong to the last u: they are right if the change is at rounding, which is asked for.
        for _ in range(30):
            value = self.swing.at(a + np.log1p(u), theta)
            slope = value.by_amplitude[0] / (1 + u) + 2 / (1 - u**2)
            change = -(value.values[0] + 2 * np.arctanh(u)) / slope
            # u = 1 would be a mass that stays at its rest position, u < 0 a loss that feeds: both are possible in a
            # search, the ends of artanh are not.
            u = np.clip(u + change, -0.9, 0.95)
            if np.abs(change).max() < 1e-13:
                break
        else:
            raise TooStrongError("no half-swing has this mean amplitude")
        size = 2 * self.table.amplitude
        return size * u, -(size / slope * value.by_parameter[:, 0]).T


def decrement_start(model: DecrementModel) -> Array:
    """Starting values: linear regression of D on the first-order decrements -c_i s_i a^(w_i + 1)."""
    swing, table = model.swing, model.table
    # One of the whole exponents lies near enough to any other.
    tried = [0.0, 1.0, 2.0, 3.0] if swing.free else [None]
    found = []
    for alpha in tried:
        zero = np.zeros(swing.parameters)
        if alpha is not None:
            zero[-1] = alpha
        a = np.log(table.amplitude / table.reference)
        # At strength 0 the derivatives of L are the first coefficients; D = -A L to first order.
        slopes = -table.amplitude[:, None] * swing.at(a, zero).by_parameter[: len(swing.elements), 0].T
        strengths, *_ = np.linalg.lstsq(slopes, table.decrement, rcond=1e-9)
        misfit = float(((table.decrement - slopes @ strengths) ** 2).sum())
        found.append((misfit, np.append(strengths, [] if alpha is None else [alpha])))
    return min(found, key=lambda pair: pair[0])[1]
