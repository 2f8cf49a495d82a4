"""The pendulum and x + c x^3 in the straightened coordinate xi: what one turn loses, and how long it takes, as 2F1.

With xi = sqrt(2 V(A)) at a turning point A and dE = xi d xi, a half-swing of the conservative motion gives, to first
order in the loss and exactly in the amplitude (derivations ``pendulum-first-order`` and ``duffing-first-order``),

    d ln xi/d psi = -sum_i eps_i r_i(xi),      d tau/d psi = Theta(xi),      psi = n pi at the n-th turning point.

*Pendulum* x'' + sin(sqrt(g) x)/sqrt(g), k^2 = g xi^2/4 = sin^2(sqrt(g) A/2), loss v|v|^(alpha-1):

    r = M_(alpha+1) xi^(alpha-1) 2F1(1/2, 1/2; (alpha+3)/2; k^2),      Theta = 2F1(1/2, 1/2; 1; k^2).

*Duffing* x'' + x + c x^3, B = 1 + c A^2 = sqrt(1 + 2 c xi^2), mu = c A^2/(2 B), loss |x|^m v|v|^(alpha-1):

    r = <|cos|^m |sin|^(alpha+1)> A^(m+alpha+1) B^(alpha/2)/xi^2 2F1(-alpha/2, (alpha+2)/2; (alpha+m+3)/2; mu),
    Theta = B^(-1/2) 2F1(1/2, 1/2; 1; mu):      the same integral with m = 0 and alpha = -1.

Evaluation is in balls, real or complex (for contours), or in arrays of doubles.

>>> pendulum = Well.pendulum(arb(1))                                 # x in rad
>>> (pendulum.turn(pendulum.xi(arb(2))) * arb.pi()).real.str(10)     # half a period at 2 rad: 2 K
'[4.174876463 +/- ...]'
>>> Well.duffing(arb(1)).xi(arb(1)).str(10)                          # sqrt(3/2)
'[1.224744871 +/- ...]'
"""

from dataclasses import dataclass
from typing import Any

import numpy as np
from flint import acb, arb

from asymptotics.errors import InputError
from asymptotics.expansions.moments.certified import moment
from asymptotics.numbers.precision import TooWideError


@dataclass(frozen=True)
class Loss:
    """eps |x|^m v|v|^(alpha-1), eps > 0, as balls."""

    epsilon: arb
    alpha: arb
    m: int = 0

    @property
    def weight(self) -> arb:
        """m + alpha - 1: r goes like xi^weight at small amplitude."""
        return self.alpha + self.m - 1

    @property
    def mean(self) -> arb:
        """The mean <|cos|^m |sin|^(alpha+1)> over a turn."""
        if not self.m:
            return moment(self.alpha + 1)
        x, y = arb(self.m + 1) / 2, self.alpha / 2 + 1
        return x.gamma() * y.gamma() * (x + y).rgamma() / arb.pi()


@dataclass(frozen=True)
class Well:
    """One of the two wells; ``strength`` is g > 0 of the pendulum or c of x + c x^3."""

    kind: str
    strength: arb

    @classmethod
    def pendulum(cls, g: arb) -> "Well":
        """x'' + sin(sqrt(g) x)/sqrt(g): sqrt(g) x in rad."""
        return cls("pendulum", g)

    @classmethod
    def duffing(cls, c: arb) -> "Well":
        """x'' + x + c x^3."""
        return cls("duffing", c)

    def xi(self, A: arb) -> arb:
        """sqrt(2 V(A)) of a turning point A > 0; InputError outside the well, TooWideError where balls do not tell."""
        if self.kind == "pendulum":
            root = self.strength.sqrt()
            # Beyond pi the pendulum turns over.
            _require_inside(A, arb.pi() - root * A, "less than pi rad")
            return 2 * (root * A / 2).sin() / root
        _require_inside(A, 1 + self.strength * A * A, "1 + c A^2 > 0")
        return A * (1 + self.strength * A * A / 2).sqrt()

    def amplitude(self, xi: Any) -> Any:
        """The turning point A of xi: balls, or doubles."""
        if isinstance(xi, arb):
            if self.kind == "pendulum":
                root = self.strength.sqrt()
                return 2 * (root * xi / 2).asin() / root
            return xi * (2 / (1 + self._stiffness(xi * xi))).sqrt()
        g = float(self.strength.mid())
        if self.kind == "pendulum":
            return 2 * np.arcsin(np.sqrt(g) * xi / 2) / np.sqrt(g)
        return xi * np.sqrt(2 / (1 + np.sqrt(1 + 2 * g * xi * xi)))

    def loss(self, loss: Loss, s: Any, analytic: bool = False) -> Any:
        """r at xi = e^(-s), without the strength: a ball, a complex ball, or an array."""
        weight, q = loss.weight, _exp(-2 * s)
        half, a = arb(1) / 2, loss.alpha
        power = _exp(-_like(weight, s) * s) * _like(loss.mean, s)
        if self.kind == "pendulum":
            return power * _hypergeometric(half, half, (a + 3) / 2, _like(self.strength / 4, s) * q, analytic)
        B = self._stiffness(q, analytic)
        mu = (B - 1) / (2 * B)
        # A^2 = 2 xi^2/(1 + B) turns A^(m+alpha+1) B^(alpha/2)/xi^2 into xi^weight and powers of functions that are 1 at
        # xi = 0; by logarithms, for the flag ``analytic`` is theirs.
        size = _log(2 / (1 + B), analytic) * _like((a + loss.m + 1) / 2, s) + _log(B, analytic) * _like(a / 2, s)
        return power * _exp(size) * _hypergeometric(-a / 2, a / 2 + 1, (a + loss.m + 3) / 2, mu, analytic)

    def turn(self, xi: Any) -> Any:
        """Theta = d tau/d psi at xi."""
        return self.theta(-_log(xi))

    def near_zero(self, loss: Loss, xi: arb) -> arb:
        """r/(M xi^weight) for every xi in a ball that may hold 0, where it is 1."""
        a, q, half = loss.alpha, xi * xi, arb(1) / 2
        if self.kind == "pendulum":
            return (self.strength * q / 4).hypgeom_2f1(half, half, (a + 3) / 2)
        B = self._stiffness(q)
        # As in ``loss``, with the leading power divided out, so that a ball that holds xi = 0 will do.
        size = (2 / (1 + B)).log() * (a + loss.m + 1) / 2 + B.log() * a / 2
        value: arb = size.exp() * ((B - 1) / (2 * B)).hypgeom_2f1(-a / 2, a / 2 + 1, (a + loss.m + 3) / 2)
        return value

    def theta_near_zero(self, xi: arb) -> arb:
        """Theta for every xi in a ball that may hold 0."""
        half, q = arb(1) / 2, xi * xi
        if self.kind == "pendulum":
            return (self.strength * q / 4).hypgeom_2f1(half, half, arb(1))
        B = self._stiffness(q)
        value: arb = ((B - 1) / (2 * B)).hypgeom_2f1(half, half, arb(1)) / B.sqrt()
        return value

    def theta(self, s: Any, analytic: bool = False) -> Any:
        """Theta at xi = e^(-s)."""
        q, half = _exp(-2 * s), arb(1) / 2
        if self.kind == "pendulum":
            return _hypergeometric(half, half, arb(1), _like(self.strength / 4, s) * q, analytic)
        B = self._stiffness(q, analytic)
        # A root by its logarithm, which is not finite where a ball meets the cut: the integrator then bisects.
        return _exp(-_log(B, analytic) / 2) * _hypergeometric(half, half, arb(1), (B - 1) / (2 * B), analytic)

    def _stiffness(self, q: Any, analytic: bool = False) -> Any:
        """B = sqrt(1 + 2 c xi^2) with q = xi^2."""
        square = 1 + _like(2 * self.strength, q) * q
        return square.sqrt(analytic=analytic) if isinstance(square, acb) else _sqrt(square)


def _like(x: arb, other: Any) -> Any:
    """A ball beside balls, a double beside doubles."""
    return x if isinstance(other, arb | acb) else float(x.mid())


def _exp(x: Any) -> Any:
    return x.exp() if isinstance(x, arb | acb) else np.exp(x)


def _sqrt(x: Any) -> Any:
    return x.sqrt() if isinstance(x, arb) else np.sqrt(x)


def _log(x: Any, analytic: bool = False) -> Any:
    if isinstance(x, acb):
        return x.log(analytic=analytic)
    return x.log() if isinstance(x, arb) else np.log(x)


def _hypergeometric(a: arb, b: arb, c: arb, z: Any, analytic: bool) -> Any:
    """2F1(a, b; c; z), cut along [1, infinity): where ``analytic`` is asked a ball that may meet the cut is refused."""
    if isinstance(z, acb):
        # 2F1 is cut from 1 on: a ball that may meet the cut is not analytic, and the integrator is told so by nan.
        if analytic and not (z.real < 1 or z.imag > 0 or z.imag < 0):
            return acb("nan")
        return z.hypgeom_2f1(a, b, c)
    if isinstance(z, arb):
        return z.hypgeom_2f1(a, b, c)
    from scipy.special import hyp2f1  # noqa: PLC0415 (slow to load; balls do without)

    return hyp2f1(float(a.mid()), float(b.mid()), float(c.mid()), z)


def _require_inside(A: arb, room: arb, accepted: str) -> None:
    if A <= 0 or room <= 0:
        raise InputError("x0", f"{A.str(5)} is not certainly inside the well", accepted)
    if not (A > 0 and room > 0):
        raise TooWideError(f"{A.str(5)} is not certainly inside the well")
