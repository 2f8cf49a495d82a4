r"""A result as HTML, for notebooks: the verdict or value first, lines of text, a small table; all text escaped.

Mathematics is typeset: that of a line by signs and raised and lowered letters, LaTeX in a cell (``Tex``) as MathML.

>>> block("x < 1", ["certified"], ("n", "x"), [("0", "1")])
'<div><p><strong>x &lt; 1</strong></p><p>certified</p><table><thead><tr><th>n</th><th>x</th></tr></thead>...</div>'
>>> block("a**2 <= epsilon_0", (), ("", ""), [("printed", Tex(r"\frac{1}{2}"))])
'<div><p><strong>a<sup>2</sup> &le; &epsilon;<sub>0</sub></strong></p>...<math...<mfrac>...</math>...</div>'
"""

from base64 import b64encode
from collections.abc import Iterable, Sequence
from html import escape

from asymptotics.errors import InputError
from asymptotics.present.mathml import mathml
from asymptotics.present.signs import signs


class Tex(str):
    """LaTeX without dollars, in the place of a text."""

    __slots__ = ()


def block(
    title: str,
    lines: Iterable[str] = (),
    head: Sequence[str] = (),
    rows: Iterable[Sequence[object]] = (),
    picture: str = "",
) -> str:
    """One block: ``title`` in bold, each line that is not empty, the table if it has a head, a picture."""
    # Everything that was typed, or read from a file, may come by here: no text reaches the page unescaped.
    told = "".join(f"<p>{_set(line)}</p>" for line in lines if line)
    body = "".join("<tr>" + "".join(f"<td>{_set(cell)}</td>" for cell in row) + "</tr>" for row in rows)
    top = "".join(f"<th>{_set(name)}</th>" for name in head)
    table = f"<table><thead><tr>{top}</tr></thead><tbody>{body}</tbody></table>" if head else ""
    return f"<div><p><strong>{_set(title)}</strong></p>{told}{table}{picture}</div>"


def _set(cell: object) -> str:
    if not isinstance(cell, Tex):
        return signs(escape(str(cell)))
    try:
        return mathml(cell)
    except InputError:  # without the extra it is left to the MathJax of a notebook
        return f"${escape(cell)}$"


def image(svg: bytes, title: str) -> str:
    """A picture that stands in the page itself: it needs no file, and its ids meet no others.

    >>> image(b"<svg/>", "x & y")
    '<img src="data:image/svg+xml;base64,PHN2Zy8+" alt="x &amp; y" style="max-width:100%">'
    """
    data = b64encode(svg).decode("ascii")
    return f'<img src="data:image/svg+xml;base64,{data}" alt="{escape(title)}" style="max-width:100%">'
