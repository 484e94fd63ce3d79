"""The table of docs/speed.md, out of results.json: `python bench/page.py` renews it."""

import json
from pathlib import Path

RESULTS = Path(__file__).with_name("results.json")
PAGE = Path(__file__).parents[1] / "docs/speed.md"
MARKS = ("<!-- table: bench/page.py -->\n", "<!-- end -->\n")


def table() -> str:
    """Markdown: a line a measure, a column a peer, their time over ours."""
    results = json.loads(RESULTS.read_text())
    peers = [name for name in results["versions"] if name != "freebody"]
    versions = ", ".join(f"{name} {results['versions'][name]}" for name in peers)
    lines = [f"| measure | {' | '.join(peers)} |", f"|---|{'---:|' * len(peers)}"]
    for measure, by_threads in results["ratios"].items():
        for threads, ratios in by_threads.items():
            cells = [f"{ratios[name]:g}" if name in ratios else "" for name in peers]
            if any(cells):
                lines.append(f"| {measure}, {threads} | {' | '.join(cells)} |")
    return f"{results['instruction_set']}; {versions}.\n\n" + "\n".join(lines) + "\n"


def renewed() -> str:
    """The page with the table as it is now."""
    before, rest = PAGE.read_text().split(MARKS[0])
    _, after = rest.split(MARKS[1])
    return f"{before}{MARKS[0]}\n{table()}\n{MARKS[1]}{after}"


def renew() -> None:
    PAGE.write_text(renewed())


if __name__ == "__main__":
    renew()
