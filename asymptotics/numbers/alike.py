"""When two results are the same: where their fields are, arrays element by element and balls by middle and radius.

Balls and arrays have another ``==``: that of a ball is "certainly equal", which is false of a ball and its own copy,
and that of an array is an array.

>>> import numpy as np
>>> key(np.array([1.0, np.nan])) == key(np.array([1.0, np.nan])), key(arb(2).sqrt()) == key(arb(2).sqrt())
(True, True)
>>> key(np.array([1.0])) == key(np.array([2.0])), key(arb(2).sqrt()) == key(arb(2))
(False, False)
"""

from collections.abc import Hashable, Mapping
from dataclasses import fields, is_dataclass
from typing import Any

import numpy as np
from flint import acb, arb


def key(value: Any) -> Hashable:
    """The value as something that is equal where the value is the same, and has a hash."""
    if isinstance(value, np.ndarray):
        # 0.0 is added to make -0.0 the 0.0 that it equals.
        plain = value + 0.0 if value.dtype.kind in "fc" else value
        return value.shape, value.dtype.str, tuple(value.ravel()) if value.dtype.hasobject else plain.tobytes()
    if isinstance(value, arb):
        # A ball that is not finite has no such parts; its text tells one from another.
        parts = (value.mid(), value.rad())
        return tuple(tuple(map(int, x.man_exp())) for x in parts) if value.is_finite() else str(value)
    if isinstance(value, acb):
        return key(value.real), key(value.imag)
    if isinstance(value, list | tuple):
        return tuple(map(key, value))
    if isinstance(value, Mapping):
        return frozenset((name, key(part)) for name, part in value.items())
    if is_dataclass(value) and not isinstance(value, type):
        return (type(value), *(key(getattr(value, f.name)) for f in fields(value) if f.compare))
    return value  # type: ignore[no-any-return]


class Alike:
    """A dataclass, declared with ``eq=False``, that is equal to another where its compared fields are the same."""

    def __eq__(self, other: object) -> bool:
        return key(self) == key(other) if type(other) is type(self) else NotImplemented

    def __hash__(self) -> int:
        return hash(key(self))
