"""From whatever names a law to its equations: an exponent, a list of them, a law, an oscillator, or "symbolic".

>>> expand(3, order=3, gauge="no-first-harmonic").Omega[2].exact
'9/256'
>>> expand(["1", "2"], order=2).Omega[1, 1].exact
'-8/(9*pi)'
>>> expand("symbolic", order=2).Omega[2].exact
'-alpha**2*gamma(alpha + 1/2)/(sqrt(pi)*(alpha + 1)**2*gamma(alpha + 1))'
>>> expand(1.5) == expand("3/2"), expand(1.5).notes
(True, ('alpha: the float 1.5 was read as 3/2',))
"""

from typing import Any

from asymptotics.errors import InputError, require_flag
from asymptotics.expansions.equations.given import terms_of
from asymptotics.expansions.equations.result import Equations
from asymptotics.expansions.equations.row import CoefficientRow
from asymptotics.expansions.normal_form.coefficients import expansion_coefficients
from asymptotics.expansions.normal_form.results import Coefficients
from asymptotics.gauges import TURNING_POINT, require_gauge
from asymptotics.law import LawLike, SpringLike
from asymptotics.numbers.policy import Number, exact_integer
from asymptotics.running.public import public
from asymptotics.terms import Term

# Refused by size before anything is estimated; what lies below may still be refused by its estimate.
MAX_ORDER, MAX_DIGITS, MAX_TERMS = 200, 1000, 4


@public
def expand(
    law: LawLike, *, order: int = 4, gauge: str = TURNING_POINT, digits: int = 30, spring: SpringLike | None = None,
    exact: bool = False, max_seconds: Number = 60,
) -> Equations:  # fmt: skip
    """The amplitude and phase equations through delta^order, delta = epsilon A^(alpha-1) in units m = k = x0 = 1.

        dA/dtau = -A (p_1 delta + p_2 delta^2 + ...),    dpsi/dtau = 1 + Omega_1 delta + Omega_2 delta^2 + ...

    Source: derivations ``half-swing-equations``, ``no-logarithms``.

    Parameters
    ----------
    law
        an exponent (the coefficients need no strength), a list of exponents, a ``Law`` or mapping exponent -> epsilon,
        an ``Oscillator`` (amplitudes are in m then, times in s), or "symbolic"
    order
        the last power of delta, 1 to 200
    gauge
        what A and psi are: "turning-point", "averaging" or "no-first-harmonic"
    digits
        correctly rounded significant digits of every coefficient
    spring
        springs beside the linear one, {P: c} or {(P, Q): c} for c x|x|^(P-1) |x'|^Q, or "pendulum"
    exact
        demand exact coefficients, which integer exponents have
    max_seconds
        the time the call may take, in s

    Returns
    -------
    Equations
        ``p`` and ``Omega`` by k, ``latex``, ``to_sympy``, ``lambdify``, ``observables``; formal: no bound on the
        remainder

    Raises
    ------
    InputError
        for what is no law, an order out of range, an unknown gauge, and exact coefficients where there are none
    LimitError
        where the estimate is above ``max_seconds``
    UndecidedError
        where balls cannot round a coefficient

    Examples
    --------
    >>> found = expand("3/2", order=2)
    >>> found.p[1].value[:12], found.Omega[2].exact
    ('0.4576558581', '-12/(25*pi)')
    """
    N, D = exact_integer(order, "order", 1, MAX_ORDER), exact_integer(digits, "digits", 1, MAX_DIGITS)
    require_gauge(gauge)
    require_flag(exact, "exact")
    if isinstance(law, str) and law.strip() == "symbolic":
        if exact or spring is not None:
            raise InputError("alpha", "symbolic stands alone", "one law, in closed form")
        return _symbolic(N, gauge, D)
    terms, strengths, oscillator, notes = terms_of(law, spring)
    if len(terms) > MAX_TERMS:
        raise InputError("law", f"{len(terms)} different terms are too many", f"at most {MAX_TERMS}")
    found = expansion_coefficients(terms, N, D, gauge, exact_only=exact)
    return _equations(found, terms, law=strengths, oscillator=oscillator, notes=notes)


def _symbolic(order: int, gauge: str, digits: int) -> Equations:
    # SymPy, which an expansion for numbers does not need.
    from asymptotics.expansions.half_swings.symbolic import alpha  # noqa: PLC0415
    from asymptotics.expansions.normal_form.closed_forms import symbolic_coefficients  # noqa: PLC0415

    return _equations(symbolic_coefficients(order, gauge, digits), (), symbol=alpha)


def _equations(found: Coefficients, terms: tuple[Term, ...], **rest: Any) -> Equations:
    """The one result that every route ends in."""
    p, Omega = (CoefficientRow({_key(k): c for k, c in row.items()}) for row in (found.amplitude, found.frequency))
    return Equations(terms, found.gauge, found.order, found.arithmetic, p, Omega, **rest)


def _key(key: str) -> tuple[int, ...]:
    return tuple(int(k) for k in key.split(","))
