"""What comes in at the doors of a decay: springs by name, counts as numpy writes them, a rate beside the samples."""

import numpy as np
import pytest

import asymptotics as asy
from asymptotics.errors import InputError
from asymptotics.shell.main import main


def angles():
    n = np.arange(20)
    return {"n": n, "x": (-1.0) ** n * 60 * 0.97**n, "tau": np.pi * n * 1.01}


def test_a_pendulum_may_be_added_to_each_law():
    # failed before: 'spendulum' was no law
    answer = asy.identify(angles(), unit="deg", laws=["1", "free"], springs=["pendulum", "3"], bootstrap=False)
    names = {str(a.law.candidate) for a in answer.laws}
    assert names == {"1", "free", "1+pendulum", "1+s3", "free+s3"}


@pytest.mark.parametrize("spring", ["pendulum+3", "q", "1", "", "3+3"])
def test_a_spring_that_is_none_names_its_option(spring):
    with pytest.raises(InputError, match="argument springs: .*pendulum"):
        asy.identify(angles(), unit="deg", laws=["1"], springs=[spring])


def test_a_pendulum_of_lengths_names_the_option_that_asks_for_it():
    with pytest.raises(InputError, match="argument springs: a pendulum needs angles"):
        asy.identify(angles(), laws=["1"], springs=["pendulum"])
    with pytest.raises(InputError, match="argument laws: a pendulum needs angles"):
        asy.identify(angles(), laws=["1+pendulum"])
    with pytest.raises(InputError, match="argument springs: springs need times"):
        asy.identify({"n": [0, 1, 2, 3, 4], "x": [1, -0.9, 0.8, -0.7, 0.6]}, laws=["1"], springs=["3"])


def test_counts_as_savetxt_writes_them_are_whole_numbers(tmp_path, capsys):
    path = tmp_path / "mine.csv"
    n = np.arange(4.0)
    np.savetxt(path, np.stack([n, (-0.9) ** n], axis=1), delimiter=",", header="n,x", comments="")
    assert "0.000" in path.read_text()
    assert main(["compare", str(path), "--alpha", "1", "--epsilon", "1/10", "--json"]) == 0
    assert '"n": 3,' in capsys.readouterr().out
    path.write_text("n,x\n0.5,1\n")
    assert main(["compare", str(path), "--alpha", "1", "--epsilon", "1/10"]) == 2
    assert "'0.5' is not an integer" in capsys.readouterr().err


def test_a_rate_gives_one_column_its_times(tmp_path):
    t = np.arange(0, 30, 0.05)
    path = tmp_path / "one.txt"
    np.savetxt(path, np.exp(-0.05 * t) * np.cos(3 * t))
    answer = asy.identify(str(path), rate=20, laws=["1", "2"], bootstrap=False)
    # b/m = 2/20 s, and omega_0^2 = 9 + 1/400.
    assert answer.units.omega_0 == pytest.approx(3.000417, rel=1e-4)
    assert answer.law("1").law.epsilon[0].estimate == pytest.approx(0.1 / 3.000417, rel=1e-3)


def test_a_mass_and_a_stiffness_of_another_frequency_are_told():
    """A record of 4 rad/s: 1.5 kg and 24 N/m are its own, 200 g of the same spring swing with 11 rad/s."""
    t = np.arange(0, 12, 0.08)
    record = {"t": t, "x": np.exp(-0.05 * t) * np.cos(4 * t)}
    told = [
        [note for note in asy.identify(record, laws=["1"], bootstrap=False, **known).notes if "the times say" in note]
        for known in ({"mass": 1.5, "stiffness": 24}, {"mass": 0.2, "stiffness": 24}, {"omega_0": 4.1}, {"omega_0": 8})
    ]
    assert [len(notes) for notes in told] == [0, 1, 0, 1]
    assert told[1][0].startswith("the times say omega_0 = 4 rad/s, and what was given 10.95")
