"""An integral with proof: FLINT's ``acb.integral``, which bounds a Gauss-Legendre rule on ellipses (Petras 2002).

>>> integral(lambda r, analytic: r.exp(), arb(0), arb(1), "e - 1").str(10)
'[1.718281828 +/- ...]'
"""

from collections.abc import Callable

from flint import acb, arb

from asymptotics.numbers.context import ctx
from asymptotics.running.budget import tick

EVALUATIONS_PER_BIT = 200
"""A hundred times what envelopes need: FLINT goes on to this limit where there is no value."""


def integral(f: Callable[[acb, bool], acb], low: arb, high: arb, words: str, *, evaluations: int | None = None) -> arb:
    """int f(r) dr from ``low`` to ``high``; a ball that is not finite where ``evaluations`` of f do not enclose it.

    f(r, analytic) encloses f on the complex ball r, and is not finite where ``analytic`` is asked and f is not analytic
    there.  ``words`` tell what is being done when the time is over.
    """

    failed = list[BaseException]()

    def integrand(r: acb, analytic: bool) -> acb:
        # FLINT calls back for nothing else: here alone an integral that goes on for long can be stopped.
        if not failed:
            try:
                tick(words)
                return f(r, analytic)
            except BaseException as error:
                # FLINT knows no errors: it would call back to its limit, with one set, which the interpreter may meet
                # at another place as a SystemError.  Kept here and raised below; until then there is no value.
                failed.append(error)
        return acb("nan")

    limit = EVALUATIONS_PER_BIT * ctx.prec if evaluations is None else evaluations
    # The integrands are real on the real line, so that the imaginary part holds 0 and is dropped.
    found: arb = acb.integral(integrand, acb(low), acb(high), eval_limit=limit).real
    if failed:
        raise failed[0]
    return found
