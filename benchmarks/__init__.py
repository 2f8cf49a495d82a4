"""Benchmarks: ratios measured in one run, best of three.  ``python -m benchmarks [NAME] [--json | --report FOLDER]``.

==========================  =============================================================================
``smith_rows``              Smith's coefficients to row n: integer kernel beside rational arithmetics
``cubic_damping``           x'^3 order by order: exact engine beside SymPy by hand, oscilate and Maxima
``multiple_scales``         the hierarchy as whole processes, beside SymPy by hand and peers
``cost_against_order``      how the cost grows with the order for alpha = 2, 3, 3/2
``turning_point_tables``    1000 turning points: certified balls beside an mpmath iteration
``integrators``             1000 turning points beside heyoka, SciPy and mpmath, and their right digits
``hypergeometric``          2F1(1, a; a+1; z): balls beside mpmath and PARI
``comparing``               ``compare`` of 10^5 values beside certified ones
``fits``                    the law of a record: ``identify`` beside lmfit
``promises``                what is promised in a stated time, and the time it takes
``start_up``                seconds and memory of a process that imports, starts, answers
``peers``                   asks a peer in the environment ``.peers``
``report``                  JSON, Markdown and a picture, with machine and versions
``mutants``                 planted faults, and how many the tests notice
==========================  =============================================================================

Seconds depend on the machine, ratios much less; nothing here is asserted.  A peer
that is missing is an error (``--no-peers`` measures ours alone); Maxima is listed as "not installed" where it is.
"""
