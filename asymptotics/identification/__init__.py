"""The inverse problem: from a measured decay to the damping law, its strengths, and how sure they are.

==================  =========================================================================================
``identify``        the whole way: data in, ``Identification`` out
``sources``         what a table holds (``records`` reads it); ``extraction``: a record's turning points; ``defects``
``quiet_times``     turning times, each from all of them: noise does not raise the extremes
``observations``    turning points, times and passages of one run; ``printed``: decrements from tables
``coefficients``    half-swing series in doubles, for losses and springs; ``quadrature`` where they do not reach
``swing``           one half-swing at many amplitudes, with exact derivatives; ``sequence``: all turning points
``candidates``      which laws compete; ``starting``, ``fitting``: each one's best strengths
``profile``         intervals; ``correlation``: residuals that remember; ``amplitudes``: no times; ``runs``: several
runs
``comparison``      one law: fit, criteria, intervals, held-out swings
``judgement``       consistent, refuted, undetermined: by ``adequacy`` (residuals and noise) and ``contradiction``
``verdicts``        the answer in words, or a refusal
``identifiability`` what N turning points with noise can tell; ``examples``: a real record
``synthetic``       runs of known laws with known noise
``set_valued``      printed decrements: certified sets of strengths, by ``certified_ratio``, ``table_rows``,
``physical``
``plots``           the four pictures
``textbook``        the classical estimators, by name, with their systematic errors
==================  =========================================================================================

All numbers here are doubles and all intervals statistical, none of them a certificate; the exception is ``set_valued``.
"""
