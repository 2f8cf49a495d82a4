"""An identification as lines of text: the verdict, its laws, Q, the table of laws, textbook estimates, notes."""

from asymptotics.decays.identification.telling.result import Identification


def identification_text(answer: Identification) -> str:
    """What the command prints."""
    said = [line for line in (*answer.lines, answer.verdict.telling) if line]
    lines = [answer.verdict.text, *said, "", answer.table(), ""]
    for name, found in answer.textbook.items():
        bias = "" if found["systematic_error"] is None else f", systematic error {', '.join(found['systematic_error'])}"
        lines.append(f"{name}: epsilon of {','.join(found['alphas'])} = {', '.join(found['epsilon'])}{bias}")
    return "\n".join([*lines, *(f"note: {note}" for note in answer.notes)])
