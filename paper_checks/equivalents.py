"""Mutants of a form that say the same, with the reason: the only ones that a check may confirm.

Keys are statements, and patterns of the names that ``mutants`` gives.
"""

from fnmatch import fnmatchcase

FACTOR = ("sign", "twice", "11/10")
LARGE = "a numerical factor in front of what must be large changes nothing"
BOUNDED = "a factor below 4, at the exponents tried, in front of what must be large"
MULTIPLE = "any multiple of a constant of the motion is one"
SIGN_OF_X = "x -> -x has the same S, and the same T, which (28) determines up to pi"
EVEN = "(-1)^n = 1, since n is even"
TWO_MORE = "the exponent of -1 changes by an even number, since n is even"
ANY_PAIR = "the claim is true of that pair of different exponents too"
SIXTH = "one unit of the sixth decimal: the constants of Table I are rounded, some of them wrongly, in that place"
FURTHER = "the further terms vanish, since C_(i-1)^m = 0 for m < i"
SHIFT = "-pi/2 is the other sign of the claim, and 3 pi/2 the same angle"

EQUIVALENT: dict[str, dict[str, str]] = {
    "lancaster2020:15": {"twice": LARGE, "11/10": LARGE},
    "lancaster2020:22": {"1: double m": LARGE, "1: twice": LARGE, "1: 11/10": LARGE, "1: number 1/2": LARGE},
    "lancaster2020:claim.valid-for-any-b": {
        "twice": LARGE, "11/10": LARGE, "double E": LARGE, "double q at 3": BOUNDED, "square q at 3": BOUNDED,
    },
    "lancaster2020:claim.not-separable": {"0: *": ANY_PAIR, "1: *": ANY_PAIR},
    "lelas2024:claim.energy-decreases": dict.fromkeys(
        ("?: twice", "?: 11/10", "1: drop mu", "1: square mu", "2: double v"),
        "a force against the velocity dissipates with any positive factor that is a number",
    ),
    "lelas2024:claim.equal-amplitudes": {"2: sign": SHIFT, "2: number 1/2": SHIFT},
    "lelas2024:claim.shifted-pairs": {
        "2: sign": SHIFT, "2: number 1/2": SHIFT, "?: twice": "any two amplitudes", "?: 11/10": "any two amplitudes",
    },
    "lelas2024:claim.equal-initial-energies": {"?: ?: sign": "the energy is even in x and in v"},
    "lelas2024:claim.two-rates-contradict": dict.fromkeys(
        ("sign", "twice", "number 1/2"), "the mean over any number of quarter periods"
    ),
    "lelas2024:claim.not-analytically-solvable": dict.fromkeys(FACTOR, MULTIPLE),
    "lelas2024:claim.same-decay": {"0: sign": "started the other way the second motion is its own mirror image"},
    "smith2012:16": {"sign": SIGN_OF_X},
    "smith2012:claim.standard-motion": {"sign": SIGN_OF_X},
    "smith2012:56a": {"0: number 0": "a constant boundary term drops out of the difference"},
    "smith2012:58": {
        "0: 0: minus 1": "the term n = 1 has the factor n - 1 = 0", "2: 0: minus 1": "n = -1 has the factor n + 1 = 0",
        "3: 0: minus 1": "the term n = 0 has the factor n = 0", "3: 0: zero": "the term n = 0 has the factor n = 0",
    },
    "smith2012:62b": {
        "0: drop i": FURTHER, "0: without -i/2": FURTHER,
        "1: minus -1": "(-1)^(k-1) = (-1)^(k+1)", "1: minus k": "(-1)^(1-k) = (-1)^(k+1)",
        "1: square k at 0": "k^2 is even with k",
    },
    "smith2012:65": {"1: number 1/2": EVEN, "1: minus *": TWO_MORE},
    "smith2012:66": {"1: number 1/2": EVEN, "1: minus *": TWO_MORE, "1: without -2": TWO_MORE},
    "smith2012:67": {"1: number 1/2": EVEN, "1: minus *": TWO_MORE},
    "smith2012:claim.discontinuity": {"minus 1": "any multiple of S_1 but S_1 itself leaves a jump"},
    "smith2012:fig2": {"0: sign": "-0 = 0", "1: digit 7": SIXTH},
    "smith2012:fig3": {"0: sign": "-0 = 0", "?: digit 7": SIXTH},
    "smith2012:table1.S0": {"sign": "-0 = 0"},
}  # fmt: skip


def reason(key: str, name: str) -> str | None:
    """Why this mutant of this statement says the same; None if it is not known to."""
    return next((why for pattern, why in EQUIVALENT.get(key, {}).items() if fnmatchcase(name, pattern)), None)
