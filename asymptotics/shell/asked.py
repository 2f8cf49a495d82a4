"""A question as a command of the shell: its options declared, its answer made of the parts that it offers."""

import argparse
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Any, NoReturn

import asymptotics
from asymptotics.ask.answers import Part, Request
from asymptotics.ask.moving import without_units
from asymptotics.ask.page import page_of
from asymptotics.ask.question import Question
from asymptotics.ask.registry import loaded
from asymptotics.errors import InputError
from asymptotics.present.files import require_different
from asymptotics.running.cut_short import changed
from asymptotics.shell.answer import Answer, shortened
from asymptotics.shell.files import FILES, Makers, picture_maker, read_files, write_files

CHECKER = Path(asymptotics.__file__).parent / "testing" / "check_certificate.py"


class Refuse(argparse.Action):
    """An option that makes no sense here; ``const`` is the reason."""

    def __call__(
        self,
        parser: argparse.ArgumentParser,
        namespace: argparse.Namespace,
        values: str | Sequence[Any] | None,
        option_string: str | None = None,
    ) -> NoReturn:
        """Leave with the reason, exit code 2."""
        parser.error(f"argument {option_string}: not in this command: {self.const}")


@dataclass(frozen=True)
class Command:
    """What the shell asks of a command: ``configure``, ``run`` and ``cut_short``."""

    question: Question

    @property
    def page(self) -> str:
        """What --help says first."""
        return self.question.page

    def configure(self, parser: argparse.ArgumentParser) -> None:
        """Declare the options."""
        self.question.add_to(parser, Refuse)

    def parsed(self, parser: argparse.ArgumentParser, words: list[str]) -> argparse.Namespace:
        """The options; the command's own are taken out of those that belong to the rest of the words."""
        options = parser.parse_args(words)
        rest = next((o for o in self.question.options if o.rest), None)
        if rest is None:
            return without_units(options)
        own = argparse.ArgumentParser(allow_abbrev=False, add_help=False, exit_on_error=False)
        for option in (o for o in self.question.options if not o.place):
            replace(option, needed=False).add_to(own)
        try:
            options, others = own.parse_known_args(getattr(options, rest.key), options)
        except argparse.ArgumentError as error:
            raise InputError(str(error.argument_name), str(error.message), f"see {parser.prog} --help") from error
        setattr(options, rest.key, others)
        return options

    def run(self, options: argparse.Namespace) -> Answer:
        """Read the request, refuse its files before the work, compute, write the files and tell the answer."""
        if (other := self.question.asked_by(options)) is not self.question:
            return Command(other).run(options)
        request, show = self._prepared(options)
        if (instead := self.question.offers.instead(request)) is not None:
            for name in FILES:
                if request.typed(name):
                    raise InputError(
                        f"--{name}", "nothing is computed here that it could hold", "the command without it"
                    )
            return Answer(*instead, options.json)
        of_shell = self.question.offers.of_shell
        return show(self.question.function(**request.values) if of_shell is None else of_shell(request))

    def cut_short(self, options: argparse.Namespace, found: Any) -> Answer | None:
        """The same with the rows that were done when the time was over."""
        if isinstance(found, Answer):
            return found
        if self.question.offers.missing is None or self.question.asked_by(options) is not self.question:
            return None
        request, show = self._prepared(options)
        done, missing = self.question.offers.missing(found, request)
        return shortened(show(found), done, missing)

    def _prepared(self, options: argparse.Namespace) -> tuple[Request, Callable[[Any], Answer]]:
        """What was asked, with all that can be refused before the work, and how the result is shown."""
        offers = self.question.offers
        # What has an own way to write reads its other files itself.
        own = {name: getattr(options, name, None) for name in ("plot", "html", "certificate")}
        files = read_files(options if offers.show is None else argparse.Namespace(**own))
        if offers.reads:  # a file of data must not be overwritten by a picture of it, whichever of several it is
            for name in read_words(getattr(options, offers.reads)):
                require_different({"FILE": Path(name), **files})
        request = Request(self.question.of_options(options), options)
        offers.typed(request)
        if offers.show is None:
            return request, lambda found: self._shown(request, files, found)
        show = offers.show(request)

        def shown(found: Any) -> Answer:
            proof = _Proof.of(offers.certificate, request, files, found)
            data, text = show(found)
            drawing: Makers = {"--plot": picture_maker(options, lambda: [found])} if offers.picture else {}
            drawing["--html"] = lambda _: self._page(request, found)
            more = write_files(files | proof.checker, drawing | proof.makers)
            text = "\n".join([text, *more, *proof.lines])
            return Answer(data | proof.data, text, options.json, bool(offers.failed(found, request)))

        return request, shown

    def _shown(self, request: Request, files: dict[str, Path], found: Any) -> Answer:
        offers, options = self.question.offers, request.options
        makers: Makers = {"--csv": lambda _: offers.as_csv(found, request)}
        makers["--html"] = lambda _: self._page(request, found)
        if offers.picture:
            style = offers.style(found, request) if options.plot else {}
            makers["--plot"] = picture_maker(options, lambda: offers.drawn(found, request), **style)
        proof = _Proof.of(offers.certificate, request, files, found)
        files, makers = files | proof.checker, makers | proof.makers
        with changed(lambda rows: self._with_rows(request, files, found, rows)):
            written = write_files(files, makers, options if offers.again is not None else None, self.question)
        answer = self._answer(request, found, written)
        return replace(answer, data=answer.data | proof.data, text="\n".join([answer.text, *proof.lines]))

    def _page(self, request: Request, found: Any) -> str:
        own = None if self.question.offers.page is None else self.question.offers.page(found, request)
        return (
            str(own)
            if own is not None
            else page_of(self.question, request, found, self.question.as_typed(request.options))
        )

    def _with_rows(self, request: Request, files: dict[str, Path], found: Any, rows: Any) -> Answer | None:
        """The answer with the rows of its table that were done when the time was over; half a picture is none."""
        made = self.question.offers.rows_done
        done = None if made is None else made(rows, request)
        if done is None:
            return None
        table, count, missing = done
        file = {"--csv": files["--csv"]}
        written = write_files(file, {"--csv": lambda _: table}, request.options, self.question)
        return shortened(self._answer(request, found, written), count, f"{missing} in {written[0]}")

    def _answer(self, request: Request, found: Any, written: list[str]) -> Answer:
        offers, options = self.question.offers, request.options
        wanted = bool(offers.latex) and request.has_latex
        latex = offers.as_latex(found, request) if wanted else ""
        data = offers.record(found, request, latex, written)
        # LaTeX stands alone, unless the files are part of every answer.
        text = latex if wanted else offers.text(found, request)
        shown = [text] if wanted and not offers.always_files else [text, *written]
        shown += [more] if (more := offers.besides(found, request)) else []
        return Answer(data, "\n".join(shown), options.json, bool(offers.failed(found, request)))


@dataclass(frozen=True)
class _Proof:
    """What --certificate adds: its file and that of the checker, what was proved (JSON), what is left (text)."""

    checker: dict[str, Path] = field(default_factory=dict)
    makers: Makers = field(default_factory=dict)
    data: dict[str, Any] = field(default_factory=dict)
    lines: tuple[str, ...] = ()

    @classmethod
    def of(cls, make: Part | None, request: Request, files: dict[str, Path], found: Any) -> "_Proof":
        """Made before anything is written; nothing where none is asked for."""
        path = files.get("--certificate")
        if make is None or path is None:
            return cls()
        made = make(found, request)
        makers: Makers = {
            "--certificate": lambda _: f"{made.to_json()}\n",
            "checker": lambda _: CHECKER.read_text(encoding="utf-8"),
        }
        data = {"certificate": {"proved": list(made.proved), "left": list(made.left)}}
        told = tuple(f"not in the certificate: {line}" for line in made.left)
        return cls({"checker": path.with_name(CHECKER.name)}, makers, data, told)


def read_words(given: str | list[str]) -> list[str]:
    """One word or several."""
    return [given] if isinstance(given, str) else given


def command_of(name: str) -> Command:
    """The question of that name as a command; it is loaded now."""
    return Command(loaded(name))
