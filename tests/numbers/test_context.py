"""Threads: precision and series cap of FLINT are the process's, and no result depends on who else is computing."""

import ast
import os
import sys
import threading
import time
from contextlib import suppress
from pathlib import Path

import mpmath
import pytest
from flint import ctx as flint_ctx

import asymptotics as asy
from asymptotics.numbers.context import alone, ctx
from asymptotics.numbers.decimal_context import intervals, workdps
from asymptotics.running.budget import budget
from asymptotics.turning.quadratic_series import abel_coefficients, half_period_series, map_series
from tests.each import each
from tests.sources import nodes

ROOT = Path(__file__).parents[2]


PATIENCE = 30  # seconds


@pytest.fixture
def racing():
    """Threads take turns a hundred thousand times a second."""
    before = sys.getswitchinterval()
    sys.setswitchinterval(1e-6)
    yield
    sys.setswitchinterval(before)


def raced(jobs, seconds=1.0):
    """Each job in a thread of its own, again and again; what came out wrong, and how often any came out at all."""
    expected, wrong, runs, begin = [job() for job in jobs], [], [], time.monotonic()

    def is_over():
        # A machine that is not idle needs longer until each has had its second turn.
        passed = time.monotonic() - begin
        return wrong or passed > PATIENCE or (passed > seconds and all(runs.count(job) > 1 for job in jobs))

    def work(job, right):
        while not is_over():
            try:
                found = job()
            except Exception as error:  # noqa: BLE001 (an error is a wrong result too)
                found = error
            runs.append(job)
            if found != right:
                wrong.append((found, right))

    threads = [threading.Thread(target=work, args=pair, daemon=True) for pair in zip(jobs, expected, strict=True)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join(timeout=2 * PATIENCE)
    assert wrong or not any(thread.is_alive() for thread in threads)
    assert wrong or all(runs.count(job) > 1 for job in jobs)
    return wrong


def test_exact_series_in_threads(racing):
    jobs = [lambda n=n, f=f: f(n) for n in (3, 9, 14) for f in (map_series, half_period_series, abel_coefficients)]
    assert raced(jobs) == []
    assert (flint_ctx.prec, flint_ctx.cap) == (53, 10)


def test_public_calls_in_threads(racing):
    """Low and high precision, exact and certified, texts and doubles: what comes out is what comes out alone."""
    osc = asy.Oscillator({2: "1/10"}, mass="3/2", stiffness=30, x0="1/5")
    motion, slow = asy.motion(osc, order=2), asy.envelope(osc)
    jobs = [
        lambda: asy.turning_points({2: 1}, 3, digits=40).points, lambda: asy.moment("5/2", digits=200).value,
        lambda: motion.at("1/3", digits=9).x, lambda: slow.amplitude("1/3", digits=12),
        lambda: float(osc.omega_0().mid()), lambda: str(osc) + repr(osc.dimensionless), lambda: slow.slow("1/50"),
        lambda: asy.expand(2, order=2).Omega[2].interval(), lambda: asy.expand(2, order=2).Omega[2].mpf(),
    ]  # fmt: skip
    assert raced(jobs) == []


def test_intervals_and_decimals_of_mpmath_are_set_back():
    before = mpmath.mp.prec, mpmath.iv.prec
    with workdps(70), intervals(300):
        assert (mpmath.mp.dps, mpmath.iv.prec) == (70, 300)
    assert (mpmath.mp.prec, mpmath.iv.prec) == before


def test_a_bad_precision_leaves_the_door_free():
    for bad in (0, -5, "x", None):
        with pytest.raises((ValueError, TypeError)), ctx.workprec(bad):
            pass
    assert (alone.lock.locked(), flint_ctx.prec) == (False, 53)


def held(action):
    """Do something while another thread is inside, at 500 bits."""
    inside, done = threading.Event(), threading.Event()

    def hold():
        with ctx.workprec(500):
            inside.set()
            done.wait(60)

    thread = threading.Thread(target=hold)
    thread.start()
    inside.wait(60)
    try:
        return action()
    finally:
        done.set()
        thread.join()


@pytest.mark.skipif(not hasattr(os, "fork"), reason="no fork on this system")
@pytest.mark.filterwarnings("ignore:This process .* is multi-threaded:DeprecationWarning")
def test_a_fork_while_another_thread_is_inside_is_no_deadlock():
    def child():
        pid = os.fork()
        if not pid:
            right = flint_ctx.prec == 53 and map_series(3)[3] == map_series(3)[3] and asy.moment(2).value[:3] == "0.5"
            os._exit(0 if right else 1)
        end = time.monotonic() + 60
        while time.monotonic() < end:
            ended, code = os.waitpid(pid, os.WNOHANG)
            if ended:
                return code
            time.sleep(0.01)
        os.kill(pid, 9)
        return "hangs"

    assert held(child) == 0
    with alone:  # and the thread that forks goes on where it was
        assert child() == 0


class TakenUnseen:
    """The lock of a child that was forked when another thread had taken it and had not come to say so."""

    def locked(self):
        return False

    def acquire(self, timeout):
        return False


def test_a_lock_that_was_taken_and_does_not_say_so_is_freed_in_the_child():
    door = type(alone)()
    door.lock = TakenUnseen()
    door.forked()
    with budget(5), door:
        assert door.owner == threading.get_ident()
        door.forked()  # the thread that forked is inside, and stays there
        assert door.depth == 1 and door.owner


@pytest.mark.skipif(not hasattr(os, "fork"), reason="no fork on this system")
@pytest.mark.filterwarnings("ignore:This process .* is multi-threaded:DeprecationWarning")
def test_children_forked_beside_computing_threads_compute(racing):
    over = threading.Event()

    def compute():
        while not over.is_set():
            asy.moment("5/2", digits=20)

    threads = [threading.Thread(target=compute, daemon=True) for _ in range(3)]
    for thread in threads:
        thread.start()
    try:
        children = []
        for _ in range(8):
            pid = os.fork()
            if not pid:
                with suppress(BaseException), budget(10):
                    os._exit(0 if asy.moment(2).value[:3] == "0.5" else 1)
                os._exit(2)
            children.append(pid)
        assert [os.waitstatus_to_exitcode(os.waitpid(pid, 0)[1]) for pid in children] == [0] * 8
    finally:
        over.set()
        for thread in threads:
            thread.join(60)


def test_nobody_is_let_in_while_another_thread_is_inside():
    assert held(lambda: alone.lock.acquire(timeout=0.05)) is False


# --- the door is the only one

FOLDERS = ("asymptotics", "derivations", "paper_checks", "benchmarks")
DOOR = {"asymptotics/numbers/context.py", "asymptotics/numbers/decimal_context.py"}
LOOKED_UP = {  # caches of what no precision enters: files, parsers, formulas as text, numbers of doubles
    "asymptotics/made_by.py", "asymptotics/ask/typed.py", "asymptotics/ask/question.py", "asymptotics/papers/lookup.py",
    "asymptotics/shell/main.py",
    "asymptotics/papers/derived.py", "asymptotics/papers/documented.py", "asymptotics/papers/stored.py",
    "asymptotics/present/mathml.py", "asymptotics/decays/identification/measuring/damped_cosine.py",
}  # fmt: skip
CACHES = {"cache", "lru_cache", "cached_property"}
SETS = {"prec", "cap", "dps"}
CHANGES = {"workprec", "workdps", "extraprec", "extradps", "workcap", "autoprec"}


def faults(parts, *, caches=True):
    """What sets a precision, or keeps a result, without the door."""
    found = []
    for node in parts:
        if isinstance(node, ast.ImportFrom):
            names = {alias.name for alias in node.names}
            found += ["FLINT's own context" for _ in names & {"ctx"} if node.module == "flint"]
            found += [f"mpmath's own {n}" for n in names & CHANGES if str(node.module).startswith("mpmath")]
            found += [f"functools.{n}" for n in names & CACHES if node.module == "functools" and caches]
        if isinstance(node, ast.Attribute):
            if isinstance(node.ctx, ast.Store) and node.attr in SETS and not _is_own(node):
                found.append(f"sets {ast.unparse(node)}")
            if node.attr in CHANGES and ast.unparse(node.value) != "ctx":
                found.append(f"calls {ast.unparse(node)}")
            of = getattr(node.value, "id", None)
            if (of, node.attr) == ("flint", "ctx") or caches and of == "functools" and node.attr in CACHES:
                found.append(ast.unparse(node))
        if isinstance(node, ast.With) and any("ctx.work" in ast.unparse(i.context_expr) for i in node.items):
            inner = [n for statement in node.body for n in ast.walk(statement)]
            found += ["hands out a value from inside" for n in inner if isinstance(n, ast.Yield | ast.YieldFrom)]
        if isinstance(node, ast.Call) and getattr(node.func, "id", None) == "setattr":
            found += ["setattr" for a in node.args[1:2] if getattr(a, "value", None) in SETS]
    return found


def _is_own(node):
    """``self.prec = ...`` of an object that is no context."""
    return isinstance(node.value, ast.Name) and node.value.id == "self"


def test_no_precision_is_set_and_nothing_kept_outside_the_door():
    for path in (p for f in FOLDERS for p in sorted((ROOT / f).rglob("*.py"))):
        name = str(path.relative_to(ROOT))
        caches = name.startswith("asymptotics/") and name not in LOOKED_UP
        assert name in DOOR or faults(nodes(path), caches=caches) == [], name


@each("text", [
    "from flint import ctx", "import flint\nflint.ctx.prec = 100", "ctx.prec = 9", "ctx.cap, x = 3, 4", "mp.dps = 30",
    "mpmath.mp.prec += 5", "with mpmath.workdps(30): pass", "from mpmath import workprec", "mp.extraprec(3)",
    "from functools import lru_cache", "import functools\n@functools.cache\ndef f(): pass", "setattr(c, 'prec', 3)",
    "def g():\n    with ctx.workprec(9):\n        yield 1", "mpmath.iv.prec = 80", "from mpmath import iv\niv.dps = 3",
])  # fmt: skip
def test_the_walk_finds_what_it_looks_for(text):
    assert faults(ast.walk(ast.parse(text)))


def test_harmless_code_passes_the_walk():
    fine = "with ctx.workprec(9): f(ctx.prec)\nwith workdps(3): pass\nself.prec = 4\nfrom x.context import lru_cache"
    assert faults(ast.walk(ast.parse(fine))) == []
