"""The multiple-scale solution of any law through an order: explicit for one law, implicit for sums and springs."""

from collections.abc import Mapping
from dataclasses import replace

from asymptotics.curves.implicit import ImplicitSolution, implicit_solution
from asymptotics.curves.slow_formulas import closed_wave, slow_formulas
from asymptotics.curves.solution import MAX_ORDER, Solution
from asymptotics.curves.started import DIGITS, start_in_motion
from asymptotics.errors import require_flag
from asymptotics.expansions.half_swings.symbolic import alpha as symbolic_alpha
from asymptotics.expansions.multiple_scales.hierarchy import multiple_scales
from asymptotics.expansions.multiple_scales.orders import a
from asymptotics.frames import BARE, frame_of
from asymptotics.gauges import TURNING_POINT
from asymptotics.law import Law, LawLike, Oscillator
from asymptotics.law_given import one_exponent, oscillator_of
from asymptotics.numbers.bridge import to_sympy
from asymptotics.numbers.policy import Number, exact_integer
from asymptotics.running.public import public


@public
def solution(
    law: LawLike, *, order: int = 3, symbolic: bool = False, max_seconds: Number = 60
) -> Solution | ImplicitSolution:
    """The multiple-scale solution A(t), phi(t), x(t) as formulas through an order: explicit for one law, else implicit.

    Parameters
    ----------
    law
        {alpha: epsilon}, a ``Law`` or an ``Oscillator`` (SI); an exponent alone, or "symbolic", leaves the strength a
        symbol
    order
        of the expansion, 1 to 12
    symbolic
        whether the strength stays a symbol where one is given
    max_seconds
        the time the call may take, in s

    Returns
    -------
    Solution or ImplicitSolution
        the formulas as SymPy expressions, ``latex``, and ``at`` a time as numbers; of a sum, or beside springs,
        implicit

    Raises
    ------
    InputError
        for an order out of range, anti-damping, and a sum without losses

    Examples
    --------
    >>> moving = solution(Oscillator({2: "1/10"}, x0="3/5", v0="-4/5"), order=3)
    >>> moving.at(0, digits=6).x, moving.at(7, digits=6).x
    ('0.599973', '-0.0420555')
    """
    N = exact_integer(order, "order", 1, MAX_ORDER)
    require_flag(symbolic, "symbolic")
    frame = frame_of(law) if isinstance(law, Oscillator) else BARE
    if isinstance(law, Law | Oscillator | Mapping):
        oscillator = oscillator_of(law)
        oscillator.law.require_dissipative("solution that decays")
        # One power of the velocity alone makes A explicit: with delta as the one variable tau(delta) can be reversed.
        if len(oscillator.law.terms) > 1 or not oscillator.law.is_pure:
            return replace(implicit_solution(oscillator, N, frame), symbolic=symbolic)
    exponent, given = one_exponent(law)
    scales = multiple_scales("symbolic" if exponent is None else exponent, order=N, gauge=TURNING_POINT)
    alpha = symbolic_alpha if exponent is None else to_sympy(exponent)
    p_1 = -scales.rates[1][0].subs(a, 1)
    relative, phase = slow_formulas(scales, alpha, N, DIGITS)
    # Rates of order N act over times 1/epsilon and count like epsilon^(N-1), as the last waveform that is kept does.
    waves = tuple(closed_wave(scales, n) for n in range(1, N))
    start = None if given is None or given.v0.is_zero else start_in_motion(given, scales)
    return Solution(alpha, N, p_1, relative, phase, waves, scales, given, scales.notes, start, symbolic, frame=frame)
