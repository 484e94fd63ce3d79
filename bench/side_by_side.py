"""freebody beside its peers, in one run: `make bench`, which installs the peers first.

The case and its right answers are in case.py and reference.py, an adapter for each program in peers.
"""

import argparse
import importlib

import page
import picture
import report
from measures import Row, bulk, ensembles, single, trajectories
from race import Tuning
from way import Program

PROGRAMS = {
    "ours": "Freebody",
    "with_heyoka": "Heyoka",
    "with_numbalsoda": "NumbaLsoda",
    "with_casadi": "CasADi",
    "with_scipy": "SciPy",
    "with_pinocchio": "Pinocchio",
    "with_mujoco": "MuJoCo",
}


def programs() -> list[Program]:
    """Those that are installed; the others are named, with the reason."""
    found: list[Program] = []
    for module, kind in PROGRAMS.items():
        try:
            found.append(getattr(importlib.import_module(f"peers.{module}"), kind)())
            print(f"{found[-1].name} {found[-1].version}")
        except ImportError as missing:
            print(f"{kind}: not installed ({missing})")
    return found


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--only", default="", help="measures, such as AC: printed, and nothing written")
    wanted = parser.parse_args().only or "ABCDE"

    everyone, tuning = programs(), Tuning()
    traced = importlib.import_module("peers.ours").FreebodyTape()
    print(f"{traced.name}: {traced.operations} operations\n")
    rows: list[Row] = []
    measures = {
        "AE": lambda: single(everyone),
        "BE": lambda: bulk(everyone),
        "C": lambda: trajectories(everyone, tuning),
        "D": lambda: ensembles([*everyone, traced], tuning),
    }
    for letters, measure in measures.items():
        if set(letters) & set(wanted):
            for row in measure():
                if row.name[0] in wanted:
                    report.show(row)
                    rows.append(row)
    report.summary(rows)
    if wanted == "ABCDE":
        page.RESULTS.write_text(report.ratios(rows, everyone))
        page.renew()
        picture.draw(everyone, page.PAGE.with_name("work-precision.svg"))


if __name__ == "__main__":
    main()
