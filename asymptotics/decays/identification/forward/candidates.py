"""Candidate laws: which losses, which springs.

>>> [str(c) for c in default_candidates(with_springs=False)][:6]
['0', '1', '2', '3', '0+1', '0+2']
>>> law = read_candidate("1+1,2:+s3")
>>> law.formula()
"x'' + x + e1 x' + e2 x^2 x' + c3 x^3 = 0"
"""

import re
from dataclasses import dataclass, replace
from itertools import combinations

from asymptotics.decays.identification.forward.coefficients import Element, loss, spring
from asymptotics.decays.identification.forward.swing import MAX_FREE_ALPHA, HalfSwingModel
from asymptotics.errors import InputError
from asymptotics.numbers.context import cached_property
from asymptotics.numbers.exact import ExactReal, parse_real
from asymptotics.numbers.integers import parse_integer
from asymptotics.terms import terms_of

FREE, PENDULUM = "free", "pendulum"
MAX_TERMS = 6
"""With more terms the columns of a fit are parallel within any noise, and its series has too few orders (``swing``)."""
FORMS = (
    "exponents joined by +, as 1+2 or 3/2; free; A,M: for the loss |x|^M v|v|^(A-1); sP for a spring x|x|^(P-1); "
    "pendulum"
)
_SPRINGS: tuple[tuple[int, ...], ...] = ((), (3,), (3, 5))
"""The springs that are tried by themselves: the first odd terms of a symmetric force, which has no others."""


@dataclass(frozen=True)
class Candidate:
    """``losses``: pairs (exponent as text, or "free"; power m of |x|); ``springs``: the powers p of x|x|^(p-1);
    ``pendulum``: sin x stands for x, without a coefficient of its own."""

    losses: tuple[tuple[str, int], ...]
    springs: tuple[int, ...] = ()
    pendulum: bool = False

    @property
    def free(self) -> bool:
        """Whether the exponent is to be found."""
        return self.losses[0][0] == FREE

    @property
    def alphas(self) -> tuple[str, ...]:
        """The losses as text: exponents, A,M for a factor |x|^M."""
        return tuple(a + (f",{m}" if m else "") for a, m in self.losses)

    @cached_property
    def elements(self) -> tuple[Element, ...]:
        """The terms of the forward model, losses first."""
        # The exponent of a free loss is a parameter of the fit; the 1 that stands here is used by nobody.
        losses = [loss(1.0 if a == FREE else _float(parse_real(a, "laws")), m) for a, m in self.losses]
        return (*losses, *(spring(p) for p in self.springs))

    def swing(self, coarse: bool = False) -> HalfSwingModel:
        """The forward model's half-swing."""
        return HalfSwingModel(self.elements, self.free, coarse=coarse)

    def is_within(self, other: "Candidate") -> bool:
        """Whether ``other`` has all these terms and more."""
        # sin x is no sum of springs with coefficients to find: a law with it is within none without it.
        alike = self != other and self.pendulum == other.pendulum
        return alike and set(self.losses) <= set(other.losses) and set(self.springs) <= set(other.springs)

    def formula(self) -> str:
        """The equation with letters for the strengths."""
        terms = [_loss_text(i + 1, a, m) for i, (a, m) in enumerate(self.losses)]
        terms += [f"c{p} x^{p}" if p % 2 else f"c{p} x|x|^{p - 1}" for p in self.springs]
        return f"x'' + {'sin x' if self.pendulum else 'x'} + " + " + ".join(terms) + " = 0"

    def __str__(self) -> str:
        losses = [f"{a}:" if "," in a else a for a in self.alphas]
        return "+".join([*losses, *(f"s{p}" for p in self.springs), *([PENDULUM] if self.pendulum else [])])


def _float(value: ExactReal) -> float:
    # A double is enough: a fit tells no exponent from its neighbour at 1e-16.
    return float(value.ball().mid())


def _loss_text(number: int, alpha: str, m: int) -> str:
    known = {"0": "sgn(x')", "1": "x'", "2": "x'|x'|", "3": "x'^3", FREE: "x'|x'|^(alpha-1)"}
    text = known.get(alpha, f"x'|x'|^({alpha}-1)")
    factor = "" if not m else f"x^{m} " if m % 2 == 0 else f"|x|^{m} " if m > 1 else "|x| "
    return f"e{number} {factor}{text}"


def loss_in_words(alpha: str, m: int = 0) -> str:
    """What a loss is called; ``m``: the power of |x| in it.

    >>> loss_in_words("0"), loss_in_words("1"), loss_in_words("3/2"), loss_in_words("1", 2)
    ('dry friction', 'viscous drag', 'drag in v^(3/2)', 'drag in |x|^2 v')
    """
    words = {"0": "dry friction", "1": "viscous drag", "2": "drag in v^2", "3": "cubic drag"}
    if not m:
        return words.get(alpha, f"drag in v^({alpha})")
    return f"drag in |x|^{m} " + {"0": "sgn v", "1": "v"}.get(alpha, f"v^{alpha}")


def default_candidates(with_springs: bool, angles: bool = False) -> list[Candidate]:
    """Every subset of the exponents 0, 1, 2, 3, and one free exponent; each with the springs x^3 and x^3, x^5 too,
    and for angles each sum as a pendulum."""
    exponents = ("0", "1", "2", "3")
    # From small laws to large ones, which is the order in which they are tried.
    sets = [chosen for size in range(1, 5) for chosen in combinations(exponents, size)] + [(FREE,)]
    springs = _SPRINGS if with_springs else ((),)
    found = [Candidate(tuple((a, 0) for a in chosen), extra) for extra in springs for chosen in sets]
    # The free exponent, which stands last, has no pendulum: its series is interpolated in the amplitude already.
    pendulums = [replace(c, pendulum=True) for c in found[: len(sets) - 1]] if with_springs and angles else []
    return found + pendulums


def read_candidate(text: str) -> Candidate:
    """A candidate from text such as ``1+2``, ``free+s3`` or ``1+1,2:``; InputError for anything else."""
    losses: list[tuple[str, int]] = []
    springs: list[int] = []
    pendulum = False
    for item in terms_of(text, "laws"):
        if re.fullmatch(r"s\d+", item):
            springs.append(parse_integer(item[1:], "laws", 2, 9))
        elif item == PENDULUM:
            pendulum = True
        elif item == FREE:
            losses.append((FREE, 0))
        else:
            losses.append(_read_loss(item))
    if not losses:
        raise InputError("laws", f"{text[:40]!r} has no loss", FORMS)
    # Beside another loss a free exponent is hardly ever determined: the columns of near exponents are nearly parallel.
    if len(losses) > 1 and any(a == FREE for a, _ in losses):
        raise InputError("laws", f"{text[:40]!r} joins a free exponent with others", "free alone, or with springs")
    if len(set(losses)) < len(losses) or len(set(springs)) < len(springs):
        raise InputError("laws", f"{text[:40]!r} names a term twice", FORMS)
    if len(losses) + len(springs) > MAX_TERMS:
        raise InputError("laws", f"{text[:40]!r} has too many terms", f"at most {MAX_TERMS}")
    if pendulum and (springs or any(a == FREE or m for a, m in losses)):
        raise InputError(
            "laws", f"{text[:40]!r} is no pendulum with known exponents", "exponents and pendulum, as 1+2+pendulum"
        )
    return Candidate(tuple(losses), tuple(springs), pendulum)


def read_springs(text: str) -> Candidate:
    """The springs of a text such as ``3+5`` or ``pendulum``, beside a loss that stands for any; InputError names them.

    >>> read_springs("3+5").springs, read_springs("pendulum").pendulum
    ((3, 5), True)
    """
    try:
        words = ["" if item == PENDULUM else "s" for item in terms_of(text, "springs")]
        return read_candidate("+".join(["0", *(w + i for w, i in zip(words, terms_of(text, "springs")))]))
    except InputError as error:
        reason = f"{text[:40]!r} is no spring or sum of springs"
        raise InputError("springs", reason, f"powers from 2 to 9: 3, 3+5; or {PENDULUM}") from error


def _read_loss(item: str) -> tuple[str, int]:
    powers, colon, strength = item.partition(":")
    if strength:
        raise InputError("laws", f"{item[:40]!r} has a strength, which is to be found", f"{powers}: without it")
    alpha_text, comma, power = powers.partition(",")
    alpha = parse_real(alpha_text, "laws")
    # A force with a negative exponent is infinite at rest; beyond 10 a loss is gone after the first swings.
    if alpha < 0 or alpha > 10:
        raise InputError("laws", f"{alpha} is out of range", f"exponents from 0 to 10; free: 0 to {MAX_FREE_ALPHA:g}")
    return str(alpha), parse_integer(power, "laws", 1, 9) if comma else 0
