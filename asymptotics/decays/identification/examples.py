"""The files that come with the package, to try ``identify`` on; where they come from stands in ``data/README.md``.

>>> sorted(EXAMPLES), roll_decay().name
(['phone', 'ringdown', 'ship'], 'kvlcc2_roll_decay.csv')
>>> example("phone").is_file()
True
"""

from pathlib import Path

from asymptotics.errors import require_choice

_DATA = Path(__file__).parent / "data"
EXAMPLES = {"phone": "phone_pendulum.csv", "ship": "kvlcc2_roll_decay.csv", "ringdown": "resonator_ringdown.txt"}
"""A phone on a pendulum, the roll of a tanker model, the level of a resonator."""


def example(name: str) -> Path:
    """The file of an example; InputError for an unknown name."""
    return _DATA / EXAMPLES[require_choice(name, "example", EXAMPLES)]


def roll_decay() -> Path:
    """The file: t in s, roll angle in rad; about 147 turning points from 10.45 to 1.1 degrees, CC BY 4.0."""
    return example("ship")
