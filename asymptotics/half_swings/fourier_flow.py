"""Odd exponents: the flow (U, W) and the waveform Z directly, in rational Fourier polynomials, in each gauge.

For odd alpha_i the force epsilon_i X'^alpha_i is smooth, and z = X - i X' = A e^(i psi) Z(psi, delta) obeys

    (d_psi + D_1 + i) Z = i W (Z + Phi),    D_1 = U (1 + sum_i (alpha_i - 1) delta_i d_i),
    Phi = e^(-i psi) (sum_i epsilon_i X'^alpha_i)/A.

Put delta_i = i eta_i and q = e^(2 i psi): all coefficients become rational.  With U(i eta) = i U^(eta) and
W(i eta) = W^(eta),

    (2 q d_q + D^_1 + 1) Z = W^ (Z + Phi^),
    Phi^ = sum_i (-1)^((alpha_i+1)/2) 2^(-alpha_i) eta_i q^(-(alpha_i+1)/2) Y^alpha_i,
    Y(q, eta) = q Z(q, eta) - Z(1/q, -eta),

because the conjugate of Z is Z(1/q, -eta).  At degree n the mean (power q^0) fixes U^_n or W^_n, the other powers fix
Z_n, and the gauge fixes the mean of Z_n: Z(psi = 0) = 1, or mean 0, or no first harmonic in X.

A Fourier polynomial of degree n in eta is stored as q^(M n) times itself, M = (max alpha + 1)/2: a plain ``fmpq_poly``.

>>> flow = fourier_flow((3,), 4)
>>> flow.U                                     # x'^3: p_1 = 3/8
-3/8*d + -315/4096*d^3 + O(5)
>>> flow.W                                     # Omega_2 = -45/256
1 + 45/256*d^2 + 2079/262144*d^4 + O(5)
>>> fourier_flow((1,), 4).W                        # 1/sqrt(1 - delta^2/4)
1 + 1/8*d^2 + 3/128*d^4 + O(5)
"""

from dataclasses import dataclass

from flint import fmpq, fmpq_poly

from asymptotics.errors import InputError
from asymptotics.gauges import NO_FIRST_HARMONIC, TURNING_POINT, require_gauge
from asymptotics.half_swings.grading import Grading
from asymptotics.half_swings.pi_ring import PiNumber
from asymptotics.series import Key, Series, accumulate, is_exact_zero

Part = dict[Key, fmpq_poly]


@dataclass(frozen=True)
class FourierFlow:
    """U = d ln A/d psi and W = d tau/d psi (coefficients rational), and the waveform Z, in one gauge.

    ``Z[n]`` maps an exponent of total degree n to the polynomial q^(shift n) Z_n(q), in the variable eta = delta/i.
    """

    grading: Grading
    U: Series
    W: Series
    Z: tuple[Part, ...]
    shift: int

    def bracket(self, gauge: str) -> Series:
        """c^(eta) = <Z> (averaging) or <Z + conj(Z) e^(-2 i psi)> (no-first-harmonic), from the waveform of this gauge.

        >>> fourier_flow((3,), 2).bracket("averaging")
        1 + 3/32*d + -75/1024*d^2 + O(3)
        """
        values: dict[Key, PiNumber] = {}
        for n, part in enumerate(self.Z):
            for k, p in part.items():
                mean = p[self.shift * n]
                if gauge == NO_FIRST_HARMONIC and n:
                    mean += (-1) ** n * p[self.shift * n - 1]
                values[k] = PiNumber.rational(mean)
        nonzero = {k: x for k, x in values.items() if not is_exact_zero(x)}
        return Series(nonzero, self.U.variables, self.U.order)


def fourier_flow(alphas: tuple[int, ...], order: int, gauge: str = TURNING_POINT) -> FourierFlow:
    """Solve the homological equation through degree ``order`` for odd alpha_i >= 1 in one of the three gauges.

    Raises InputError for any other exponent: Y^alpha is a Laurent polynomial for odd integers only.
    """
    for alpha in alphas:
        if alpha != int(alpha) or alpha < 1 or alpha % 2 == 0:
            raise InputError("alpha", f"{alpha} has no smooth flow in theta", "odd integers >= 1")
    require_gauge(gauge)
    grading = Grading.of(fmpq(a) for a in alphas)
    M, zero = (max(alphas) + 1) // 2, (0,) * len(alphas)
    Z: list[Part] = [{zero: fmpq_poly([1])}]
    powers: list[list[Part]] = [[{zero: fmpq_poly([1])}]]
    powers += [[{zero: fmpq_poly([-1, 1]) ** k}] for k in range(1, max(alphas) + 1)]
    U: list[dict[Key, fmpq]] = [{}]
    W: list[dict[Key, fmpq]] = [{zero: fmpq(1)}]
    forcing: list[Part] = [{}]  # Z_n + Phi_n
    for n in range(1, order + 1):
        forcing.append(_phi(alphas, powers, n, M))
        rest = _right_side(grading, Z, U, W, forcing, n, M)
        U.append({k: p[M * n] for k, p in rest.items()} if n % 2 else {})
        W.append({k: -p[M * n] for k, p in rest.items()} if n % 2 == 0 else {})
        Z.append({k: _integrate(p, n, M, gauge) for k, p in rest.items()})
        for k, p in Z[n].items():
            forcing[n][k] = forcing[n].get(k, fmpq_poly([])) + p
        _extend_powers(powers, Z, n, M)
    return FourierFlow(grading, _real(U, len(alphas), order, 1), _real(W, len(alphas), order, 0), tuple(Z), M)


def _phi(alphas: tuple[int, ...], powers: list[list[Part]], n: int, M: int) -> Part:
    """Phi^_n: the terms of Y^alpha_i of degree n - 1, times eta_i; q^(-(alpha_i+1)/2) against the shift M."""
    total: Part = {}
    for i, alpha in enumerate(alphas):
        half = (alpha + 1) // 2
        scale = fmpq((-1) ** half, 2**alpha)
        for k, p in powers[alpha][n - 1].items():
            key = (*k[:i], k[i] + 1, *k[i + 1 :])
            total[key] = total.get(key, fmpq_poly([])) + (p * scale).left_shift(M - half)
    return total


def _right_side(
    grading: Grading,
    Z: list[Part],
    U: list[dict[Key, fmpq]],
    W: list[dict[Key, fmpq]],
    forcing: list[Part],
    n: int,
    M: int,
) -> Part:
    """Degree n of W^(Z + Phi^) - D^_1 Z without the unknown Z_n, U^_n, W^_n: equal to 2 q d_q Z_n + U^_n - W^_n."""
    total = dict(forcing[n])
    for j in range(1, n):
        if j % 2:
            known, parts = {k: -u for k, u in U[j].items()}, _first_order(grading, Z[n - j])
        else:
            known, parts = W[j], forcing[n - j]
        accumulate(total, known.items(), [(key, p.left_shift(M * j)) for key, p in parts.items()])
    return total


def _first_order(grading: Grading, part: Part) -> Part:
    """(1 + sum_i (alpha_i - 1) eta_i d_i) Z."""
    return {k: p * (1 + grading.weight(k)) for k, p in part.items()}


def _integrate(p: fmpq_poly, n: int, M: int, gauge: str) -> fmpq_poly:
    """Z_n from 2 q d_q Z_n = p - mean(p); the gauge fixes the mean of Z_n."""
    z = [c / (2 * (m - M * n)) if m != M * n else fmpq(0) for m, c in enumerate(p.coeffs())]
    z += [fmpq(0)] * (M * n + 1 - len(z))
    if gauge == TURNING_POINT:
        z[M * n] = -sum(z, start=fmpq(0))
    elif gauge == NO_FIRST_HARMONIC:  # mean of Z_n + q^-1 conj(Z_n), and conj(Z_n)(q) = (-1)^n Z_n(1/q)
        z[M * n] = -((-1) ** n) * z[M * n - 1]
    return fmpq_poly(z)


def _extend_powers(powers: list[list[Part]], Z: list[Part], n: int, M: int) -> None:
    """Append degree n of Y^k for every k, Y = q Z(q, eta) - Z(1/q, -eta)."""
    Y = powers[1]
    Y.append({k: p.left_shift(1) - (-1) ** n * _reversed(p, 2 * M * n) for k, p in Z[n].items()})
    powers[0].append({})
    for k in range(2, len(powers)):
        total: Part = {}
        for j in range(n + 1):
            accumulate(total, powers[k - 1][j].items(), Y[n - j].items())
        powers[k].append(total)


def _reversed(p: fmpq_poly, degree: int) -> fmpq_poly:
    coefficients = list(p.coeffs())
    return fmpq_poly([fmpq(0)] * (degree + 1 - len(coefficients)) + coefficients[::-1])


def _real(parts: list[dict[Key, fmpq]], variables: int, order: int, parity: int) -> Series:
    """Back from eta to delta: f(i eta) = i^parity f^(eta), so f_n = (-1)^((n - parity)/2) f^_n."""
    values = {k: PiNumber.rational(x * (-1) ** ((n - parity) // 2)) for n, p in enumerate(parts) for k, x in p.items()}
    return Series({k: x for k, x in values.items() if not is_exact_zero(x)}, variables, order)
