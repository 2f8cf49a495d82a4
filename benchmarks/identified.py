"""Evidence for ``identify``: decays of a known law (``decays``), the verdicts, and how often they are right, by class.

What is counted: records with an answer; 95 % intervals of the true law's strengths that hold the truth; records in
which the true law is among the consistent ones; records with another law called identified, and with laws that the
limit of work left untried.  The seeds of the printed table are used for nothing else.  ``size`` is the number of
records, which go round the classes.

``--store FILE`` keeps one line of JSON for each record as soon as it is judged: an interrupted run goes on where it was
(records of the same seed and code; what other code judged is left alone).
"""

import json
from collections.abc import Iterable
from dataclasses import asdict, dataclass
from pathlib import Path
from time import process_time
from typing import Any

import numpy as np

import asymptotics as asy
from asymptotics.decays.identification.judging.judgement import rivals
from asymptotics.errors import InputError, LimitError
from asymptotics.made_by import mark
from benchmarks.decays import CLASSES, SEED, Decay, decay
from benchmarks.table import Table, seconds_text

SIZE, PATIENCE = 240, 600
"""Seconds for one record: more than it needs on a machine that is not idle, so that no verdict depends on the load."""
_HEAD = (
    "class", "records", "answered", "intervals", "covered", "law consistent", "identified", "wrongly", "untried",
    "CPU s",
)  # fmt: skip


@dataclass
class Counts:
    """What was found in the records of one class; ``untried``: with laws that the limit of work left; ``seconds``:
    processor time of each."""

    records: int = 0
    answered: int = 0
    intervals: int = 0
    covered: int = 0
    consistent: int = 0
    identified: int = 0
    wrongly: int = 0
    untried: int = 0
    seconds: tuple[float, ...] = ()

    def add(self, made: Decay, **asked: Any) -> str:
        """One record more; what is remarkable about its answer, in a few words."""
        self.records += 1
        start = process_time()
        try:
            answer = asy.identify(made.data, **made.said, **asked)
        except (InputError, LimitError) as error:
            return f"refused: {error}"
        finally:
            self.seconds = (*self.seconds, process_time() - start)
        self.answered += 1
        law = answer.law(made.law).law
        pairs = list(zip((*law.epsilon, *law.springs), made.strengths))
        held = [interval.contains(true) for interval, true in pairs]
        named = [str(other.candidate) for other in rivals([entry.law for entry in answer.laws])[0]]
        found = answer.verdict.kind == "identified"
        right, wrong = found and named == [made.law], found and named != [made.law]
        self.intervals += len(made.strengths)
        self.covered += sum(held)
        self.consistent += law.verdict == "consistent"
        self.identified += right
        self.wrongly += wrong
        self.untried += any(entry.law.untried for entry in answer.laws)
        amiss = wrong or law.verdict != "consistent"
        said = [f"{answer.verdict.text[:150]}; {made.law}: {law.verdict} {law.reason[:120]}"] if amiss else []
        said += [f"missed {made.strengths} by {law.epsilon}{law.springs}"] if len(pairs) > sum(held) else []
        return "; ".join(said)

    def row(self, name: str) -> tuple[str, ...]:
        """One line of the table: shares of what was answered, the median and the ninth decile of the time."""
        times = [seconds_text(float(np.quantile(self.seconds, q))) for q in (0.5, 0.9)] if self.seconds else ["-", "-"]
        shares = (_share(n, self.answered) for n in (self.consistent, self.identified, self.wrongly, self.untried))
        return (
            name, str(self.records), str(self.answered), str(self.intervals), _share(self.covered, self.intervals),
            *shares, " / ".join(times),
        )  # fmt: skip


def _share(part: int, whole: int) -> str:
    return f"{100 * part / whole:.1f} %" if whole else "-"


def total(counts: Iterable[Counts]) -> Counts:
    """All classes together."""
    whole = Counts()
    for c in counts:
        for name in asdict(c):
            setattr(whole, name, getattr(whole, name) + getattr(c, name))
    return whole


def run(size: int = SIZE, seed: int = SEED, store: Path | None = None) -> Table:
    """``size`` records, every default candidate, one after the other; those in ``store`` are not judged again."""
    known = {} if store is None else stored(store, seed)
    found: dict[str, list[Counts]] = {kind: [] for kind in CLASSES[:size]}
    for number in range(size):
        kind, index = CLASSES[number % len(CLASSES)], number // len(CLASSES)
        if (kind, index) not in known:
            one = Counts()
            said = one.add(decay(kind, index, seed), max_seconds=PATIENCE)
            known[kind, index] = one
            if store is not None:
                line = {"class": kind, "index": index, "seed": seed, "code": mark(), "said": said, **asdict(one)}
                with store.open("a", encoding="utf-8") as stream:
                    stream.write(json.dumps(line) + "\n")
        found[kind].append(known[kind, index])
    rows = [total(counts).row(kind) for kind, counts in found.items()]
    everything = total(c for counts in found.values() for c in counts)
    return Table("identify on decays of a known law", _HEAD, (*rows, everything.row("all")))


def stored(store: Path, seed: int) -> dict[tuple[str, int], Counts]:
    """The records that this code has judged, by class and index."""
    found = {}
    for text in store.read_text(encoding="utf-8").splitlines() if store.exists() else []:
        line = json.loads(text)
        if (line["seed"], line["code"]) == (seed, mark()):
            counts = {name: line[name] for name in asdict(Counts())}
            found[line["class"], line["index"]] = Counts(**counts | {"seconds": tuple(counts["seconds"])})
    return found
