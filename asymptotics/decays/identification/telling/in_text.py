"""An identification as lines of text: the verdict, the laws, the strengths of the best, textbook estimates, notes."""

from asymptotics.decays.identification.telling.result import Identification


def told(answer: Identification) -> str:
    """What the command prints."""
    said = [line for line in (answer.in_words, answer.verdict.telling) if line]
    lines = [answer.verdict.text, *said, "", answer.table(), ""]
    for law in answer.laws[:1]:
        lines.append(law.law.candidate.formula())
        shown = [law.physical(i) for i in range(len(law.law.epsilon))]
        lines += [
            f"  {name} of {a}: {ends.estimate:.4g} [{ends.low:.4g}, {ends.high:.4g}] (SI)"
            for a, found in zip(law.law.candidate.alphas, shown)
            if found is not None
            for name, ends in [found]
            if ends.low is not None and ends.high is not None
        ]
    for name, found in answer.textbook.items():
        bias = "" if found["systematic_error"] is None else f", systematic error {', '.join(found['systematic_error'])}"
        lines.append(f"{name}: epsilon of {','.join(found['alphas'])} = {', '.join(found['epsilon'])}{bias}")
    return "\n".join([*lines, *(f"note: {note}" for note in answer.notes)])
