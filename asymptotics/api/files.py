"""One's own values beside certified ones.  Right digits are counted as
-log10 of the relative error, against values of which every digit is proved.

``identify`` and ``sweep`` are owned by their rooms (``identification``, ``sweeps``).
"""

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from asymptotics.api.units import oscillator_of
from asymptotics.comparison.run import Comparison, compare_file
from asymptotics.comparison.tabled import compare_table, series_table
from asymptotics.errors import InputError, shown
from asymptotics.law import LawLike, Oscillator
from asymptotics.numbers.policy import Number, exact_integer
from asymptotics.public import public
from asymptotics.tables.inputs import Inputs

MAX_DIGITS = 1000


@public
def compare(
    file: Any,
    law: LawLike | None = None,
    *,
    columns: str | None = None,
    digits: int | None = None,
    table: str | None = None,
    alpha: Number | Sequence[Number] | None = None,
    epsilon: Number | Sequence[Number] | None = None,
    max_seconds: Number = 60,
) -> Comparison:
    """Turning points (column n) or a motion (tau or t) beside the certified values, each with its right digits.

    ``file``: a CSV file, or columns by name: a mapping of sequences or arrays, or a data frame.  It is in SI units when
    ``law`` is an oscillator, else in units of x0 and tau.  With ``table`` the rows are held against that table, as a
    file of coefficients from ``expand --csv`` or ``half-swing --csv`` is, and ``law``, ``alpha``, ``epsilon`` are its
    inputs (``asy.table``).  InputError for what is missing or wrong.

    >>> compare({"n": [1, 2], "x": [-0.4107197, 0.2635711]}, {2: 1}).rows[1].marked
    '0.26357[11]'
    """
    source = _source(file)
    wanted = None if digits is None else exact_integer(digits, "digits", 1, MAX_DIGITS)
    # A file of coefficients names its table by its columns; what is no such file is compared as points or a motion.
    table = series_table(source) if table is None else table
    if table is not None:
        if not isinstance(table, str):
            raise InputError("table", f"{shown(table)} is no name", "a name of table_names()")
        return compare_table(source, table, Inputs.read(alpha, epsilon, law), columns=columns, digits=wanted)
    for name, value in (("alpha", alpha), ("epsilon", epsilon)):
        if value is not None:
            raise InputError(name, "there is no table", f"{name} with table, or the law")
    si = isinstance(law, Oscillator)
    return compare_file(source, oscillator_of(law), columns=columns, digits=wanted, si=si)


def _source(file: Any) -> Path | Mapping[str, Any]:
    """A file by its name, or columns by theirs; a data frame has ``keys`` and columns as a mapping has."""
    if isinstance(file, str | Path):
        return Path(file)
    if isinstance(file, Mapping):
        return file
    # By its methods: pandas, an extra, need not be installed for a file to be compared.
    if hasattr(file, "columns") and hasattr(file, "to_dict"):
        found: dict[str, Any] = file.to_dict("list")
        return found
    raise InputError("file", f"a {type(file).__name__} is no file name", "a path, a mapping of columns, a data frame")
