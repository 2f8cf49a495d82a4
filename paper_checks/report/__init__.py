"""The report: every statement with its verdict, the regenerated tables and figures, as HTML, JSON and LaTeX."""

from paper_checks.report.build import write_report

__all__ = ["write_report"]
