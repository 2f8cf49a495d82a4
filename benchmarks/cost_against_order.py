"""What an order costs: the whole expansion (p and Omega, turning-point gauge) for alpha = 2, 3 and 3/2."""

from functools import partial

from asymptotics.expansions.normal_form.digits import certified_digits
from asymptotics.expansions.normal_form.expansion import exact_expansion
from asymptotics.numbers.exact import parse_real
from benchmarks.table import Table, best_time, seconds_text

DIGITS = 40


def run(size: int = 24) -> Table:
    """Orders size/8, size/4, size/2, size: exact for alpha = 2, 3; 40 certified digits for alpha = 3/2.

    The last column is the growth against the order before, to compare with 2^k for a cost of order^k.
    """
    routes = {
        "alpha = 2, exact": lambda order: exact_expansion((2,), order),
        "alpha = 3, exact": lambda order: exact_expansion((3,), order),
        f"alpha = 3/2, {DIGITS} digits": lambda order: certified_digits([parse_real("3/2", "--alpha")], order, DIGITS),
    }
    rows = []
    for name, route in routes.items():
        before = None
        for order in (max(1, size // 8), max(2, size // 4), max(3, size // 2), max(4, size)):
            seconds = best_time(partial(route, order), 3 if order <= 12 else 1)
            growth = "-" if before is None else f"{seconds / before:.1f}"
            rows.append((name, str(order), seconds_text(seconds), growth))
            before = seconds
    return Table("Cost against order", ("what", "order", "seconds", "growth"), tuple(rows))
