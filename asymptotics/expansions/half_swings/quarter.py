"""From the quarter-swing to the half-swing: the reversal identity, for any sum of laws and any coefficient ring.

The symmetry t -> -t, epsilon -> -epsilon of a reversible system (Devaney, Trans. Amer. Math. Soc. 218, 1976), used
order by order: no theorem of convergence is needed.

With X = r cos(theta), X' = -r sin(theta), s = sin(theta), c = cos(theta), rho_i = epsilon_i r^(alpha_i - 1), the motion
between two turning points, 0 <= theta <= pi, obeys (derivation ``half-swing-equations``)

    d ln r/d theta = - N s/D,   d tau/d theta = 1/D,   N = sum_i rho_i s^alpha_i,   D = 1 - N c.

The quarter-swing runs from the turning point theta = 0, where rho_i = delta_i, to the equilibrium passage theta = pi/2:

    R(delta) = ln r(pi/2)/r(0),    T_q(delta) = tau(pi/2) - tau(0) = pi/2 + O(delta).

*Reversal identity.*  On the second quarter put theta = pi - phi.  Then s stays, c changes sign, d theta = -d phi, and

    d ln r/d phi = N s/(1 + N cos(phi)):   the first-quarter equation with every rho_i replaced by -rho_i.

It starts at phi = 0 with -rho_i(pi) = -F_i and ends at the same equilibrium passage.  Hence, for all laws together,

    L = ln r(pi)/r(0) = R(delta) - R(-F),   F_i = delta_i exp((alpha_i - 1) L),   T = T_q(delta) + T_q(-F).

R has no constant term, so L is fixed order by order, also at alpha_i = 1 where F_i = delta_i: L is the primary object.

*Springs.*  Losses |x|^m v|v|^(alpha-1) and springs c x|x|^(p-1) |v|^q put rho |c|^m s^alpha and -gamma c|c|^(p-1) s^q
into N.  The reflection turns N into -N with rho -> -rho and the same gamma: S changes the sign of the losses only, and
the identity reads L = R(delta) - R(S F), F_i = delta_i exp((d_i - 1) L), T = T_q(delta) + T_q(S F) (derivation
``reversal-identity``).  The forces enter through the weights d_i - 1 and the signs of ``grading`` alone.

Coulomb friction, alpha = 0: X circles about the shifted centre delta with radius 1 - delta, so |X'|^2 = 1 - 2 delta at
the passage and R = ln(1 - 2 delta)/2.  (Only R is needed for F; any T_q will do in this example.)

>>> from flint import fmpq
>>> d = Series.variable(0, 1, 4, fmpq(1))
>>> coulomb = QuarterSwing(Grading.of((0,)), (1 - 2*d).log() / 2, T_q=d)
>>> half_swing(coulomb).F[0]                                     # delta/(1 - 2 delta): A falls by 2 delta
1*d + 2*d^2 + 4*d^3 + 8*d^4 + O(5)

*Waveform moments.*  The gauges other than the turning-point gauge need means over the waveform.  All of them follow
from one family of integrals over the first quarter, started with X(0) = r(0) = 1 (so epsilon_i = delta_i):

    K_k(delta) = int_0^T_q tau^k e^(-i tau) X d tau
               = int_0^(pi/2) tau^k (cos tau - i sin tau) r cos(theta) (d tau/d theta) d theta,      k = 0, 1, 2, ...

A gauge conversion through order n needs K_k through order n - k for k = 0, ..., n.  ``K[k]`` holds the pair of real
series (Re K_k, Im K_k).  With h = 1 - c both are single classes of exponents at order delta^m:
Re: h^(m alpha/2 + (k-1)/2) (analytic) dh, Im: h^(m alpha/2 + k/2) (analytic) dh.
Two remarks save work: d tau/d theta = 1 - cot(theta) d ln r/d theta = 1 + c d ln r/dc exactly, for any sum of laws; and
the moments of X' follow by parts (X = 0 at the passage): int tau^k e^(-i tau) X' d tau = i K_k - k K_(k-1) - [k = 0].
"""

from dataclasses import dataclass

from asymptotics.expansions.half_swings.grading import Grading
from asymptotics.series import Series, compose_all


@dataclass(frozen=True)
class QuarterSwing:
    """The quarter-swing from a turning point to the equilibrium passage.

    ``grading``: the weights and signs of the strengths; ``R``: ln r(pi/2)/r(0), no constant term; ``T_q``: its
    duration, constant term pi/2;
    ``K``: pairs (Re K_k, Im K_k) of waveform moments, empty if they were not asked for.
    """

    grading: Grading
    R: Series
    T_q: Series
    K: tuple[tuple[Series, Series], ...] = ()

    @property
    def Q(self) -> tuple[Series, ...]:
        """rho_i at the equilibrium passage: Q_i = delta_i exp((alpha_i - 1) R)."""
        return self.grading.strengths(self.R)


@dataclass(frozen=True)
class HalfSwing:
    """From one turning point to the next: L = ln(A_(n+1)/A_n), F_i = delta_i exp((alpha_i - 1) L), duration T."""

    grading: Grading
    L: Series
    F: tuple[Series, ...]
    T: Series

    @property
    def order(self) -> int:
        """The order through which L, F and T are known."""
        return self.L.order


def half_swing(quarter: QuarterSwing) -> HalfSwing:
    """The half-swing by the reversal identity L = R(delta) - R(S F), T = T_q(delta) + T_q(S F).

    L is found by Newton's iteration on G(L) = L - R(delta) + R(S F(L)), whose derivative is
    G' = 1 + (sum_i (d_i - 1) delta_i d_i R)(S F).  As R has no constant term G'' = O(delta), and a step turns an error
    e of L into O(delta e^2): from n right orders to 2 n + 2.  Every step is a ring operation, so balls stay enclosures.
    """
    R, grading = quarter.R.without_constant(), quarter.grading
    weighted = grading.weighted(R)
    L, known = Series({}, R.variables, 0), 0
    while known < R.order:
        known = min(2 * known + 2, R.order)
        L = L.extend(known)
        images = grading.reversed(grading.strengths(L))
        # Both at once: what costs is the monomials in the images.
        there, slope = compose_all((R.truncate(known), weighted.truncate(known)), images)
        L = L - (L - R.truncate(known) + there) * (slope + 1).inverse()
    F = grading.strengths(L)
    T = quarter.T_q + quarter.T_q.compose(grading.reversed(F))
    return HalfSwing(grading, L, F, T)
