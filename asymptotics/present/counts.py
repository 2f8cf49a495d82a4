"""How many there are, in words.

>>> many(1, "sample"), many(2, "sample"), many(0, "turning point")
('1 sample', '2 samples', '0 turning points')
"""


def many(count: int, thing: str) -> str:
    """The number and the noun, which has an s where it is not one."""
    return f"{count} {thing}" if count == 1 else f"{count} {thing}s"
