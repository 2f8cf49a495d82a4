"""Smooth forces: the flow (U, W) and the waveform Z directly, in rational Fourier polynomials, in each gauge.

This is the homological equation of the normal form, one order after the other.

Losses eps |x|^m v|v|^(alpha-1) with m even, alpha odd and springs c x|x|^(p-1) |v|^q with p odd, q even are
polynomials in x and v (cubic damping, Duffing, the pendulum, van der Pol, Rayleigh).  Then
z = X - i X' = A e^(i psi) Z(psi, delta) obeys

    (d_psi + D_1 + i) Z = i W (Z + Phi),    D_1 = U (1 + sum_i (d_i - 1) delta_i d_i),
    Phi = e^(-i psi) (sum of the forces)/A.

Put delta_i = i eta_i for the losses, leave the springs, and let q = e^(2 i psi): all coefficients become rational.
With U = i U_hat and W = W_hat,

    (2 q d_q + D_hat_1 + 1) Z = W_hat (Z + Phi_hat),
    Phi_hat = sum i^(1+alpha) 2^(-d) eta q^(-(d+1)/2) P^m Y^alpha  +  sum i^q 2^(-d) gamma q^(-(d+1)/2) P^p Y^q,
    P = q Z(q, eta) + Z(1/q, -eta),    Y = q Z(q, eta) - Z(1/q, -eta),

because the conjugate of Z is Z(1/q, -eta); the powers of i are even.  At a monomial the mean (power q^0) fixes U_hat if
its loss degree is odd and W_hat if it is even, the other powers fix Z, and the gauge fixes the mean of Z: Z(psi = 0) =
1, or mean 0, or no first harmonic in X.

A Fourier polynomial of degree n in the strengths is stored as q^(M n) times itself, M the largest (d+1)/2 for each
power of a strength: a plain ``fmpq_poly``.

>>> flow = fourier_flow((3,), 4)
>>> flow.U                                     # x'^3: p_1 = 3/8
-3/8*d + -315/4096*d^3 + O(5)
>>> flow.W                                     # Omega_2 = -45/256
1 + 45/256*d^2 + 2079/262144*d^4 + O(5)
>>> fourier_flow((1,), 4).W                    # 1/sqrt(1 - delta^2/4)
1 + 1/8*d^2 + 3/128*d^4 + O(5)
>>> duffing = Term(1, 0, 3, "position")
>>> fourier_flow([duffing], 3).W.inverse()       # omega of x'' + x + x^3 = 0 in powers of A^2
1 + 3/8*d + -21/256*d^2 + 81/2048*d^3 + O(4)
"""

from dataclasses import dataclass

from flint import fmpq, fmpq_poly

from asymptotics.errors import InputError
from asymptotics.expansions.half_swings.forces import Forces, Given
from asymptotics.expansions.half_swings.grading import Grading
from asymptotics.expansions.half_swings.pi_ring import PiNumber
from asymptotics.gauges import NO_FIRST_HARMONIC, TURNING_POINT, require_gauge
from asymptotics.graded import WholePowers, monomial_part
from asymptotics.running.budget import tick
from asymptotics.series import Key, Series, accumulate, is_exact_zero
from asymptotics.terms import Term as Term  # for the examples

Part = dict[Key, fmpq_poly]


@dataclass(frozen=True)
class FourierFlow:
    """U = d ln A/d psi and W = d tau/d psi (coefficients rational), and the waveform Z, in one gauge.

    ``Z[n]`` maps an exponent of total degree n to the polynomial q^(shift n) Z_n(q), in eta = delta/i for the losses.
    """

    grading: Grading
    U: Series
    W: Series
    Z: tuple[Part, ...]
    shift: int

    def bracket(self, gauge: str) -> Series:
        """c_hat(eta) = <Z> (averaging) or <Z + conj(Z) e^(-2 i psi)> (no-first-harmonic), from the waveform of this
        gauge.

        >>> fourier_flow((3,), 2).bracket("averaging")
        1 + 3/32*d + -75/1024*d^2 + O(3)
        """
        values: dict[Key, PiNumber] = {}
        for n, part in enumerate(self.Z):
            for k, p in part.items():
                mean = p[self.shift * n]
                if gauge == NO_FIRST_HARMONIC and n:
                    mean += (-1) ** self.grading.loss_degree(k) * p[self.shift * n - 1]
                values[k] = PiNumber.rational(mean)
        nonzero = {k: x for k, x in values.items() if not is_exact_zero(x)}
        return Series(nonzero, self.U.variables, self.U.order)


def fourier_flow(given: Given, order: int, gauge: str = TURNING_POINT) -> FourierFlow:
    """Solve the homological equation through degree ``order`` for polynomial forces, in one of the three gauges.

    Numbers in the place of forces are the exponents of plain losses.  Raises InputError for any other force: its
    Fourier series does not end.
    """
    forces = Forces.read(given, order)
    require_gauge(gauge)
    if not forces.is_smooth:
        accepted = "losses with alpha odd integers >= 1 and m even, springs with p odd and q even"
        raise InputError("alpha", "a force is no polynomial in x and v: it has no smooth flow in theta", accepted)
    return _FourierKernel(forces, order, gauge).solve()


class _FourierKernel:
    """The state of the recurrence: lists by total degree."""

    def __init__(self, forces: Forces, order: int, gauge: str) -> None:
        self.grading, self.order, self.gauge = forces.exact_grading(), order, gauge
        self.members = forces.through(order)
        # (d + 1)/2 for each power of the strength, rounded up: with q^(M n) in front no power of q is negative.
        self.M = max((-(-(m.integer_velocity + m.position + 1) // (2 * m.order)) for m in self.members), default=1)
        zero = (0,) * forces.variables
        self.Z: list[Part] = [{zero: fmpq_poly([1])}]
        used = [(m.position, m.integer_velocity, m.order) for m in self.members]
        self.P = WholePowers(fmpq_poly([1]), fmpq_poly([1, 1]), zero, [(m, n) for m, _, n in used], order)
        self.Y = WholePowers(fmpq_poly([1]), fmpq_poly([-1, 1]), zero, [(v, n) for _, v, n in used], order)
        self.U: list[dict[Key, fmpq]] = [{}]
        self.W: list[dict[Key, fmpq]] = [{zero: fmpq(1)}]
        self.forcing: list[Part] = [{}]  # Z_n + Phi_n

    def solve(self) -> FourierFlow:
        """All degrees, and the way back from eta to delta."""
        l = self.grading.loss_degree  # noqa: E741 (the letter of ``grading``)
        for n in range(1, self.order + 1):
            tick(f"order {n} of {self.order} of the smooth flow")
            self.forcing.append(self._phi(n))
            rest = self._right_side(n)
            middle = self.M * n
            # Solvability: the mean, stored at q^(M n), has to vanish,
            # which fixes U_hat or W_hat by the parity of the monomial.
            self.U.append({k: p[middle] for k, p in rest.items() if l(k) % 2})
            self.W.append({k: -p[middle] for k, p in rest.items() if l(k) % 2 == 0})
            self.Z.append({k: self._integrate(p, n, l(k)) for k, p in rest.items()})
            for k, p in self.Z[n].items():
                self.forcing[n][k] = self.forcing[n].get(k, fmpq_poly([])) + p
            if n < self.order:
                self._extend(n)
        return FourierFlow(self.grading, self._real(self.U, 1), self._real(self.W, 0), tuple(self.Z), self.M)

    def _phi(self, n: int) -> Part:
        """Phi_hat_n: for each member the product of powers whose degree its key completes to n."""
        total: Part = {}
        for m in self.members:
            if m.order > n:
                continue
            alpha = m.integer_velocity
            degree = alpha + m.position
            # i^(1+alpha) of a loss, i^q of a spring: even powers of i, so that signs are left.
            turn = alpha + 1 if m.sign < 0 else alpha
            scale, shift = m.ratio * fmpq((-1) ** (turn // 2), 2**degree), self.M * m.order - (degree + 1) // 2
            for k, p in monomial_part(self.P, m.position, self.Y, alpha, n - m.order).items():
                key = tuple(a + b for a, b in zip(k, m.key))
                total[key] = total.get(key, fmpq_poly([])) + (p * scale).left_shift(shift)
        return total

    def _right_side(self, n: int) -> Part:
        """Degree n of W_hat (Z + Phi_hat) - D_hat_1 Z without the unknown Z_n, U_hat_n, W_hat_n: 2 q d_q Z_n + U_hat_n
        - W_hat_n."""
        total = dict(self.forcing[n])
        for j in range(1, n):
            shift = self.M * j
            if self.U[j]:
                # D_1 = U (1 + sum (d_i - 1) delta_i d_i) multiplies a
                # monomial by 1 + a_k; q^(M j) aligns what is stored.
                grown = [(k, (p * (1 + self.grading.weight(k))).left_shift(shift)) for k, p in self.Z[n - j].items()]
                accumulate(total, [(k, -u) for k, u in self.U[j].items()], grown)
            if self.W[j]:
                accumulate(total, self.W[j].items(), [(k, p.left_shift(shift)) for k, p in self.forcing[n - j].items()])
        return total

    def _integrate(self, p: fmpq_poly, n: int, loss_degree: int) -> fmpq_poly:
        """Z_n from 2 q d_q Z_n = p - mean(p); the gauge fixes the mean of Z_n."""
        middle = self.M * n
        z = [c / (2 * (m - middle)) if m != middle else fmpq(0) for m, c in enumerate(p.coeffs())]
        # The mean may lie above the last coefficient that is there.
        z += [fmpq(0)] * (middle + 1 - len(z))
        if self.gauge == TURNING_POINT:
            # Z = 1 at psi = 0, where q = 1: the coefficients of Z_n have the sum 0.
            z[middle] = -sum(z, start=fmpq(0))
        elif self.gauge == NO_FIRST_HARMONIC:  # mean of Z_n + q^-1 conj(Z_n), and conj(Z_n)(q) = (-1)^l Z_n(1/q)
            z[middle] = -((-1) ** loss_degree) * z[middle - 1]
        return fmpq_poly(z)

    def _extend(self, n: int) -> None:
        """Append degree n of all powers of P and Y."""
        turned = {k: p.left_shift(1) for k, p in self.Z[n].items()}
        mirrored = {k: (-1) ** self.grading.loss_degree(k) * _reversed(p, 2 * self.M * n) for k, p in self.Z[n].items()}
        for powers, side in ((self.P, 1), (self.Y, -1)):
            powers.extend({k: p + side * mirrored[k] for k, p in turned.items()})

    def _real(self, parts: list[dict[Key, fmpq]], parity: int) -> Series:
        """Back from eta to delta: f(i eta) = i^parity f_hat(eta), so f_n = (-1)^((l - parity)/2) f_hat_n."""
        l = self.grading.loss_degree  # noqa: E741 (the letter of ``grading``)
        values = {k: PiNumber.rational(x * (-1) ** ((l(k) - parity) // 2)) for part in parts for k, x in part.items()}
        nonzero = {k: x for k, x in values.items() if not is_exact_zero(x)}
        return Series(nonzero, self.grading.variables, self.order)


def _reversed(p: fmpq_poly, degree: int) -> fmpq_poly:
    coefficients = list(p.coeffs())
    return fmpq_poly([fmpq(0)] * (degree + 1 - len(coefficients)) + coefficients[::-1])
