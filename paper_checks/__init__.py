"""The statements of the three papers as data, each with the check that could refute it right below.

One folder per paper, one file per section.  ``python -m paper_checks --help`` runs the checks and writes the report.
"""
