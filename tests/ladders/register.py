"""How the registers of functions that return balls are written: ``upper_bounds``, ``elsewhere``, ``none_needed``."""

Names = dict[str, str]


def each(module: str, names: str, told: str) -> Names:
    """The functions of a module -> a test (of the file that has the module's name, or ``FILE::TEST``), or a reason."""
    room, _, name = module.rpartition(".")
    file = "/".join(["tests", *room.split("."), f"test_{name}.py"]) if room else f"tests/test_{name}.py"
    told = f"{file}::{told}" if told.startswith("test_") else told
    return {f"asymptotics.{module}.{function}": told for function in names.split()}
