"""The house rules that a machine can read."""

import re
import tomllib
from pathlib import Path

from repo.repository import ROOT, relative, text_files

# A path or a host of one machine, in any file, is wrong on every other machine.
LOCAL = re.compile(r"(?<![\w.~}$)-])/(?:home|root|work|Users)/|files\.pythonhosted|index\.crates\.io")


def test_no_file_names_a_machine():
    texts = {relative(p): p.read_text() for p in text_files() if p.name != Path(__file__).name}
    assert {path: found[0] for path, text in texts.items() if (found := LOCAL.search(text))} == {}


def test_one_subject_a_file():
    sources = [p for p in text_files() if p.suffix in {".rs", ".py", ".pyi"}]
    sizes = {
        relative(p): len(p.read_text().splitlines())
        for p in sources
        if "tests" not in p.relative_to(ROOT).parts
    }
    assert {path: lines for path, lines in sizes.items() if lines > 300} == {}


def test_unsafe_code_stands_where_contributing_says():
    rule = (ROOT / "CONTRIBUTING.md").read_text().partition("## Unsafe code")[2].partition("\n## ")[0]
    sources = {relative(p): p.read_text() for p in text_files() if p.suffix == ".rs"}
    unsafe = {path: text for path, text in sources.items() if re.search(r"\bunsafe\b", text)}
    assert sorted(unsafe) == sorted(re.findall(r"`(crates/[\w/.]+)`", rule))
    assert all("// SAFETY" in text for text in unsafe.values())


def test_the_package_imports_modules_from_its_root_and_no_names():
    """import-linter takes an import of the compiled `_core` for one of the root, and lets both pass."""
    package = ROOT / "python/freebody"
    modules = {path.stem for path in package.iterdir()}
    for source in package.rglob("*.py"):
        for names in re.findall(r"^\s*from freebody import ([\w, ]+)", source.read_text(), re.MULTILINE):
            assert {re.split(r" as ", name.strip())[0] for name in names.split(",")} <= modules, source


def test_one_version_and_the_changelog_knows_it():
    cargo = tomllib.loads((ROOT / "Cargo.toml").read_text())
    version = cargo["workspace"]["package"]["version"]
    pyproject = tomllib.loads((ROOT / "pyproject.toml").read_text())
    assert "version" in pyproject["project"]["dynamic"], "the wheel's version comes from Cargo.toml"
    for crate in cargo["workspace"]["members"]:
        manifest = tomllib.loads((ROOT / crate / "Cargo.toml").read_text())
        assert manifest["package"]["version"] == {"workspace": True}
    assert re.search(rf"^## \[?{re.escape(version)}\b", (ROOT / "CHANGELOG.md").read_text(), re.MULTILINE)


def test_constraints_pin_every_version_and_nothing_else():
    lines = (ROOT / "constraints.txt").read_text().splitlines()
    assert [line for line in lines if not re.fullmatch(r"[\w.-]+==[\w.]+", line)] == []


def test_every_dependency_is_pinned_and_explained():
    """Why this one and not another: one line each in ARCHITECTURE.md."""
    pyproject = tomllib.loads((ROOT / "pyproject.toml").read_text())
    project, groups = pyproject["project"], pyproject["dependency-groups"]
    lists = [project["dependencies"], *project["optional-dependencies"].values(), *groups.values()]
    listed = {entry for entries in lists for entry in entries if isinstance(entry, str)}
    names = {re.split(r"[\[<>=]", entry)[0] for entry in listed} - {project["name"]}
    pinned = {line.split("==")[0].lower() for line in (ROOT / "constraints.txt").read_text().splitlines()}
    explained = (ROOT / "ARCHITECTURE.md").read_text()
    for name in sorted(names):
        assert name.lower() in pinned, name
        assert re.search(rf"^\| .*`{name}`", explained, re.MULTILINE), f"{name} is not explained"


def test_every_crate_used_is_explained():
    explained = (ROOT / "ARCHITECTURE.md").read_text()
    for manifest in ROOT.glob("crates/*/Cargo.toml"):
        tables = tomllib.loads(manifest.read_text())
        for name in {**tables.get("dependencies", {}), **tables.get("dev-dependencies", {})}:
            assert name.startswith("freebody") or f"`{name}`" in explained, f"{name} is not explained"
