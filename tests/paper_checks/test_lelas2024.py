"""Every statement of Lelas 2024: present, borne out by its check, and refutable; the figures are reproducible."""

from fractions import Fraction

from mpmath import mp, mpf, odefun, pi

from paper_checks.lelas2024 import model
from paper_checks.registry import load
from paper_checks.verdict import Printed

ENTRIES = load("lelas2024")
SOUND = (Printed.HOLDS, Printed.DEFINITION)

VALUES = ["tau-a", "tau-b", "tau-tilde-a", "tau-tilde-b", "tau-exact-a", "tau-exact-b", "rest-a", "rest-b"]
NOT_HOLDING = {  # found by hand from the paper's own equations and numbers, see the notes of the entries
    "10": "misprint",
    "claim.slower-decay": "partly",
    "54": "partly",
    "value.tau-tilde-a": "misprint",
    "value.tau-tilde-b": "misprint",
    "value.tau-exact-b": "misprint",
    "claim.slope-small": "transcription",
    "claim.dropping-the-slope": "partly",
    "claim.amplitude-not-negative": "partly",
    "claim.equal-amplitudes": "partly",
    "claim.two-rates-contradict": "partly",
    "claim.integrated-rate": "transcription",
    "claim.slope-of-line": "transcription",
    "claim.same-decay-friction": "partly",
    "claim.stop-time-section-3": "transcription",
    "claim.both-sides-positive": "partly",
    "claim.force-of-47": "misprint",
    "claim.range-of-49": "partly",
    "claim.no-closed-form": "partly",
    "claim.stop-time-section-5": "transcription",
    "claim.describes-well": "partly",
    "claim.not-analytically-solvable": "partly",
    "claim.figure-of-section-6": "misprint",
    "claim.agrees-well": "partly",
    "claim.number-of-sections": "misprint",
    "claim.integral-of-sin-cubed": "misprint",
    "claim.slight-decrease": "partly",
    "claim.force-powers": "partly",
    "claim.force-without-sign": "partly",
}


def short(key: str) -> str:
    return key.removeprefix("lelas2024:")


def test_the_ids_are_the_papers_numbering():
    ids = {short(key) for key in ENTRIES}
    claims = {key for key in ids if key.startswith("claim.")}
    numbered = {str(number) for number in range(1, 55)}
    assert ids - claims == numbered | {"fig1", "fig2"} | {f"value.{name}" for name in VALUES}
    assert len(claims) >= 40


def test_entries_stand_in_reading_order():
    numbers = [int(short(key)) for key in ENTRIES if short(key).isdigit()]
    assert numbers == list(range(1, 55))


def test_verdicts_other_than_holds():
    found = {short(key): str(entry.verdict) for key, entry in ENTRIES.items() if entry.verdict not in SOUND}
    assert found == NOT_HOLDING


def test_exact_friction_motion_solves_its_equation():
    """Against a Taylor integrator swing by swing: X'' = -X + eps sign, the sign that of the swing."""
    eps = mpf("0.15")
    exact = model.coulomb(eps)
    with mp.workdps(20):
        state = [mpf(1), mpf(0)]
        for swing in range(3):
            push = eps if swing % 2 == 0 else -eps
            solution = odefun(lambda _, y, push=push: [y[1], push - y[0]], 0, state)
            assert abs(solution(1)[0] - exact(swing * pi + 1)) < mpf(10) ** -15
            state = [solution(pi)[0], mpf(0)]
        assert abs(exact(mpf(100)) - state[0]) < mpf(10) ** -15  # stopped at -(1 - 6 eps) = -0.1


def test_half_swings_by_hand():
    """eps = 1/3: 1 - 2/3 = 1/3 <= eps, one swing; a little less: a second one."""
    assert model.half_swings(Fraction(1, 3)) == 1
    assert model.half_swings(Fraction(33, 100)) == 2
    assert model.half_swings(Fraction(2)) == 0


def test_exact_air_motion_solves_its_equation():
    """Against a Taylor integrator on the first half-swing: X'' = -X + eps X'^2."""
    with mp.workdps(20):
        time, place = model.air(mpf("0.25"), 0, Fraction(2, 3))
        solution = odefun(lambda _, y: [y[1], -y[0] + y[1] ** 2 / 4], 0, [mpf(1), mpf(0)])
        assert abs(solution(time)[0] - place) < mpf(10) ** -14
