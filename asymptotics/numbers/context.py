"""The one door to what is global in a process: the precision of FLINT and of mpmath, the length of FLINT's series.

FLINT has one precision and one cap of power series for the whole process, whatever thread asks.  A thread that changes
them under another's hands makes its balls wider and cuts its exact series short, without a word.  So whoever sets them
is alone until they are set back: ``ctx.workprec`` and ``ctx.workcap`` (and what ``numbers.decimal_context`` has for
mpmath) hold one re-entrant lock, a result that is kept is computed inside it (``lru_cache``, ``cached_property``, in
place of those of ``functools``), and a public call holds it from beginning to end (``running.public``).  Nothing else
in the project sets a precision: a test walks through its syntax trees.

>>> from flint import arb
>>> with ctx.workprec(200):
...     ctx.prec, arb(2).sqrt().rad() < 1e-55
(200, True)
>>> ctx.prec
53

A thread that waits asks for its time (``budget.tick``).  A process that is forked while another thread is inside starts
with a door of its own and the usual precision.
"""

import functools
import os
from collections.abc import Callable
from threading import Lock, get_ident
from types import TracebackType
from typing import Any, Generic, ParamSpec, TypeVar, overload

import flint

from asymptotics.running.budget import tick

P = ParamSpec("P")
T = TypeVar("T")
# Longer would delay the refusal of a thread whose time is over, shorter would only wake it more often.
_PATIENCE = 0.1  # seconds between two looks at the time of a thread that waits


class _Alone:
    """A re-entrant lock whose holder is the one thread that computes."""

    def __init__(self) -> None:
        # What a forked child sets back; ``decimal_context`` adds mpmath's, so that nobody loads it who needs none.
        self.guarded: list[tuple[Any, str]] = [(flint.ctx, "prec"), (flint.ctx, "cap")]
        self.free()

    def free(self) -> None:
        """Nobody is inside any more, whoever was."""
        # A plain lock beside its owner and its depth: ``forked`` has to ask who holds it, which an RLock does not tell.
        self.lock, self.owner, self.depth = Lock(), 0, 0
        self.usual: list[int] = []

    def __enter__(self) -> None:
        me = get_ident()
        if self.owner != me:
            while not self.lock.acquire(timeout=_PATIENCE):
                tick("the wait for another thread, which computes")
            # The values before the outermost setting: where a child of this process goes back to. Before the owner is
            # known, so that whoever sees one sees his values too.
            self.usual = [getattr(owner, name) for owner, name in self.guarded]
            self.owner = me
        self.depth += 1

    def __exit__(self, *_: object) -> None:
        self.depth -= 1
        if not self.depth:
            self.owner = 0
            self.lock.release()

    def forked(self) -> None:
        """In the child: the thread that forked goes on where it was; a lock that another one held is lost with it."""
        if self.owner == get_ident():
            return
        if self.owner:
            for (owner, name), value in zip(self.guarded, self.usual):
                setattr(owner, name, value)
        # Whatever ``locked`` says: another thread may have taken the lock and not have come to say so, or to be its
        # owner, when this process was forked; it is not here to give it back.
        self.free()


alone = _Alone()
"""``with alone:`` no other thread of the project changes a precision."""
if hasattr(os, "register_at_fork"):
    os.register_at_fork(after_in_child=alone.forked)


class Setting:
    """One global value, set for a while."""

    def __init__(self, owner: Any, name: str, value: int) -> None:
        self.owner, self.name, self.value = owner, name, value

    def __enter__(self) -> None:
        # First alone, then read: what another thread has set for a while is not what is to be set back.
        alone.__enter__()
        self.before = getattr(self.owner, self.name)
        try:
            setattr(self.owner, self.name, self.value)
        # A value that FLINT refuses, or an alarm: who has set nothing must not keep the others out.
        except BaseException:
            alone.__exit__()
            raise

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        setattr(self.owner, self.name, self.before)
        alone.__exit__()


DOORS = (_Alone, Setting)
"""What is opened and closed: an alarm waits until that is done."""


class _Context:
    """FLINT's context, as far as the project uses it: to read, and to set for a while, alone."""

    @property
    def prec(self) -> int:
        """The bits of a ball's middle."""
        return int(flint.ctx.prec)

    @property
    def cap(self) -> int:
        """The terms that a power series keeps."""
        return int(flint.ctx.cap)

    def workprec(self, bits: int) -> Setting:
        """``with ctx.workprec(bits):`` balls of that many bits."""
        return Setting(flint.ctx, "prec", bits)

    def workcap(self, terms: int) -> Setting:
        """``with ctx.workcap(terms):`` power series of that many terms."""
        return Setting(flint.ctx, "cap", terms)


ctx = _Context()


def inside(function: Callable[P, T]) -> Callable[P, T]:
    """The function, alone from its first line to its last."""

    @functools.wraps(function)
    def call(*args: P.args, **kwargs: P.kwargs) -> T:
        with alone:
            return function(*args, **kwargs)

    return call


def lru_cache(maxsize: int | None) -> Callable[[Callable[..., T]], "functools._lru_cache_wrapper[T]"]:
    """``functools.lru_cache``, filled inside the door."""
    # The look-up takes no lock. Two threads may make the same value one after the other, which costs time and no more.
    return lambda function: functools.lru_cache(maxsize)(inside(function))


def cache(function: Callable[..., T]) -> "functools._lru_cache_wrapper[T]":
    """``functools.cache``, filled inside the door."""
    return functools.cache(inside(function))


class cached_property(Generic[T]):  # noqa: N801 (a decorator, as in functools)
    """``functools.cached_property``, filled inside the door and with no other lock (Python 3.11 has one of its own)."""

    def __init__(self, function: Callable[[Any], T]) -> None:
        self.function, self.__doc__ = function, function.__doc__

    def __set_name__(self, owner: type, name: str) -> None:
        self.name = name

    @overload
    def __get__(self, instance: None, owner: type | None = None) -> "cached_property[T]": ...
    @overload
    def __get__(self, instance: object, owner: type | None = None) -> T: ...
    def __get__(self, instance: object | None, owner: type | None = None) -> "cached_property[T] | T":
        if instance is None:
            return self
        # Python finds a kept value before it asks here (there is no
        # ``__set__``); another thread may have made it meanwhile.
        with alone:
            kept = instance.__dict__
            if self.name not in kept:
                kept[self.name] = self.function(instance)
            found: T = kept[self.name]
            return found
