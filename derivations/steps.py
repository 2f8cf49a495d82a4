"""The notation of a derivation: a title and displayed steps, each checked at the moment it is written down.

What is displayed is what is checked.  SymPy evaluates eagerly, ``diff(x**2, x)`` is ``2*x`` before anybody sees it, so
a side is written with objects that wait: ``Derivative``, ``Integral``, ``Limit``, ``Sum`` of SymPy, and here

    At(f, {x: 2})          f with 2 in the place of x (of any subexpression, all at once)
    Taylor(f, x, 3)        the expansion of f through x^3
    Coefficient(f, x, 3)   the coefficient of x^3 in it
    Solution(l, r, x)      the one x with l = r
    defined("h", body)     a function that prints as h(...) and stands for body(...)
    named("U_1", value)    a number or expression computed elsewhere, under its name

``step`` evaluates both sides and reduces the difference to zero; it refuses two sides that are printed alike, and a
bare name beside its value.  ``asserts`` displays relations (<, >, !=, or several) as they are written and decides those
very relations: nothing can be displayed that was not decided.  No line takes a double.  ``defines`` displays
``name := value``; such a line proves nothing and says so.

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

import sys
from dataclasses import dataclass, field
from importlib import import_module
from typing import Any, SupportsIndex

import sympy

from derivations.document import document
from derivations.relations import difference, established, latex, shown_in_latex, shown_in_text, text
from derivations.waiting import At, Coefficient, Solution, Taylor, defined, exact, is_name, named

__all__ = ["At", "Coefficient", "Derivation", "Solution", "Step", "Taylor", "defined", "difference", "named"]


@dataclass(frozen=True)
class Step:
    """One displayed line: ``left = right``, ``left := right``, or relations alone (``right`` is None).

    ``proves`` are the ids of the papers' statements that this line proves, with the lines above it; ``corrects`` those
    that fail, where this line has what is true instead; ``kind`` is "equality", "relation" or "definition".
    """

    reason: str
    left: sympy.Basic
    right: sympy.Basic | None = None
    proves: tuple[str, ...] = ()
    kind: str = "equality"
    corrects: tuple[str, ...] = ()

    def latex(self) -> str:
        """The line in LaTeX."""
        if self.right is None:
            return shown_in_latex(self.left)
        sign = " := " if self.kind == "definition" else " = "
        return latex(self.left) + sign + latex(self.right)

    def text(self) -> str:
        """The line in plain text."""
        if self.right is None:
            return shown_in_text(self.left)
        return f"{text(self.left)} {':=' if self.kind == 'definition' else '='} {text(self.right)}"


def _of_module(name: str) -> "Derivation":
    found: Derivation = import_module(name).derivation
    return found


@dataclass
class Derivation:
    """A named chain of checked steps.  ``name`` is the module's name with hyphens."""

    name: str
    title: str
    source: str
    steps: list[Step] = field(default_factory=list)

    def __reduce_ex__(self, protocol: SupportsIndex) -> Any:
        # By its name, as a function is: the module proves it again where it is loaded, and a copy is the thing itself.
        module = f"derivations.{self.name.replace('-', '_')}"
        ours = getattr(sys.modules.get(module), "derivation", None) is self
        return (_of_module, (module,)) if ours else super().__reduce_ex__(protocol)

    def step(
        self,
        reason: str,
        left: sympy.Basic,
        right: sympy.Basic,
        proves: tuple[str, ...] = (),
        corrects: tuple[str, ...] = (),
    ) -> None:
        """Display ``left = right``; AssertionError if they are not equal, printed alike, or a name and its value."""
        left, right = exact(left), exact(right)
        if (remainder := difference(left, right)) != 0:
            raise AssertionError(f"{self._where(reason)}: the two sides differ by {remainder}")
        if text(left) == text(right) or latex(left) == latex(right):
            raise AssertionError(f"{self._where(reason)}: both sides are printed as {left}")
        if is_name(left) or is_name(right):
            raise AssertionError(f"{self._where(reason)}: {left} = {right} says what a name stands for: `defines`")
        self.steps.append(Step(reason, left, right, proves, corrects=corrects))

    def defines(self, reason: str, name: str | sympy.Expr, value: sympy.Basic) -> sympy.Expr:
        """Display ``name := value`` and return the name, which stands for the value from here on; it proves nothing.

        >>> x = sympy.Symbol("x")
        >>> d = Derivation("square", "The square of a sum", source="school")
        >>> s = d.defines("let", "s", x + 1)
        >>> d.step("expand", s**2, x**2 + 2*x + 1)
        >>> [(step.kind, step.text()) for step in d.steps]
        [('definition', 's := x + 1'), ('equality', 's**2 = x**2 + 2*x + 1')]
        """
        value = exact(value)
        left = named(name, value) if isinstance(name, str) else name
        if difference(left, value) != 0:
            raise AssertionError(f"{self._where(reason)}: {left} does not stand for {value}")
        self.steps.append(Step(reason, left, value, kind="definition"))
        return left

    def asserts(
        self,
        reason: str,
        *relations: sympy.core.relational.Relational,
        proves: tuple[str, ...] = (),
        corrects: tuple[str, ...] = (),
    ) -> None:
        """Display relations, built with ``evaluate=False``; AssertionError if one is not true as displayed.

        >>> x = sympy.Symbol("x", positive=True)
        >>> d = Derivation("order", "An order", source="school")
        >>> d.asserts("e is less than pi", sympy.Lt(sympy.E, sympy.pi, evaluate=False))
        >>> d.asserts("a square is larger", sympy.Gt(x**2, x, evaluate=False))
        Traceback (most recent call last):
            ...
        AssertionError: order, step 2 (a square is larger): x**2 > x is not established
        >>> d.asserts("a result of a computation", True)
        Traceback (most recent call last):
            ...
        AssertionError: order, step 2 (a result of a computation): True is no relation that could be displayed
        >>> d.steps[0].text()
        'E < pi'
        """
        for relation in relations:
            if not isinstance(relation, sympy.core.relational.Relational):
                raise AssertionError(f"{self._where(reason)}: {relation} is no relation that could be displayed")
            if not established(exact(relation)):
                raise AssertionError(f"{self._where(reason)}: {relation} is not established")
        shown = relations[0] if len(relations) == 1 else sympy.Tuple(*relations)
        self.steps.append(Step(reason, shown, None, proves, "relation", corrects))

    def _where(self, reason: str) -> str:
        return f"{self.name}, step {len(self.steps) + 1} ({reason})"

    def to_dict(self) -> dict[str, object]:
        """The derivation as the JSON of ``asymptotics derive``."""
        steps = [
            {
                "reason": s.reason,
                "kind": s.kind,
                "left": s.text() if s.right is None else text(s.left),
                "right": None if s.right is None else text(s.right),
                "latex": s.latex(),
                "proves": list(s.proves),
                "corrects": list(s.corrects),
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
        """The derivation as a LaTeX document that stands alone."""
        return document([self])
