r"""What the letters of the formulas mean: the one list from which every shown formula is completed.

>>> sorted(letters(r"\frac{dA}{d\tau} = -A \left(\delta_{1} x_{n}^{2}\right)"))
['A', '\\delta', '\\tau', 'n', 'x']
>>> defined(r"\sin \psi", {})
'$\\psi$: phase, n pi at the n-th turning point'
"""

import re
from collections.abc import Mapping

MEANINGS = {
    "A": "slow amplitude (the turning amplitude in the turning-point gauge)",
    "A'": "turning amplitude after the half-swing",
    "C": "coefficient",
    "D": "the slow time, 1 at the start",
    "D_n": "derivative with respect to the n-th slow time",
    "F": "fraction of the strength kept by a half-swing",
    "G": "generating function",
    "H": "phase as a function of the local strength",
    "L": "logarithm of the ratio of two turning amplitudes",
    "M": "moment",
    "Q": "quality factor",
    "T": "duration of the half-swing, in units of 1/omega_0",
    "U": "rate of ln A, turning-point gauge",
    "V": "rate of the local strength, turning-point gauge",
    "W": "rate of the time, turning-point gauge",
    "X": "displacement in units of the start",
    "a": "slow amplitude",
    "b": "strength of the damping in N (s/m)^alpha",
    "c": "strength of the spring",
    "d": "differential",
    "e": "base of the natural logarithm",
    "f": "rate of the amplitude at its order",
    "g": "rate of the phase at its order",
    "i": "a number that counts",
    "k": "a number that counts",
    "m": "mass in kg",
    "n": "a number that counts",
    "p": "exponent",
    "q": "exponent",
    "r": "radius of the start",
    "s": "the variable integrated over",
    "t": "time in s",
    "u": "the variable integrated over",
    "v": "velocity",
    "w": "argument",
    "x": "displacement",
    "y": "argument",
    "z": "argument",
    r"\Gamma": "Euler's Gamma function",
    r"\Omega": "frequency series, in units of omega_0",
    r"\Phi": "Abel function of the amplitude",
    r"\alpha": "exponent of the damping",
    r"\chi": "phase within the half-swing",
    r"\delta": "local strength epsilon A^(alpha-1)",
    r"\epsilon": "strength b omega_0^alpha x_0^(alpha-1)/k",
    r"\varepsilon": "strength b omega_0^alpha x_0^(alpha-1)/k",
    r"\eta": "small number",
    r"\gamma": "incomplete gamma function",
    r"\kappa": "M_(alpha+1) epsilon, the rate of the averaged law",
    r"\mu": "strength of the force that keeps the cycle up",
    r"\omega": "frequency; omega_0 = sqrt(k/m)",
    r"\phi": "slow phase psi - tau, 0 at the start at rest",
    r"\varphi": "slow phase psi - tau, 0 at the start at rest",
    r"\psi": "phase, n pi at the n-th turning point",
    r"\sigma": "the slow time in which the local strength is expanded",
    r"\tau": "time omega_0 t",
    r"\theta": "angle, or the Abel function of the time",
}
# Words of text and names of functions, in braces that may hold one more pair, and the arguments of environments.
_WORDS = re.compile(
    r"\\(?:text|mathrm|operatorname|mathit|textbf)\*?\s*\{(?:[^{}]|\{[^{}]*\})*\}"
    r"|\\(?:begin|end)\{[^}]*\}(?:\{[^}]*\})?"
)
# A Greek name, a letter, or a number with its exponent: the e of 1.5e-7 is no letter.
_TOKEN = re.compile(r"\\[A-Za-z]+|[A-Za-z]|\d(?:\.?\d)*e-?\d+")
GREEK = {name for name in MEANINGS if name.startswith("\\")} | {
    r"\beta", r"\zeta", r"\iota", r"\lambda", r"\nu", r"\xi", r"\rho", r"\upsilon", r"\Delta", r"\Lambda", r"\Psi",
    r"\Theta", r"\Sigma", r"\Xi", r"\Pi", r"\Upsilon", r"\vartheta", r"\varrho", r"\ell",
}  # fmt: skip


def letters(formula: str) -> set[str]:
    """The letters of a formula, Latin and Greek, without those of words, functions and numbers; pi is known."""
    tokens = _TOKEN.findall(_WORDS.sub(" ", formula))
    found = {t for t in tokens if (t in GREEK if t.startswith("\\") else len(t) == 1)}
    # A d before another letter, or on top of a fraction, is that of a differential.
    return found - ({"d"} if re.search(r"\\frac\{d|\bd\\?[A-Za-z]", formula) else set())


def defined(formula: str, own: Mapping[str, str]) -> str:
    """The letters of a formula with their meanings, those of the result (``own``) before those of everywhere."""
    known = {**MEANINGS, **own}
    told = (f"${letter}$: {known[letter]}" for letter in sorted(letters(formula)) if letter in known)
    return "; ".join(told)
