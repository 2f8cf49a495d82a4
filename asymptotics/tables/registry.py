"""The tables by name.

>>> table = build("smith2012.table1", digits=6)
>>> table.columns, table.rows[1], table.certified
(('half_cycle', 'S_hat', 'u'), ('2', '0.0987650', '-0.410720'), True)
>>> build("moments", 5, Inputs.of(alphas=["1/2"]), "interval").rows
(('1/2', '[0.55641, 0.55642]', '[0.63661, 0.63662]', '[0.45765, 0.45766]'),)
"""

from dataclasses import asdict
from difflib import get_close_matches
from typing import Any

from asymptotics.errors import InputError
from asymptotics.numbers.integers import require_integer
from asymptotics.running.cut_short import changed
from asymptotics.tables.cells import Rows, round_rows, rounded_so_far
from asymptotics.tables.inputs import Inputs
from asymptotics.tables.provenance import checksum, provenance
from asymptotics.tables.recipe import Recipe, RowsInProgress
from asymptotics.tables.recipes import RECIPES
from asymptotics.tables.table import Table

MAX_DIGITS = 10_000


def names() -> dict[str, str]:
    """The names of all tables with their titles."""
    return {name: recipe.title for name, recipe in RECIPES.items()}


def description(name: str) -> dict[str, Any]:
    """What a table is: title, columns, units, keys, the route and the one that checks it, cost, options."""
    # The function that computes is no part of the description.
    found = asdict(_recipe(name))
    found.pop("compute")
    return {key: list(value) if isinstance(value, tuple) else value for key, value in found.items()}


def build(name: str, digits: int = 30, inputs: Inputs | None = None, rounding: str = "nearest") -> Table:
    """Build a table; InputError for an unknown name, inputs the table has no use for, digits outside [1, 10000]."""
    recipe, given = _recipe(name), inputs or Inputs()
    _require_use(name, recipe, given)
    require_integer(digits, "digits", 1, MAX_DIGITS)
    verdicts = []

    def compute(wanted: int) -> Rows:
        found = recipe.compute(given, wanted)
        # The verdict of the pass whose digits are printed: the last one.
        verdicts.append(found.certified)
        return found.rows

    def table(rows: tuple[tuple[str, ...], ...], certified: bool) -> Table:
        columns, units = _columns(recipe, rows)
        asked = {**given.to_dict(), "digits": digits, "rounding": rounding}
        origin = provenance(asked, recipe.source, certified, checksum(columns, rows))
        keys = tuple(key for key in recipe.keys if key in columns)
        return Table(name, recipe.title, columns, rows, recipe.source, certified, keys, units, origin)

    # Stopped inside a row, an inner computation hands over what it has (points of a sequence, say), turned into rows by
    # its recipe if it can; otherwise the rows that the recipe has begun count.
    def so_far(found: Any) -> Table | None:
        """The rows that were done; a sequence that a row would have come from is none."""
        cells = found if isinstance(found, list) else progress.longest()
        done = rounded_so_far(cells, digits, rounding)
        return table(done, _proved(recipe, done)) if done else None

    # The order matters: the rows must still be known when the error passes ``changed``.
    with RowsInProgress() as progress, changed(so_far, otherwise=lambda: so_far(progress.longest())):
        rows = round_rows(compute, digits, rounding)
    return table(rows, verdicts[-1])


def _proved(recipe: Recipe, rows: tuple[tuple[str, ...], ...]) -> bool:
    """Whether rows that stand alone are proved: a column says so, or every value was found with its digits."""
    columns = _columns(recipe, rows)[0]
    unproved = {"certified": "false", "value": ""}
    return not any(row[i] == unproved[name] for row in rows for i, name in enumerate(columns) if name in unproved)


def _columns(recipe: Recipe, rows: tuple[tuple[str, ...], ...]) -> tuple[tuple[str, ...], tuple[str, ...]]:
    """The columns there are: a leading one that holds nothing but the default may be left out by the recipe."""
    # Smith's Table I has no column u_0 where it is 1, as printed.
    missing = len(recipe.columns) - len(rows[0]) if rows else 0
    return recipe.columns[missing:], recipe.units[missing:]


def _recipe(name: str) -> Recipe:
    if name not in RECIPES:
        near = get_close_matches(name[:60], RECIPES, n=1)
        meant = f"; did you mean {near[0]}?" if near else ""
        raise InputError("NAME", f"no table {name[:60]!r}{meant}", ", ".join(RECIPES))
    return RECIPES[name]


def _require_use(name: str, recipe: Recipe, given: Inputs) -> None:
    """InputError for an option that would change nothing."""
    used = recipe.uses.split()
    asked = {"alpha": given.alphas, "law": given.law, "epsilon": given.epsilons, "rows": given.rows}
    for option, value in asked.items():
        if value and option not in used:
            accepted = ", ".join(f"--{u}" for u in used) or "no such option"
            raise InputError(option, f"it changes nothing in {name}", accepted)
