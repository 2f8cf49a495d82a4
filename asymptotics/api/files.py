"""Data in, verdicts out: one's own values beside certified ones, and the derivations.

``identify`` and ``sweep`` are owned by their rooms (``identification``, ``sweeps``).
"""

from difflib import get_close_matches
from importlib import import_module
from importlib.util import find_spec
from pathlib import Path
from typing import Any

from asymptotics.api.units import oscillator_of
from asymptotics.comparison.run import Comparison, compare_file
from asymptotics.errors import InputError, shown
from asymptotics.law import Oscillator
from asymptotics.numbers.policy import exact_integer
from asymptotics.public import public, public_beside_others

MAX_DIGITS = 1000


@public
def compare(
    file: Any, law: Any, *, columns: str | None = None, digits: Any = None, max_seconds: Any = 60
) -> Comparison:
    """A CSV file of turning points (column n) or a motion (tau or t) beside the certified values.

    The file is in SI units when ``law`` is an oscillator, else in units of x0 and tau.  InputError for what the file
    does not say or says wrongly.
    """
    if not isinstance(file, str | Path):
        raise InputError("file", f"a {type(file).__name__} is no file name", "a path")
    wanted = None if digits is None else exact_integer(digits, "digits", 1, MAX_DIGITS)
    si = isinstance(law, Oscillator)
    return compare_file(Path(file), oscillator_of(law), columns=columns, digits=wanted, si=si)


@public_beside_others
def derive(name: str | None = None, *, max_seconds: Any = 60) -> Any:
    """A derivation by name, run as it is loaded (each displayed step asserted); without a name the list of names.

    InputError where only this package was installed, without the folder ``derivations`` of its wheel.
    """
    if find_spec("derivations") is None:
        raise InputError("name", "the derivations are not installed", "all of a wheel: pip install . in a clone")
    names: list[str] = import_module("derivations.__main__").names()
    if name is None:
        return names
    if not isinstance(name, str) or name not in names:
        near = get_close_matches(name, names, n=3) if isinstance(name, str) else []
        raise InputError("name", f"no derivation {shown(name)}", f"such as {', '.join(near or names[:3])}")
    return import_module("derivations." + name.replace("-", "_")).derivation
