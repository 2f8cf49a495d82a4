"""Pictures as bytes."""

import pytest

from asymptotics.present.figures import render


@pytest.mark.parametrize("kind", ["svg", "png"])
def test_pictures_are_the_same_bytes_each_time(kind):
    def draw(axes):
        axes.plot([0, 1], [1, 0], label=r"$\omega t$")
        axes.legend()

    assert render(draw, kind=kind) == render(draw, kind=kind)
    assert render(draw, kind=kind) != render(lambda axes: axes.plot([0, 1]), kind=kind)
