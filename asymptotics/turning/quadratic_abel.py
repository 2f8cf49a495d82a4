"""The n-th turning point without iterating (alpha = 2): a truncated Abel function and a rigorous bound of its defect.

Psi_K = sum_(k<K) c_k p^(2k-1) satisfies Psi_K(F(p)) = Psi_K(p) + 1 + d(p) with d = O(p^(2K)).  The full series
diverges; the truncated one still gives rigorous answers, because the defect is an analytic function near 0:

* **On the circle |p| = rho**, |2 h(p)/p^2 - 1| <= eta(rho) := 2(-log(1-rho) - rho)/rho^2 - 1, so sigma = sqrt(2h) obeys
  |sigma(p)/p - 1| <= e(rho) := 1 - sqrt(1 - eta(rho)).  By Rouche's theorem -sigma(-q) = sigma(p) has exactly one root
  q = F(p) in |q| < r when r (1 - e(r)) > rho (1 + e(rho)); F is analytic, and |F(p)| >= rho (1 - e(rho))/(1 + e(r)).
* **Hence** |d| <= D := sum |c_k| (|F|^(2k-1) + rho^(2k-1)) + 1 on the circle, and by Schwarz's lemma
  |d(p)| <= D (p/rho)^(2K) for 0 <= p <= rho.
* **Along the orbit** 1/p_(j+1) > 1/p_j + 2/3 (derivation ``smith-contraction``), so the defects from the M-th point on
  add up to at most D/rho^(2K) (p_M^(2K) + (3/2) p_M^(2K-1)/(2K-1)).

So Psi_K(p_n) = Psi_K(p_M) + (n - M) up to that bound, and p_n follows by one step of the mean value theorem.  The
elapsed time is Theta_K(p_n) - Theta_K(p_M) in the same way; with Y = (rho (1+e(rho)))^2 / 2, on the circle

    |T| <= pi (1+e(r)) (1+r) (1-r)^(-1/2) (2 - (e^Y - 1)/Y)^(-1/2).

>>> from asymptotics.turning.quadratic_map import amplitudes
>>> from itertools import islice
>>> with ctx.workprec(100):
...     head = list(islice(amplitudes(arb(2)), 301))
...     jump = AbelFunction(terms=8, radius=fmpq(1, 4))
...     far = jump.advance(head[100], 200)
>>> far.overlaps(head[300]), far.rel_accuracy_bits() > 60
(True, True)
"""

from dataclasses import dataclass
from functools import cached_property

from flint import arb, ctx, fmpq

from asymptotics.errors import UndecidedError
from asymptotics.turning.quadratic_series import abel_coefficients, time_coefficients


@dataclass(frozen=True)
class AbelFunction:
    """Psi_K and Theta_K with K = ``terms``, and the bounds of their defects from the circle |p| = ``radius``.

    Raises ValueError if the hypotheses of the bound fail on that circle.
    """

    terms: int
    radius: fmpq

    @cached_property
    def psi(self) -> list[fmpq]:
        """c_k of Psi_K."""
        return abel_coefficients(self.terms)

    @cached_property
    def theta(self) -> list[fmpq]:
        """theta_k / pi of Theta_K."""
        return time_coefficients(self.terms)

    @cached_property
    def _image(self) -> tuple[arb, arb]:
        """Bounds r_1 <= |F(p)| <= r_2 on the circle."""
        rho, r = arb(self.radius), arb(self.radius) * arb(fmpq(3, 2))
        e_rho, e_r = _distortion(rho), _distortion(r)
        if not (r < 1 and r * (1 - e_r) > rho * (1 + e_rho)):
            raise ValueError(f"the radius {self.radius} is too large for the bound")
        return rho * (1 - e_rho) / (1 + e_r), r

    def _circle_bound(self, coefficients: list[fmpq]) -> arb:
        """A bound of |sum c_k (F^(2k-1) - p^(2k-1))| on the circle."""
        low, high = self._image
        rho, total = arb(self.radius), arb(0)
        for k, c in enumerate(coefficients):
            total += abs(arb(c)) * ((1 / low if k == 0 else high ** (2 * k - 1)) + rho ** (2 * k - 1))
        return total

    def _period_bound(self) -> arb:
        """A bound of |T| on the circle."""
        r, rho = self._image[1], arb(self.radius)
        level = (rho * (1 + _distortion(rho))) ** 2 / 2
        stretch = 2 - level.expm1() / level
        if not stretch > 0:
            raise ValueError(f"the radius {self.radius} is too large for the bound of the half period")
        return arb.pi() * (1 + _distortion(r)) * (1 + r) * (1 - r).rsqrt() * stretch.rsqrt()

    def _along_orbit(self, p: arb, circle: arb) -> arb:
        """The sum of all defects from the point p on, as a ball around 0."""
        m = 2 * self.terms
        total = circle / arb(self.radius) ** m * (p**m + p ** (m - 1) * 3 / (2 * (m - 1)))
        return arb(0, total.upper())

    def advance(self, p: arb, steps: int) -> arb:
        """The amplitude ``steps`` half-swings after p (a ball in (0, radius))."""
        if not (p > 0 and p < arb(self.radius)):
            raise ValueError(f"{p.str(5)} is not in (0, {self.radius})")
        defect = self._along_orbit(p, self._circle_bound(self.psi) + 1)
        return self._solve(_odd_laurent(self.psi, p) + steps + defect, p)

    def _solve(self, value: arb, start: arb) -> arb:
        """The only p up to about ``start`` with Psi_K(p) = value: Newton, then the mean value theorem."""
        middle = (arb(3) / 2 / value).mid()
        for _ in range(ctx.prec.bit_length() + 3):
            step = (_odd_laurent(self.psi, middle) - value) / _slope(self.psi, middle)
            middle = (middle - step).mid()
        guess = middle * (1 + arb(0, arb(2) ** -10))
        if not (guess < arb(self.radius) and self._decreasing_up_to(guess.union(start))):
            raise UndecidedError("the truncated Abel function may not decrease here: use a later head or fewer terms")
        root = middle + (value - _odd_laurent(self.psi, middle)) / _slope(self.psi, guess)
        if not guess.contains(root):
            raise UndecidedError("the enclosure of the turning point was not verified: raise the precision")
        return root

    def _decreasing_up_to(self, p: arb) -> bool:
        """Whether sum_(k>=1) (2k-1) |c_k| p^(2k) < c_0, which makes Psi_K decrease on (0, p]."""
        rest = sum(((2 * k - 1) * abs(arb(c)) * p ** (2 * k) for k, c in enumerate(self.psi) if k), arb(0))
        return bool(rest < arb(self.psi[0]))

    def time_between(self, p: arb, q: arb) -> arb:
        """The time from the turning point with amplitude p to a later one with amplitude q, in units of 1/omega_0."""
        circle = arb.pi() * self._circle_bound(self.theta) + self._period_bound()
        change = arb.pi() * (_odd_laurent(self.theta, q) - _odd_laurent(self.theta, p))
        return change + self._along_orbit(p, circle)


def _distortion(r: arb) -> arb:
    """e(r) of the module's docstring."""
    eta = 2 * (-(-r).log1p() - r) / r**2 - 1
    return 1 - (1 - eta).sqrt()


def _odd_laurent(coefficients: list[fmpq], p: arb) -> arb:
    """sum c_k p^(2k-1)."""
    square, total = p * p, arb(0)
    for c in reversed(coefficients):
        total = total * square + arb(c)
    return total / p


def _slope(coefficients: list[fmpq], p: arb) -> arb:
    """sum (2k-1) c_k p^(2k-2)."""
    return _odd_laurent([(2 * k - 1) * c for k, c in enumerate(coefficients)], p) / p
