"""The kernel of the hierarchy in the turning-point gauge for integer exponents: every X_k a polynomial, to any order.

On 0 < psi < pi the velocity has one sign.  With Y = -X' > 0 a loss is -epsilon |x|^m Y^alpha and a spring c x^p Y^q,
polynomials in X and Y for integer alpha, q, even m and odd p: also for alpha = 0 and for even alpha.  Put

    X = a sum_k delta^k x_k(psi),   V = X' = a sum_k delta^k v_k(psi),   da/dtau = -a p,   dpsi/dtau = 1 + Omega,

x_0 = cos psi, v_0 = -sin psi, D = (1 + Omega) d_psi - p E with E = 1 + sum_i k_i (d_i - 1) on a delta^k.  At order k,
V = D X and D V + X + F = 0 are

    x_k' = v_k - K - (-p_k cos psi - Omega_k sin psi),
    v_k' = -x_k - L - (p_k sin psi - Omega_k cos psi),
    K = sum_(0<j<k) (Omega_j d_psi - p_j E) x_(k-j),      L = sum_(0<j<k) (Omega_j d_psi - p_j E) v_(k-j) + F_k,

and by variation of constants, x_k = c u + s w, v_k = -s u + c w,

    u' = p_k + (s L - c K),          w' = Omega_k - (s K + c L).

The turning points stand at psi = 0 and psi = pi for every a: X(a, 0) = a and V = 0 there, that is u = w = 0 at both
ends.  The two conditions at pi give p_k and Omega_k: pi p_k = -int_0^pi (s L - c K), pi Omega_k = int_0^pi (s K + c L).
X(a, psi + pi) = -X(a, psi) is the rest of the period.

Nothing is taken from the half-swing engine: the ansatz alone gives all of it.

>>> solved = turning_hierarchy((2,), 3)
>>> solved.p, solved.Omega
(4/(3*pi)*d + 2/(135*pi)*d^3 + O(4), -1/6*d^2 + O(4))
>>> solved.X[1][(1,)].to_sympy()
4*psi*cos(psi)/(3*pi) + cos(psi)**2/3 - 2*cos(psi)/3 + 1/3
>>> turning_hierarchy((0,), 4).p, turning_hierarchy((0,), 4).Omega      # dry friction: exact at first order
(2/pi*d + O(5), O(5))
"""

from dataclasses import dataclass

from flint import fmpq

from asymptotics.costs import require_affordable, turning_hierarchy_seconds
from asymptotics.errors import InputError
from asymptotics.expansions.half_swings.forces import Forces, Given
from asymptotics.expansions.half_swings.grading import Grading
from asymptotics.expansions.half_swings.pi_ring import PI, PiNumber
from asymptotics.expansions.multiple_scales.ring import COSINE, ONE, PSI, SINE, ZERO, Wave
from asymptotics.gauges import TURNING_POINT
from asymptotics.graded import WholePowers, monomial_part, summed
from asymptotics.numbers.exact import MAX_ORDER
from asymptotics.numbers.integers import require_integer
from asymptotics.running.budget import Unasked, tick
from asymptotics.series import Key, Series, accumulate, monomials

Part = dict[Key, Wave]
MAX_SECONDS = Unasked(60)
ACCEPTED = "losses |x|^M x'|x'|^(A-1), A an integer and M even, springs x^P |x'|^Q, P odd and Q an integer"


@dataclass(frozen=True)
class TurningHierarchy:
    """Orders 0, ..., N of the hierarchy in the turning-point gauge, on 0 < psi < pi.

    ``X[n]``, ``V[n]``: exponent k of total degree n -> x_k, v_k; ``K[n]``, ``L[n]``: what the lower orders give (module
    docstring); ``p``, ``Omega``: the slow flow, coefficients in Q[pi, 1/pi].
    """

    forces: Forces
    order: int
    p: Series
    Omega: Series
    X: tuple[Part, ...]
    V: tuple[Part, ...]
    K: tuple[Part, ...]
    L: tuple[Part, ...]
    gauge: str = TURNING_POINT

    @property
    def grading(self) -> Grading:
        """The weights d_i - 1 and the signs of the strengths."""
        return self.forces.exact_grading()

    def keys(self, n: int) -> list[Key]:
        """The exponents of total degree n."""
        return monomials(self.forces.variables, n)

    def forcing(self, key: Key) -> Wave:
        """What the lower orders give of x_k'' + x_k: -(L + K')."""
        n = sum(key)
        return -(self.L[n].get(key, ZERO) + self.K[n].get(key, ZERO).derivative())


def turning_hierarchy(given: Given, order: int, *, max_seconds: float = MAX_SECONDS) -> TurningHierarchy:
    """Solve the hierarchy through ``order`` >= 1; numbers are exponents of plain losses.

    Raises InputError for forces that do not close, LimitError when the estimated time is above ``max_seconds``.
    """
    require_integer(order, "order", 1, MAX_ORDER)
    forces = Forces.read(given, order)
    if not forces.is_closed:
        raise InputError("law", "the hierarchy of these forces does not close in polynomials", ACCEPTED)
    require_affordable(estimated_seconds(forces, order), max_seconds, "order", f"order {order}")
    kernel = _TurningKernel(forces, order)
    for n in range(1, order + 1):
        tick(f"order {n} of {order} of the hierarchy")
        kernel.advance(n)
    p, Omega = (Series(c, forces.variables, order) for c in (kernel.p, kernel.Omega))
    X, V, K, L = (tuple(parts) for parts in (kernel.X, kernel.V, kernel.K, kernel.L))
    return TurningHierarchy(forces, order, p, Omega, X, V, K, L)


def estimated_seconds(forces: Forces, order: int) -> float:
    """A rough estimate of the time."""
    degree = max(m.integer_velocity + m.position for m in forces.through(order))
    return turning_hierarchy_seconds(order, forces.variables, degree)


class _TurningKernel:
    """The state of the recurrence, extended by ``advance``."""

    def __init__(self, forces: Forces, order: int) -> None:
        zero = (0,) * forces.variables
        self.forces, self.grading, self.order = forces, forces.exact_grading(), order
        self.X: list[Part] = [{zero: COSINE}]
        self.V: list[Part] = [{zero: -SINE}]
        self.K: list[Part] = [{}]
        self.L: list[Part] = [{}]
        self.p: dict[Key, PiNumber] = {}
        self.Omega: dict[Key, PiNumber] = {}
        members = forces.through(order)
        self.members = members
        used = [(m.position, m.integer_velocity, m.order) for m in members]
        self.X_powers = WholePowers(ONE, COSINE, zero, [(m, n) for m, _, n in used], order)
        self.Y_powers = WholePowers(ONE, SINE, zero, [(v, n) for _, v, n in used], order)

    def advance(self, n: int) -> None:
        """Order n: what the lower orders give, the two conditions at pi, x_k and v_k."""
        K, L = self._slow(self.X, n), summed(self._slow(self.V, n), self._force(n))
        self.K.append(K)
        self.L.append(L)
        self.X.append({})
        self.V.append({})
        for key in monomials(self.forces.variables, n):
            # The integrals without the rates first: u and w less p_k psi and Omega_k psi.
            k, l = K.get(key, ZERO), L.get(key, ZERO)  # noqa: E741 (the letters of the docstring)
            u = (SINE * l - COSINE * k).integral()
            w = -(SINE * k + COSINE * l).integral()
            for rates, f in ((self.p, u), (self.Omega, w)):
                # Both conditions in one form: u + pi p_k = 0 and w + pi Omega_k = 0 at psi = pi.
                rate = f.at_pi() * fmpq(-1) / PI
                # Exact numbers, so that a zero is one: Omega_k of an
                # odd loss degree, all of dry friction from order 2 on.
                if rate != 0:
                    rates[key] = rate
            u, w = (f + PSI * rates[key] if key in rates else f for rates, f in ((self.p, u), (self.Omega, w)))
            self.X[n][key] = (COSINE * u + SINE * w).lowered()
            self.V[n][key] = (COSINE * w - SINE * u).lowered()
        self.X_powers.extend(self.X[n])
        # Y = -X' is the positive one.
        self.Y_powers.extend({k: -f for k, f in self.V[n].items()})

    def _slow(self, parts: list[Part], n: int) -> Part:
        """sum_(0<j<n) (Omega_j d_psi - p_j E) of the part of degree n - j."""
        total: Part = {}
        for key, f in ((k, f) for part in parts[1:n] for k, f in part.items()):
            # D = (1 + Omega) d_psi - p E on a delta^k: E multiplies by 1 + a_k.
            turned, grown = f.derivative(), f * -(1 + self.grading.weight(key))
            for rates, g in ((self.Omega, turned), (self.p, grown)):
                accumulate(total, [(key, g)], [(j, c) for j, c in rates.items() if sum(j) + sum(key) == n])
        return total

    def _force(self, n: int) -> Part:
        """The forces at degree n: -epsilon |X|^m Y^alpha and c X^p Y^q."""
        total: Part = {}
        for m in self.members:
            if m.order <= n:
                found = monomial_part(self.X_powers, m.position, self.Y_powers, m.integer_velocity, n - m.order)
                accumulate(total, found.items(), [(m.key, m.ratio * m.sign)])
        return total
