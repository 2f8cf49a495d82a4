"""The ledger of trust, ``docs/trust.md``: what each answer rests on, found by asking; ``python -m tests.ledger``.

Every command is asked, as the shell asks it, for a law of each class; a cell is what it answers: with a certificate,
certified, exact, an estimate, refused, or - where the command has no such option.
"""

import shlex
import tempfile
from functools import cache
from pathlib import Path

from asymptotics.ask.answers import Request
from asymptotics.ask.registry import QUESTIONS, loaded
from asymptotics.ask.typed import Answered, parser_of
from asymptotics.errors import InputError, UndecidedError
from tests.worlds import WORLDS

PAGE = Path(__file__).parents[1] / "docs" / "trust.md"
CERTIFICATE, CERTIFIED, EXACT, BOUND, ESTIMATE, REFUSED, NONE = (
    "**certificate**", "certified", "exact", "estimate, bound proved", "estimate", "refused", "-",
)  # fmt: skip
TOLD = (
    "dry friction", "linear", "quadratic", "another rational power", "an irrational power", "a sum of powers",
    "a sum with dry friction", "a start in motion", "air and a spring x^3", "a pendulum in air",
    "a loss that knows the place", "gains", "gains and losses",
)  # fmt: skip
LAWS = {name: WORLDS[name].words for name in TOLD}
SINGLE = {"dry friction": "0", "linear": "1", "quadratic": "2", "another rational power": "3/2"}
GROUPS = {
    "Digits of the motion": (
        "turning-points --count 3 --digits 8 --times",
        "motion --reference --time 5 --digits 8",
        "table turning-points --rows 3 --digits 8",
        "compare FILE --digits 9",
    ),
    "Approximations": (
        "motion --order 2 --time 5",
        "motion --order 2 --time 5 --bound",
        "solution --order 2",
        "envelope --digits 8",
        "damping --digits 6",
    ),
    "Coefficients": (
        "expand --order 2 --digits 8",
        "half-swing --order 2 --digits 8",
        "multiple-scales --order 2",
        "limit-cycle --order 2 --digits 6",
        "stokes --digits 5",
    ),
}
BESIDES = {"motion --reference": "the balls of `turning-points`; closed forms: exact identities, evaluated in balls"}
"""What another way of asking a command rests on."""


def _takes_a_law(name: str) -> bool:
    return any(asked.kind.options for asked in loaded(name).asked)


def _without_its_law(name: str) -> str:
    """The example of a question without the law, of which it is asked for every class."""
    words, law = loaded(name).example.split(), {f"--{o.name}" for a in loaded(name).asked for o in a.kind.options}
    kept = [w for before, w in zip(["", *words], words) if w not in law and before not in law]
    return " ".join([name, *kept])


def groups() -> dict[str, tuple[str, ...]]:
    """The columns of each table: those of GROUPS, and among the approximations every other question with a law."""
    named = {words.split()[0] for columns in GROUPS.values() for words in columns}
    others = [
        name for name in QUESTIONS if name not in named and _takes_a_law(name) and "{" not in loaded(name).example
    ]
    return {**GROUPS, "Approximations": (*GROUPS["Approximations"], *map(_without_its_law, others))}


def rows_of_rests() -> list[str]:
    """What each command rests on, in the words of its question."""
    asked = dict.fromkeys(words.split()[0] for columns in groups().values() for words in columns)
    rows = [(f"`{name}`", loaded(name).rests) for name in asked] + [(f"`{words}`", r) for words, r in BESIDES.items()]
    rows += [(f"`{name}`", loaded(name).rests) for name in QUESTIONS if name not in asked]
    return [f"| {name} | {rests} |" for name, rests in rows]


@cache
def _file() -> str:
    path = Path(tempfile.mkdtemp()) / "mine.csv"
    path.write_text("n,x\n1,-0.8\n")
    return str(path)


def asked(words: str) -> Answered | None:
    """The request, as the shell asks it; None where the command has no such option."""
    name, *rest = shlex.split(words.replace("FILE", _file()))
    question = loaded(name)
    known = {option.name for option in question.options}
    if any(word.startswith("--") and word[2:] not in known for word in rest):
        return None
    options = parser_of(name).parse_args(rest)
    request = Request(question.of_options(options), options)
    question.offers.typed(request)
    of_shell = question.offers.of_shell
    found = question.function(**request.values) if of_shell is None else of_shell(request)
    return Answered(question, request, found)


def cell(words: str) -> str:
    """What the answer to a request rests on."""
    try:
        answer = asked(words)
        if answer is None:
            return NONE
        return CERTIFICATE if _has_certificate(answer) else _word(answer)
    except (InputError, UndecidedError):
        return REFUSED


def _has_certificate(answer: Answered) -> bool:
    make = answer.question.offers.certificate
    try:
        return make is not None and bool(make(answer.found, answer.request).proved)
    except InputError:
        return False


def _word(answer: Answered) -> str:
    data = answer.data
    if data.get("bound") is not None:
        return BOUND
    if data.get("arithmetic") == "exact" or (answer.question.name == "multiple-scales"):
        return EXACT
    return CERTIFIED if answer.certified else ESTIMATE


def _of_law(words: str, name: str) -> str:
    if not words.startswith("stokes"):
        return cell(f"{words} {LAWS[name]}")
    return cell(f"{words} --alpha {SINGLE[name]}") if name in SINGLE else NONE


def row(columns: tuple[str, ...], name: str) -> str:
    """What each request answers for a law."""
    return f"| {name} | {' | '.join(_of_law(words, name) for words in columns)} |"


def tables() -> str:
    """All tables of the page."""
    lines: list[str] = []
    for title, columns in groups().items():
        heads = [words.partition(" --digits")[0].removesuffix(" FILE") for words in columns]
        lines += [
            f"## {title}",
            "",
            f"| motion | {' | '.join(f'`{h}`' for h in heads)} |",
            "|---" * (len(heads) + 1) + "|",
        ]
        lines += [row(columns, name) for name in LAWS]
        lines.append("")
    lines += ["## What they rest on, where there is no certificate", "", "| command | rests on |", "|---|---|"]
    return "\n".join([*lines, *rows_of_rests()])


def page() -> str:
    """The whole page."""
    head, _, rest = PAGE.read_text(encoding="utf-8").partition("<!-- ledger -->\n")
    return f"{head}<!-- ledger -->\n{tables()}\n<!-- end of ledger -->{rest.partition('<!-- end of ledger -->')[2]}"


if __name__ == "__main__":
    PAGE.write_text(page(), encoding="utf-8")
