"""The statements of the three papers with their verdicts, as data: what was found when each was checked.

Lancaster 2020, Lelas 2024 and Smith 2012, equation by equation.  The checks themselves are in ``paper_checks/`` of a
checkout, which writes ``data.json`` here; this room only reads it.

>>> from asymptotics.papers.lookup import paper
>>> record = paper("smith2012:43")
>>> record.title, record.printed, record.evidence
('The equation of the first turning point', 'holds', 'proved')
"""
