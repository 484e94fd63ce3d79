"""How many operations the left sides of (2.8), (2.10) and (2.11) take: the table of docs/equations.md.

`operation_counts.py [PAGE]` prints the table, or puts it between the marks of a page.
"""

import sys
from pathlib import Path

import freebody as fb

BEGIN, END = "<!-- operation counts: begin -->\n", "<!-- operation counts: end -->\n"

# The orientation systems that the paper works out. Konoplev, section 4
SYSTEMS = {"Euler": "zxz", "ship": "zyx", "aircraft": "yzx"}
MOMENTS = ("A", "A", "C")
BODIES = {
    "general": fb.SymbolicBody(),
    "symmetric, mass centre on the third axis": fb.SymbolicBody(com=(0, 0, "z_c"), inertia_about_com=MOMENTS),
    "symmetric, mass centre at the origin": fb.SymbolicBody(com=(0, 0, 0), inertia_about_com=MOMENTS),
}
FORMS = ("2.8", "2.10", "2.11")
WAYS = {False: "As they stand", True: "Simplified"}

Count = tuple[float, int]


def count(form: str, angles: str, body: fb.SymbolicBody, *, simplify: bool) -> Count:
    """Operations written out, and with what occurs several times computed once."""
    # No force acts: the right sides are zeros, and what is counted is the left sides.
    return fb.equations(form, angles, body, forces=(), simplify=simplify).operation_count


def counts() -> dict[tuple[str, str], dict[tuple[str, bool], Count]]:
    """By body and orientation system, then by form and whether simplified."""
    ways = [(form, simplify) for simplify in WAYS for form in FORMS]
    return {
        (name, system): {way: count(way[0], angles, body, simplify=way[1]) for way in ways}
        for name, body in BODIES.items()
        for system, angles in SYSTEMS.items()
    }


def table() -> str:
    """The counts in Markdown, as they stand and simplified."""
    text = ""
    for simplify, way in WAYS.items():
        forms = " | ".join(f"({form})" for form in FORMS)
        text += f"\n{way}:\n\n| body | angles | {forms} |\n|---|---|---|---|---|\n"
        for (name, system), row in counts().items():
            numbers = (row[form, simplify] for form in FORMS)
            cells = " | ".join(f"{written_out:.0f} / {shared}" for written_out, shared in numbers)
            text += f"| {name} | {system} `{SYSTEMS[system]}` | {cells} |\n"
    return text + "\n"


def between_marks(page: str) -> str:
    """What a page holds between its marks."""
    return page.partition(BEGIN)[2].partition(END)[0]


if __name__ == "__main__":
    for page in map(Path, sys.argv[1:]):
        text = page.read_text()
        page.write_text(text.replace(between_marks(text), table()))
    if not sys.argv[1:]:
        print(table(), end="")
