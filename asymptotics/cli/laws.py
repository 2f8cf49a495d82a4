"""The options that name a law, shared by the commands: ``--alpha A`` or ``--law A[:E]`` repeated."""

import argparse
from dataclasses import dataclass

from asymptotics.errors import InputError
from asymptotics.numbers.exact import REAL_FORMS, ExactReal, parse_real

MAX_LAWS, MAX_ALPHA = 4, 1000


@dataclass(frozen=True)
class Exponents:
    """The exponents of a sum of laws, all different, in the order given; ``notes`` says what was merged."""

    alphas: tuple[ExactReal, ...]
    notes: tuple[str, ...]

    @property
    def shown(self) -> str | list[str]:
        """The exponent of one law, or the list of all, as text."""
        texts = [str(a) for a in self.alphas]
        return texts[0] if len(texts) == 1 else texts


def add_law(parser: argparse.ArgumentParser) -> None:
    """The options --alpha, --epsilon and --law."""
    text = "the exponent of the damping law, any real number >= 0: 3/2, 0.1, sqrt(2), ..."
    parser.add_argument("--alpha", metavar="A", help=text)
    text = "its strength; accepted as in the other commands, it does not enter the coefficients of powers of delta"
    parser.add_argument("--epsilon", metavar="E", help=text)
    text = "one term of a sum of laws, repeated: its exponent and (optionally) its strength epsilon"
    parser.add_argument("--law", action="append", metavar="A[:E]", help=text)


def read_exponents(options: argparse.Namespace) -> Exponents:
    """The exponents of --alpha or --law; InputError for none, both, more than four, or exponents out of range."""
    if (options.alpha is None) == (options.law is None):
        reason = "is missing" if options.alpha is None else "cannot be combined with --law"
        raise InputError("--alpha", reason, "either --alpha A, or --law A:E once for each term")
    if options.epsilon is not None:
        if options.alpha is None:
            raise InputError("--epsilon", "belongs to --alpha", "--law A:E for the terms of a sum")
        parse_real(options.epsilon, "--epsilon")
    if options.alpha is not None:
        return Exponents((read_alpha(options.alpha, "--alpha"),), ())
    alphas: list[ExactReal] = []
    notes = []
    for text in options.law:
        alpha_text, _, strength = text.partition(":")
        alpha = read_alpha(alpha_text, "--law")
        if strength:
            parse_real(strength, "--law")
        if alpha in alphas:
            notes.append(f"equal exponents merged: alpha = {alpha} (its delta is the sum of the strengths)")
        else:
            alphas.append(alpha)
    if len(alphas) > MAX_LAWS:
        raise InputError("--law", f"{len(alphas)} different exponents are too many", f"at most {MAX_LAWS}")
    return Exponents(tuple(alphas), tuple(notes))


def read_alpha(text: str, argument: str) -> ExactReal:
    """An exponent: a real number from 0 to 1000, given exactly."""
    alpha = parse_real(text, argument)
    if alpha < 0 or alpha > MAX_ALPHA:
        raise InputError(argument, f"{alpha} is out of range", f"a real number from 0 to {MAX_ALPHA}: {REAL_FORMS}")
    return alpha
