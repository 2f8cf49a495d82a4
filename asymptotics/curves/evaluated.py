"""A ``Solution`` in numbers: NumPy functions in doubles, and mpmath at any precision; nothing here is certified.

Polynomial and closed waveforms are evaluated as they stand; open integrals come from the table of ``waves`` (doubles)
and from its balls (mpmath), the rates without a closed form from the certified half-swing at the precision asked for.

>>> from asymptotics.curves.solve import solution
>>> found = solution({"3/2": "1/10"}, order=4)
>>> [x[:25] for x in (found.at(7, digits=20).x, found.at(7, digits=60).x)]
['0.58239487308158191715', '0.58239487308158191714515']
"""

from collections.abc import Callable
from functools import partial
from typing import Any

import mpmath
import numpy as np
import sympy
from flint import arb
from sympy import Expr, Symbol

from asymptotics.envelopes.slow_time import end_of_amplitude, epsilon
from asymptotics.errors import InputError, LimitError
from asymptotics.law import Oscillator
from asymptotics.numbers.arrays import real_array
from asymptotics.numbers.bridge import to_sympy
from asymptotics.numbers.context import ctx
from asymptotics.numbers.decimal_context import workdps
from asymptotics.numbers.decimals import bits_for, certified_decimal
from asymptotics.numbers.exact import ExactReal

Function = Callable[..., Any]
delta = Symbol("delta", positive=True)
tau = Symbol("tau", nonnegative=True)
chi = Symbol("chi", real=True)
# 16384 times in a piece are 128 KB in each array of doubles: a matter of speed alone.  64 bits beyond the digits are
# room for what cancels in a waveform; no claim rests on them.  Turns of 2000 decimals are a matter of time alone.
_CHUNK, _GUARD, _MOST_TURNS = 1 << 14, 64, 2000


def functions(s: Any, strength: Any) -> tuple[Function, Function, Function]:
    """(A, phi, x) as functions of arrays tau and epsilon, or of tau alone with a ``strength``."""
    # Twenty digits, since a double holds 17: rates that are decimals must not be what limits an array.
    s = s.refined(20).formulas
    names, shape, begun = [tau, epsilon, *s.letters], _shape(s), _letters(s)
    amplitude, phase = (sympy.lambdify(names, e, "numpy", cse=True) for e in (s.amplitude, s.phase))
    end = np.vectorize(end_of_amplitude(s.relative, s.alpha, s.p_1), otypes=[float])

    def both(times: Any, eps: Any) -> tuple[Any, Any]:
        times, eps = real_array(times, "tau"), real_array(eps, "epsilon")
        values = begun(eps)
        # From there on A is 0 and phi NaN; the formulas are taken at the start.
        gone = times >= end(values[-1] if values else eps)
        times = np.where(gone, 0.0, times)
        # A formula without tau (phi = 0, say) is one number to NumPy: adding 0 times gives it the shape, and keeps NaN.
        # At a time whose powers leave the doubles what is left out is as far gone as the decay itself.
        with np.errstate(over="ignore"):
            A, phi = (f(times, eps, *values) + 0.0 * times for f in (amplitude, phase))
        return np.where(gone, 0.0, A), np.where(gone, np.nan, phi)

    def x(times: Any, eps: Any) -> Any:
        size, lag = both(times, eps)
        turned, gone = real_array(times, "tau") + lag, size == 0
        size, turned = np.where(gone, 1.0, size), np.where(gone, 0.0, turned)
        # The half-swing and the phase within it, as in ``Solution.x``: (-1)^swings without a power of a negative base.
        swings = np.floor(turned / np.pi)
        sign = 1.0 - 2.0 * np.mod(swings, 2.0)
        local = eps * size ** (float(s.alpha) - 1.0)
        return np.where(gone, 0.0, sign * size * shape(turned - np.pi * swings, local))

    found = (lambda t, e: both(t, e)[0], lambda t, e: both(t, e)[1], _in_chunks(x))
    if strength is None:
        return found
    A, phi, x_of = (partial(_at, f, float(strength)) for f in found)
    return A, phi, x_of


def _letters(s: Any) -> Function:
    """The values of ``letters`` at a strength: a_0 and phi_0, and epsilon_0 = epsilon a_0^(alpha-1)."""
    if s.start is None:
        return lambda _: ()
    first = sympy.lambdify([epsilon], list(s.start), "numpy", cse=True)

    def values(eps: Any) -> tuple[Any, Any, Any]:
        size, turn = first(eps)
        return size, turn, eps * size ** (float(s.alpha) - 1.0)

    return values


def _shape(s: Any) -> Function:
    """cos psi + sum delta^k x_k(psi) in doubles, 0 <= psi <= pi: polynomials, or a table of the open integrals."""
    # Closed waveforms of other exponents hold hypergeometric functions, which NumPy does not have: the table has them.
    if s.has_formulas:
        return sympy.lambdify([chi, delta], s.shape(chi), "numpy", cse=True)  # type: ignore[no-any-return]
    waves = s.waveforms

    def shape(psi: Any, local: Any) -> Any:
        rows, c, sine = waves.table.at(psi), np.cos(psi), np.sin(psi)
        total = c.copy()
        for (n,), P, Q in zip(waves.table.keys, rows[::2], rows[1::2]):
            # X - i X' = A e^(i psi) (P + i Q): its real part.
            total += local**n * (c * P - sine * Q)
        return total

    return shape


def numbers(s: Any, number: Expr, digits: int) -> tuple[Any, Any, Any]:
    """A, phi and x at tau = ``number`` as mpmath numbers of about that many digits."""
    s = s.formulas
    # Beyond the end the root of a negative number would give complex digits without a word.
    rough = _values(s, number, 45)
    if s.alpha < 1:
        made = s.refined(20)
        end = end_of_amplitude(made.relative, s.alpha, s.p_1)(float(s.with_start_strength(epsilon).subs(rough)))
        if not number < end:
            raise InputError("time", f"A has vanished at tau = {end:.6g}", "an earlier time")
    # Fifteen decimals more than are shown, for what cancels in A, phi and the waveform, and those that the turns of the
    # phase take; not proved to suffice, and ``certified`` is False.
    turns = digits_of_turns(number, s.phase.subs(rough))
    made, dps = s.refined(digits + turns), digits + turns + 15
    value = _values(made, number, dps)
    with workdps(dps):
        size, lag = (mpmath.mpf(sympy.N(e.subs(value), dps)) for e in (made.amplitude, made.phase))
        turned = mpmath.mpf(sympy.N(number, dps)) + lag
        swings = mpmath.floor(turned / mpmath.pi)
        psi = turned - swings * mpmath.pi
        local = mpmath.mpf(sympy.N(value[epsilon], dps)) * size ** mpmath.mpf(sympy.N(made.alpha - 1, dps))
        side = 1 - 2 * (int(swings) % 2)  # a power of -1 would pass through a double
        if made.is_closed:
            return size, lag, side * size * sympy.lambdify([chi, delta], made.shape(chi), "mpmath")(psi, local)
        shape = mpmath.cos(psi) + sum(local**n * x for n, x in _open_waves(made, psi, digits).items())
        return size, lag, side * size * shape


def _values(s: Any, number: Expr, dps: int) -> dict[Any, Any]:
    """The values of tau, epsilon and the letters of the start."""
    value: dict[Any, Any] = {tau: number, epsilon: strength_of(s._given(), dps)}
    for letter, e in s.letters.items():
        # In their order: epsilon_0 is a formula in a_0, which has its value by then.
        value[letter] = sympy.N(e.subs(value), dps)
    return value


def strength_of(oscillator: Oscillator, digits: int) -> Expr:
    """The dimensionless strength of the one law: exact, or with that many digits where it is a product of roots."""
    (term,) = oscillator.dimensionless.terms
    return strength_of_term(term, digits)


def strength_of_term(term: Any, digits: int) -> Expr:
    """The same of one term without units."""
    # A product of several roots (mass, stiffness and x0 to fractional powers) is no one exact number here.
    if isinstance(term.strength, ExactReal):
        return to_sympy(term.strength)
    return sympy.Float(certified_decimal(term.strength.ball, digits), digits)


def digits_of_turns(*sizes: Any) -> int:
    """The decimals in front of the point of a phase that is the sum of these; LimitError for very many."""
    # What is left of a phase without its turns stands behind the point.  Three bits are less than a decimal.
    values = (mpmath.mpf(sympy.N(x, 15)) for x in sizes)
    found = max(int(mpmath.mag(x)) // 3 + 1 if x else 0 for x in values)
    if found > _MOST_TURNS:
        raise LimitError("time", "the phase has too many turns", f"at most 1e{_MOST_TURNS // 2}")
    return max(0, found)


def _open_waves(s: Any, psi: Any, digits: int) -> dict[int, Any]:
    """x_n at a phase, from the middle of balls."""
    with ctx.workprec(bits_for(digits, _GUARD)):
        # Of the balls only the middle is used: the phase itself is an approximation, so that an enclosure of x_n there
        # would enclose nothing of interest.
        found = s.waveforms.enclosed(arb(mpmath.nstr(psi, digits + 15)).mid())
        return {n: mpmath.mpf(x.mid().str(digits + 15, radius=False)) for (n,), x in found.items()}


def _at(f: Function, strength: float, times: Any) -> Any:
    return f(times, strength)


def _one(strength: Any) -> float:
    """One strength for all times."""
    found = real_array(strength, "epsilon")
    if found.ndim:
        raise InputError("epsilon", f"an array of shape {found.shape} is no strength", "one number")
    return float(found)


def _in_chunks(f: Function) -> Function:
    """The same function, evaluated in pieces that stay in the cache of the processor."""

    def chunked(times: Any, *rest: Any) -> Any:
        flat = real_array(times, "tau")
        rest = tuple(_one(value) for value in rest)
        found = np.empty(flat.size)
        for i in range(0, flat.size, _CHUNK):
            found[i : i + _CHUNK] = f(flat.ravel()[i : i + _CHUNK], *rest)
        return found.reshape(flat.shape)

    return chunked
