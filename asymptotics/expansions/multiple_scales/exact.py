"""The kernel of the classical route for smooth forces: Fourier coefficients and flow, exact, order by order.

Losses epsilon |x|^m v|v|^(alpha-1) with alpha odd and m even, springs c x|x|^(p-1) |v|^q with p odd and q even are
polynomials in X and X'.  Put

    X = a sum_k delta^k x_k(psi),    da/d tau = -a p(delta),    d psi/d tau = 1 + Omega(delta),
    delta_i = epsilon_i a^(d_i - 1),    x_0 = cos psi,    no first harmonic in the other x_k,

d_i the degree of the force, and c_j for epsilon_j where it is a spring.  On a delta^k x_k the total time derivative is
D = (1 + Omega) d_psi - p E with E = 1 + sum_i k_i (d_i - 1).  It is one vector field, and the slow derivatives D_n are
its parts of degree n: nobody has to remember that D_1 D_2 and D_2 D_1 differ.  Order n of
D^2 X + X + sum_i epsilon_i X^m_i (D X)^alpha_i + sum_j c_j X^p_j (D X)^q_j = 0 is

    x_n'' + x_n = (what the lower orders give) + 2 p_n-terms sin psi + 2 Omega_n-terms cos psi;

the first harmonic of the right side must vanish (solvability), the other harmonics m give x_n by division by 1 - m^2.

*Rational arithmetic.*  Let l be the degree in the losses alone.  t -> -t changes the sign of every loss and of no
spring, hence x_k is a cosine series for even l and a sine series for odd l; p has odd l, Omega even l, and with a
spring both have terms of every total degree.  So with delta = i eta for the losses and the springs as they are,
X = sum_k eta^k xhat_k(q), q = e^(i psi), D = i Dhat, all coefficients are rational:

    Dhat = (1 + Omegahat) q d_q - phat E,
    Xhat - Dhat^2 Xhat + sum_i (-1)^((alpha_i+1)/2) eta_i Xhat^m_i (Dhat Xhat)^alpha_i
                       + sum_j (-1)^(q_j/2) c_j Xhat^p_j (Dhat Xhat)^q_j = 0.

xhat_n has the odd harmonics |m| <= h_n = 1 + n max(d - 1) and is stored as q^(h_n) xhat_n, a polynomial in q^2.

>>> solved = odd_hierarchy((3,), 4)
>>> solved.p, solved.Omega
(3/8*d + 351/8192*d^3 + O(5), 9/256*d^2 + 1755/262144*d^4 + O(5))
>>> solved.harmonics((1,))                          # X_1 = a^3 sin(3 psi)/32
{3: 1/32}
>>> odd_hierarchy((1,), 4).Omega                    # sqrt(1 - delta^2/4) - 1
-1/8*d^2 + -1/128*d^4 + O(5)
>>> duffing = odd_hierarchy([Term(1, 0, 3, "position")], 2)
>>> duffing.Omega, duffing.harmonics((1,))          # Duffing: X_1 = a^3 cos(3 psi)/32
(3/8*d + -15/256*d^2 + O(3), {3: 1/32})
"""

from dataclasses import dataclass

from flint import fmpq, fmpq_poly

from asymptotics.costs import hierarchy_seconds, require_affordable
from asymptotics.errors import InputError
from asymptotics.expansions.half_swings.forces import Forces, Given, Member
from asymptotics.expansions.half_swings.grading import Grading
from asymptotics.graded import WholePowers, monomial_part, summed
from asymptotics.numbers.exact import MAX_ORDER
from asymptotics.numbers.integers import require_integer
from asymptotics.running.budget import Unasked, tick
from asymptotics.series import Key, Series, accumulate, monomials
from asymptotics.terms import Term

Part = dict[Key, fmpq_poly]
GAUGE = "no-first-harmonic"
MAX_SECONDS = Unasked(60)


@dataclass(frozen=True)
class OddHierarchy:
    """Everything that orders 0, ..., N of the hierarchy determine, gauge no-first-harmonic.

    ``forces``: what acts beside the linear spring; ``p_hat``, ``Omega_hat``: the flow in eta, coefficients fmpq.
    ``X[n]``, ``Y[n]``, ``known[n]``: exponent of total degree n -> polynomial of xhat_n, of the velocity Dhat Xhat, and
    of minus the right side of the equation for x_n before the terms with p_n and Omega_n.
    """

    forces: Forces
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
        return self.real(self.p_hat)

    @property
    def Omega(self) -> Series:
        """Omega(delta) in d psi/d tau = 1 + Omega(delta)."""
        return self.real(self.Omega_hat)

    def harmonics(self, key: Key) -> dict[int, fmpq]:
        """x_k: the coefficients of sin(m psi) (loss degree odd) or cos(m psi) (even), m >= 1, without zeros."""
        return self.real_harmonics(key, self.X[sum(key)].get(key, fmpq_poly([])))

    def right_side(self, key: Key) -> dict[int, fmpq]:
        """The part of x_k'' + x_k that the lower orders give: coefficients like those of ``harmonics``."""
        return self.real_harmonics(key, -self.known[sum(key)].get(key, fmpq_poly([])))

    @property
    def grading(self) -> Grading:
        """The weights d_i - 1 and the signs of the strengths."""
        return self.forces.exact_grading()

    @property
    def spread(self) -> int:
        """max (d - 1): how many harmonics an order adds."""
        return spread_of(self.forces, self.order)

    def real(self, series: Series) -> Series:
        """A series of real quantities, or of i times such, from eta = -i delta back to delta."""
        return series.map_keys(lambda k, c: c * sign(self.forces.loss_degree(k)))

    def real_harmonics(self, key: Key, p: fmpq_poly) -> dict[int, fmpq]:
        """(-i)^l sum_m c_m e^(i m psi) in sin(m psi) or cos(m psi): the coefficients 2 (-1)^floor(l/2) c_m."""
        # The harmonic m of q^h xhat(q) stands at q^(m + h), and the polynomial is stored in q^2.
        h, turn = 1 + sum(key) * self.spread, 2 * sign(self.forces.loss_degree(key))
        return {m: turn * p[(m + h) // 2] for m in range(1, h + 1, 2) if p[(m + h) // 2] != 0}

    def keys(self, n: int) -> list[Key]:
        """The exponents of total degree n that occur."""
        return [k for k in monomials(self.forces.variables, n) if k in self.X[n]]


def sign(n: int) -> int:
    """(-1)^floor(n/2): from eta = -i delta back to delta, for series of either parity of the loss degree n.

    Omega(i eta) = Omegahat and p(i eta) = i phat, so Omega_n = (-1)^(n/2) Omegahat_n, p_n = (-1)^((n-1)/2) phat_n.
    """
    # The same number for n = 0, 1 and for n = 2, 3: one function serves cosines (n even) and sines (n odd).
    return -1 if n % 4 >= 2 else 1


def spread_of(forces: Forces, order: int) -> int:
    """How many harmonics an order adds: the largest d - 1, a member of a family counted for each power of its key."""
    # -(-x // y) rounds up: half a harmonic would be one.
    return max((-(-(_degree(m) - 1) // m.order) for m in forces.through(order)), default=0)


def odd_hierarchy(given: Given, order: int, *, max_seconds: float = MAX_SECONDS) -> OddHierarchy:
    """Solve the hierarchy through order ``order`` >= 1 for polynomial forces; numbers are exponents of plain losses.

    Raises InputError for other forces or orders, LimitError when the estimated time is above ``max_seconds``.
    """
    require_integer(order, "order", 1, MAX_ORDER)
    forces = require_smooth(given, order)
    require_affordable(estimated_seconds(forces, order), max_seconds, "order", f"order {order}")
    kernel = _HarmonicKernel(forces, order)
    for n in range(1, order + 1):
        tick(f"order {n} of {order} of the hierarchy")
        kernel.advance(n)
    p, Omega = (_series(parts, forces.variables, order) for parts in (kernel.p, kernel.Omega))
    return OddHierarchy(forces, order, p, Omega, tuple(kernel.X), tuple(kernel.Y), tuple(kernel.known))


def require_smooth(given: Given, order: int) -> Forces:
    """The forces, if they are polynomials in x and v; InputError for anything else, or for nothing."""
    accepted = "losses |x|^M x'^A, A odd and M even, springs x^P x'^Q, P odd and Q even"
    if not isinstance(given, Forces):
        if not given:
            raise InputError("alpha", "no exponent is given", accepted)
        for a in given:
            if not isinstance(a, Term) and (not isinstance(a, int) or a < 0):
                raise InputError("alpha", f"{a!r} has no exact hierarchy", accepted)
    forces = Forces.read(given, order)
    for m in forces.members:
        if not m.is_polynomial:
            name = "spring" if m.sign > 0 else "law" if m.position else "alpha"
            factors = f"velocity to the power {m.velocity}" + (f", position to {m.position}" if m.position else "")
            raise InputError(name, f"{factors}: no polynomial, so its Fourier series does not end", accepted)
    return forces


def estimated_seconds(forces: Forces, order: int) -> float:
    """A rough estimate of the time for the hierarchy."""
    count = len(monomials(forces.variables + 1, order))
    # For the estimate alone: how many products of series an order needs.
    powers = max(max(m.integer_velocity, 1) + m.position for m in forces.through(order))
    length = 1 + order * (spread_of(forces, order) + 1) // 2
    return hierarchy_seconds(count, powers, length)


def _degree(m: Member) -> int:
    return m.integer_velocity + m.position


def rotated(p: fmpq_poly, h: int) -> fmpq_poly:
    """q d_q of q^(-h) p(q^2), stored the same way."""
    return 2 * p.derivative().left_shift(1) - h * p


def _rotated(part: Part, h: int) -> Part:
    return {k: rotated(p, h) for k, p in part.items()}


class _HarmonicKernel:
    """The state of the recurrence: lists by total degree, extended by ``advance``."""

    def __init__(self, forces: Forces, order: int) -> None:
        zero = (0,) * forces.variables
        self.forces, self.grading, self.spread = forces, forces.exact_grading(), spread_of(forces, order)
        self.members, self.order = forces.through(order), order
        self.X: list[Part] = [{zero: fmpq_poly([fmpq(1, 2), fmpq(1, 2)])}]  # cos psi
        self.Y: list[Part] = [{zero: fmpq_poly([fmpq(-1, 2), fmpq(1, 2)])}]  # Dhat Xhat: q d_q of it
        used = [(m.position, m.integer_velocity, m.order) for m in self.members]
        self.X_powers = WholePowers(fmpq_poly([1]), self.X[0][zero], zero, [(m, n) for m, _, n in used], order)
        self.Y_powers = WholePowers(fmpq_poly([1]), self.Y[0][zero], zero, [(v, n) for _, v, n in used], order)
        self.p: list[dict[Key, fmpq]] = [{}]
        self.Omega: list[dict[Key, fmpq]] = [{}]
        self.known: list[Part] = [{}]

    def advance(self, n: int) -> None:
        """Order n: the right side, solvability, division by m^2 - 1, and the new velocity."""
        h = 1 + n * self.spread
        # Where the first harmonic stands in what is stored.
        first = (1 + h) // 2
        # The order matters: x_n from the lower orders, then its velocity with the new rates, then the powers of both.
        velocity = self._slow(self.X, n)
        # (1 - m^2) x_n + R = 0 beside the newest rates: R is the force,
        # less the derivative of the velocity as far as it is known.
        R = self._force(n)
        for k, part in summed(_rotated(velocity, h), self._slow(self.Y, n)).items():
            R[k] = R.get(k, fmpq_poly([])) - part
        self.known.append(R)
        odd = {k for k in R if self.forces.loss_degree(k) % 2}
        # Solvability (Fredholm's alternative): the first harmonic is in the kernel of d^2/dpsi^2 + 1, so that it has to
        # vanish on the right, which the terms with p_n and Omega_n bring about.
        self.p.append({k: -R[k][first] for k in odd})
        self.Omega.append({k: p[first] for k, p in R.items() if k not in odd})
        self.X.append({k: _divided(p, h) for k, p in R.items()})
        self.Y.append(summed(_rotated(self.X[n], h), velocity, self._newest(n)))
        self.X_powers.extend(self.X[n])
        self.Y_powers.extend(self.Y[n])

    def _force(self, n: int) -> Part:
        """The forces at degree n: (-1)^((alpha+1)/2) eta X^m Y^alpha and (-1)^(q/2) c X^p Y^q."""
        total: Part = {}
        for member in self.members:
            if member.order > n:
                continue
            # The stored polynomials of a factor and of its product differ by powers of q: this is the difference.
            scale, shift = in_eta(member), (member.order * self.spread + 1 - _degree(member)) // 2
            found = monomial_part(
                self.X_powers, member.position, self.Y_powers, member.integer_velocity, n - member.order
            )
            for k, p in found.items():
                key = tuple(i + j for i, j in zip(k, member.key))
                total[key] = total.get(key, fmpq_poly([])) + (p * scale).left_shift(shift)
        return total

    def _slow(self, parts: list[Part], n: int) -> Part:
        """sum_(0<j<n) (Omegahat_j q d_q - phat_j E) of the part of degree n - j: the known slow derivatives."""
        total: Part = {}
        for j in range(1, n):
            # As in ``_force``: what is stored for degree n - j is moved to where degree n has it.
            shift, h = j * self.spread // 2, 1 + (n - j) * self.spread
            grown = {k: p.left_shift(shift) * -(1 + self.grading.weight(k)) for k, p in parts[n - j].items()}
            turned = {k: rotated(p, h).left_shift(shift) for k, p in parts[n - j].items()}
            accumulate(total, self.p[j].items(), grown.items())
            accumulate(total, self.Omega[j].items(), turned.items())
        return total

    def _newest(self, n: int) -> Part:
        """(Omegahat_n q d_q - phat_n) of cos psi."""
        (cosine,), (sine,) = self.X[0].values(), self.Y[0].values()
        shift = n * self.spread // 2
        # The newest rates act on X_0 alone at this order.
        slow = {k: -c * cosine.left_shift(shift) for k, c in self.p[n].items()}
        return summed(slow, {k: c * sine.left_shift(shift) for k, c in self.Omega[n].items()})


def in_eta(member: Member) -> fmpq:
    """What stands before eta^key X^position Y^velocity: the ratio times i^(alpha+1) of a loss or i^q of a spring."""
    turns = member.integer_velocity + (member.sign < 0)
    return -member.ratio if turns % 4 == 2 else member.ratio


def _divided(p: fmpq_poly, h: int) -> fmpq_poly:
    """xhat_m = R_m/(m^2 - 1), without first harmonic."""
    harmonics = ((2 * i - h, c) for i, c in enumerate(p.coeffs()))
    return fmpq_poly([c / (m * m - 1) if m * m != 1 else fmpq(0) for m, c in harmonics])


def _series(parts: list[dict[Key, fmpq]], variables: int, order: int) -> Series:
    return Series({k: c for part in parts for k, c in part.items() if c != 0}, variables, order)
