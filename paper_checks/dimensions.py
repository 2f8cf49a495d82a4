"""The dimension of a form: what is dimensionally false is no form of a statement, whatever units its check is made in.

A dimension is the powers of mass, length and time.  Sums are of one dimension, exponents and arguments of functions of
none.  The strength b of b |v|^alpha has M L^(1-alpha) T^(alpha-2): where a form has no letter alpha, the exponents are
those at which the statement's own form is of one dimension.

>>> import sympy
>>> x, b, m = sympy.symbols("x_0 b m", positive=True)
>>> dimension(m * x**2, LETTERS["lelas2024"]), dimension(b * sympy.exp(x), LETTERS["lelas2024"])
((1, 2, 0), None)
>>> [dimensionally_false("lelas2024:21", form, 2 * b) for form in (b, b * m, sympy.sqrt(b), b + x)]
[False, True, True, True]
"""

from collections.abc import Iterable, Iterator, Mapping
from functools import cache, lru_cache
from itertools import product
from typing import Any

import sympy
from sympy.core.function import AppliedUndef

Dimension = tuple[sympy.Expr, ...]
NONE: Dimension = (sympy.S.Zero,) * 3
ALPHA, ALPHA_2 = sympy.symbols("alpha alpha'", nonnegative=True)
EXPONENTS = (ALPHA, *map(sympy.Rational, (0, 1, 2, 3)), sympy.Rational(3, 2))


class UnknownError(Exception):
    """Whether the form is of one dimension is not known: a letter or an object without a dimension."""


class FalseError(Exception):
    """The form is of no dimension: a sum of two, or a function of what is no number."""


def _letters(**groups: str) -> dict[str, Dimension]:
    """Letters by their dimension: the powers of mass, length and time."""
    known = {"number": (0, 0, 0), "mass": (1, 0, 0), "length": (0, 1, 0), "time": (0, 0, 1)}
    known |= {"rate": (0, 0, -1), "speed": (0, 1, -1), "acceleration": (0, 1, -2), "force": (1, 1, -2)}
    known |= {"stiffness": (1, 0, -2), "energy": (1, 2, -2), "drag": (1, 0, -1), "density": (1, -1, 0)}
    known |= {"wavenumber": (0, -1, 0), "slowness": (0, -1, 1), "square": (0, 2, -2)}
    return {letter: tuple(map(sympy.Integer, known[group])) for group in groups for letter in groups[group].split()}


LETTERS: dict[str, dict[str, Dimension]] = {
    "lancaster2020": _letters(
        number="E K T X alpha alpha' p q rho s theta w pi", mass="m", length="A a a_0 x x_0", time="t",
        rate="omega omega_0 gamma", speed="v v_0 r", acceleration="g", force="f", stiffness="k",
    ) | {"c": (sympy.S.One, sympy.S.Zero, sympy.Integer(-3)), "c'": (sympy.S.One, -sympy.S.One, sympy.Integer(-3))},
    "lelas2024": _letters(
        number="eps f mu n phi_0 s sigma sine tau", mass="m", length="A_0 B_0 x x_0", time="t",
        rate="fdot omega_0 omega_d",
        speed="v v_0 V", acceleration="g", force="F_d", stiffness="k", drag="b", density="C",
    ),
    "smith2012": _letters(
        number="S_1 S_2n S_2n+1 S_plus T g_0 i k m n u u_0 u_1 u_2 w z f df mu", mass="M", length="x dx q1 q2 q3",
        time="t dxdv", rate="omega omega_0 k0", speed="v v1 v2 v3 dv xdot qdot1 qdot2 qdot3", acceleration="a a1 a2 a3",
        force="F", energy="S phi", drag="f_v", stiffness="f_x", wavenumber="gamma k1 k2 k3", slowness="k4 k5 k6",
        square="E",
    ),
}  # fmt: skip
VISCOUS = _letters(rate="gamma")  # section 2 of Smith: the damping is linear
FORCE = _letters(force="f")  # f(x, v) of sections 1 and 2; a polynomial f_n later
OWN = {"smith2012:claim.integrating-factor-exists": _letters(rate="k")}
OWN |= {"smith2012:32": VISCOUS, "smith2012:33": VISCOUS, "smith2012:34": VISCOUS} | dict.fromkeys(
    (f"smith2012:{number}" for number in (9, 11, 12, 13)), FORCE
)
UNITS = {
    paper: tuple(sympy.Symbol(name, positive=True) for name in names.split())
    for paper, names in {"lancaster2020": "m k omega_0 x_0 b", "lelas2024": "m k omega_0 x_0 g",
                         "smith2012": "M omega gamma x v"}.items()
}  # fmt: skip
"""What a mutant multiplies a form by."""


def dimension(form: sympy.Basic, letters: Mapping[str, Dimension]) -> Dimension | None:
    """The dimension of an expression; None if it has none, UnknownError if that cannot be told."""
    try:
        return _dimension(form, letters)
    except FalseError:
        return None


def _dimension(form: sympy.Basic, letters: Mapping[str, Dimension]) -> Dimension:
    if form.is_number:
        return NONE
    if isinstance(form, sympy.Symbol):
        return _of(str(form), letters)
    if isinstance(form, AppliedUndef):
        return _of(str(form.func), letters)
    if isinstance(form, sympy.Derivative):
        taken = _sum((_times(_dimension(x, letters), n) for x, n in form.variable_count))
        return _sum((_dimension(form.expr, letters), _times(taken, -sympy.S.One)))
    if isinstance(form, sympy.Add | sympy.Max | sympy.Min):
        return _one(_dimension(part, letters) for part in form.args if part != 0)
    if isinstance(form, sympy.Mul):
        return _sum(_dimension(part, letters) for part in form.args)
    if isinstance(form, sympy.Pow):
        _must_be_number(form.exp, letters)
        return _times(_dimension(form.base, letters), _exponent(form.exp))
    if isinstance(form, sympy.Abs):
        return _dimension(form.args[0], letters)
    if isinstance(form, sympy.sign):
        _dimension(form.args[0], letters)
        return NONE
    if isinstance(form, sympy.Function):
        for part in form.args:
            _must_be_number(part, letters)
        return NONE
    raise UnknownError(form)


def _exponent(form: sympy.Expr) -> sympy.Expr:
    """An exponent with the alpha of this module, whatever the statement assumes of its own."""
    names = {"alpha": ALPHA, "alpha'": ALPHA_2}
    return form.xreplace({s: names[str(s)] for s in form.free_symbols if str(s) in names})


def _of(name: str, letters: Mapping[str, Dimension]) -> Dimension:
    if name not in letters:
        raise UnknownError(name)
    return letters[name]


def _must_be_number(form: sympy.Basic, letters: Mapping[str, Dimension]) -> None:
    if _dimension(form, letters) != NONE:
        raise FalseError(form)


def _one(found: Iterable[Dimension]) -> Dimension:
    different = set(found)
    if len(different) > 1:
        raise FalseError(different)
    return different.pop() if different else NONE


def _sum(found: Iterable[Dimension]) -> Dimension:
    return tuple(sympy.expand(sympy.Add(*powers)) for powers in zip(*found)) or NONE


def _times(found: Dimension, power: sympy.Expr) -> Dimension:
    return tuple(sympy.expand(power * part) for part in found)


def dimensionally_false(key: str, form: Any, model: Any) -> bool:
    """Whether a part of the form has no dimension, or another than that part of the statement's true form has."""
    return any(_another(key, part, true) for part, true in _pairs(form, model))


def _pairs(form: Any, model: Any) -> Iterator[tuple[Any, Any]]:
    """The expressions of a form with those in the same places of the model."""
    if isinstance(form, tuple) and isinstance(model, tuple):
        for part, other in zip(form, model):
            yield from _pairs(part, other)
    else:
        yield form, model


def _another(key: str, form: Any, model: Any) -> bool:
    """Whether there is an exponent at which the model has a dimension, and none at which the form has the same."""
    numbers = (isinstance(part, sympy.Expr | int) and not isinstance(part, bool) for part in (form, model))
    if not all(numbers) or 0 in (form, model):
        return False
    true = _dimensions(key, sympy.S.Zero + model)
    mine = _dimensions(key, sympy.S.Zero + form)
    pairs = [(a, b) for a, b in zip(mine, true) if isinstance(b, tuple)]
    return len(pairs) > 0 and not any(a == "unknown" or a == b for a, b in pairs)


@lru_cache(2000)
def _dimensions(key: str, form: sympy.Expr) -> tuple[Dimension | str | None, ...]:
    """The dimension of a form in each of the systems; "unknown" where a letter has none."""
    letters = _systems(key) if any(str(s) in ("b", "b'") for s in form.free_symbols) else _systems(key)[:1]
    found = [_told(form, system) for system in letters]
    return tuple(found * (len(_systems(key)) // len(found)))


def _told(form: sympy.Expr, letters: Mapping[str, Dimension]) -> Dimension | str | None:
    try:
        return dimension(form, letters)
    except UnknownError:
        return "unknown"


@cache
def _systems(key: str) -> tuple[dict[str, Dimension], ...]:
    """The letters of a statement, once for each pair of exponents of its two laws."""
    letters = LETTERS[key.partition(":")[0]] | OWN.get(key, {})
    if not key.startswith("lancaster2020"):
        return (letters,)
    pairs = product(EXPONENTS, (ALPHA_2, *EXPONENTS[1:]))
    return tuple(letters | {"b": _strength(first), "b'": _strength(second)} for first, second in pairs)


def _strength(alpha: sympy.Expr) -> Dimension:
    return sympy.S.One, 1 - alpha, alpha - 2
