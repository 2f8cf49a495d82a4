"""The mark of a caller's own function: what it computes is filed under its code, so that a corrected one is computed.

The mark of the library (``made_by.mark``) covers the code of the library only.  Of a function from elsewhere the code
counts: its own, that of the functions of its module that it calls, its defaults and what it closes over.  A version
that the caller gives stands for all of it; what cannot be seen needs one.

>>> caller_mark(print), caller_mark(caller_mark), caller_mark(print, "1") == caller_mark(input, "1")
('...', '', True)
"""

import hashlib
from collections.abc import Callable
from fractions import Fraction
from functools import partial
from types import BuiltinFunctionType, CodeType, FunctionType, ModuleType
from typing import Any

from asymptotics.errors import InputError
from asymptotics.made_by import PACKAGES

_PLAIN = (str, bytes, int, float, complex, bool, type(None), Fraction)


def caller_mark(task: Callable[..., Any], version: str | None = None) -> str:
    """Sixteen hexadecimal digits for a function from elsewhere; "" for one of this library, and for the version "".

    InputError where the code, or what it uses, cannot be seen.
    """
    inner: Any = task
    while isinstance(inner, partial):
        inner = inner.func
    if version == "" or (version is None and str(getattr(inner, "__module__", "")).partition(".")[0] in PACKAGES):
        return ""
    said = f"version {version}" if version is not None else _code_of(task, set())
    return hashlib.sha256(said.encode()).hexdigest()[:16]


def _code_of(value: Any, met: set[int]) -> str:
    """A text that is another one for other code, and the same in every process."""
    if isinstance(value, int) and not isinstance(value, bool):
        return hex(value)  # of any length: Python prints no decimal of more than 4300 digits
    if isinstance(value, _PLAIN):
        return repr(value)
    if isinstance(value, tuple | list):
        return f"[{', '.join(_code_of(item, met) for item in value)}]"
    if isinstance(value, frozenset | set):  # whose order is another one in each process
        return f"{{{', '.join(sorted(_code_of(item, met) for item in value))}}}"
    if isinstance(value, dict):
        return f"{{{', '.join(f'{_code_of(k, met)}: {_code_of(v, met)}' for k, v in value.items())}}}"
    if isinstance(value, partial):
        return f"partial({_code_of(value.func, met)}, {_code_of(value.args, met)}, {_code_of(value.keywords, met)})"
    if isinstance(value, CodeType):
        return f"code({value.co_code.hex()}, {value.co_names}, {_code_of(value.co_consts, met)})"
    if isinstance(value, ModuleType):
        return f"module {value.__name__}"
    if isinstance(value, FunctionType):
        return _function(value, met)
    if isinstance(value, type | BuiltinFunctionType):
        return f"{value.__module__}.{value.__qualname__}"
    if hasattr(value, "tolist"):  # an array, whose text may be cut short
        return f"{value.dtype} {value.tolist()!r}"
    said = repr(value)  # an oscillator
    if " at 0x" in said:  # where it lies, and not what it is
        reason = f"it uses a {type(value).__name__}, which cannot be seen"
        raise InputError("task", reason, "a function of plain values, or version=")
    return said


def _function(function: FunctionType, met: set[int]) -> str:
    if id(function) in met:  # it calls itself
        return "again"
    met.add(id(function))
    parts = [_code_of(part, met) for part in (function.__code__, function.__defaults__, function.__kwdefaults__)]
    parts += [_code_of(cell.cell_contents, met) for cell in function.__closure__ or ()]
    root = function.__module__
    for name in _names(function.__code__):
        if name not in function.__globals__:  # an attribute, or a word of Python
            continue
        used = function.__globals__[name]
        # A function from elsewhere is known by its name; of what the function's own module has, the content counts.
        elsewhere = isinstance(used, FunctionType) and used.__module__ != root
        parts.append(f"{name}: {used.__module__ if elsewhere else _code_of(used, met)}")
    return f"function({', '.join(parts)})"


def _names(code: CodeType) -> list[str]:
    """The names that a function and those inside it look up."""
    inner = [name for part in code.co_consts if isinstance(part, CodeType) for name in _names(part)]
    return sorted({*code.co_names, *inner})
