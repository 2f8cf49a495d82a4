"""Requests at the edges: exponents near 0, near 1, near each other, up to 1000; strengths 1e+-300; starts to 10^18."""

from fractions import Fraction
from random import Random

FAMILIES = ("near 1", "near each other", "near 0", "large", "strong and weak")
COMMANDS = ("points", "start", "reference", "moving", "bound", "half-swing", "expand")


def requests(family, count, seed):
    """``count`` command lines of a family, without --digits and --max-seconds."""
    random = Random(f"{family} {seed}")
    return [_line(random, random.choice(COMMANDS), _laws(random, family)) for _ in range(count)]


def _laws(random, family):
    small, e = Fraction(1, 10 ** random.randint(1, 30)), lambda: f"{random.uniform(0.01, 2):.3g}"
    more = random.random() < 0.5
    if family == "near 1":
        return [(1 + random.choice((1, -1)) * small, e()), *([(1, e())] if more else [])]
    if family == "near each other":
        a = Fraction(random.randint(1, 50), 10)
        return [(a, e()), (a + small, e())]
    if family == "near 0":
        return [(small, e()), *([(random.choice((Fraction(1, 2), 1, Fraction(3, 2), 2)), e())] if more else [])]
    if family == "large":
        a = random.choice((random.randint(10, 1000), f"{random.uniform(10, 1000):.4g}", 1000))
        return [(a, e()), *([(random.choice((Fraction(1, 2), 1, Fraction(3, 2), 2)), e())] if more else [])]
    sized = lambda: f"1e{random.choice((1, -1)) * random.randint(1, 300)}"  # noqa: E731
    a = random.choice((0, Fraction(1, 100), Fraction(1, 2), 1, "sqrt(2)", Fraction(3, 2), 2, 3, 50))
    return [(a, sized()), *([(random.choice((Fraction(1, 3), Fraction(5, 2), 5)), sized())] if more else [])]


def _line(random, command, laws):
    given = [part for a, e in laws for part in ("--law", f"{a}:{e}")]
    bare = [part for a, _ in laws for part in ("--law", str(a))]
    time = random.choice(("1", "10", "100", "1000", "1e6", "1e12"))
    order = str(random.randint(1, 4))
    if command == "points":
        return ["turning-points", *given, "--count", "3", "--times"]
    if command == "start":
        return ["turning-points", *given, "--count", "1", "--start", str(10 ** random.randint(1, 18))]
    if command == "reference":
        return ["motion", *given, "--reference", "--time", time]
    if command == "moving":
        place = ["--x0", f"{random.uniform(-2, 2):.3g}", "--v0", f"{random.uniform(-3, 3):.3g}"]
        return ["turning-points", *given, "--count", "2", "--times", *place]
    if command == "bound":
        return ["motion", *given, "--order", order, "--bound", "--time", time]
    if command == "half-swing":
        return ["half-swing", *bare, "--delta", ",".join(e for _, e in laws)]
    return ["expand", *given, "--order", order, "--bound"]
