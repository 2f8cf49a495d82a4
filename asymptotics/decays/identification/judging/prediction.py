"""How well a law that was fitted to the first swings predicts those that it has not seen."""

import numpy as np

from asymptotics.decays.identification.fitting.model import Model
from asymptotics.decays.identification.forward.quadrature import TooStrongError
from asymptotics.decays.identification.judging.laws import Fitted
from asymptotics.decays.identification.judging.single_fits import fit_law
from asymptotics.decays.identification.measuring.observations import Observations


def predicted_error(law: Fitted, seen: Observations, share: float = 2 / 3) -> float | None:
    """Fit the first ``share`` of the swings, predict the amplitudes of the rest: rms error over the noise.

    None if the first part does not determine the law.
    """
    if law.fit is None or seen.samples is not None:
        return None
    early = seen.up_to(int(share * seen.last))
    first = fit_law(law.candidate, early)
    if first.fit is None:
        return None
    model = Model(first.fit.model.swing, seen, first.fit.model.offset, law.candidate.pendulum)
    late = np.flatnonzero(seen.n > early.last)  # what the fit has not seen
    try:
        predicted, _ = model.predict(first.fit.theta)
    except TooStrongError:
        return None
    return float(np.sqrt(np.mean((seen.x - predicted[: len(seen.x)])[late] ** 2)) / law.fit.scales["x"])
