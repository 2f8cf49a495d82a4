"""Smith's coefficients for quadratic damping (alpha = 2), exactly.

  asymptotics smith f --n 7          the polynomial f_n(w) = sum_i C_i^n w^i
  asymptotics smith c --n 31 --i 10  one coefficient C_i^n
  asymptotics smith g --i 3          the sum G_i(z) = sum_n C_i^n z^n in closed form
  asymptotics smith r --w 1/2        where sum_n f_n(w) z^n converges: certified radii in z

w = gamma v / omega, z = w / (w^2 - u), u = gamma x; the limit given for G_i is that of sin^i(theta) G_i(tan theta)
at theta = pi.  The series converges for |z| < R and diverges for |z| > R; summed over i and n at once it converges
absolutely for |z| < rho <= R.
"""

import argparse
from fractions import Fraction
from importlib import import_module
from math import log2
from typing import Any

from asymptotics.cli.answer import Answer, add_digits, add_json, add_max_seconds, read_digits
from asymptotics.cli.files import add_csv, csv_text, read_files, write_files
from asymptotics.costs import binomial_seconds, require_affordable
from asymptotics.errors import InputError, LimitError
from asymptotics.invariants.exact import coefficient, coefficients
from asymptotics.numbers.exact import parse_integer, parse_real
from asymptotics.numbers.rationals import to_fmpq

MAX_ROW, MAX_N, MAX_G = 5_000, 100_000, 100
MAX_W, MAX_DIGITS = 10, 1000
MAX_SECONDS, MAX_BYTES = 120, 1 << 30


def configure(parser: argparse.ArgumentParser) -> None:
    """Declare the options."""
    parser.add_argument(
        "what",
        metavar="WHAT",
        choices=("f", "c", "g", "r"),
        help="f polynomial, c coefficient, g generating function, r radii",
    )
    parser.add_argument("--n", metavar="N", help=f"1 to {MAX_ROW} for f, 1 to {MAX_N} for c")
    parser.add_argument("--i", metavar="I", help=f"0 to n-1 for c, 0 to {MAX_G} for g")
    parser.add_argument("--w", metavar="W", help="for r: a real number other than 0")
    add_digits(parser, MAX_DIGITS, "30 with r, where alone there is something to round")
    parser.add_argument("--latex", action="store_true", help="print it as LaTeX")
    add_csv(parser, "the coefficients: n, i, C_i^n")
    add_max_seconds(parser)
    add_json(parser)


def run(options: argparse.Namespace) -> Answer:
    """Run the command."""
    files = read_files(options)
    if files and options.what in "gr":
        raise InputError("--csv", f"smith {options.what} is not a row of coefficients", "--csv with f or c")
    if options.what != "r":
        _refuse(options, "w", "r")
        _refuse(options, "digits", "r")
    data = {"f": _polynomial, "c": _coefficient, "g": _generating_function, "r": _radii}[options.what](options)
    text = data["latex"] if options.latex else data["text"]
    written = write_files(files, {"--csv": lambda _: csv_text(["n", "i", "C"], _rows(data))})
    hidden = ("text",) if options.latex or options.what in "gr" else ("text", "latex")
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
    _refuse(options, "i", "c and g")
    n = _integer(options, "n", 1, MAX_ROW)
    row = {str(i): _text(c) for i, c in coefficients(n).items()}
    terms = "\n".join(f"  w^{i:<5}{c}" for i, c in row.items())
    latex = f"f_{{{n}}}(w) = {_polynomial_latex(row)}"
    return {"n": n, "coefficients": row, "latex": latex, "text": f"f_{n}(w), coefficients:\n{terms}"}


def _coefficient(options: argparse.Namespace) -> dict[str, Any]:
    n = _integer(options, "n", 1, MAX_N)
    i = _integer(options, "i", 0, n - 1)
    same_parity = (n - i) % 2 == 0
    if not same_parity:
        _check_work(n, i)
    value = _text(coefficient(n, i))
    note = "i and n have the same parity: the coefficient is zero" if same_parity else None
    text = f"C_{i}^{n} = {value}" + (f"   ({note})" if note else "")
    latex = f"C_{{{i}}}^{{{n}}} = {_fraction_latex(value)}"
    return {"n": n, "i": i, "value": value, "note": note, "latex": latex, "text": text}


def _generating_function(options: argparse.Namespace) -> dict[str, Any]:
    _refuse(options, "n", "f and c")
    i = _integer(options, "i", 0, MAX_G)
    symbolic = import_module("asymptotics.invariants.symbolic")  # loads SymPy, which f and c do without
    result = symbolic.generating_function(i).to_dict()
    text = f"G_{result['i']}(z) = {result['expression']}\nlimit of sin^i(theta) G_i at theta = pi: {result['limit']}"
    return {**result, "text": text}


def _radii(options: argparse.Namespace) -> dict[str, Any]:
    """R(w) and rho(w), correctly rounded."""
    _refuse(options, "n", "f and c")
    _refuse(options, "i", "c and g")
    if options.w is None:
        raise InputError("--w", "is missing", "a real number other than 0")
    w, digits = parse_real(options.w, "--w"), read_digits(options, MAX_DIGITS)
    if w.is_zero or not abs(w) <= MAX_W:
        raise InputError("--w", f"{w} is out of range", f"0 < |w| <= {MAX_W}")
    certified = import_module("asymptotics.invariants.certified")  # with its decimals, which f and c do without
    decimal = import_module("asymptotics.numbers.decimals").certified_decimal
    R = decimal(lambda: certified.series_radius(w.ball()), digits)
    rho = decimal(lambda: certified.absolute_radius(w.ball()), digits)
    latex = rf"R = {R},\quad \rho = {rho}"
    return {"w": str(w), "R": R, "rho": rho, "digits": digits, "certified": True, "latex": latex,
            "text": f"R    {R}\nrho  {rho}"}  # fmt: skip


def _refuse(options: argparse.Namespace, name: str, users: str) -> None:
    """An option that has no effect here is a mistake, not a decoration."""
    if getattr(options, name) is not None:
        raise InputError(f"--{name}", f"smith {options.what} does not use it", f"--{name} with {users}")


def _integer(options: argparse.Namespace, name: str, low: int, high: int) -> int:
    value = getattr(options, name)
    if value is None:
        raise InputError(f"--{name}", "is missing", f"an integer from {low} to {high}")
    return parse_integer(value, f"--{name}", low, high)


def _check_work(n: int, i: int) -> None:
    """Refuse a coefficient whose line of integers would take too long or too much memory, with the estimate."""
    line = (n - i + 1) // 2
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
