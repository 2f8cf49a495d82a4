"""A result as HTML, for notebooks: the verdict or value first, lines of text, a small table; all text escaped.

>>> block("x < 1", ["certified"], ("n", "x"), [("0", "1")])
'<div><p><strong>x &lt; 1</strong></p><p>certified</p><table><thead><tr><th>n</th><th>x</th></tr></thead>...</div>'
"""

from base64 import b64encode
from collections.abc import Iterable, Sequence
from html import escape


def block(
    title: str,
    lines: Iterable[str] = (),
    head: Sequence[str] = (),
    rows: Iterable[Sequence[object]] = (),
    picture: str = "",
) -> str:
    """One block: ``title`` in bold, each line that is not empty, the table if it has a head, a picture."""
    # Everything that was typed, or read from a file, may come by here: no text reaches the page unescaped.
    told = "".join(f"<p>{escape(line)}</p>" for line in lines if line)
    body = "".join("<tr>" + "".join(f"<td>{escape(str(cell))}</td>" for cell in row) + "</tr>" for row in rows)
    top = "".join(f"<th>{escape(name)}</th>" for name in head)
    table = f"<table><thead><tr>{top}</tr></thead><tbody>{body}</tbody></table>" if head else ""
    return f"<div><p><strong>{escape(title)}</strong></p>{told}{table}{picture}</div>"


def image(svg: bytes, title: str) -> str:
    """A picture that stands in the page itself: it needs no file, and its ids meet no others.

    >>> image(b"<svg/>", "x & y")
    '<img src="data:image/svg+xml;base64,PHN2Zy8+" alt="x &amp; y" style="max-width:100%">'
    """
    data = b64encode(svg).decode("ascii")
    return f'<img src="data:image/svg+xml;base64,{data}" alt="{escape(title)}" style="max-width:100%">'
