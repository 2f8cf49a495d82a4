"""A solution in words and in LaTeX: every letter that is printed is defined in the same output.

>>> from sympy import symbols
>>> x, y = symbols("x y")
>>> rows_of("f", x + y), document("f")[:23]
(['f = x + y'], '\\\\documentclass{article}')
"""

import re
from dataclasses import replace
from typing import Any, NamedTuple

import mpmath
import sympy
from sympy import Add, Eq, Expr, Integer, latex

from asymptotics.numbers.decimal_context import workdps
from asymptotics.present.shown import Page, Shown, fields_of

# Layout alone.  Six terms fill a line of LaTeX in landscape; through order 4 the text of x is short enough to have
# every letter written out, as SymPy prints it.
_TERMS, _PLAIN = 6, 4
_chi = sympy.Symbol("chi", real=True)
A_0 = sympy.Symbol("A_0", positive=True)


class _Numbers(NamedTuple):
    amplitude: str
    phase: str | None
    x: str


class SolutionPoint(Shown, _Numbers):
    """A, phi and x at one time, in decimals; heuristic: the error of the truncation is not in them.

    ``phase``: None where the mass is held or the amplitude has vanished.
    """

    __slots__ = ()

    def _page(self) -> Page:
        page = fields_of(self)
        return replace(page, lines=("estimate: the error of the truncation is not in it",))

    def _formula(self) -> str:
        return rf"A = {self.amplitude},\quad \phi = {self.phase},\quad x = {self.x}"


def rounded_point(size: Any, lag: Any, x: Any, digits: int) -> SolutionPoint:
    """A, phi and x as decimals of so many digits."""
    with workdps(digits + 15):
        return SolutionPoint(*(mpmath.nstr(v, digits, strip_zeros=False) if v else "0" for v in (size, lag, x)))


def text_of(s: Any) -> str:
    """The formulas of a ``Solution`` as text."""
    leading, slow, relative, slow_phase, start = _slow_part(s)
    power = {Integer(1): "x'", Integer(2): "x'|x'|"}.get(s.alpha, f"x'|x'|^({s.alpha} - 1)")
    place = f"x(0) = {-1 if s.mirrored else 1}, x'(0) = 0" if s.start is None else "x(0)**2 + x'(0)**2 = 1"
    lines = [f"x'' + x + epsilon {power} = 0, {place}: through order {s.order}, turning-point gauge"]
    lines += [f"{e.lhs!s:7} = {e.rhs}" for e in start]
    lines += [] if s.alpha == 1 else [f"D       = {slow}"]
    lines += [f"A_0     = {leading}", f"A       = {relative}", f"phi     = {slow_phase}"]
    waves = "".join(f" + delta{f'**{n}' if n > 1 else ''}*x_{n}(psi)" for n in range(1, s.order))
    # The waveforms are told on one half-swing; the last line of the formulas continues them.
    where = f"psi = tau + phi, delta = {s.local_strength}, on 0 < psi < pi"
    lines.append(f"x       = A*(cos(psi){waves}), {where}")
    lines += [f"x_{n}     = {wave}" for n, wave in enumerate(s.shown_waves(), start=1)]
    lines += [f"{e.lhs} = {e.rhs}" for e in s.definitions()]
    lines.append("X(psi + pi) = -X(psi)")
    lines += [] if s.oscillator is None else [f"epsilon = {s.strength}"]
    end = s.valid_until
    limit = "for every tau >= 0 (alpha >= 1)" if end == sympy.oo else f"while tau < {end}"
    # Of a symbolic exponent: the end exists for alpha < 1 alone, and is the first branch.
    if isinstance(end, sympy.Piecewise):
        limit = f"for every tau >= 0 where alpha >= 1, else while tau < {end.args[0][0]}"
    lines += [f"valid   {limit}", f"error   O(epsilon**{s.order}) at fixed epsilon*tau; not certified"]
    return "\n".join([*lines, *proved_lines(s)])


def x_by_name(s: Any) -> dict[str, str]:
    """x as SymPy text in the letters A, psi, delta, chi, and what these are: short where ``text_of_x`` is long."""
    return {
        "x": f"(-1)**floor(psi/pi)*A*({s.shape(_chi)})",
        "chi": "psi - pi*floor(psi/pi)",
        "psi": f"tau + {s.phase}",
        "delta": str(s.local_strength),
        "A": str(s.amplitude),
    }


def text_of_x(s: Any) -> str:
    """x as SymPy text in tau and epsilon, letter by letter: SymPy takes seconds to write out so long an expression.

    Beyond order ``_PLAIN`` A and psi, which occur hundreds of times, are bound by a Lambda, which SymPy applies as it
    reads the text: 31 kB in place of 5 MB at order 12 of alpha = 2.
    """
    found = x_by_name(s)
    text, A, turned = found.pop("x"), found.pop("A"), found.pop("psi")
    text = _replaced(text, {"delta": found["delta"]})
    if s.order > _PLAIN:
        return f"Lambda((A, psi), Lambda(chi, {text})({found['chi']}))({A}, {turned})"
    for letter, value in (("chi", found["chi"]), ("psi", turned), ("A", A)):
        text = _replaced(text, {letter: value})
    return text


def _replaced(text: str, values: dict[str, str]) -> str:
    for letter, value in values.items():
        # Whole words, since A stands in other names.  A value may hold letters that are replaced after it: delta has A,
        # chi has psi.
        text = re.sub(rf"\b{letter}\b", f"({value})", text)
    return text


def proved_lines(s: Any) -> list[str]:
    """What is proved of the error, where a strength is given."""
    if s.oscillator is None:
        return []
    found = s.validity
    if found["valid_label"] != "proved":
        return [f"proved  nothing for all times: {found['not_proved']}"]
    end = "every tau >= 0" if found["valid_until"] == "oo" else f"0 <= tau <= {found['valid_until']}"
    unit = "x_0 = 1" if s.start is None else "x(0)**2 + x'(0)**2 = 1"
    return [f"proved  |x - x_{s.order}| <= {found['valid_within']} for {end} ({unit}, before rounding)"]


def _slow_part(s: Any) -> tuple[Expr, Expr, Expr, Expr, list[Eq]]:
    """A_0, D, A and phi as they are shown, and what a start in motion puts before them: a_0, phi_0, epsilon_0."""
    found = (*s.leading, A_0 * s.relative, s.slow_phase)
    if s.start is None:
        return *found[:-1], s.first_phase + s.slow_phase, []
    leading, slow, relative, slow_phase = (s.with_start_strength(e) for e in found)
    a_0 = next(iter(s.letters))
    # Unevaluated: SymPy would decide at once that two expressions are equal or not, and print True.
    begin = [Eq(letter, value, evaluate=False) for letter, value in s.letters.items()]
    return leading, slow, a_0 * relative, s.first_phase + slow_phase, begin


def latex_lines(s: Any) -> list[str]:
    """The formulas of a ``Solution`` as displayed lines of LaTeX."""
    leading, slow, relative, slow_phase, start = _slow_part(s)
    force = r"\dot x" if s.alpha == 1 else rf"\dot x|\dot x|^{{{latex(s.alpha - 1)}}}"
    place = rf"x(0) = {-1 if s.mirrored else 1},\quad \dot x(0) = 0" if s.start is None else r"x(0)^2 + \dot x(0)^2 = 1"
    lines = [rf"\ddot x + x + \epsilon\,{force} = 0,\quad {place}"]
    for e in start:
        lines += rows_of(latex(e.lhs), e.rhs)
    lines += [] if s.alpha == 1 else [rf"D = {latex(slow)}"]
    lines += [rf"A_{{0}} = {latex(leading)}", *rows_of(r"A/A_{0}", sympy.expand(relative / A_0))]
    lines += rows_of(r"\phi", sympy.expand(slow_phase))
    waves = "".join(rf" + \delta^{{{n}}} x_{{{n}}}(\psi)" for n in range(1, s.order))
    lines.append(rf"x = A\Bigl(\cos\psi{waves}\Bigr),\quad \psi = \tau + \phi,\quad \delta = {latex(s.local_strength)}")
    for n, wave in enumerate(s.shown_waves(), start=1):
        lines += rows_of(f"x_{{{n}}}", wave)
    for e in s.definitions():
        lines += rows_of(latex(e.lhs), e.rhs)
    return [*lines, r"0 < \psi < \pi,\quad X(\psi + \pi) = -X(\psi)"]


def rows_of(name: str, expression: Expr) -> list[str]:
    """name = sum, broken into lines of a few terms so that it fits on a page."""
    parts = Add.make_args(expression)
    pieces = [latex(Add(*parts[i : i + _TERMS])) for i in range(0, len(parts), _TERMS)]
    if len(pieces) == 1:
        return [f"{name} = {pieces[0]}"]
    joined = r" \\ &\quad {} + ".join(pieces)
    return [rf"\begin{{aligned}} {name} &= {joined} \end{{aligned}}"]


def document(body: str) -> str:
    """A LaTeX document that compiles by itself."""
    head = "\\documentclass{article}\n\\usepackage{amsmath,amssymb}\n\\usepackage[margin=1.5cm,landscape]{geometry}\n"
    return f"{head}\\allowdisplaybreaks\n\\begin{{document}}\n{body}\n\\end{{document}}\n"
