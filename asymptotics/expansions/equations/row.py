"""The coefficients of one series, keyed as one writes them: ``p[3]``, or ``p[2, 1]`` for several strengths.

>>> row = CoefficientRow({(1,): Coefficient("0.5", None), (3,): Coefficient("0.125", None)})
>>> row[3].value, row["1"].value, list(row), len(row)
('0.125', '0.5', [1, 3], 2)
"""

from collections.abc import Iterator, Mapping
from typing import Any

from asymptotics.errors import InputError
from asymptotics.expansions.normal_form.show import SHOWN_DIGITS, sum_latex
from asymptotics.numbers.exact import MAX_ORDER
from asymptotics.numbers.policy import exact_integer
from asymptotics.numbers.value import Coefficient, coefficient_columns, rounded
from asymptotics.present.shown import Page, Rows
from asymptotics.series import Key


class CoefficientRow(Rows, Mapping[Any, Coefficient]):
    """The coefficients of one series: ``row[3]`` for one law, ``row[2, 1]`` for several; text keys "2,1" work too."""

    def __init__(self, coefficients: Mapping[Key, Coefficient]) -> None:
        self._items = dict(coefficients)

    def __getitem__(self, key: Any) -> Coefficient:
        wanted = _key(key)
        if wanted not in self._items:
            known = ", ".join(",".join(map(str, k)) for k in self._items)
            raise InputError("key", f"there is no coefficient {key!r}", known or "none at this order")
        return self._items[wanted]

    def __contains__(self, key: object) -> bool:
        try:
            return _key(key) in self._items
        # A key that is malformed stands in no row; ``in`` answers and raises nothing.
        except InputError:
            return False

    def get(self, key: Any, default: Any = None) -> Any:
        """The coefficient, or ``default`` where there is none."""
        known = key in self  # Mapping.get waits for a KeyError, and a malformed key is an InputError here
        return self[key] if known else default

    def __iter__(self) -> Iterator[Any]:
        return iter(k[0] if len(k) == 1 else k for k in self._items)

    def __len__(self) -> int:
        return len(self._items)

    def keyed(self) -> dict[Key, Coefficient]:
        """Exponents of the delta_i -> coefficient."""
        return dict(self._items)

    def named(self) -> dict[str, Coefficient]:
        """The coefficients by their keys as text, "k" or "k1,k2"."""
        return {",".join(map(str, k)): c for k, c in self._items.items()}

    def __eq__(self, other: object) -> bool:
        return isinstance(other, CoefficientRow) and self._items == other._items

    def __hash__(self) -> int:
        return hash(frozenset(self._items.items()))

    def _page(self) -> Page:
        rows = tuple((key, c, c.exact or "") for key, c in self.named().items())
        return Page(
            f"{len(self)} coefficients",
            ("correctly rounded digits, exact where a form is known",),
            ("power", "value", "exact"),
            rows,
        )

    def _table(self) -> dict[str, list[Any]]:
        return {"key": list(self.named())} | coefficient_columns(list(self.named().values()))

    def _formula(self) -> str:
        names = (
            (r"\delta",)
            if all(len(k) == 1 for k in self._items)
            else tuple(rf"\delta_{{{i}}}" for i in range(1, 1 + max(map(len, self._items), default=1)))
        )
        return sum_latex(self._items, names)

    def to_dict(self) -> dict[str, dict[str, str | None]]:
        """JSON-ready: keys "k" or "k1,k2"."""
        return {key: c.to_dict() for key, c in self.named().items()}

    def __repr__(self) -> str:
        shown = ", ".join(f"{','.join(map(str, k))}: {_brief(c)}" for k, c in list(self._items.items())[:6])
        return "{" + shown + (", ..." if len(self) > 6 else "") + "}"


def sum_at(row: list[tuple[Key, Any]], deltas: list[Any]) -> Any:
    """sum of c delta^key, in whatever the numbers are.

    >>> sum_at([((1, 0), 2), ((1, 2), 5)], [3, 10])
    1506
    """
    total: Any = 0
    for key, c in row:
        for d, n in zip(deltas, key):
            c = c * d**n if n else c
        total = total + c
    return total


def _brief(c: Coefficient) -> str:
    return rounded(c.value, SHOWN_DIGITS) if c.value is not None else str(c.exact)


def _key(key: Any) -> Key:
    parts = key.split(",") if isinstance(key, str) else key if isinstance(key, tuple) else (key,)
    return tuple(exact_integer(k, "key", 0, MAX_ORDER) for k in parts)
