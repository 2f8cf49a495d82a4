"""Every public call has a time of its own and is alone when it computes: what has none is listed with its reason."""

import gc
import inspect
import signal
import sys
import threading
import time
import traceback
from itertools import count
from time import monotonic

import pytest

import asymptotics as asy
from asymptotics.errors import InputError, LimitError
from asymptotics.numbers.context import alone
from asymptotics.running import budget as module
from asymptotics.running import public
from asymptotics.running.budget import budget, seconds_left, tick
from asymptotics.testing import oracles
from tests.each import each
from tests.every_call import CALLS, parameters
from tests.present.every_type import types

QUICK = {  # public methods without a time, and why it is bounded by what they are given
    "doubles at the places they are given": {"__call__", "rhs"},
    "what is known, as text or data": {
        "to_dict", "to_json", "to_text", "to_csv", "to_csv_file", "to_latex", "to_parquet", "latex", "latex_shape",
        "to_dataframe", "save", "shape",
        "grade_in_words", "in_words", "text", "keyed", "named", "get", "keys", "items", "values", "with_notes",
        "rounded_to_error",
        "header", "table", "definitions", "shown_waves", "with_start_strength", "named_columns",
    },
    "hands its time on to what checks": {"check"},
    "what is known, of one row or one letter": {
        "axis", "beside", "c", "d", "errors", "law", "lost_digits", "physical", "row", "rows", "strengths",
        "time_text", "unit", "unit_of_loss", "with_unit",
    },
    "an interval, and one beside it": {"contains", "stretched", "widened"},
    "draws: what it computes has the time of ``sample``, and a page gives it five seconds": {"plot", "picture"},
    "one conversion of known digits": {"mpf", "interval", "sympy", "fraction", "ball", "number"},
    "a law or oscillator read, compared or put together": {
        "with_law", "from_terms", "require_pure", "require_dissipative", "plus", "read",
    },
    "balls for the package itself: one formula": {
        "omega_0", "length", "epsilons", "deltas", "to_si", "delta", "scaled_at", "enclosed",
    },
}  # fmt: skip
LOOKED_UP = {"paper", "statements"}  # texts, without a library: nothing computes
WITHOUT = {name for names in QUICK.values() for name in names}
ALSO = {"Oscillator.kappas", "MotionSamples.columns"}  # balls and samples; those of an envelope are computed


def functions():
    named = {n: getattr(asy, n) for n in asy.__all__ if inspect.isfunction(getattr(asy, n)) and n not in LOOKED_UP}
    checks = {n: f for n, f in vars(oracles).items() if n.startswith("check_")}
    return named | checks


def methods():
    found = {}
    for thing in types():
        for kind in thing.__mro__[:-1]:
            if not kind.__module__.startswith("asymptotics"):
                continue
            for name, made in vars(kind).items():
                if inspect.isfunction(made) and (name == "__call__" or not name.startswith("_")):
                    found[f"{kind.__name__}.{name}"] = made
    return found


def timed(function):
    parameter = inspect.signature(function).parameters.get("max_seconds")
    return parameter is not None and parameter.kind is parameter.KEYWORD_ONLY and hasattr(function, "__wrapped__")


@each("name", sorted(functions()))
def test_every_public_function_has_a_time(name):
    assert timed(functions()[name])


def test_every_public_method_has_a_time_or_a_reason():
    without = {name for name, made in methods().items() if not timed(made) and name not in ALSO}
    assert {name.partition(".")[2] for name in without} <= WITHOUT
    assert len(methods()) - len(without) > 30


@each("name", sorted({*CALLS} & functions().keys() - {"plot"}))
def test_a_time_that_is_none_is_refused_by_name(name):
    call = getattr(asy, name)
    usual = {p: None for p, about in parameters(call).items() if about.default is about.empty}
    for bad in (0, -1, "x", float("nan"), True, [], 10**7, "1e400"):
        with pytest.raises(InputError, match="argument max_seconds: "):  # before anything else is looked at
            call(**usual, max_seconds=bad)


OSC = asy.Oscillator({"17/7": "1/10"}, mass="3/2", stiffness=30, x0="1/5")
LONG = {  # what no command asks; the numbers are not used elsewhere in the tests, so that no cache answers
    "Reference.sample": lambda s: asy.reference(OSC).sample([30.0, 400.0], max_seconds=s),
    "Motion.bound": lambda s: asy.motion(OSC, order=3).bound(30, max_seconds=s),
    "Envelope.series": lambda s: asy.envelope({"19/7": "1/10"}).series(9, max_seconds=s),
}


@pytest.fixture
def ticking(monkeypatch):
    """A clock that goes one second further each time it is read; no alarm helps."""
    seconds = count()
    monkeypatch.setattr(module, "monotonic", lambda: float(next(seconds)))
    monkeypatch.setattr(public, "PERIOD", 3600.0)


@pytest.mark.parametrize("name", LONG)
def test_the_work_of_a_public_call_asks_for_the_time(name, ticking):
    with pytest.raises(LimitError, match="argument max_seconds: "):
        LONG[name](12)


def test_work_that_never_asks_is_stopped(monkeypatch):
    monkeypatch.setattr(public, "PERIOD", 0.01)

    @public.public
    def deaf(*, max_seconds=60):
        for _ in count():
            pass

    with pytest.raises(LimitError, match="are over"):
        deaf(max_seconds="1/20")
    assert signal.getsignal(signal.SIGALRM) is signal.SIG_DFL
    assert signal.getitimer(signal.ITIMER_REAL) == (0, 0)
    assert not alone.lock.locked()


def test_what_a_library_makes_of_the_alarm_is_still_a_matter_of_time(monkeypatch):
    monkeypatch.setattr(public, "PERIOD", 0.01)

    @public.public
    def muddled(*, max_seconds=60):
        try:
            for _ in count():
                pass
        except LimitError:
            raise TypeError("not understood") from None

    with pytest.raises(LimitError, match="are over"):
        muddled(max_seconds="1/20")
    with pytest.raises(ZeroDivisionError), public.limited(60):
        raise ZeroDivisionError


def test_an_alarm_of_somebody_else_is_left_alone():
    rung = []
    before = signal.signal(signal.SIGALRM, lambda *_: rung.append(1))
    try:
        signal.setitimer(signal.ITIMER_REAL, 0.05)
        asy.moment("1/2", max_seconds=5)
        end = time.monotonic() + 5
        while not rung and time.monotonic() < end:
            time.sleep(0.01)
        assert rung
    finally:
        signal.signal(signal.SIGALRM, before)


def test_a_call_inside_another_has_the_time_of_the_outer_one(monkeypatch):
    monkeypatch.setattr(public, "PERIOD", 3600.0)
    left = []

    @public.public
    def inner(*, max_seconds=60):
        left.append(seconds_left())

    @public.public
    def outer(*, max_seconds=60):
        inner(max_seconds=max_seconds)  # as it was given, or not

    with budget(1000):
        inner()
        inner(max_seconds=5)
        inner(max_seconds=60)  # the same number as the default, but asked for
        outer()
        outer(max_seconds=60)
    inner()
    outer()
    assert [5 < one <= 60 for one in left] == [False, False, True, False, True, True, True]
    assert left[0] > 900 and left[1] <= 5 and left[3] > 900


def test_who_waits_for_another_thread_asks_for_the_time():
    inside, done = threading.Event(), threading.Event()

    def hold():
        with alone:
            inside.set()
            done.wait(30)

    thread = threading.Thread(target=hold)
    thread.start()
    inside.wait(30)
    try:
        with pytest.raises(LimitError, match="wait for another thread"):
            asy.moment("1/2", max_seconds="1/10")
    finally:
        done.set()
        thread.join()
    assert asy.moment("1/2").value


@pytest.mark.filterwarnings("ignore::pytest.PytestUnraisableExceptionWarning")  # Python's, of a handler just changed
def test_the_alarm_does_not_leave_the_door_half_open(monkeypatch):
    """Ten thousand rings a second while the door is opened and closed: it is free, or ours, each time."""
    monkeypatch.setattr(public, "PERIOD", 1e-4)
    for _ in range(100):
        with pytest.raises(LimitError), public.limited(0.001):
            while True:
                with alone:
                    pass
        assert (alone.lock.locked(), alone.owner, alone.depth) == (False, 0, 0)


def test_an_alarm_that_comes_before_the_last_one_is_done_does_nothing(monkeypatch):
    """As on a machine so slow that a look at the stack takes longer than from one alarm to the next."""
    looks = []

    def slow_look(frame):
        looks.append(sum(1 for _ in traceback.walk_stack(frame)))
        end = monotonic() + 1e-3
        while monotonic() < end:
            pass
        return False

    monkeypatch.setattr(public, "PERIOD", 1e-4)
    monkeypatch.setattr(public, "is_lost", slow_look)
    with pytest.raises(LimitError), public.limited(0.15):
        while True:
            pass
    assert len(looks) > 5 and max(looks) < min(looks) + 10


def test_the_alarm_waits_until_the_collector_is_done(monkeypatch):
    """A callback of the collector would swallow the error, and print it."""
    monkeypatch.setattr(public, "PERIOD", 1e-3)
    monkeypatch.setattr(sys, "unraisablehook", lambda lost: heard.append(lost.exc_type))
    heard = []

    def slow(phase, info):
        end = monotonic() + 0.02
        while monotonic() < end:
            pass

    gc.freeze()  # all that other tests have left would be searched, for a second
    gc.callbacks.append(slow)
    try:
        with pytest.raises(LimitError), public.limited(0.001):
            gc.collect()
            while True:
                pass
    finally:
        gc.callbacks.remove(slow)
    assert heard == []


def test_a_library_is_imported_whole_before_the_alarm_is_heard(tmp_path, monkeypatch):
    """Failed before: pandas, stopped on the way, had no attribute 'plotting' for the rest of the process."""
    slow = "from time import monotonic\nend = monotonic() + 0.3\nwhile monotonic() < end: pass\nwhole = True\n"
    (tmp_path / "a_slow_library.py").write_text(slow)
    monkeypatch.syspath_prepend(tmp_path)
    monkeypatch.setattr(public, "PERIOD", 0.01)
    with pytest.raises(LimitError), public.limited(0.05):
        import a_slow_library  # noqa: PLC0415

        while True:
            pass
    assert a_slow_library.whole


def test_ticks_inside_a_public_call_count_down():
    with budget(0), pytest.raises(LimitError):
        tick()
