"""The options that give a law with its strengths: --alpha and one strength, or --law A:B repeated for a sum.

>>> parser = argparse.ArgumentParser()
>>> add_law(parser, "epsilon", "E", "the strength")
>>> print(read_law(parser.parse_args(["--law", "0:1/20", "--law", "3/2:0.1"]), "epsilon"))
1/20 sign(x') + 1/10 x'|x'|^(1/2)
"""

import argparse

from asymptotics.cli.laws import MAX_LAWS, read_alpha
from asymptotics.errors import InputError
from asymptotics.law import Law
from asymptotics.numbers.exact import REAL_FORMS, ExactReal, parse_real
from asymptotics.terms import Term


def add_law(parser: argparse.ArgumentParser, strength: str, letter: str, meaning: str) -> None:
    """The options --alpha, --``strength`` and --law."""
    parser.add_argument("--alpha", metavar="A", help=f"the exponent of the damping law, A >= 0: {REAL_FORMS}")
    parser.add_argument(f"--{strength}", metavar=letter, help=meaning)
    parser.add_argument("--law", action="append", metavar=f"A:{letter}", help="one term of a sum; repeat it")


def read_law(options: argparse.Namespace, strength: str) -> Law:
    """The law; InputError for both forms at once, a missing half, too many terms, a negative exponent or strength."""
    single = (options.alpha, getattr(options, strength))
    if options.law:
        if any(value is not None for value in single):
            raise InputError("--law", "it stands next to --alpha", f"either --law, or --alpha and --{strength}")
        law = Law.from_terms([_term(text) for text in options.law])
        if len(law.terms) > MAX_LAWS:
            raise InputError("--law", f"{len(law.terms)} different exponents are too many", f"at most {MAX_LAWS}")
        return law
    letter = "E" if strength == "epsilon" else "B"
    for name, value in zip(("alpha", strength), single):
        if value is None:
            raise InputError(f"--{name}", "it is missing", f"--alpha and --{strength}, or --law A:{letter}")
    return Law({read_alpha(single[0], "--alpha"): _strength(single[1], f"--{strength}")})


def _term(text: str) -> Term:
    alpha, colon, strength = text.partition(":")
    if not colon:
        raise InputError("--law", f"{text[:60]!r} has no colon", "exponent:strength, such as 3/2:0.1")
    return Term(_strength(strength, "--law"), read_alpha(alpha, "--law"))


def _strength(text: str, argument: str) -> ExactReal:
    value = parse_real(text, argument)
    if value < 0:
        raise InputError(argument, f"{value} is negative: anti-damping", "a strength >= 0")
    return value
