"""Damage to a certificate: what a bad copy, a bad program or a bad intention would do to a file."""

import copy


def leaves(content, inner=False, place=()):
    """The places of the strings and integers, and of what holds them if ``inner``."""
    if inner and place:
        yield place
    if isinstance(content, dict | list):
        keys = content if isinstance(content, dict) else range(len(content))
        for key in keys:
            yield from leaves(content[key], inner, (*place, key))
    elif not inner:
        yield place


def put(content, place, value):
    """The content with another value at a place."""
    if not place:
        return value
    here = content
    for key in place[:-1]:
        here = here[key]
    here[place[-1]] = value
    return content


def got(content, place):
    """The value at a place."""
    for key in place:
        content = content[key]
    return content


def damaged(content, rng):
    """One to three places of it changed: a digit, a sign, a small or a large number, two pieces exchanged."""
    content = copy.deepcopy(content)
    if rng.random() < 0.1 and len(content["pieces"]) > 1:
        i, j = rng.sample(range(len(content["pieces"])), 2)
        content["pieces"][i], content["pieces"][j] = content["pieces"][j], content["pieces"][i]
    for _ in range(rng.randint(1, 3)):
        part = rng.choice(["pieces"] * 4 + ["claims", "claims", "law", "start", "stiffness", "bits", "root"])
        places = [place for place in leaves(content) if place[0] == part]
        if places:
            place = rng.choice(places)
            put(content, place, _other(got(content, place), rng))
    return content


def _other(value, rng):
    if isinstance(value, int) and not isinstance(value, bool):
        return value + rng.choice([-1, 1, 2, 10])
    if not isinstance(value, str) or not value:
        return rng.choice(["0", "1", value])
    kind = rng.randrange(5)
    if kind == 0:  # a digit
        places = [i for i, c in enumerate(value) if c.isdigit()]
        i = rng.choice(places) if places else 0
        return value[:i] + str(rng.randrange(10)) + value[i + 1 :]
    if kind == 1:  # the sign
        return value[1:] if value.startswith("-") else "-" + value
    if kind == 2:  # the last digits
        return value[: max(1, len(value) - rng.randint(1, 12))]
    if kind == 3:
        return value + str(rng.randrange(10))
    return rng.choice(["0", "1", "-1", value[::-1]])
