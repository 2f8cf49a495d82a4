"""The record that comes with the package: the roll decay of a tanker model (attribution in ``data/README.md``).

>>> roll_decay().name
'kvlcc2_roll_decay.csv'
"""

from pathlib import Path


def roll_decay() -> Path:
    """The file: t in s, roll angle in rad; about 147 turning points from 10.45 to 1.1 degrees, CC BY 4.0."""
    return Path(__file__).parent / "data" / "kvlcc2_roll_decay.csv"
