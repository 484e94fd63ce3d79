"""DAVE-ML files that tests write."""

from pathlib import Path

from freebody.dave_ml import DaveModel, load_dave_ml

DART = Path(__file__).parent / "dart.dml"


def write(folder: Path, body: str, head: str = "<?xml version='1.0'?>") -> Path:
    """A file of these elements; the first of them stands on line 3."""
    path = folder / "model.dml"
    path.write_text(f"{head}\n<DAVEfunc>\n{body}\n</DAVEfunc>\n", encoding="utf-8")
    return path


def variable(id: str, content: str = "", **attributes: object) -> str:
    """A variableDef in one line."""
    more = "".join(f' {name}="{value}"' for name, value in attributes.items())
    return f'<variableDef name="{id}" varID="{id}" units="nd"{more}>{content}</variableDef>'


def calculation(math: str) -> str:
    return f"<calculation><math>{math}</math></calculation>"


def calculated(folder: Path, math: str, *inputs: str) -> DaveModel:
    """A model whose output `out` is a calculation."""
    lines = [variable(name, "<isInput/>") for name in inputs]
    return load_dave_ml(
        write(folder, "\n".join([*lines, variable("out", calculation(math) + "<isOutput/>")]))
    )


def tabulated(folder: Path, function: str, *inputs: str) -> DaveModel:
    """A model whose output `out` is a function."""
    lines = [variable(name, "<isInput/>") for name in inputs]
    return load_dave_ml(write(folder, "\n".join([*lines, variable("out", "<isOutput/>"), function])))
