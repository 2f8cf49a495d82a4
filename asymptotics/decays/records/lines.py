"""One line of a text table: its cells, and whether it is a remark.

>>> split('1.5;"a;b"; 2', ";"), is_comment("# made today"), is_comment("1 2")
(['1.5', 'a;b', '2'], True, False)
"""

import csv
import re

WHITE = " "
COMMENT = re.compile(r"\s*(?:#|%|//|!)\s?")


def split(line: str, separator: str) -> list[str]:
    """The cells of one line, quotes obeyed, without the white space around them."""
    if separator == WHITE:
        return line.split()
    if '"' not in line:
        return [cell.strip() for cell in line.strip(" ").split(separator)]
    return [cell.strip() for cell in next(csv.reader([line], delimiter=separator, skipinitialspace=True), [])]


def is_comment(line: str) -> bool:
    """A line that is blank, or a remark: from its first sign on."""
    return not line.strip() or bool(COMMENT.match(line))
