"""What was finished when work is cut short, by its time or by Ctrl-C: the error carries it, and ``done`` hands it over.

>>> rows = []
>>> try:
...     with keeping(lambda: tuple(rows)):
...         rows.append("row 1")
...         raise KeyboardInterrupt
... except KeyboardInterrupt as stop:
...     done(stop)
('row 1',)
>>> try:
...     with keeping(lambda: None), keeping(lambda: "rows of a step on the way"):
...         raise KeyboardInterrupt
... except KeyboardInterrupt as stop:
...     done(stop) is None
True
>>> try:
...     with changed(lambda found: found + ("and its unit",)), keeping(lambda: tuple(rows)):
...         try:
...             raise KeyboardInterrupt
...         except KeyboardInterrupt:
...             raise RuntimeError("what a library has made of it")
... except RuntimeError as stop:
...     done(stop)
('row 1', 'and its unit')
>>> try:
...     with changed(len, otherwise=lambda: "what was there before"):
...         raise KeyboardInterrupt
... except KeyboardInterrupt as stop:
...     done(stop)
'what was there before'
>>> done(ValueError()) is None
True

What is handed over is made when it is asked for: by then the time that was over is over for nobody.
"""

import gc
from collections.abc import Callable
from contextlib import AbstractContextManager, suppress
from types import FrameType, TracebackType
from typing import Any

# Twenty errors made of one another are more than libraries make; the count ends a chain that should close on itself.
_NAME, _DEPTH = "_rows_done", 20


def is_lost(frame: FrameType | None) -> bool:
    """Whether what is raised there is swallowed by the interpreter, and printed: in ``__del__``, or in what the
    collector of garbage calls when it starts and stops.

    >>> is_lost(None)
    False
    """
    # ``gc.callbacks`` are functions of Python, with code, or objects of C, without.
    collecting = {getattr(call, "__code__", None) for call in gc.callbacks}
    while frame is not None:
        if frame.f_code in collecting or frame.f_code.co_name == "__del__":
            return True
        frame = frame.f_back
    return False


def done(error: BaseException) -> Any:
    """The rows that were finished before ``error``, in the form of the result that was asked for; None without any."""
    made = _maker(error)
    return None if made is None else made()


def _maker(error: BaseException | None) -> Callable[[], Any] | None:
    """What the error carries, or one that it came from: a library may have made it of another."""
    for _ in range(_DEPTH):
        if error is None:
            return None
        made: Callable[[], Any] | None = getattr(error, _NAME, None)
        if made is not None:
            return made
        error = error.__cause__ or error.__context__
    return None


class keeping(AbstractContextManager[Any]):  # noqa: N801 (used as a context manager, as ``suppress`` is)
    """``with keeping(rows):`` an error from inside carries ``rows()``: what an inner call has kept are no rows here."""

    def __init__(self, rows: Callable[[], Any]) -> None:
        self.rows = rows

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        if error is not None:
            # An error of C or with slots takes no attribute: then nothing is handed over, and the error itself goes on.
            with suppress(AttributeError, TypeError):
                setattr(error, _NAME, self.rows)


class changed(AbstractContextManager[Any]):  # noqa: N801 (as above)
    """``with changed(into):`` what an error from inside carries is turned ``into`` the result of this place.

    ``otherwise()`` is handed over where the error carries nothing: what was done before this place was reached.
    """

    def __init__(self, into: Callable[[Any], Any], otherwise: Callable[[], Any] | None = None) -> None:
        self.into, self.otherwise = into, otherwise

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        made = None if error is None else _maker(error)
        if error is None or (made is None and self.otherwise is None):
            return

        def again() -> Any:
            found = None if made is None else made()
            if found is None:
                return None if self.otherwise is None else self.otherwise()
            return self.into(found)

        with suppress(AttributeError, TypeError):
            setattr(error, _NAME, again)
