"""A question with a time of its own: the shell gives it that, unless it is told another."""

import pytest

from asymptotics.decays.identification.forward.work import PATIENCE
from asymptotics.decays.identification.synthetic import observed
from asymptotics.shell import main as shell


@pytest.mark.parametrize(("asked", "seconds"), [([], PATIENCE), (["--max-seconds", "50"], 50)])
def test_identify_has_ten_minutes(asked, seconds, tmp_path, monkeypatch, capsys):
    from asymptotics.shell import clock  # noqa: PLC0415 (loaded by the shell at its first request)

    given, limited = [], clock.limited
    monkeypatch.setattr(clock, "limited", lambda s, show: given.append(s) or limited(s, show))
    seen = observed("1", [0.02], 12, 1e-3, seed=2)
    file = tmp_path / "run.csv"
    file.write_text("n,x\n" + "\n".join(f"{n},{x}" for n, x in zip(seen.n, seen.x)))
    assert shell.main(["identify", str(file), "--laws", "1", "2", *asked]) == 0
    assert given == [seconds] and "consistent" in capsys.readouterr().out
    given.clear()
    shell.main(["moment", "--p", "2"])
    assert given in ([], [60])
