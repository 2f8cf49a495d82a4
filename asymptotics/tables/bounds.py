"""Error bounds of the expansions: constants and ranges that are theorems, rounded up."""

from asymptotics.bounds.local import local_bounds
from asymptotics.numbers.exact import ExactReal
from asymptotics.tables.inputs import GRID, Inputs
from asymptotics.tables.recipe import Found, rows_in_progress

# As far as orders are usually taken; --rows goes on.
_ORDERS = 3


def error_bounds(inputs: Inputs, _digits: int) -> Found:
    """Rows (alpha, order, delta_max, C_L, m_L, C_T, m_T); --rows is the highest order.

    |L - L_N| <= C_L d^m_L and |T - T_N| <= C_T d^m_T on each half-swing that starts at delta = d <= delta_max.  The
    constants are rounded up and delta_max down, to two digits whatever is asked for.
    """
    orders = range(1, inputs.count(_ORDERS) + 1)
    rows = rows_in_progress()
    for a in inputs.alphas_or(GRID):
        rows += [_row(a, order) for order in orders]
    return Found(rows, True)


def _row(a: ExactReal, order: int) -> tuple[str, ...]:
    found = local_bounds((a,), order).to_dict()
    names = ("delta_max", "amplitude", "amplitude_power", "frequency", "frequency_power")
    return (str(a), str(order), *(str(found[name]) for name in names))
