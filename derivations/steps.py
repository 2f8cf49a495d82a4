"""The notation of a derivation: a title and displayed steps, each checked at the moment it is written down.

>>> import sympy
>>> x = sympy.Symbol("x")
>>> d = Derivation("square", "The square of a sum", source="school")
>>> d.step("expand", (x + 1)**2, x**2 + 2*x + 1)
>>> d.step("a false step", (x + 1)**2, x**2 + 1)
Traceback (most recent call last):
    ...
AssertionError: square, step 2 (a false step): the two sides differ by 2*x
>>> print(d.text())
square: The square of a sum
  source: school
  1. expand
       (x + 1)**2 = x**2 + 2*x + 1
"""

from dataclasses import dataclass, field

import sympy


@dataclass(frozen=True)
class Step:
    """One displayed line: ``left = right`` (or the statement ``left`` alone), with the reason in words."""

    reason: str
    left: sympy.Basic
    right: sympy.Basic | None = None

    def latex(self) -> str:
        """The line in LaTeX."""
        return sympy.latex(self.left) + ("" if self.right is None else " = " + sympy.latex(self.right))

    def text(self) -> str:
        """The line in plain text."""
        return str(self.left) + ("" if self.right is None else f" = {self.right}")


@dataclass
class Derivation:
    """A named chain of checked steps.  ``name`` is the module's name with hyphens."""

    name: str
    title: str
    source: str
    steps: list[Step] = field(default_factory=list)

    def step(self, reason: str, left: sympy.Basic, right: sympy.Basic) -> None:
        """Display ``left = right`` after reducing the difference to zero; AssertionError if it is not."""
        difference = sympy.expand(left - right)
        if difference != 0:
            difference = sympy.simplify(difference)
        if difference != 0:
            raise AssertionError(f"{self._where(reason)}: the two sides differ by {difference}")
        self.steps.append(Step(reason, left, right))

    def holds(self, reason: str, truth: bool, shown: sympy.Basic) -> None:
        """Display ``shown`` after asserting a fact that an exact computation decided."""
        if truth is not True:
            raise AssertionError(f"{self._where(reason)}: not established ({truth!r})")
        self.steps.append(Step(reason, shown))

    def _where(self, reason: str) -> str:
        return f"{self.name}, step {len(self.steps) + 1} ({reason})"

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
