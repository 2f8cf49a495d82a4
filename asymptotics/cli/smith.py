"""Smith's coefficients for quadratic damping (alpha = 2), exactly.

  asymptotics smith f --n 7          the polynomial f_n(w) = sum_i C_i^n w^i
  asymptotics smith c --n 31 --i 10  one coefficient C_i^n
  asymptotics smith g --i 3          the sum G_i(z) = sum_n C_i^n z^n in closed form
  asymptotics smith r --w 1/2        where sum_n f_n(w) z^n converges: certified radii in z
  asymptotics smith s --u 1/4 --w -1/4          the first constant S at a point of the orbit, certified
  asymptotics smith t --u 1/4 --w -1/4 --tau 3  the second, T = omega t - (time since the last turning point)

w = gamma v / omega, z = w / (w^2 - u), u = gamma x; the limit given for G_i is that of sin^i(theta) G_i(tan theta)
at theta = pi.  The series converges for |z| < R and diverges for |z| > R; summed over i and n at once it converges
absolutely for |z| < rho <= R.  S and T are the same all along a half-swing; at w = 0 it is the one that starts there.
"""

import argparse
from fractions import Fraction
from importlib import import_module
from math import log2
from typing import Any

from asymptotics.cli.answer import Answer, add_common, add_digits, read_digits
from asymptotics.cli.files import add_csv, read_files, write_files
from asymptotics.costs import binomial_seconds, require_affordable
from asymptotics.errors import InputError, LimitError
from asymptotics.motions.invariants.exact import coefficient, coefficients
from asymptotics.numbers.exact import ExactReal, parse_integer, parse_real
from asymptotics.numbers.rationals import to_fmpq
from asymptotics.present.inputs import csv_text

# Limits of what is printed; one coefficient alone goes further than a row, since only a line of integers is carried.
MAX_ROW, MAX_N, MAX_G = 5_000, 100_000, 100
MAX_DIGITS = 1000
# The work and the memory of one coefficient, estimated from n and i before it begins: refusals, no digits.
MAX_SECONDS, MAX_BYTES = 120, 1 << 30
_USERS = {
    "n": ("f", "c"),
    "i": ("c", "g"),
    "w": ("r", "s", "t"),
    "u": ("s", "t"),
    "tau": ("t",),
    "digits": ("r", "s", "t"),
}


def configure(parser: argparse.ArgumentParser) -> None:
    """Declare the options."""
    parser.add_argument(
        "what",
        metavar="WHAT",
        choices=("f", "c", "g", "r", "s", "t"),
        help="f polynomial, c coefficient, g generating function, r radii, s and t constants of the motion",
    )
    parser.add_argument("--n", metavar="N", help=f"1 to {MAX_ROW} for f, 1 to {MAX_N} for c")
    parser.add_argument("--i", metavar="I", help=f"0 to n-1 for c, 0 to {MAX_G} for g")
    parser.add_argument("--w", metavar="W", help="for r, s, t: gamma v/omega (for r other than 0)")
    parser.add_argument("--u", metavar="U", help="for s, t: gamma x")
    parser.add_argument("--tau", metavar="TAU", help="for t: omega t at that point (default 0)")
    add_digits(parser, MAX_DIGITS, "30 with r, s, t, where alone there is something to round")
    parser.add_argument("--latex", action="store_true", help="print it as LaTeX")
    add_csv(parser, "the coefficients: n, i, C_i^n")
    add_common(parser)


def run(options: argparse.Namespace) -> Answer:
    """Run the command."""
    files = read_files(options)
    if files and options.what not in "fc":
        raise InputError("--csv", f"smith {options.what} is not a row of coefficients", "--csv with f or c")
    for name, users in _USERS.items():
        if options.what not in users:
            _refuse(options, name, " and ".join(users))
    makers = {
        "f": _polynomial,
        "c": _coefficient,
        "g": _generating_function,
        "r": _radii,
        "s": _constant,
        "t": _constant,
    }
    data = makers[options.what](options)
    text = data["latex"] if options.latex else data["text"]
    written = write_files(files, {"--csv": lambda _: csv_text(["n", "i", "C"], _rows(data))}, options, "smith")
    # The LaTeX of a long row would double the JSON: of f and c it is there only where it was asked for.
    hidden = ("text",) if options.latex or options.what not in "fc" else ("text", "latex")
    data = {name: value for name, value in data.items() if name not in hidden} | ({"files": written} if written else {})
    shown = [text] if options.latex else [text, *written]
    return Answer({"what": options.what, **data}, "\n".join(shown), options.json)


def _rows(data: dict[str, Any]) -> list[tuple[object, object, str]]:
    """(n, i, C_i^n) of a polynomial, or of one coefficient."""
    n = data["n"]
    return (
        [(n, i, c) for i, c in data["coefficients"].items()]
        if "coefficients" in data
        else [(n, data["i"], data["value"])]
    )


def _polynomial(options: argparse.Namespace) -> dict[str, Any]:
    n = _integer(options, "n", 1, MAX_ROW)
    row = {str(i): _text(c) for i, c in coefficients(n).items()}
    terms = "\n".join(f"  w^{i:<5}{c}" for i, c in row.items())
    latex = f"f_{{{n}}}(w) = {_polynomial_latex(row)}"
    return {"n": n, "coefficients": row, "latex": latex, "text": f"f_{n}(w), coefficients:\n{terms}"}


def _coefficient(options: argparse.Namespace) -> dict[str, Any]:
    n = _integer(options, "n", 1, MAX_N)
    i = _integer(options, "i", 0, n - 1)
    same_parity = (n - i) % 2 == 0
    # C_i^n is 0 where i and n have the same parity (the recurrence couples opposite ones alone): no work to estimate.
    if not same_parity:
        _check_work(n, i)
    value = _text(coefficient(n, i))
    note = "i and n have the same parity: the coefficient is zero" if same_parity else None
    text = f"C_{i}^{n} = {value}" + (f"   ({note})" if note else "")
    latex = f"C_{{{i}}}^{{{n}}} = {_fraction_latex(value)}"
    return {"n": n, "i": i, "value": value, "note": note, "latex": latex, "text": text}


def _generating_function(options: argparse.Namespace) -> dict[str, Any]:
    i = _integer(options, "i", 0, MAX_G)
    symbolic = import_module("asymptotics.motions.invariants.symbolic")  # loads SymPy, which f and c do without
    result = symbolic.generating_function(i).to_dict()
    text = f"G_{result['i']}(z) = {result['expression']}\nlimit of sin^i(theta) G_i at theta = pi: {result['limit']}"
    return {**result, "text": text}


def _radii(options: argparse.Namespace) -> dict[str, Any]:
    """R(w) and rho(w), correctly rounded."""
    w, digits = _real(options, "w"), read_digits(options, MAX_DIGITS)
    R, rho = import_module("asymptotics.api.constants").radii(w, digits=digits)  # loads SymPy, as for G
    latex = rf"R = {R},\quad \rho = {rho}"
    return {"w": str(w), "R": str(R), "rho": str(rho), "digits": digits, "certified": True, "latex": latex,
            "text": f"R    {R}\nrho  {rho}"}  # fmt: skip


def _constant(options: argparse.Namespace) -> dict[str, Any]:
    """S or T at a point, correctly rounded."""
    u, w, digits = _real(options, "u"), _real(options, "w"), read_digits(options, MAX_DIGITS)
    constants, name = import_module("asymptotics.api.constants"), options.what.upper()
    tau = None if options.tau is None else parse_real(options.tau, "--tau")
    value = str(constants.S(u, w, digits=digits) if name == "S" else constants.T(u, w, tau or 0, digits=digits))
    where = {"u": str(u), "w": str(w), **({} if name == "S" else {"tau": str(tau or 0)})}
    return {**where, "value": value, "digits": digits, "certified": True, "latex": f"{name} = {value}",
            "text": f"{name}  {value}"}  # fmt: skip


def _refuse(options: argparse.Namespace, name: str, users: str) -> None:
    """An option that has no effect here is a mistake, not a decoration."""
    if getattr(options, name) is not None:
        raise InputError(f"--{name}", f"smith {options.what} does not use it", f"--{name} with {users}")


def _real(options: argparse.Namespace, name: str) -> ExactReal:
    if getattr(options, name) is None:
        raise InputError(f"--{name}", "is missing", "a real number")
    return parse_real(getattr(options, name), f"--{name}")


def _integer(options: argparse.Namespace, name: str, low: int, high: int) -> int:
    value = getattr(options, name)
    if value is None:
        raise InputError(f"--{name}", "is missing", f"an integer from {low} to {high}")
    return parse_integer(value, f"--{name}", low, high)


def _check_work(n: int, i: int) -> None:
    """Refuse a coefficient whose line of integers would take too long or too much memory, with the estimate."""
    line = (n - i + 1) // 2
    # (n - i + 1)/2 integers that grow to about n log2 n bits, half of that on average, eight bits to a byte.
    size = line * n * log2(n + 2) / 16 + 1
    if size > MAX_BYTES:
        reason = f"C_{i}^{n} would take {size / 2**20:.0f} MiB"
        raise LimitError("--n", reason, f"at most {MAX_BYTES >> 20} MiB: a smaller n or i")
    require_affordable(binomial_seconds(line, i, n), MAX_SECONDS, "--n", f"C_{i}^{n}", ": a smaller n or i")


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
