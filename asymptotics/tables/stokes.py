"""What stands in front of the factorial growth: the Stokes constants c_1 (amplitude) and d_1 (time) of one law."""

from flint import arb

from asymptotics.expansions.divergence.result import action_of, pole_of, stokes_constants
from asymptotics.numbers.exact import ExactReal
from asymptotics.tables.cells import Cell, Nearest
from asymptotics.tables.inputs import Inputs
from asymptotics.tables.recipe import Found, rows_in_progress

_ALPHAS = ("0", "2", "4", "6")  # near 1 it takes longer: 1.1 a second, 1.03 twenty


def constants(inputs: Inputs, digits: int) -> Found:
    """Rows (alpha, c, 2 pi |c|, c_1, d_1); InputError for alpha = 1 and above 50, LimitError near 1."""
    alphas = inputs.alphas_or(_ALPHAS)
    rows, certified = rows_in_progress(), True
    for alpha in alphas:
        s = stokes_constants(alpha, 1, digits)
        certified = certified and s.certified
        exact = _cell(pole_of(alpha), s.pole), _cell(action_of(alpha), s.action)
        rows.append((s.alpha, *exact, Nearest(s.constants[0]), Nearest(s.time_constants[0])))
    return Found(rows, certified)


def _cell(number: arb | ExactReal, text: str) -> Cell:
    """A rational number as it is: no number of digits tells its decimal, where it ends, from its neighbours."""
    return number.rational if isinstance(number, ExactReal) else Nearest(text)
