"""The notation of a derivation: a title and displayed steps, each checked at the moment it is written down.

What is displayed is what is checked.  SymPy evaluates eagerly, ``diff(x**2, x)`` is ``2*x`` before anybody sees it, so
a side is written with objects that wait: ``Derivative``, ``Integral``, ``Limit``, ``Sum`` of SymPy, and here

    At(f, {x: 2})          f with 2 in the place of x (of any subexpression, all at once)
    Taylor(f, x, 3)        the expansion of f through x^3
    Coefficient(f, x, 3)   the coefficient of x^3 in it
    Solution(l, r, x)      the one x with l = r
    defined("h", body)     a function that prints as h(...) and stands for body(...)
    named("U_1", value)    a number or expression computed elsewhere, under its name

``step`` evaluates both sides and reduces the difference to zero; it refuses two sides that are printed alike.
``asserts`` displays a relation (<, >, !=) as it is written, and evaluates that very relation.

>>> x = sympy.Symbol("x")
>>> d = Derivation("square", "The square of a sum", source="school")
>>> d.step("expand", (x + 1)**2, x**2 + 2*x + 1)
>>> d.step("differentiate", sympy.Derivative((x + 1)**2, x), 2*x + 2)
>>> d.step("a false step", (x + 1)**2, x**2 + 1)
Traceback (most recent call last):
    ...
AssertionError: square, step 3 (a false step): the two sides differ by 2*x
>>> d.step("an empty step", sympy.diff(x**2, x), 2*x)
Traceback (most recent call last):
    ...
AssertionError: square, step 3 (an empty step): both sides are printed as 2*x
>>> print(d.text())
square: The square of a sum
  source: school
  1. expand
       (x + 1)**2 = x**2 + 2*x + 1
  2. differentiate
       Derivative((x + 1)**2, x) = 2*x + 2
"""

from dataclasses import dataclass, field

import sympy

from derivations.waiting import At, Coefficient, Solution, Taylor, defined, exact, named

__all__ = ["At", "Coefficient", "Derivation", "Solution", "Step", "Taylor", "defined", "difference", "named"]


@dataclass(frozen=True)
class Step:
    """One displayed line: ``left = right`` (or the statement ``left`` alone), with the reason in words.

    ``proves`` are the ids of the papers' statements that this line proves, with the lines above it.
    """

    reason: str
    left: sympy.Basic
    right: sympy.Basic | None = None
    proves: tuple[str, ...] = ()

    def latex(self) -> str:
        """The line in LaTeX."""
        return sympy.latex(self.left) + ("" if self.right is None else " = " + sympy.latex(self.right))

    def text(self) -> str:
        """The line in plain text."""
        return str(self.left) + ("" if self.right is None else f" = {self.right}")


def difference(left: sympy.Basic, right: sympy.Basic) -> sympy.Expr:
    """``left - right`` with everything that waits evaluated, reduced as far as SymPy can; 0 if they are equal."""
    remainder = left.doit() - right.doit()
    for reduce in (sympy.expand, sympy.simplify, sympy.expand_func, sympy.gammasimp):
        if remainder != 0:
            remainder = reduce(remainder)
    return remainder


@dataclass
class Derivation:
    """A named chain of checked steps.  ``name`` is the module's name with hyphens."""

    name: str
    title: str
    source: str
    steps: list[Step] = field(default_factory=list)

    def step(self, reason: str, left: sympy.Basic, right: sympy.Basic, proves: tuple[str, ...] = ()) -> None:
        """Display ``left = right``; AssertionError if they are not equal, or printed alike."""
        left, right = exact(left), exact(right)
        if (remainder := difference(left, right)) != 0:
            raise AssertionError(f"{self._where(reason)}: the two sides differ by {remainder}")
        if str(left) == str(right) or sympy.latex(left) == sympy.latex(right):
            raise AssertionError(f"{self._where(reason)}: both sides are printed as {left}")
        self.steps.append(Step(reason, left, right, proves))

    def holds(self, reason: str, truth: bool, shown: sympy.Basic, proves: tuple[str, ...] = ()) -> None:
        """Display ``shown`` after asserting a fact that an exact computation decided."""
        if truth is not True:
            raise AssertionError(f"{self._where(reason)}: not established ({truth!r})")
        self.steps.append(Step(reason, shown, None, proves))

    def asserts(self, reason: str, relation: sympy.core.relational.Relational, proves: tuple[str, ...] = ()) -> None:
        """Display a relation, built with ``evaluate=False``; AssertionError if it is not true as displayed.

        >>> x = sympy.Symbol("x", positive=True)
        >>> d = Derivation("order", "An order", source="school")
        >>> d.asserts("e is less than pi", sympy.Lt(sympy.E, sympy.pi, evaluate=False))
        >>> d.asserts("a square is larger", sympy.Gt(x**2, x, evaluate=False))
        Traceback (most recent call last):
            ...
        AssertionError: order, step 2 (a square is larger): x**2 > x is not established
        >>> d.steps[0].text()
        'E < pi'
        """
        if not isinstance(relation, sympy.core.relational.Relational):
            raise AssertionError(f"{self._where(reason)}: {relation} is no relation that could be displayed")
        left, right = (side.doit() for side in relation.args)
        if relation.func(sympy.simplify(left - right), 0) is not sympy.true:
            raise AssertionError(f"{self._where(reason)}: {relation} is not established")
        self.steps.append(Step(reason, relation, None, proves))

    def _where(self, reason: str) -> str:
        return f"{self.name}, step {len(self.steps) + 1} ({reason})"

    def to_dict(self) -> dict[str, object]:
        """The derivation as the JSON of ``asymptotics derive``."""
        steps = [
            {
                "reason": s.reason,
                "left": str(s.left),
                "right": None if s.right is None else str(s.right),
                "latex": s.latex(),
                "proves": list(s.proves),
            }
            for s in self.steps
        ]
        return {"name": self.name, "title": self.title, "source": self.source, "steps": steps}

    def text(self) -> str:
        """The derivation as plain text."""
        lines = [f"{self.name}: {self.title}", f"  source: {self.source}"]
        for number, step in enumerate(self.steps, 1):
            lines += [f"  {number}. {step.reason}", f"       {step.text()}"]
        return "\n".join(lines)

    def latex(self) -> str:
        """The derivation as a LaTeX section."""
        lines = [rf"\section*{{{self.title}}}", rf"\emph{{{self.source}}}"]
        for step in self.steps:
            lines += [step.reason, rf"\[ {step.latex()} \]"]
        return "\n".join(lines)
