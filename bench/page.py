"""The tables of docs/speed.md, out of results.json and vehicles.json: `python bench/page.py` renews them."""

import json
from collections.abc import Callable
from pathlib import Path

RESULTS = Path(__file__).with_name("results.json")
VEHICLES = Path(__file__).with_name("vehicles.json")
PAGE = Path(__file__).parents[1] / "docs/speed.md"
END = "<!-- end -->\n"


def peers() -> str:
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


def vehicles() -> str:
    """Markdown: a line a vehicle, a column a measure, its time over that of the plain body."""
    results = json.loads(VEHICLES.read_text())
    measures = list(next(iter(results["ratios"].values())))
    lines = [f"| vehicle | operations | {' | '.join(measures)} |", f"|---|---:|{'---:|' * len(measures)}"]
    for name, ratios in results["ratios"].items():
        cells = " | ".join(f"{ratios[measure]:g}" for measure in measures)
        lines.append(f"| {name} | {results['operations'][name]} | {cells} |")
    return f"{results['instruction_set']}, one thread.\n\n" + "\n".join(lines) + "\n"


TABLES: dict[str, Callable[[], str]] = {
    "<!-- table: bench/page.py -->\n": peers,
    "<!-- table of vehicles: bench/page.py -->\n": vehicles,
}


def renewed() -> str:
    """The page with the tables as they are now."""
    text = PAGE.read_text()
    for mark, table in TABLES.items():
        before, rest = text.split(mark)
        _, after = rest.split(END, 1)
        text = f"{before}{mark}\n{table()}\n{END}{after}"
    return text


def renew() -> None:
    PAGE.write_text(renewed())


if __name__ == "__main__":
    renew()
