"""The laws behind a table, exported by ``damping --from``: fitted again from the numbers in the header of the file.

The header holds the table itself, never the name of a file.  The fit is one in doubles, so nothing here is certified:
what is judged is whether the file says what its request gives.

>>> header = ["law", "grade", "alpha", "low", "strength", "high", "code"]
>>> request = {"A": "0.1,0.2,0.4", "zeta": "0.01,0.01,0.01", "resolution": "0.001,0.001,0.001", "laws": "1"}
>>> rows = [(2, ["1", "consistent", "1", "0.01711", "0.02", "0.02299", ""])]
>>> found = compared_law(request, header, rows)
>>> [(row.key, row.column, row.marked[:6]) for row in found.rows], found.certified
([('1, 1', 'low', '0.01[7'), ('1, 1', 'strength', '0.02'), ('1, 1', 'high', '0.02[2')], False)
"""

from importlib import import_module

from asymptotics.cli.swept import typed_options
from asymptotics.comparison.cells import Cells, compared_cells
from asymptotics.comparison.reading import as_double
from asymptotics.comparison.run import Comparison
from asymptotics.numbers.exact import parse_rational
from asymptotics.sweeps.grid import Point

_COLUMNS = ("A", "zeta", "Q", "decrement", "resolution")
# What tells every double apart: the fit is one in doubles.
_DIGITS = 17


def compared_law(request: Point, header: list[str], rows: list[tuple[int, list[str]]]) -> Comparison:
    """Strengths, intervals and grades beside those of the request; InputError for a table that cannot be used."""
    command = import_module("asymptotics.ask.questions.damping")
    table = {name: _numbers(request[name]) for name in _COLUMNS if name in request}
    given = {n: v for n, v in request.items() if n.partition(".")[0] in ("spring", "mass", "stiffness")}
    options = typed_options("damping", given)
    springs = command.damping_law.__question__["spring"].kind.assemble(options)
    laws = request["laws"].split(",") if "laws" in request else None
    found = command.damping_law(table, laws=laws, spring=springs, mass=options.mass, stiffness=options.stiffness)
    right = tuple((*map(str, row), "") for row in command.law_rows(found))
    method = "the table in the header fitted again, in doubles"
    cells = Cells((*command.LAW_HEAD, "code"), right, ("law", "alpha"), frozenset({"code"}), method=method)
    return compared_cells(rows, header, cells, _DIGITS, certified=False)


def _numbers(text: str) -> list[float]:
    cells = text.split(",")
    for cell in cells:
        # Read by the grammar of numbers first: a header is foreign text.
        parse_rational(cell, "FILE")
    return list(map(as_double, cells))
