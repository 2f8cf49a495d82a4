"""One time budget for a whole request: where it is asked for, what it stops, and that nothing runs past it silently."""

import argparse
import resource
import signal
import subprocess
import sys
import threading
from itertools import count

import pytest

from asymptotics.ask.registry import QUESTIONS
from asymptotics.costs import require_affordable
from asymptotics.errors import LimitError
from asymptotics.running import budget as module
from asymptotics.running import public
from asymptotics.running.budget import budget, require_seconds, seconds_left, tick
from asymptotics.shell import clock
from asymptotics.shell.asked import command_of
from asymptotics.shell.main import main

# Commands that may take long; the numbers are not used elsewhere in the tests, so that no cache answers.
LONG = [
    "expand --alpha sqrt(11) --order 9",
    "expand --alpha sqrt(11) --order 5 --gauge averaging",
    "expand --alpha 7 --order 23 --exact",
    "expand --alpha 6 --order 9 --exact",
    "expand --alpha 301/2 --order 3 --digits 3",
    "expand --law 1/5 --law 6/5 --law 11/5 --law 16/5 --order 4",
    "expand --alpha 17/13 --order 2 --bound",
    "half-swing --alpha sqrt(13) --order 9",
    "half-swing --alpha 17/11 --delta 1/3",
    "multiple-scales --law 1 --law 5 --order 21",
    "limit-cycle --law 1:-1 --law 1,4:1 --order 22",
    "limit-cycle --law 1:-1 --law 1,2:3 --order 0 --mu 17/19",
    "envelope --law 1/2:1/100 --law 3/2:1/5 --law sqrt(7):1/10 --time 4 --digits 5",
    "table smith2012.table1 --rows 40 --epsilon 2/7",
    "table normal-form --alpha 7/5,8/5 --rows 5",
    "motion --alpha 17/7 --damping 1/10 --x0 1 --time 30 --order 9",
    "motion --alpha 17/7 --damping 1/10 --x0 1 --time 60 --reference",
    "turning-points --alpha 17/7 --epsilon 1/10 --count 40",
    "turning-points --alpha 2 --epsilon 1/10 --count 40",
    "smith f --n 400",
]


@pytest.fixture
def ticking(monkeypatch):
    """A clock that goes one second further each time it is read; no alarm helps."""
    seconds = count()
    monkeypatch.setattr(module, "monotonic", lambda: float(next(seconds)))
    monkeypatch.setattr(public, "PERIOD", 3600.0)


@pytest.mark.parametrize("line", LONG)
def test_the_work_of_every_command_asks_for_the_time(line, ticking, capsys):
    assert main([*line.split(), "--max-seconds", "12"]) == 2
    assert "argument --max-seconds: " in capsys.readouterr().err


def test_every_command_that_may_take_long_has_a_budget():
    without = {"sweep"}  # it is resumed, and each point has its own budget
    for command in QUESTIONS:
        parser = argparse.ArgumentParser()
        command_of(command).configure(parser)
        assert ("--max-seconds" in parser.format_help()) == (command not in without), command


def test_one_deadline_for_all_passes(ticking):
    with budget(10), budget(100), pytest.raises(LimitError, match="10 s are over at pass 2"):
        for k in range(40):
            tick(f"pass {k // 4}")
    tick("without a budget nothing is over")


def test_the_inner_budget_counts_where_it_is_earlier(ticking):
    with budget(1000), budget(3), pytest.raises(LimitError, match="3 s are over at b"):
        for stage in ("a", "b", None, None):
            tick(stage)


def test_the_stages_are_reported():
    told = []
    with budget(60, told.append):
        tick("a")
        tick()
        with budget(600):  # does not count, and does not hide the progress
            tick("b")
    assert told == ["a", "a", "b"]


def test_an_estimate_of_twice_what_is_left_is_not_started(monkeypatch):
    monkeypatch.setattr(module, "monotonic", lambda: 100.0)
    require_seconds(1e9, "anything without a budget")
    assert seconds_left() == float("inf")
    with budget(7):
        assert seconds_left() == 7
        require_seconds(14, "just possible")
        with pytest.raises(LimitError, match="too much would take about 14 s, more than the 7 s allowed"):
            require_seconds(14.1, "too much")


def test_an_estimate_is_above_what_is_left_in_the_words_too(monkeypatch):
    now = [100.0]
    monkeypatch.setattr(module, "monotonic", lambda: now[0])
    with budget(0.5):
        now[0] += 0.4
        with pytest.raises(LimitError, match=r"would take about 0.3 s, more than the 0.1 s left of 0.5 \("):
            require_seconds(0.3, "it")
        now[0] += 1
        with pytest.raises(LimitError, match=r"would take about 0.02 s, more than the 0 s left of 0.5 \("):
            require_seconds(0.02, "it")
    with pytest.raises(LimitError, match=r"would take about 0.4 s \(accepted: work of at most 0.2 s\)"):
        require_affordable(0.4, 0.2, "order", "it")


def _options(seconds):
    return argparse.Namespace(max_seconds=seconds)


def test_the_alarm_stops_what_does_not_ask():
    before = signal.getsignal(signal.SIGALRM)
    with pytest.raises(LimitError, match="are over at the start"), clock.timed(_options("1/10")):
        for _ in count():
            pass
    assert signal.getsignal(signal.SIGALRM) == before
    assert signal.getitimer(signal.ITIMER_REAL) == (0, 0)


def test_the_alarm_rings_again_for_whoever_did_not_listen(monkeypatch):
    monkeypatch.setattr(public, "PERIOD", 0.01)
    caught = 0
    with pytest.raises(LimitError), clock.timed(_options("1/50")):
        while caught < 3:
            try:
                for _ in count():
                    pass
            except LimitError:
                caught += 1
        for _ in count():
            pass
    assert caught == 3


def test_beside_other_threads_the_ticks_alone_count():
    found = []

    def work():
        with pytest.raises(LimitError) as stopped, clock.timed(_options("1/100")):
            for k in count():
                tick(f"step {k}")
        found.append(stopped.value)

    thread = threading.Thread(target=work)
    thread.start()
    thread.join(timeout=60)
    assert found


@pytest.mark.slow
@pytest.mark.parametrize(
    "line",
    [
        "expand --alpha sqrt(2) --order 60",
        "expand --alpha sqrt(2) --order 200",
        "expand --alpha 401/2 --order 8",
        "expand --alpha 301 --order 12",
        "expand --law 1/2 --law 3/2 --law 2 --law 3 --order 6",
        "expand --law 1/2 --law 3/2 --law 2 --law 3 --order 3 --bound",
        "expand --alpha symbolic --order 4 --digits 300",
        "half-swing --alpha sqrt(2) --order 60",
        "envelope --law 0:0.01 --law 2:0.3 --time 40 --digits 600",
        "multiple-scales --law 1 --law 3 --order 16",
        "limit-cycle --law 1:-1 --law 1,2:1 --order 60 --mu 3",
        "table smith2012.table1 --rows 10000 --digits 1000",
        "motion --alpha 3/2 --damping 1/10 --x0 1 --time 1000 --order 12 --plot {folder}/x.svg",
        "turning-points --alpha 3/2 --epsilon 1 --count 100000 --digits 100",
    ],
)
def test_no_command_runs_twice_as_long_as_it_may(line, tmp_path):
    """A fast machine may answer within its two seconds; nobody takes four."""
    start_up = _seconds([sys.executable, "-m", "asymptotics.shell.main", "moment", "--p", "1/2"])
    arguments = [*line.format(folder=tmp_path).split(), "--max-seconds", "2"]
    assert _seconds([sys.executable, "-m", "asymptotics.shell.main", *arguments]) < 4 + start_up


def _seconds(command):
    """Process time of a command that answers or names its budget."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    assert done.returncode == 0 or (done.returncode == 2 and "--max-seconds" in done.stderr), done.stderr
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
