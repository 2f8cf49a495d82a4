"""The options that make an oscillator of a law: mass, stiffness, start; in SI units, or dimensionless.

One rule for every command: everything is in SI as soon as --damping (b in N (s/m)^alpha), --mass or --stiffness is
given, and then --law A:B gives b, --x0 metres and --v0 metres per second.  Otherwise nothing has a unit: m = k = 1, the
equation is X'' + X + sum_i E_i X'|X'|^(A_i-1) = 0 as it is typed, and starts at X(0) = x0 (1), X'(0) = v0 (0).
"""

import argparse
from collections.abc import Callable
from dataclasses import replace
from typing import Any

from asymptotics.ask.answers import Request
from asymptotics.ask.forces import read_law
from asymptotics.ask.kinds import Kind
from asymptotics.ask.pairs import Pair, excludes
from asymptotics.errors import InputError
from asymptotics.frames import BARE, frame_of
from asymptotics.law import Law, Oscillator
from asymptotics.law_given import Given
from asymptotics.numbers.exact import ExactReal, parse_real
from asymptotics.numbers.policy import exact_number
from asymptotics.present.drawn import Drawn

OVERLAY = "another law in the same picture, A:B or A:B+A:B; repeat it"
PHYSICAL = ("damping", "mass", "stiffness")
QUANTITIES = {
    "mass": ("M", "1", "the mass in kg"),
    "stiffness": ("K", "1", "the stiffness in N/m"),
    "x0": ("X", "1", "the displacement at t = 0, in m beside SI units"),
    "v0": ("V", "0", "the velocity at t = 0, in m/s beside SI units"),
}


def _time(value: Any, name: str) -> ExactReal:
    moment = exact_number(value, name)
    if moment < 0:
        raise InputError(
            name,
            f"{moment} is before the start, where the state is given",
            "a time >= 0, in s, of a law alone in 1/omega_0",
        )
    return moment


TIME = Kind("T", _time)
"""A time >= 0, in s or without a unit."""


def is_physical(options: argparse.Namespace) -> bool:
    """Whether the command is in SI: whether --damping, --mass or --stiffness was given."""
    return any(getattr(options, name, None) is not None for name in PHYSICAL)


def unit_pairs(*units: str) -> tuple[Pair, ...]:
    """b and epsilon say the same thing, each in its units: --epsilon is refused beside these."""
    accepted = "--epsilon alone, or --damping instead"
    return (excludes("epsilon", " ".join(units or PHYSICAL), "it has no units, and {other} has", accepted),)


def read_oscillator(options: argparse.Namespace, strength: str = "damping") -> Given:
    """The oscillator of the options; --epsilon and units at once are refused before (``unit_pairs``).

    ``strength``: what is said to be missing when there is none.  Where --epsilon stands beside a mass or a stiffness it
    is the dimensionless strength of the oscillator in SI; InputError if the b of that is no exact number.
    """
    given = [name for name in QUANTITIES if getattr(options, name, None) is not None]
    si, named = is_physical(options), options.epsilon is not None
    if options.alpha is not None and not (named or si or options.law):
        raise InputError("--epsilon", "is missing", "--epsilon E, without units; or --damping B in N (s/m)^alpha")
    # Under the name by which it was given, or would have to be given: an error names that option.
    law = read_law(options, "epsilon" if named else "damping" if si else strength)
    numbers: dict[str, Any] = {name: exact_number(getattr(options, name), f"--{name}") for name in given}
    oscillator = Oscillator(law, **numbers)
    oscillator = _with_epsilon(oscillator) if named and si else oscillator
    return Given(oscillator, frame_of(oscillator) if si else BARE)


def read_moving(options: argparse.Namespace) -> Given:
    """The same, or what rests: x0 = 0 and v0 = 0 has an answer, though no unit of length."""
    if not _rests(options):
        return read_oscillator(options)
    # Another start stands in, so that every other option is still read and refused as usual.
    return replace(read_oscillator(argparse.Namespace(**{**vars(options), "x0": "1"})), rests=True)


def _rests(options: argparse.Namespace) -> bool:
    starts = {name: getattr(options, name) for name in ("x0", "v0")}
    zero = {name for name, text in starts.items() if text is not None and parse_real(text, f"--{name}").is_zero}
    return "x0" in zero and ("v0" in zero or options.v0 is None)


def require_stretch(request: Request) -> None:
    """InputError for a picture or a table of a curve that ends where it begins."""
    if request.has_files and not request["time"] > 0:
        raise InputError("--time", "there is no stretch of time to draw", "a time > 0 with --plot or --csv")


def overlaid(
    options: argparse.Namespace, found: Drawn, given: Given, again: Callable[[Oscillator], Drawn]
) -> list[Drawn]:
    """What --plot draws: the answer, and the same for each law of --overlay (terms joined by +), start and springs."""
    results = [found]
    for text in options.overlay or []:
        terms = argparse.Namespace(alpha=None, epsilon=None, damping=None, spring=None, law=text.split("+"))
        law = Law.from_terms([*read_law(terms, "epsilon").losses, *given.oscillator.law.springs])
        results.append(again(given.oscillator.with_law(law)))
    return results


def _with_epsilon(unit: Oscillator) -> Oscillator:
    """The oscillator whose dimensionless strength is what stands in ``unit`` as b; InputError if its b is no root."""
    # epsilon = scale b, scale = omega_0^alpha x0^(alpha-1)/k: b is a quotient, exact where the powers are one root.
    (term,) = unit.law.terms
    epsilon = term.strength
    scale = unit.units.scale(ExactReal(1), term.velocity, term.weight)
    if not isinstance(scale, ExactReal) or not isinstance(epsilon, ExactReal):
        reason = f"the b of epsilon = {epsilon} is no exact number for this mass, stiffness and x0"
        raise InputError("--epsilon", reason, "--damping B, or a file without units")
    return unit.with_law({term.velocity: epsilon / scale})
