"""The fit of the motion itself: every sample counts, no extreme is sought, and the sampling may be as it is.

The turning points a_n and their times come from ``sequence``; within each half-swing

    dy/dtheta = -s m,   dtau/dtheta = 1 + c m,   m = N/(1 - c N),   N = sum_i delta_i f_i(theta) e^(w_i y)

is integrated for all half-swings and all derivatives at once by Runge and Kutta's fourth-order steps in theta; between
its nodes, where position, velocity and acceleration are known, x(t) is a polynomial of degree 5.  Unknown beside the
law: the first amplitude, the base line (offset and drift), omega_0 and the start of the clock.  Samples that remember
(AR(1), by the time between them) are compared by their innovations.
"""

import numpy as np

from asymptotics.decays.identification.fitting.model import Model
from asymptotics.decays.identification.forward.coefficients import Array, Element
from asymptotics.decays.identification.forward.quadrature import TooStrongError, is_smooth
from asymptotics.decays.identification.forward.swing import HalfSwingModel
from asymptotics.decays.identification.forward.work import counted
from asymptotics.decays.identification.measuring.observations import Indices, Observations

_STEPS, _KINKED, _NEAR_THE_TOP = 16, 32, 48
"""Steps of a half-swing (with a power of the speed that is no whole one; of a pendulum beyond 130 degrees): what they
leave is below 1e-6 of the amplitude, the least noise that is believed."""
_CONTINUED = 7
"""Of 32 graded steps, those about as wide as one of 16 even ones: a polynomial is continued by no more than that."""
_FLOOR = 1e-6
"""The error of these steps as a noise: without it a record without noise would fit it."""
_STEP = 1e-5
"""One-sided differences in the law: their error, 1e-5 of the curvature, steers the minimiser a little worse and is no
error of the minimum; smaller steps would meet the rounding."""


class WaveformModel(Model):
    """All samples of one run; the vector of ``Model`` with a drift after the offset, and the four numbers of a second
    mode after that, where one is fitted beside the motion."""

    def __init__(self, swing: HalfSwingModel, seen: Observations, pendulum: bool = False) -> None:
        super().__init__(swing, seen, offset=True, pendulum=pendulum)
        assert seen.samples is not None
        self.samples = seen.samples
        # Beside the law: offset, drift, the second mode, ln omega_0 and t_0.
        self.offset, self.size = True, self.after + 4 + len(self.samples.mode)
        self.mode = slice(self.after + 2, self.after + 2 + len(self.samples.mode))
        t = self.samples.t
        self._u = (t - t[0]) / (t[-1] - t[0])
        # Memory falls exponentially with time: that of neighbours, to the power of the gap in units of the usual one.
        self._rho = self.samples.memory ** (np.diff(t) / float(np.median(np.diff(t))))
        self.groups, self.kinds, self.shape = [slice(0, len(t))], ["x"], np.ones(len(t))
        slow = self.samples.slow
        self._slow = None if slow is None else np.linalg.qr(self._innovations(slow))[0]
        self.absorbed = 0 if slow is None else slow.shape[1]
        self.data = self._white(self.samples.x)

    @property
    def units(self) -> int:
        """How many data stand beside each other."""
        return len(self.data)

    def start(self, theta: Array) -> Array:
        """The vector from one of the turning points, with or without an offset; one of this kind as it is."""
        if len(theta) == self.size:
            return theta
        # The turning points of a smooth line may have been fitted without an offset.
        rest = theta[self.after : -2] if len(theta) > self.after + 2 else [0.0]
        return np.array([*theta[: self.after], rest[0], 0.0, *self.samples.mode, *theta[-2:]])

    def level(self) -> tuple[float, float]:
        """The noise level of the data, measured without a law, and its degrees of freedom."""
        return self.samples.noise * float(np.sqrt(1 - self.samples.memory**2)), self.samples.freedom

    def floor(self, kind: str, theta: Array) -> float:
        """The noise below which the error of the integration itself would be fitted."""
        return _FLOOR * self.seen.reference

    def predict(self, theta: Array) -> tuple[Array, Array]:
        """The samples and their derivatives (samples, parameters), both as innovations."""
        x, slopes = self._foretold(theta)
        return self._white(x), self._white(slopes)

    def _foretold(self, theta: Array) -> tuple[Array, Array]:
        """The same as they are read off the sensor."""
        # As in ``least_squares``: e^300 is still a double.
        if not abs(theta[-2]) < 300:
            raise TooStrongError("the frequency leaves every bound")
        run, after, t = self._sequence(theta), self.after, self.samples.t
        clock = np.exp(theta[-2]) * (t - theta[-1])
        # Samples before the first and after the last turning point belong to the polynomials at the ends, continued.
        n = np.clip(np.searchsorted(run.tau, clock, side="right") - 1, 0, len(run.tau) - 2)
        well = 0.0 if self.angle is None else self.reference * self.angle / 2
        # Of the integration and the interpolation, for all columns.
        counted(1000 + self.size * (0.3 * len(t) + 2 * len(run.tau) * len(self.swing.elements)))
        nodes, order = _nodes(self.swing, run.a[:-1], theta[self.law], well), self.samples.derivative
        wide = len(nodes[0]) * _CONTINUED // _KINKED if _is_kinked(self.swing) else 1
        values, speed = _between(*nodes, n, clock - run.tau[n], order, wide)
        radius = self.seen.sign[0] * np.where(n % 2, -1.0, 1.0) * self.reference
        x, by_a = values[0], (values[1] - values[0]) / _STEP
        if not np.isfinite(values).all():
            raise TooStrongError("the motion leaves every bound")
        slopes = np.zeros((len(t), self.size))
        # The chain rule: a parameter moves the amplitude at which a half-swing begins, and the time of its beginning.
        slopes[:, :after] = (by_a * run.d_a[:, n] - speed * run.d_tau[:, n]).T
        # And the law acts within the half-swing itself.
        slopes[:, self.law] += ((values[2:] - x) / _STEP).T
        # A derivative by time brings a factor omega_0 for each order.
        slopes[:, -2], slopes[:, -1] = speed * clock + order * x, -speed * np.exp(theta[-2])
        radius = radius * np.exp(order * theta[-2])
        slopes *= radius[:, None]
        slopes[:, after], slopes[:, after + 1] = 1.0, self._u
        x = radius * x + theta[after] + theta[after + 1] * self._u
        if self.samples.mode:
            beside, slopes[:, self.mode] = mode_at(t - t[0], *theta[self.mode])
            x = x + beside
        return x, slopes

    def base_line(self, theta: Array) -> Array:
        """Offset, drift and what wanders beside them, at the samples: of the columns those that the fit absorbs."""
        line = theta[self.after] + theta[self.after + 1] * self._u
        if self.samples.slow is None:
            return np.asarray(line)
        left = self._innovations(self.samples.x - self._foretold(theta)[0])
        columns = self._innovations(self.samples.slow)
        return np.asarray(line + self.samples.slow @ np.linalg.lstsq(columns, left, rcond=None)[0])

    def measured_sizes(self, theta: Array) -> tuple[Indices, Array, Array]:
        """(n, amplitude, its standard error) at the turning points with samples of half a swing on both sides.

        The amplitude of the law, and the size of cos(omega_0 (t - t_n)) in what it leaves of the samples there: the
        motion as it is measured, without a smooth line.
        """
        t, times, size = self.samples.t, self.turning_times(theta), self.amplitudes(theta)[0]
        left = self._coloured(self.data - self.predict(theta)[0])
        rate, found = float(np.exp(theta[-2])), []
        for n, centre in enumerate(times):
            place = rate * (t - centre)
            near = np.abs(place) < np.pi / 2
            wave = np.cos(place[near])
            # As many samples as tell a size, of both sides, about a turning point whose swing is whole.
            inside = t[0] <= centre - np.pi / 2 / rate and centre + np.pi / 2 / rate <= t[-1]
            if inside and (place[near] < 0).any() and (place[near] > 0).any():
                power, sign = float(wave @ wave), float(self.seen.sign[0]) * (-1.0) ** n
                rho = self._rho[np.flatnonzero(near)[:-1]]
                spread = self.samples.noise * np.sqrt(_correlated_square(wave, rho)) / power
                found.append((n, size[n] + sign * float(wave @ left[near]) / power, spread))
        rows = np.array(found).reshape(-1, 3)
        return rows[:, 0].astype(int), rows[:, 1], rows[:, 2]

    def _coloured(self, white: Array) -> Array:
        """What ``_white`` was made of."""
        size = np.sqrt(1 - self.samples.memory**2)
        values: Array = np.array(white) / size
        if self.samples.memory:
            values[1:] *= np.sqrt(1 - self._rho**2)
            for i, rho in enumerate(self._rho, start=1):
                values[i] += rho * values[i - 1]
        return values

    def _white(self, values: Array) -> Array:
        """The innovations, without what a base line that wanders explains: the same as fitting it beside the law."""
        white = self._innovations(values)
        return white if self._slow is None else white - self._slow @ (self._slow.T @ white)

    def _innovations(self, values: Array) -> Array:
        """The innovations of an AR(1) process in continuous time; the values themselves without memory."""
        if self.samples.memory == 0:
            return values
        rho = self._rho.reshape(-1, *[1] * (values.ndim - 1))
        size = np.sqrt(1 - self.samples.memory**2)
        later = (values[1:] - rho * values[:-1]) / np.sqrt(1 - rho**2) * size
        # All innovations have one size, that of the innovation over the usual gap; the determinant is the same for all
        # laws.
        return np.concatenate([values[:1] * size, later])


def mode_at(t: Array, cosine: float, sine: float, omega: float, rate: float) -> tuple[Array, Array]:
    """A second mode that decays, and its derivatives by its four numbers.

    >>> x, by = mode_at(np.array([0.0, 1.0]), 2.0, 0.0, np.pi, 0.0)
    >>> x.round(12).tolist(), by.shape
    ([2.0, -2.0], (2, 4))
    """
    # A step of the search may ask for any growth: beyond e^50 the cost refuses it.
    size = np.exp(np.clip(-rate * t, -50.0, 50.0))
    C, S = size * np.cos(omega * t), size * np.sin(omega * t)
    x = cosine * C + sine * S
    return x, np.stack([C, S, t * (sine * C - cosine * S), -t * x], axis=1)


@np.errstate(over="ignore", invalid="ignore")  # a step of the search may leave the doubles: no swing there
def _nodes(swing: HalfSwingModel, a: Array, law: Array, well: float) -> tuple[Array, Array, Array, Array]:
    """(tau, x, v, acceleration) in units of the reference at the nodes of each half-swing: (nodes, columns, swings).

    The columns: as it is, with a moved by a small step, and with each parameter of the law moved.  ``well``: of a
    pendulum half its reference in rad, otherwise 0.
    """
    count = len(swing.elements)
    columns = 2 + len(law)
    A = np.repeat(a[None], columns, axis=0)
    A[1] += _STEP
    laws = np.repeat(law[None], columns, axis=0)
    laws[np.arange(2, columns), np.arange(len(law))] += _STEP
    q = [
        laws[:, -1:] if swing.free and i == 0 else np.full((columns, 1), e.velocity)
        for i, e in enumerate(swing.elements)
    ]
    w = [v + e.position - 1 for v, e in zip(q, swing.elements, strict=True)]
    delta = [laws[:, i : i + 1] * np.exp(np.clip(w[i] * A, -50, 50)) for i in range(count)]

    steps = _STEPS if well < 0.9 else _NEAR_THE_TOP  # sin(A/2) = 0.9 at 128 degrees: near the top the clock has a peak
    steps = max(steps, _KINKED) if _is_kinked(swing) else steps
    h, places = np.pi / steps, np.arange(2 * steps + 1) * np.pi / steps / 2
    places, pace = _graded(places) if _is_kinked(swing) else (places, np.ones(len(places)))
    sines, cosines = np.abs(np.sin(places)), np.cos(places)  # a power of a negative rounding of sin(pi) is nan
    # Where s^alpha has no slope by alpha, at rest, the force is that just before.
    near = np.maximum(sines, sines[1]) if _is_kinked(swing) else sines
    shapes = list(zip(*(_shapes(e, v, near, cosines) for e, v in zip(swing.elements, q, strict=True)), strict=True))
    powers = [_whole(weight) for weight in w]

    def force(k: int, y: Array) -> Array:
        """At the node k of half-steps."""
        total, E = np.zeros_like(y), np.exp(y)
        for f, power, weight, d in zip(shapes[k], powers, w, delta, strict=True):
            if power == 0:
                total += d * f
            else:
                total += d * f * (E if power == 1 else E * E if power == 2 else np.exp(weight * y))
        return total

    def slope(k: int, y: Array) -> Array | float:
        return np.sqrt(np.maximum(1 - (well * cosines[k] * np.exp(A + y)) ** 2, 0.0)) if well else 1.0

    def rates(k: int, y: Array, N: Array) -> tuple[Array, Array]:
        d = slope(k, y) - cosines[k] * N
        if not (d > 0.01).all():  # as in ``quadrature``: the loss is about to stop the motion
            raise TooStrongError("no turning point follows on the other side")
        clock = pace[k] / d
        return -sines[k] * N * clock, clock

    y, tau = np.zeros_like(A), np.zeros_like(A)
    found = []
    for k in range(0, 2 * steps + 1, 2):
        r, N, c = np.exp(A + y), force(k, y), cosines[k]
        x = np.arcsin(np.clip(well * r * c, -1, 1)) / well if well else r * c  # back to the angle
        found.append((tau, x, -r * sines[k], r * (N - c * slope(k, y))))
        if k == 2 * steps:
            break
        y1, t1 = rates(k, y, N)
        y2, t2 = rates(k + 1, at := y + h / 2 * y1, force(k + 1, at))
        y3, t3 = rates(k + 1, at := y + h / 2 * y2, force(k + 1, at))
        y4, t4 = rates(k + 2, at := y + h * y3, force(k + 2, at))
        y, tau = y + h / 6 * (y1 + 2 * y2 + 2 * y3 + y4), tau + h / 6 * (t1 + 2 * t2 + 2 * t3 + t4)
    nodes = [np.stack(part) for part in zip(*found, strict=True)]
    return nodes[0], nodes[1], nodes[2], nodes[3]


def _correlated_square(w: Array, rho: Array) -> float:
    """w^T C w, where the correlation of two samples is the product of the ``rho`` of the gaps between them.

    >>> w, C = np.array([1.0, 2.0, 3.0]), np.array([[1, 0.5, 0.4], [0.5, 1, 0.8], [0.4, 0.8, 1]])
    >>> bool(np.isclose(_correlated_square(w, np.array([0.5, 0.8])), w @ C @ w))
    True
    """
    carried = total = 0.0
    for each, r in zip(w.tolist(), [0.0, *rho.tolist()], strict=True):
        carried = each + r * carried
        total += each * (2 * carried - each)
    return total


def _is_kinked(swing: HalfSwingModel) -> bool:
    """Whether a power of the speed may be no whole one."""
    return swing.free or not is_smooth(swing.elements)


def _graded(z: Array) -> tuple[Array, Array]:
    """theta and dtheta/dz at even places z of a half-swing, dense at both turning points: theta = z - sin(2 z)/2.

    A power s^alpha of the speed that is no whole one has no Taylor series where s = 0, and at alpha = 0 it jumps there
    from 0 to 1: even steps are off by h/6 of the loss for any small alpha, and their slope by alpha is no number.  With
    dtheta/dz = 2 sin(z)^2 the power counts for nothing at its kink.
    """
    return z - np.sin(2 * z) / 2, 2 * np.sin(z) ** 2


def _shapes(element: Element, velocity: Array, sines: Array, cosines: Array) -> Array:
    """f(theta) of one term at each place, a column over the sets of parameters."""
    s, c = sines[:, None, None], cosines[:, None, None]
    if element.kind == "loss":
        return np.asarray(s**velocity * np.abs(c) ** element.position)
    return np.asarray(np.broadcast_to(-c * np.abs(c) ** (element.position - 1), (len(s), *velocity.shape)))


def _whole(weight: Array) -> int:
    """The weight where it is 0, 1 or 2 throughout, for which products do; otherwise -1.  These are the usual laws:
    others cost an exponential at each node."""
    w = float(weight.flat[0])
    return int(w) if np.ptp(weight) == 0 and w in (0.0, 1.0, 2.0) else -1


@np.errstate(over="ignore", invalid="ignore", divide="ignore")
def _between(
    tau: Array, x: Array, v: Array, acceleration: Array, n: Array, since: Array, order: int, wide: int = 1
) -> tuple[Array, Array]:
    """A derivative of x in all columns (columns, samples), and the next one of the first column, at times ``since``
    turning point ``n``; outside the half-swing by the polynomial of its first or last ``wide`` intervals."""
    # The interval is chosen by the unmoved column: the moved ones differ by 1e-5, and are continued by their
    # polynomials.
    k = np.clip((since[None] >= tau[:, 0, n]).sum(axis=0) - 1, 0, len(tau) - 2)
    after = since > tau[-1, 0, n]
    first, last = np.where(after, k + 1 - wide, k), np.where(since < 0, k + wide, k + 1)
    t0, x0, v0, a0 = (part[first, :, n].T for part in (tau, x, v, acceleration))
    t1, x1, v1, a1 = (part[last, :, n].T for part in (tau, x, v, acceleration))
    h = t1 - t0
    u = (since[None] - t0) / h
    p1, p2 = h * v0, h**2 * a0 / 2
    # Hermite's interpolation of degree 5: position, velocity and acceleration at both nodes.
    D, E, G = x1 - x0 - p1 - p2, h * v1 - p1 - 2 * p2, h**2 * a1 - 2 * p2
    p = [x0, p1, p2, 10 * D - 4 * E + G / 2, -15 * D + 7 * E - G, 6 * D - 3 * E + G / 2]
    for _ in range(order):
        p = _derived(p, h)
    return _summed(p, u), _summed(_derived([c[:1] for c in p], h[:1]), u[:1])[0]


def _derived(p: list[Array], h: Array) -> list[Array]:
    return [i * c / h for i, c in enumerate(p)][1:]


def _summed(p: list[Array], u: Array) -> Array:
    total = p[-1]
    for c in p[-2::-1]:
        total = c + u * total
    return np.asarray(total)
