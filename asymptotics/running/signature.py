"""Signatures as people read them: types by their names, a union by that of its module.

>>> from asymptotics.curves.motions import motion
>>> import inspect
>>> inspect.signature(motion)
<Signature (law: LawLike, *, order: int = 3, gauge: str = 'turning-point', max_seconds: Number = 60) -> Motion>
"""

import inspect
from collections.abc import Mapping
from types import NoneType, UnionType
from typing import Any, TypeVar, Union, get_args, get_origin

T = TypeVar("T")


class Name(str):
    """The name of a type in a signature, which Python prints without quotes."""

    __slots__ = ()
    __repr__ = str.__str__


def readable(function: Any, hints: Mapping[str, Any] | None = None) -> inspect.Signature:
    """The signature of a function, types as text; ``hints``: other annotations of its parameters."""
    plain, hints = inspect.signature(function), hints or {}
    unions = {name: {*get_args(its)} for name, its in getattr(function, "__globals__", {}).items() if _is_union(its)}
    kept = [p.replace(annotation=_text(hints.get(n, p.annotation), unions)) for n, p in plain.parameters.items()]
    return plain.replace(parameters=kept, return_annotation=_text(plain.return_annotation, unions))


def named(function: T) -> T:
    """A function that shows its ``readable`` signature."""
    shown: Any = function
    shown.__signature__ = readable(function)
    return function


def _is_union(annotation: Any) -> bool:
    return isinstance(annotation, UnionType) or get_origin(annotation) is Union


def _text(annotation: Any, unions: Mapping[str, set[Any]]) -> Any:
    """An annotation as its module writes it."""
    if annotation in (inspect.Parameter.empty, None) or annotation is NoneType:
        return annotation if annotation is inspect.Parameter.empty else Name("None")
    if isinstance(annotation, str):
        return Name(annotation)
    members = get_args(annotation)
    if _is_union(annotation):
        named = max((n for n in unions if unions[n] <= {*members}), key=lambda n: len(unions[n]), default="")
        others = [str(_text(m, unions)) for m in members if m not in unions.get(named, ())]
        return Name(" | ".join([*filter(None, [named]), *others]))
    if isinstance(annotation, list):  # the arguments of a Callable
        return Name(f"[{', '.join(str(_text(a, unions)) for a in annotation)}]")
    name = getattr(annotation, "__name__", None) or str(annotation).rpartition(".")[2]
    return Name(
        f"{name}[{', '.join(str(_text(m, unions)) for m in members)}]"
        if members
        else "..."
        if annotation is ...
        else name
    )
