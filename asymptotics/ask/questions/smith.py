"""Smith's coefficients C_i^n, polynomials f_n and generating functions G_i, exactly."""

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from fractions import Fraction
from importlib import import_module
from math import log2
from typing import Annotated, Any

from asymptotics.ask.answers import Again, Offers, Request
from asymptotics.ask.kinds import REAL, SECONDS, choice, digits, whole
from asymptotics.ask.pairs import Pair, demands, needs
from asymptotics.ask.question import question
from asymptotics.costs import binomial_seconds, require_affordable
from asymptotics.errors import InputError, LimitError
from asymptotics.motions.invariants.exact import coefficient, coefficients
from asymptotics.numbers.policy import Number
from asymptotics.numbers.rationals import to_fmpq
from asymptotics.present.inputs import csv_text
from asymptotics.running.budget import Unasked

# Limits of what is printed; one coefficient alone goes further than a row, since only a line of integers is carried.
MAX_ROW, MAX_N, MAX_G = 5_000, 100_000, 100
MAX_DIGITS = 1000
# The work and the memory of one coefficient, estimated from n and i before it begins: refusals, no digits.
MAX_SECONDS, MAX_BYTES = Unasked(120), 1 << 30
_USERS = {
    "n": ("f", "c"),
    "i": ("c", "g"),
    "w": ("r", "s", "t"),
    "u": ("s", "t"),
    "tau": ("t",),
    "digits": ("r", "s", "t"),
}


_NEEDED = {  # what a word needs, and what that is
    "n": {"f": f"an integer from 1 to {MAX_ROW}", "c": f"an integer from 1 to {MAX_N}"},
    "i": {"c": "an integer from 0 to n - 1", "g": f"an integer from 0 to {MAX_G}"},
    "w": dict.fromkeys("rst", "a real number"),
    "u": dict.fromkeys("st", "a real number"),
}


def _pairs() -> Iterator[Pair]:
    """What each word needs, and that it is given nothing else."""
    for name, users in _USERS.items():
        yield from (demands(f"what={what}", name, accepted) for what, accepted in _NEEDED.get(name, {}).items())
        yield needs(name, f"what={'|'.join(users)}", "smith {value} does not use it", f"with {' and '.join(users)}")
    yield needs("csv", "what=f|c", "smith {value} is not a row of coefficients", "--csv with f or c")


@dataclass(frozen=True)
class SmithAnswer:
    """What was asked of Smith's machinery: JSON, text, LaTeX, and the rows (n, i, C_i^n) of coefficients."""

    data: dict[str, Any]
    text: str
    latex: str
    rows: tuple[tuple[int, int, str], ...] = ()


def _data(found: SmithAnswer, request: Request) -> dict[str, Any]:
    # The LaTeX of a long row would double the JSON: of coefficients it is there only where it was asked for.
    latex = {} if found.rows and not request.typed("latex") else {"latex": found.latex}
    return {"what": request["what"], **found.data, **latex}


def _at_more_digits(point: Mapping[str, str], digits: int) -> dict[str, str]:
    """Exact fractions refuse --digits."""
    return dict(point) if point.get("") in ("f", "c", "g") else {**point, "digits": str(digits)}


@question(
    Offers(
        latex="print it as LaTeX",
        table="the coefficients: n, i, C_i^n",
        own_latex=True,
        again=Again(at=_at_more_digits, exact=True),  # rational arithmetic, or balls
        data=_data,
        text=lambda found, _: found.text,
        as_latex=lambda found, _: found.latex,
        as_csv=lambda found, _: csv_text(["n", "i", "C"], found.rows),
        lacks={
            "alpha": "all of it is of alpha = 2; `half-swing --alpha` has the other exponents",
            "gauge": "constants of the motion have no gauge",
            "plot": "coefficients are no curve",
            "points": "there is no curve",
        },
    ),
    pairs=tuple(_pairs()),
    swept=True,
    example="f --n 3",
    rests="exact rational arithmetic",
)
def smith(
    what: Annotated[str, choice("f", "c", "g", "r", "s", "t", letter="WHAT").called(place=True, suffix="")],
    *,
    n: Annotated[int | None, whole(1, MAX_N)] = None,
    i: Annotated[int | None, whole(0, MAX_N, "I")] = None,
    w: Annotated[Number | None, REAL.called(letter="W")] = None,
    u: Annotated[Number | None, REAL.called(letter="U")] = None,
    tau: Annotated[Number | None, REAL.called(letter="TAU")] = None,
    digits: Annotated[int | None, digits(MAX_DIGITS, "30")] = None,
    max_seconds: Annotated[Number, SECONDS] = 60,
) -> SmithAnswer:
    """Smith's coefficients for quadratic damping (alpha = 2), exactly.

      asymptotics smith f --n 7          the polynomial f_n(w) = sum_i C_i^n w^i
      asymptotics smith c --n 31 --i 10  one coefficient C_i^n
      asymptotics smith g --i 3          the sum G_i(z) = sum_n C_i^n z^n in closed form
      asymptotics smith r --w 1/2        where sum_n f_n(w) z^n converges: certified radii in z
      asymptotics smith s --u 1/4 --w -1/4          the first constant S at a point of the orbit, certified
      asymptotics smith t --u 1/4 --w -1/4 --tau 3  the second, T = omega t - (time since the last turning point)

    w = gamma v / omega, z = w / (w^2 - u), u = gamma x; the limit given for G_i is that of sin^i(theta) G_i(tan theta)
    at theta = pi.  The series converges for |z| < R and diverges for |z| > R; summed over i and n at once it converges
    absolutely for |z| < rho <= R.  S and T are the same all along a half-swing; at w = 0 it is the one that starts
    there.  In Python: ``asy.f``, ``asy.C``, ``asy.G``, ``asy.radii``, ``asy.S``, ``asy.T``.

    Parameters
    ----------
    what
        f polynomial, c coefficient, g generating function, r radii, s and t constants of the motion
    n
        the row; of f to 5000
    i
        0 to n-1 of c, 0 to 100 of g
    w
        gamma v/omega (of r other than 0)
    u
        gamma x
    tau
        omega t at that point (default 0)
    digits
        significant digits, correctly rounded
    max_seconds
        the time the request may take, in seconds

    Raises
    ------
    InputError
        for a parameter that is missing, that has no effect, or out of range
    LimitError
        with the estimate, for a coefficient that would take too long
    """
    given = {"n": n, "i": i, "w": w, "u": u, "tau": tau, "digits": digits}
    return _MAKERS[what](given)


def _polynomial(given: dict[str, Any]) -> SmithAnswer:
    n = _at_most(given, "n", 1, MAX_ROW)
    row = {str(i): _text(c) for i, c in coefficients(n).items()}
    terms = "\n".join(f"  w^{i:<5}{c}" for i, c in row.items())
    latex = f"f_{{{n}}}(w) = {_polynomial_latex(row)}"
    rows = tuple((n, int(i), c) for i, c in row.items())
    return SmithAnswer({"n": n, "coefficients": row}, f"f_{n}(w), coefficients:\n{terms}", latex, rows)


def _coefficient(given: dict[str, Any]) -> SmithAnswer:
    n = given["n"]
    i = _at_most(given, "i", 0, n - 1)
    same_parity = (n - i) % 2 == 0
    # C_i^n is 0 where i and n have the same parity (the recurrence couples opposite ones alone): no work to estimate.
    if not same_parity:
        _check_work(n, i)
    value = _text(coefficient(n, i))
    note = "i and n have the same parity: the coefficient is zero" if same_parity else None
    text = f"C_{i}^{n} = {value}" + (f"   ({note})" if note else "")
    latex = f"C_{{{i}}}^{{{n}}} = {_fraction_latex(value)}"
    return SmithAnswer({"n": n, "i": i, "value": value, "note": note}, text, latex, ((n, i, value),))


def _generating_function(given: dict[str, Any]) -> SmithAnswer:
    i = _at_most(given, "i", 0, MAX_G)
    symbolic = import_module("asymptotics.motions.invariants.symbolic")  # loads SymPy, which f and c do without
    found = symbolic.generating_function(i).to_dict()
    text = f"G_{found['i']}(z) = {found['expression']}\nlimit of sin^i(theta) G_i at theta = pi: {found['limit']}"
    return SmithAnswer({k: v for k, v in found.items() if k != "latex"}, text, found["latex"])


def _radii(given: dict[str, Any]) -> SmithAnswer:
    """R(w) and rho(w), correctly rounded."""
    w, D = given["w"], given["digits"] or 30
    R, rho = import_module("asymptotics.motions.invariants.constants").radii(w, digits=D)  # loads SymPy, as for G
    data = {"w": str(w), "R": str(R), "rho": str(rho), "digits": D, "certified": True}
    return SmithAnswer(data, f"R    {R}\nrho  {rho}", rf"R = {R},\quad \rho = {rho}")


def _first(given: dict[str, Any]) -> SmithAnswer:
    """S at a point, correctly rounded."""
    D = given["digits"] or 30
    value = str(import_module("asymptotics.motions.invariants.constants").S(given["u"], given["w"], digits=D))
    return _constant("S", {"u": str(given["u"]), "w": str(given["w"])}, value, D)


def _second(given: dict[str, Any]) -> SmithAnswer:
    """T at a point, correctly rounded."""
    D, tau = given["digits"] or 30, given["tau"] or 0
    value = str(import_module("asymptotics.motions.invariants.constants").T(given["u"], given["w"], tau, digits=D))
    return _constant("T", {"u": str(given["u"]), "w": str(given["w"]), "tau": str(tau)}, value, D)


def _constant(name: str, where: dict[str, str], value: str, D: int) -> SmithAnswer:
    return SmithAnswer(
        {**where, "value": value, "digits": D, "certified": True}, f"{name}  {value}", f"{name} = {value}"
    )


_MAKERS: dict[str, Callable[[dict[str, Any]], SmithAnswer]] = {
    "f": _polynomial, "c": _coefficient, "g": _generating_function, "r": _radii, "s": _first, "t": _second,
}  # fmt: skip


def _at_most(given: dict[str, Any], name: str, low: int, high: int) -> int:
    if not low <= given[name] <= high:
        raise InputError(name, f"{given[name]} is out of range", f"an integer from {low} to {high}")
    return int(given[name])


def _check_work(n: int, i: int) -> None:
    """Refuse a coefficient whose line of integers would take too long or too much memory, with the estimate."""
    line = (n - i + 1) // 2
    # (n - i + 1)/2 integers that grow to about n log2 n bits, half of that on average, eight bits to a byte.
    size = line * n * log2(n + 2) / 16 + 1
    if size > MAX_BYTES:
        reason = f"C_{i}^{n} would take {size / 2**20:.0f} MiB"
        raise LimitError("n", reason, f"at most {MAX_BYTES >> 20} MiB: a smaller n or i")
    require_affordable(binomial_seconds(line, i, n), MAX_SECONDS, "n", f"C_{i}^{n}", ": a smaller n or i")


def _fraction_latex(value: str) -> str:
    """p/q as LaTeX, the sign in front."""
    sign, size = ("-", value[1:]) if value.startswith("-") else ("", value)
    top, slash, bottom = size.partition("/")
    return rf"{sign}\frac{{{top}}}{{{bottom}}}" if slash else value


def _polynomial_latex(row: dict[str, str]) -> str:
    """The sum of C_i w^i as one writes it."""
    text = ""
    for i, c in row.items():
        if c == "0":
            continue
        number = _fraction_latex(c)
        power = {"0": "", "1": " w"}.get(i, f" w^{{{i}}}")
        sign = (" - " if text else "-") if number.startswith("-") else " + " if text else ""
        text += sign + (number.lstrip("-") + power).removeprefix("1 ")
    return text or "0"


def _text(q: Fraction) -> str:
    """p or p/q; through FLINT, which has no limit on the number of digits."""
    return str(to_fmpq(q))
