"""What an experiment sees, as series in the strength delta at a turning point: the same in every gauge.

>>> from asymptotics.expansions.normal_form.expansion import exact_expansion
>>> seen = observables(exact_expansion((2,), 2))
>>> seen.amplitude_ratio, seen.half_period
(1 + -4/3*d + 16/9*d^2 + O(3), pi + pi/6*d^2 + O(3))
>>> seen.energy_loss, seen.log_decrement
(8/3*d + -16/3*d^2 + O(3), 8/3*d + -32/9*d^2 + O(3))
"""

from dataclasses import dataclass

from asymptotics.expansions.half_swings.forces import Forces
from asymptotics.expansions.normal_form.expansion import Expansion
from asymptotics.series import Series


@dataclass(frozen=True)
class ObservableSeries:
    """Series in the local strengths at A_n, the observed turning amplitude.

    ``amplitude_ratio``: A_(n+1)/A_n; ``half_period``: tau_(n+1) - tau_n; ``energy_loss``: the fraction of the energy
    lost on this half-swing; ``log_decrement``: ln(A_n/A_(n+2)), over a full swing.
    """

    amplitude_ratio: Series
    half_period: Series
    energy_loss: Series
    log_decrement: Series


def observables(expansion: Expansion, forces: Forces | None = None) -> ObservableSeries:
    """The observables of an expansion, from its flow carried back to the turning points by its gauge map.

    A_(n+1)/A_n = e^L; two half-swings give ln(A_n/A_(n+2)) = -(L + L o F).  The energy at a turning point is V(A), so
    the loss is 1 - e^(2 L) v(F)/v(delta), v = V(A)/(A^2/2): 1 for the linear spring, and from ``forces`` otherwise.
    """
    half = expansion.turning_point_flow().half_swing(expansion.pi)
    kept = (half.L * 2).exp()
    if forces is not None:
        v = forces.potential(half.order)
        kept = kept * v.compose(half.F) / v
    return ObservableSeries(half.L.exp(), half.T, 1 - kept, -(half.L + half.L.compose(half.F)))
