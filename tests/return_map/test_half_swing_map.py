"""One half-swing, as it is handed on: what holds, what traps, and what the pieces leave out."""

from types import SimpleNamespace

import pytest
from flint import arb, ctx

from asymptotics.errors import UndecidedError
from asymptotics.flow.linear_spring.linear_spring import LinearSpring
from asymptotics.return_map import half_swing_map
from asymptotics.return_map.half_swing_map import integrated
from tests.flow.forces import damping_of


def test_dry_friction_holds_exactly_up_to_itself():
    law = damping_of(("0", "1/4"), ("2", "1/10"))
    p, e = arb("0.25"), arb(2) ** -40
    assert integrated(law, p).ended == "sticks" and integrated(law, p - e, e).ended == "sticks"
    with ctx.workprec(120):
        assert integrated(law, p + e).ended is None
    with ctx.workprec(60), pytest.raises(UndecidedError):
        integrated(law, p, e)


def test_what_the_pieces_leave_out_is_told_with_the_half_swing(monkeypatch):
    piece = SimpleNamespace(error=arb("1e-5"), ended=None, turn=arb("0.9"), miss=arb("1e-9"), time=arb(3))
    found = half_swing_map.of_arrival(arb(1), arb(0), piece, 3)
    assert found.tail >= arb("9.99e-6") and found.amplitude.contains(arb("-0.9") + arb("0.99e-9"))
    monkeypatch.setattr(
        half_swing_map, "half_swing_pieces", lambda *_, **__: iter([SimpleNamespace(error=arb("1e-5"), ended="held")])
    )
    assert integrated(damping_of(("2", "1/10")), arb(1)).tail >= arb("9.99e-6")


def test_a_trap_is_asked_for_all_amplitudes_that_may_be(monkeypatch):
    asked = []
    monkeypatch.setattr(LinearSpring, "ended", lambda _self, y, _w: asked.append(y) or "held")
    integrated(damping_of(("2", "1/10")), arb(1), arb("0.1"))
    assert asked[0].contains(arb("0.901")) and asked[0].contains(arb("1.099"))
