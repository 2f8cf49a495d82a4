"""One law, first order, any exponent: the averaged law dA/dtau = -kappa A^alpha with A(0) = 1, solved in closed form.

    A(tau) = [1 + (alpha-1) kappa tau]^(-1/(alpha-1)),   tau(A) = (A^(1-alpha) - 1)/((alpha-1) kappa),
    alpha = 1:  A = exp(-kappa tau),                     tau = -ln(A)/kappa          (the limits alpha -> 1)

kappa = M_(alpha+1) epsilon for the mean over a swing (Lancaster 2020, (13)), 2^(-(alpha+1)/2) epsilon for the squaring
trick of Lelas 2024.  With delta = epsilon A^(alpha-1) and w_2 = -Omega_2 = (alpha/(alpha+1))^2 M_(2 alpha), the phase
of the turning-point gauge follows from dphi/dtau = Omega_2 delta^2 and ddelta/dtau = -(alpha-1) p_1 delta^2,

    phi = -(w_2/((alpha-1) p_1)) (epsilon - delta(tau)),        alpha = 1:  phi = -w_2 epsilon^2 tau,

with an error O(epsilon^3), uniform in tau >= 0 for alpha > 1.  There delta -> 0 and the total lag
w_2 epsilon/((alpha-1) p_1) is finite; for alpha <= 1 the lag is not bounded.

For alpha < 1 the averaged amplitude is zero from tau = 1/((1-alpha) kappa) on: the extinction of the *averaged* law
(the motion itself creeps or sticks).  The bracket above is negative there and must not be used.

>>> cubic = averaged_law(Integer(3))
>>> cubic.amplitude, cubic.phase, cubic.total_lag
(1/sqrt(3*epsilon*tau/4 + 1), -15*epsilon/64 + 15*epsilon/(64*(3*epsilon*tau/4 + 1)), 15*epsilon/64)
>>> cubic.physical_amplitude()
x_0/sqrt(3*b*k*t*x_0**2/(4*m**2) + 1)
>>> averaged_law(Integer(0), SQUARING).extinction_time                 # Lelas 2024, below (32)
sqrt(2)/epsilon
"""

from dataclasses import dataclass

from sympy import Expr, Integer, Pow, S, Symbol, exp, latex, log, powsimp, simplify, sqrt, symbols

from asymptotics.errors import InputError, require_choice
from asymptotics.expansions.moments.symbolic import moment, squaring_moment

MEAN = "mean"
SQUARING = "squaring"
AVERAGINGS = (MEAN, SQUARING)
# How a formula looks depends on it, and nothing else: above it the digits of the numbers hide the rest.
_LARGEST_POWER = 50

alpha, epsilon, amplitude_symbol = symbols("alpha epsilon A", positive=True)
tau = Symbol("tau", nonnegative=True)
b, k, m, x_0, t = symbols("b k m x_0 t", positive=True)


def held_power(base: Expr, exponent: Expr) -> Expr:
    """base^exponent, not multiplied out where the numbers in the base would grow to thousands of digits.

    >>> held_power(tau / 2, Integer(-2)), held_power(tau / 100000, Integer(-100000))
    (4/tau**2, (tau/100000)**(-100000))
    """
    return Pow(base, exponent, evaluate=not abs(exponent) > _LARGEST_POWER)


@dataclass(frozen=True)
class AveragedLaw:
    """dA/dtau = -kappa A^alpha with A(0) = 1, for one exponent (a number or a symbol) and one way of averaging.

    Expressions in ``epsilon`` and ``tau``; lengths in units of x0, times in units of 1/omega_0.
    """

    alpha: Expr
    averaging: str = MEAN

    @property
    def p_1(self) -> Expr:
        """kappa/epsilon: M_(alpha+1), or 2^(-(alpha+1)/2) for the squaring trick."""
        return moment(self.alpha + 1) if self.averaging == MEAN else squaring_moment(self.alpha)

    @property
    def w_2(self) -> Expr:
        """-Omega_2 = (alpha/(alpha+1))^2 M_(2 alpha); 0 for the squaring trick, which keeps the phase at its start."""
        if self.averaging == SQUARING:
            return S.Zero
        return (self.alpha / (self.alpha + 1)) ** 2 * moment(2 * self.alpha)

    @property
    def kappa(self) -> Expr:
        """The rate kappa = p_1 epsilon of the envelope."""
        return self.p_1 * epsilon

    @property
    def amplitude(self) -> Expr:
        """A(tau) (Lancaster (13)); for alpha < 1 before ``extinction_time``, from where on the averaged law has 0."""
        if self.alpha == 1:
            return exp(-self.kappa * tau)
        return (1 + (self.alpha - 1) * self.kappa * tau) ** (-1 / (self.alpha - 1))

    @property
    def time(self) -> Expr:
        """tau(A) for 0 < A <= 1, in the symbol ``A``."""
        if self.alpha == 1:
            return -log(amplitude_symbol) / self.kappa
        return (amplitude_symbol ** (1 - self.alpha) - 1) / ((self.alpha - 1) * self.kappa)

    @property
    def delta(self) -> Expr:
        """delta(tau) = epsilon A^(alpha-1) = epsilon/(1 + (alpha-1) kappa tau)."""
        return epsilon / (1 + (self.alpha - 1) * self.kappa * tau)

    @property
    def phase(self) -> Expr:
        """phi(tau), turning-point gauge, phi(0) = 0 (derivation finite-phase-lag)."""
        if self.alpha == 1:
            return -self.w_2 * epsilon**2 * tau
        return -self.w_2 / ((self.alpha - 1) * self.p_1) * (epsilon - self.delta)

    @property
    def total_lag(self) -> Expr:
        """-phi(infinity) = w_2 epsilon/((alpha-1) p_1) for alpha > 1, the same in every gauge; InputError otherwise."""
        # A symbol whose place beside 1 is not known is let through: the formula is the one for alpha > 1.
        if (self.alpha - 1).is_positive is False:
            raise InputError("alpha", f"the lag is not bounded at alpha = {self.alpha}", "alpha > 1")
        return self.w_2 * epsilon / ((self.alpha - 1) * self.p_1)

    @property
    def extinction_time(self) -> Expr | None:
        """1/((1-alpha) kappa) for alpha < 1, where A reaches 0; None for alpha >= 1, where it never does.

        Raises InputError for an exponent whose place relative to 1 is not known.
        """
        below = (1 - self.alpha).is_positive
        if below is None:
            raise InputError("alpha", f"{self.alpha} is not known to lie on one side of 1", "a number")
        return 1 / ((1 - self.alpha) * self.kappa) if below else None

    def to_physical(self, expression: Expr) -> Expr:
        """Replace epsilon by b omega_0^alpha x_0^(alpha-1)/k and tau by omega_0 t, with omega_0 = sqrt(k/m)."""
        omega_0 = sqrt(k / m)
        strength = b * omega_0**self.alpha * x_0 ** (self.alpha - 1) / k
        return expression.subs({epsilon: strength, tau: omega_0 * t}, simultaneous=True)

    def physical_amplitude(self) -> Expr:
        """A(t) in the letters b, k, m, x_0, t: the rows of Lancaster's Table I, for any exponent."""
        if self.alpha == 1:
            return x_0 * exp(-powsimp(simplify(self.to_physical(self.kappa * tau))))
        growth = powsimp(simplify(self.to_physical((self.alpha - 1) * self.kappa * tau)))
        return x_0 * (1 + growth) ** (-1 / (self.alpha - 1))

    def _repr_latex_(self) -> str:
        return rf"$A(\tau) = {latex(self.amplitude)},\quad \varphi(\tau) = {latex(self.phase)}$"


def averaged_law(exponent: Expr | int, averaging: str = MEAN) -> AveragedLaw:
    """The averaged law for a SymPy exponent >= 0, a number or a symbol; ``averaging`` is "mean" or "squaring".

    Raises InputError for a negative or non-real exponent and for an unknown averaging.

    >>> averaged_law(alpha).extinction_time
    Traceback (most recent call last):
        ...
    asymptotics.errors.InputError: argument alpha: alpha is not known to lie on one side of 1 (accepted: a number)
    """
    require_averaging(averaging)
    value = Integer(exponent) if isinstance(exponent, int) else exponent
    if value.is_nonnegative is not True:
        raise InputError("alpha", f"{value} is not certainly >= 0", "alpha >= 0")
    return AveragedLaw(value, averaging)


def require_averaging(averaging: str) -> None:
    """InputError unless ``averaging`` is one of ``AVERAGINGS``."""
    require_choice(averaging, "averaging", AVERAGINGS)
