"""The options that make an oscillator of a law: mass, stiffness, start; in SI units, or dimensionless.

With --damping (b in N (s/m)^alpha), or as soon as a mass, a stiffness, x0 or v0 is given, everything is SI; with
--epsilon, or with nothing but --law A:E, m = k = x0 = 1 and nothing has a unit.
"""

import argparse
from dataclasses import dataclass
from typing import Any

from asymptotics.cli.forces import add_forces, read_law
from asymptotics.errors import InputError
from asymptotics.law import Oscillator
from asymptotics.numbers.exact import parse_real

PHYSICAL = ("damping", "mass", "stiffness")
QUANTITIES = {
    "mass": ("M", "1", "the mass in kg"),
    "stiffness": ("K", "1", "the stiffness in N/m"),
    "x0": ("X", "1", "the displacement at t = 0 in m"),
    "v0": ("V", "0", "the velocity at t = 0 in m/s"),
}


@dataclass(frozen=True)
class Given:
    """An oscillator, and whether what it does is told in SI units."""

    oscillator: Oscillator
    si: bool

    def unit(self, name: str) -> str:
        """The unit of a quantity with a blank before it, or nothing."""
        return f" {name}" if self.si else ""

    def label(self, unit: str) -> str:
        """The unit of an axis of a picture."""
        return f" ({unit})" if self.si else ""

    @property
    def time_label(self) -> str:
        """What the axis of time is called."""
        return "t (s)" if self.si else r"$\tau$"


def add_oscillator(parser: argparse.ArgumentParser, *, springs: bool = False) -> None:
    """The options of the law (--damping or --epsilon), and mass, stiffness, x0, v0."""
    add_forces(parser, "damping", "B", "b in N (s/m)^alpha: SI units", springs=springs)
    parser.add_argument("--epsilon", metavar="E", help="b omega_0^alpha x0^(alpha-1)/k instead: no units")
    for name, (letter, default, text) in QUANTITIES.items():
        parser.add_argument(f"--{name}", metavar=letter, help=f"{text} (default {default})")


def add_physical(parser: argparse.ArgumentParser) -> None:
    """The options that turn a command without units into one in SI: --damping, --mass, --stiffness."""
    parser.add_argument("--damping", metavar="B", help="b in N (s/m)^alpha: SI units")
    for name in PHYSICAL[1:]:
        letter, default, text = QUANTITIES[name]
        parser.add_argument(f"--{name}", metavar=letter, help=f"{text} (default {default}): SI units")


def is_physical(options: argparse.Namespace) -> bool:
    """Whether one of them was given."""
    return any(getattr(options, name) is not None for name in PHYSICAL)


def read_oscillator(options: argparse.Namespace) -> Given:
    """The oscillator of the options; InputError for units and no units at once."""
    given = [name for name in QUANTITIES if getattr(options, name, None) is not None]
    if options.epsilon is not None and (given or options.damping is not None):
        other = given[0] if given else "damping"
        raise InputError("--epsilon", f"it has no units, and --{other} has", "--epsilon alone, or --damping instead")
    strength = "damping" if options.epsilon is None else "epsilon"
    law = read_law(options, strength)
    numbers: dict[str, Any] = {name: parse_real(getattr(options, name), f"--{name}") for name in given}
    return Given(Oscillator(law, **numbers), bool(given) or options.damping is not None)
