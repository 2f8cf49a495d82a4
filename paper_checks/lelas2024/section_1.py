"""Section I: what is said of the viscous oscillator, and the plan of the paper."""

import sympy

from paper_checks.evidence import read_off
from paper_checks.identities import all_confirmed, decided, same, vanishes
from paper_checks.lelas2024.model import b, m, t, x0
from paper_checks.registry import statement
from paper_checks.verdict import Evidence, Kind, Outcome, Printed

v0, damped = sympy.symbols("v_0 omega_d", positive=True)
GAMMA = b / (2 * m)


def viscous_solution(start: sympy.Expr) -> sympy.Expr:
    """e^(-gamma t) (x0 cos(omega_d t) + start/omega_d sin(omega_d t))."""
    wave = x0 * sympy.cos(damped * t) + start / damped * sympy.sin(damped * t)
    return sympy.exp(-GAMMA * t) * wave


@statement(
    id="lelas2024:claim.viscous-closed-form", kind=Kind.CLAIM, verdict=Printed.HOLDS, evidence=Evidence.PROVED,
    title="With viscous damping the motion has a closed form valid for all times",
    latex=r"\text{the solution of the corresponding equation of motion can be written analytically in a closed form}"
    r"\ \text{valid for all times}", printed=viscous_solution(v0 + GAMMA * x0), near_miss=viscous_solution(v0),
    conditions="b != 2 m omega_0, where it has a limit; above, cosine and sine become hyperbolic",
    methods=("substitution in (1) with (2)", "initial values"),
    note="The paper does not print it. omega_d^2 = omega_0^2 - b^2/(4 m^2). Form: the solution from (x_0, v_0).",
)
def viscous_motion(form: sympy.Expr) -> Outcome:
    """m x'' + b x' + k x with k = m (gamma^2 + omega_d^2); x(0) = x_0 and x'(0) = v_0."""
    first, k = sympy.diff(form, t), m * (GAMMA**2 + damped**2)
    start = all_confirmed(same(form.subs(t, 0), x0), same(first.subs(t, 0), v0))
    return all_confirmed(start, vanishes(m * sympy.diff(form, t, 2) + b * first + k * form))


HEADINGS = ("I", "II", "III", "IV", "V", "VI", "VII")  # Introduction ... Discussion and conclusion


@statement(
    id="lelas2024:claim.number-of-sections", kind=Kind.CLAIM, verdict=Printed.MISPRINT, evidence=Evidence.MEASURED,
    extent="read off the text",
    title="How many sections the paper has", latex=r"\text{This paper is organized into six sections}",
    corrected_latex=r"\text{This paper is organized into seven sections}", printed=6, corrected=7, near_miss=8,
    conditions="the acknowledgments not counted", methods=("the numbered headings",),
    note="The same paragraph goes on to describe sections II to VII; with the introduction they are seven.",
)
def number_of_sections(form: int) -> Outcome:
    """The numbered headings before the acknowledgments."""
    return decided(form == len(read_off(HEADINGS)))
