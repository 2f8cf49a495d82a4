"""Values that balls do not decide."""

import pytest

from asymptotics.errors import UndecidedError
from asymptotics.motions.certify import certified_values, half_unit


def test_an_undecidable_value_is_said_to_be_so():
    def tie():
        raise UndecidedError("a tie")

    with pytest.raises(UndecidedError, match="a tie"):
        certified_values(tie, 5)
    assert half_unit("-123.4", 4) == "0.050"
