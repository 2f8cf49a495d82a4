"""The options that make an oscillator of a law: mass, stiffness, start; in SI units, or dimensionless.

One rule for every command: everything is in SI as soon as --damping (b in N (s/m)^alpha), --mass or --stiffness is
given, and then --law A:B gives b, --x0 metres and --v0 metres per second.  Otherwise nothing has a unit: m = k = 1, the
equation is X'' + X + sum_i E_i X'|X'|^(A_i-1) = 0 as it is typed, and starts at X(0) = x0 (1), X'(0) = v0 (0).
What is in SI may have another unit, 200 g or 5 cm; of a pendulum places are angles, in rad or 20 deg, with SI or not.

>>> options = argparse.Namespace(mass="200 g", x0="5 cm", v0=None, spring=None)
>>> without_units(options).x0, options.mass
('1/20', '1/5')
>>> without_units(argparse.Namespace(epsilon="1/10", x0="5 cm"))
Traceback (most recent call last):
    ...
asymptotics.errors.InputError: argument --x0: '5 cm' has the unit cm, and a law alone has none: ...
"""

import argparse
import re
from collections.abc import Callable
from dataclasses import replace
from typing import Any

from asymptotics.ask.answers import Request
from asymptotics.ask.forces import read_law
from asymptotics.ask.kinds import Kind
from asymptotics.ask.pairs import Pair, excludes
from asymptotics.errors import InputError, shown
from asymptotics.frames import BARE, frame_of
from asymptotics.law import Law, Oscillator
from asymptotics.law_given import Given
from asymptotics.numbers.exact import ExactReal, parse_real
from asymptotics.numbers.policy import exact_number
from asymptotics.numbers.quantities import in_si, unit_behind
from asymptotics.present.drawn import Drawn
from asymptotics.terms_given import PENDULUM

OVERLAY = "another law in the same picture, A:B or A:B+A:B; repeat it"
PHYSICAL = ("damping", "mass", "stiffness")
_WITH_UNITS = ("x0", "v0", "time")
"""What has a unit beside one of those; so have the numbers of a list of amplitudes."""
QUANTITIES = {
    "mass": ("M", "1", "the mass in kg"),
    "stiffness": ("K", "1", "the stiffness in N/m"),
    "x0": ("X", "1", 'the displacement at t = 0, beside SI units in m or with its unit: "5 cm"'),
    "v0": ("V", "0", 'the velocity at t = 0, beside SI units in m/s or with its unit: "3 cm/s"'),
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


def without_units(options: argparse.Namespace) -> argparse.Namespace:
    """The same options with plain numbers in the place of those with a unit; InputError for a unit that has no place.

    Done once, where words become options, so that headers of files and points of a sweep hold numbers.
    """
    frame = {"physical": is_physical(options), "pendulum": PENDULUM in (getattr(options, "spring", None) or [])}
    for name in (*_WITH_UNITS, "mass", "stiffness"):
        text = getattr(options, name, None)
        if isinstance(text, str):
            setattr(options, name, plain_number(text, name, **frame))
    if isinstance(getattr(options, "amplitudes", None), str):
        _in_their_unit(options, frame)
    return options


def _in_their_unit(options: argparse.Namespace, frame: dict[str, bool]) -> None:
    """Amplitudes with units as plain ones, in the unit that all of them have (--unit), else in that of SI."""
    listed = options.amplitudes
    plain = plain_list(listed, "amplitudes", **frame)
    if plain == listed:
        return
    if options.unit:
        raise InputError("--unit", f"{shown(listed)} has units of its own", "amplitudes with a unit, or --unit")
    parts = [part.strip() for part in listed.split(",")]
    unit, *others = {unit_behind(part) for part in parts}
    if others:
        options.amplitudes = plain
        return
    options.amplitudes = ",".join(part.removesuffix(unit).strip() for part in parts)
    options.unit = "deg" if unit == "\u00b0" else unit


def plain_number(text: str, name: str, *, physical: bool, pendulum: bool) -> str:
    """A number typed at the option ``name``, without its unit; any text without one as it is."""
    place = "rad" if pendulum else "m" if physical else ""
    speed, second = (f"{place}/s", "s") if physical else ("", "")
    unit = {"x0": place, "amplitudes": place, "v0": speed, "time": second}.get(name, "")
    known = unit_behind(text) if len(text) <= 100 else ""
    if known and not unit and name in (*_WITH_UNITS, "amplitudes"):
        reason = f"{shown(text)} has the unit {known}, and a law alone has none: x0 is its unit of x, 1/omega_0 of t"
        raise InputError(f"--{name}", reason, "a plain number; or --mass, --stiffness or --damping with it: SI units")
    found = in_si(text, f"--{name}", unit) if known else None
    return text if found is None else str(found)


def plain_list(text: str, name: str, *, physical: bool, pendulum: bool) -> str:
    """The same of a list or a range of a sweep; InputError where only some of its numbers have a unit.

    >>> plain_list("5 cm,6 cm", "x0", physical=True, pendulum=False)
    '1/20,3/50'
    """
    parts = re.split("([,:])", text)
    plain = [plain_number(part, name, physical=physical, pendulum=pendulum) for part in parts]
    if len({before == after for before, after in zip(parts[::2], plain[::2])}) > 1:
        reason = f"of the numbers in {shown(text)} some have a unit and others none"
        raise InputError(f"--{name}", reason, "each with its unit: 5 cm,6 cm; decimals have a point")
    return "".join(plain)


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
