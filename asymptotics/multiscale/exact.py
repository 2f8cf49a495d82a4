"""The kernel of the classical route for odd exponents: Fourier coefficients and flow, exact, order by order.

With odd alpha_i the force epsilon_i X'^alpha_i is a polynomial.  Put

    X = a sum_k delta^k x_k(psi),    da/d tau = -a p(delta),    d psi/d tau = 1 + Omega(delta),
    delta_i = epsilon_i a^(alpha_i - 1),    x_0 = cos psi,    no first harmonic in the other x_k.

On a delta^k x_k the total time derivative is D = (1 + Omega) d_psi - p E with E = 1 + sum_i k_i (alpha_i - 1).  It is
one vector field, and the slow derivatives D_n are its parts of degree n: nobody has to remember that D_1 D_2 and
D_2 D_1 differ.  Order n of D^2 X + X + sum_i epsilon_i (D X)^alpha_i = 0 is

    x_n'' + x_n = (what the lower orders give) + 2 p_n-terms sin psi + 2 Omega_n-terms cos psi;

the first harmonic of the right side must vanish (solvability), the other harmonics m give x_n by division by 1 - m^2.

*Rational arithmetic.*  t -> -t with epsilon -> -epsilon makes x_n a cosine series for even n and a sine series for odd
n.  So with delta = i eta, X = sum_k eta^k xhat_k(q), q = e^(i psi), D = i Dhat, all coefficients are rational:

    Dhat = (1 + Omegahat) q d_q - phat E,
    Xhat - Dhat^2 Xhat + sum_i (-1)^((alpha_i+1)/2) eta_i (Dhat Xhat)^alpha_i = 0.

xhat_n has the odd harmonics |m| <= h_n = 1 + n (max alpha - 1) and is stored as q^(h_n) xhat_n, a polynomial in q^2.

>>> solved = odd_hierarchy((3,), 4)
>>> solved.p, solved.Omega
(3/8*d + 351/8192*d^3 + O(5), 9/256*d^2 + 1755/262144*d^4 + O(5))
>>> solved.harmonics((1,))                          # X_1 = a^3 sin(3 psi)/32
{3: 1/32}
>>> odd_hierarchy((1,), 4).Omega                    # sqrt(1 - delta^2/4) - 1
-1/8*d^2 + -1/128*d^4 + O(5)
"""

from collections.abc import Callable
from dataclasses import dataclass

from flint import fmpq, fmpq_poly

from asymptotics.errors import InputError, LimitError
from asymptotics.numbers.exact import MAX_ORDER, require_integer
from asymptotics.series import Key, Series, accumulate, monomials

Part = dict[Key, fmpq_poly]
GAUGE = "no-first-harmonic"
MAX_SECONDS = 60.0


@dataclass(frozen=True)
class OddHierarchy:
    """Everything that orders 0, ..., N of the hierarchy determine, gauge no-first-harmonic.

    ``p_hat``, ``Omega_hat``: the flow in eta, coefficients fmpq.  ``X[n]``, ``Y[n]``, ``known[n]``: exponent of total
    degree n -> polynomial of xhat_n, of the velocity Dhat Xhat, and of minus the right side of the equation for x_n
    before the terms with p_n and Omega_n.
    """

    alphas: tuple[int, ...]
    order: int
    p_hat: Series
    Omega_hat: Series
    X: tuple[Part, ...]
    Y: tuple[Part, ...]
    known: tuple[Part, ...]
    gauge: str = GAUGE

    @property
    def p(self) -> Series:
        """p(delta) in da/d tau = -a p(delta)."""
        return self.p_hat.map_keys(lambda k, c: c * sign(sum(k)))

    @property
    def Omega(self) -> Series:
        """Omega(delta) in d psi/d tau = 1 + Omega(delta)."""
        return self.Omega_hat.map_keys(lambda k, c: c * sign(sum(k)))

    def harmonics(self, key: Key) -> dict[int, fmpq]:
        """x_k: the coefficients of sin(m psi) (total degree odd) or cos(m psi) (even), m >= 1, without zeros."""
        return real_harmonics(self.X[sum(key)].get(key, fmpq_poly([])), sum(key), self.spread)

    def right_side(self, key: Key) -> dict[int, fmpq]:
        """The part of x_k'' + x_k that the lower orders give: coefficients like those of ``harmonics``."""
        return real_harmonics(-self.known[sum(key)].get(key, fmpq_poly([])), sum(key), self.spread)

    @property
    def spread(self) -> int:
        """max alpha - 1: how many harmonics an order adds."""
        return max(self.alphas) - 1

    def keys(self, n: int) -> list[Key]:
        """The exponents of total degree n that occur."""
        return [k for k in monomials(len(self.alphas), n) if k in self.X[n]]


def sign(n: int) -> int:
    """(-1)^floor(n/2): from eta = -i delta back to delta, for series of either parity.

    Omega(i eta) = Omegahat and p(i eta) = i phat, so Omega_n = (-1)^(n/2) Omegahat_n, p_n = (-1)^((n-1)/2) phat_n.
    """
    return -1 if n % 4 >= 2 else 1


def real_harmonics(p: fmpq_poly, n: int, spread: int) -> dict[int, fmpq]:
    """x_n = (-i)^n sum_m xhat_m e^(i m psi): 2 (-1)^floor(n/2) xhat_m is the coefficient of cos or sin(m psi)."""
    h = 1 + n * spread
    return {m: 2 * sign(n) * p[(m + h) // 2] for m in range(1, h + 1, 2) if p[(m + h) // 2] != 0}


def odd_hierarchy(alphas: tuple[int, ...], order: int, *, max_seconds: float = MAX_SECONDS) -> OddHierarchy:
    """Solve the hierarchy through order ``order`` >= 1 for odd exponents alpha_i >= 1.

    Raises InputError for other exponents or orders, LimitError when the estimated time is above ``max_seconds``.
    """
    require_odd(alphas)
    require_order(alphas, order, max_seconds)
    kernel = _Kernel(alphas)
    for n in range(1, order + 1):
        kernel.advance(n)
    p, Omega = (_series(parts, len(alphas), order) for parts in (kernel.p, kernel.Omega))
    return OddHierarchy(alphas, order, p, Omega, tuple(kernel.X), tuple(kernel.Y), tuple(kernel.known))


def require_odd(alphas: tuple[int, ...]) -> None:
    """InputError unless there is an exponent and all are odd integers >= 1."""
    accepted = "odd integers >= 1; general.second_order takes any alpha >= 0"
    if not alphas:
        raise InputError("alpha", "no exponent is given", accepted)
    for a in alphas:
        if not isinstance(a, int) or a < 1 or a % 2 == 0:
            raise InputError("alpha", f"{a!r} has no exact hierarchy", accepted)


def require_order(alphas: tuple[int, ...], order: int, max_seconds: float) -> None:
    """InputError for an order below 1, LimitError for too much work (a rough estimate with a measured rate)."""
    require_integer(order, "order", 1, MAX_ORDER)
    seconds = estimated_seconds(alphas, order)
    if seconds > max_seconds:
        raise LimitError("order", f"{order} would take about {seconds:.0f} s", f"an estimate below {max_seconds:.0f} s")


def estimated_seconds(alphas: tuple[int, ...], order: int) -> float:
    """(powers) x (pairs of monomials) x (length of the polynomials), times a measured rate."""
    count = len(monomials(len(alphas) + 1, order))
    length = 1 + order * max(alphas) // 2
    return 3e-7 * max(alphas) * count**2 * length


def rotated(p: fmpq_poly, h: int) -> fmpq_poly:
    """q d_q of q^(-h) p(q^2), stored the same way."""
    return 2 * p.derivative().left_shift(1) - h * p


class _Kernel:
    """The state of the recurrence: lists by total degree, extended by ``advance``."""

    def __init__(self, alphas: tuple[int, ...]) -> None:
        zero = (0,) * len(alphas)
        self.alphas, self.spread = alphas, max(alphas) - 1
        self.X: list[Part] = [{zero: fmpq_poly([fmpq(1, 2), fmpq(1, 2)])}]  # cos psi
        self.Y: list[Part] = [{zero: fmpq_poly([fmpq(-1, 2), fmpq(1, 2)])}]  # Dhat Xhat: q d_q of it
        self.powers: list[list[Part]] = [[{zero: self.Y[0][zero] ** k}] for k in range(max(alphas) + 1)]
        self.p: list[dict[Key, fmpq]] = [{}]
        self.Omega: list[dict[Key, fmpq]] = [{}]
        self.known: list[Part] = [{}]

    def advance(self, n: int) -> None:
        """Order n: the right side, solvability, division by m^2 - 1, and the new velocity."""
        h = 1 + n * self.spread
        first = (1 + h) // 2
        velocity = self._slow(self.X, n)
        R = self._force(n)
        for k, part in _sum(_map(velocity, lambda p: rotated(p, h)), self._slow(self.Y, n)).items():
            R[k] = R.get(k, fmpq_poly([])) - part
        self.known.append(R)
        self.p.append({k: -p[first] for k, p in R.items()} if n % 2 else {})
        self.Omega.append({} if n % 2 else {k: p[first] for k, p in R.items()})
        self.X.append(_map(R, lambda p: _divided(p, h)))
        self.Y.append(_sum(_sum(_map(self.X[n], lambda p: rotated(p, h)), velocity), self._newest(n)))
        self._extend_powers(n)

    def _force(self, n: int) -> Part:
        """sum_i (-1)^((alpha_i+1)/2) eta_i Y^alpha_i at degree n."""
        total: Part = {}
        for i, a in enumerate(self.alphas):
            for k, p in self.powers[a][n - 1].items():
                key = (*k[:i], k[i] + 1, *k[i + 1 :])
                shifted = (p * (-1) ** ((a + 1) // 2)).left_shift((self.spread + 1 - a) // 2)
                total[key] = total.get(key, fmpq_poly([])) + shifted
        return total

    def _slow(self, parts: list[Part], n: int) -> Part:
        """sum_(0<j<n) (Omegahat_j q d_q - phat_j E) of the part of degree n - j: the known slow derivatives."""
        total: Part = {}
        for j in range(1, n):
            shift = j * self.spread // 2
            if j % 2:
                image = {k: p.left_shift(shift) * -self._weight(k) for k, p in parts[n - j].items()}
                accumulate(total, self.p[j].items(), image.items())
            else:
                h = 1 + (n - j) * self.spread
                turned = _map(parts[n - j], lambda p, h=h, s=shift: rotated(p, h).left_shift(s))  # type: ignore[misc]
                accumulate(total, self.Omega[j].items(), turned.items())
        return total

    def _newest(self, n: int) -> Part:
        """(Omegahat_n q d_q - phat_n) of cos psi."""
        (cosine,), (sine,) = self.X[0].values(), self.Y[0].values()
        shift = n * self.spread // 2
        slow = {k: -c * cosine.left_shift(shift) for k, c in self.p[n].items()}
        return _sum(slow, {k: c * sine.left_shift(shift) for k, c in self.Omega[n].items()})

    def _weight(self, key: Key) -> int:
        """E = 1 + sum_i k_i (alpha_i - 1): the power of a in a delta^k."""
        return 1 + sum(k * (a - 1) for k, a in zip(key, self.alphas))

    def _extend_powers(self, n: int) -> None:
        self.powers[0].append({})
        self.powers[1].append(self.Y[n])
        for k in range(2, len(self.powers)):
            total: Part = {}
            for j in range(n + 1):
                accumulate(total, self.powers[k - 1][j].items(), self.Y[n - j].items())
            self.powers[k].append(total)


def _divided(p: fmpq_poly, h: int) -> fmpq_poly:
    """xhat_m = R_m/(m^2 - 1), without first harmonic."""
    harmonics = ((2 * i - h, c) for i, c in enumerate(p.coeffs()))
    return fmpq_poly([c / (m * m - 1) if m * m != 1 else fmpq(0) for m, c in harmonics])


def _map(part: Part, f: Callable[[fmpq_poly], fmpq_poly]) -> Part:
    return {k: f(p) for k, p in part.items()}


def _sum(left: Part, right: Part) -> Part:
    total = dict(left)
    for k, p in right.items():
        total[k] = total[k] + p if k in total else p
    return total


def _series(parts: list[dict[Key, fmpq]], variables: int, order: int) -> Series:
    return Series({k: c for part in parts for k, c in part.items() if c != 0}, variables, order)
