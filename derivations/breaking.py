r"""A display in LaTeX that is wider than the page, broken by its own structure: after commas, before relations, then
before the signs of its sums; a bracket or a fraction that is still too wide is opened, and broken inside.

>>> print(*broken("a + b + c = d", room=30), sep="\n")
a + b
\qquad + c
\quad = d
>>> print(*broken(r"\frac{a + b + c + d}{2} \left(e + f\right)", room=90), sep="\n")
\frac{a + b + c + d}{2}
\qquad \times \left( e + f \right)
>>> print(*broken(r"\frac{a + b + c + d + e + f}{2}", room=90), sep="\n")
\frac{1}{2} \Bigl( a + b + c + d
\qquad\qquad + e + f \Bigr)
"""

from derivations.pieces import Node, parse, scripts, width, written

ROOM = 430.0
"""Points of a line: 455 of the page, less what the estimate of a width may miss."""
INDENT = 10.0


def broken(latex: str, room: float = ROOM) -> list[str]:
    """The lines of a display, each whole in itself; one, as it was, where it fits."""
    nodes = parse(latex)
    if width(nodes) <= room:
        return [latex]
    page = _Page(room)
    page.relations(nodes, 0)
    return page.finish()


class _Page:
    """Lines that are being filled."""

    def __init__(self, room: float) -> None:
        self.room = room
        self.lines: list[str] = []
        self.parts: list[str] = []
        self.begin(0)

    def begin(self, depth: int) -> None:
        """A new line at this depth."""
        self.finish()
        self.depth, self.used = min(depth, 6), min(depth, 6) * INDENT

    def finish(self) -> list[str]:
        """All lines, with the one that is being filled."""
        if self.parts:
            shift = r"\qquad" * (self.depth // 2) + r"\quad" * (self.depth % 2)
            self.lines.append(" ".join([shift] * bool(shift) + self.parts))
        self.parts = []
        return self.lines

    def fits(self, nodes: list[Node]) -> bool:
        return self.used + width(nodes) <= self.room

    def put(self, text: str, points: float) -> None:
        self.parts.append(text)
        self.used += points

    def place(self, nodes: list[Node]) -> None:
        """As they are, on this line."""
        self.put(written(nodes), width(nodes))

    def relations(self, nodes: list[Node], depth: int) -> None:
        """Several relations: each from a new line on; one: its sides."""
        for number, part in enumerate(_split(nodes, "comma", after=True)):
            if number and not self.fits(part):
                self.begin(depth)
            lines = len(self.lines)
            for place, side in enumerate(_split(part, "relation")):
                if place and (len(self.lines) > lines or not self.fits(side)):
                    self.begin(depth + 1)
                self.sum(side, depth + min(place, 1))

    def sum(self, nodes: list[Node], depth: int) -> None:
        """Term by term."""
        if self.fits(nodes):
            return self.place(nodes)
        for number, term in enumerate(_split(nodes, "sign")):
            if number and not self.fits(term):
                self.begin(depth + 2)
            if self.fits(term):
                self.place(term)
            else:
                self.product(term, depth + 2)
        return None

    def product(self, nodes: list[Node], depth: int) -> None:
        """Factor by factor."""
        for number, factor in enumerate(_factors(nodes)):
            if not self.fits(factor) and number and width(factor) <= self.room - depth * INDENT - 15:
                self.begin(depth)
                self.put(r"\times", 13.0)
            if self.fits(factor):
                self.place(factor)
            else:
                for node in factor:
                    self.opened(node, depth)

    def opened(self, node: Node, depth: int) -> None:
        """A bracket or a fraction of which the inside is broken; what has no inside stands as it is."""
        if self.fits([node]) or node.kind not in ("fence", "fraction"):
            return self.place([node])
        if node.kind == "fence":
            return self.fence(node, depth)
        top, bottom = node.inside
        if width(bottom) < self.room / 2:
            factor = Node("fraction", r"\frac", [[Node("atom", "1")], bottom])
            if top[0].text == "-" and not any(other.kind == "sign" for other in top):
                self.put("-", 8.0)
                top = top[1:]
            self.place([factor])
            whole = any(other.kind == "sign" for other in top)
            return self.fence(Node("fence", "", [top], ("(", ")")), depth) if whole else self.product(top, depth)
        self.fence(Node("fence", "", [top], ("(", ")")), depth)
        self.put(r"\Big/", 8.0)
        return self.fence(Node("fence", "", [bottom], ("(", ")")), depth)

    def fence(self, node: Node, depth: int) -> None:
        """Its inside term by term, between brackets that need no partner on their line."""
        if node.ends[0] != ".":
            self.put(r"\Bigl" + node.ends[0], 7.0)
        self.relations(node.inside[0], depth)
        points = max((width(nodes, 2) for _, nodes in node.script), default=0.0)
        if self.used + points <= self.room:
            return self.put(rf"\Bigr{node.ends[1]}" + scripts(node), 7.0 + points)
        for token, nodes in node.script:  # the places of a bar: a column of lines, in the small letters of an index
            room = (self.room - depth * INDENT - 30.0) / 0.75
            rows = [line for place in _split(nodes, "comma", after=True) for line in broken(written(place), room)]
            points = max(width(parse(row), 2) for row in rows)
            if self.used + points + 7.0 > self.room:
                self.begin(depth)
            column = r" \\ ".join(rows)
            self.put(rf"\Bigr{node.ends[1]}{token}{{\begin{{subarray}}{{l}}{column}\end{{subarray}}}}", points + 7.0)
        return None


def _split(nodes: list[Node], kind: str, after: bool = False) -> list[list[Node]]:
    """The parts between nodes of a kind, which begin a part, or end it."""
    parts: list[list[Node]] = [[]]
    for node in nodes:
        if node.kind == kind and not after and parts[-1]:
            parts.append([])
        parts[-1].append(node)
        if node.kind == kind and after:
            parts.append([])
    return [part for part in parts if part]


def _factors(nodes: list[Node]) -> list[list[Node]]:
    """A product may be broken after a bracket or a fraction, but not before a differential or what d/dx acts on."""
    parts: list[list[Node]] = [[]]
    for node in nodes:
        if parts[-1] and _ends(parts[-1][-1]) and not _belongs(node):
            parts.append([])
        parts[-1].append(node)
    return parts


def _ends(node: Node) -> bool:
    derives = node.kind == "fraction" and node.inside[0][0].text in ("d", r"\partial")
    return node.kind in ("fence", "fraction") and not derives


def _belongs(node: Node) -> bool:
    return node.text in (r"\,", ".", ",", "!") or node.kind in ("comma", "relation")
