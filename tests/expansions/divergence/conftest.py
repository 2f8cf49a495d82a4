"""What the tests of the constants share."""

import pytest

from asymptotics.expansions.divergence.constants import rough_petal
from asymptotics.numbers.exact import parse_real


@pytest.fixture(scope="module")
def law():
    return rough_petal(parse_real("2", "alpha"))
