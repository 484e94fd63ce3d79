"""The documents say what is so: commands, code, names, paths and links."""

import re
import runpy
import subprocess
import sys
from functools import cache
from pathlib import Path

import pytest

import freebody as fb
from repo.repository import ROOT, blocks, documents, relative

README = ROOT / "README.md"
TARGETS = set(re.findall(r"^([a-z]+):", (ROOT / "Makefile").read_text(), re.MULTILINE))
OUTPUTS = runpy.run_path(str(ROOT / "tools/page_outputs.py"))
PAGES = pytest.mark.parametrize("page", documents(), ids=relative)


def attributes(owner: object) -> set[str]:
    """What the owner has, fields and what its constructor sets included."""
    constructor = getattr(getattr(owner, "__init__", None), "__code__", None)
    return {*dir(owner), *getattr(owner, "__annotations__", ()), *getattr(constructor, "co_names", ())}


@PAGES
def test_every_make_command_is_a_target(page):
    commands = re.findall(r"^(?:\$ )?make ([a-z]+)|`make ([a-z]+)", page.read_text(), re.MULTILINE)
    assert {a or b for a, b in commands} <= TARGETS


@cache
def command_help() -> str:
    command = [sys.executable, "-m", "freebody", "--help"]
    return subprocess.run(command, capture_output=True, text=True, check=True).stdout


@PAGES
def test_every_subcommand_exists(page):
    for command in re.findall(r"(?:^|`)(?:\$ )?freebody ([a-z]+)", page.read_text(), re.MULTILINE):
        assert re.search(rf"\b{command}\b", command_help()), f"freebody has no command {command}"


@PAGES
def test_python_blocks_run_and_print_what_the_page_shows(page, tmp_path, monkeypatch):
    """`python tools/page_outputs.py PAGE` renews what is shown."""
    monkeypatch.chdir(tmp_path)
    assert OUTPUTS["renewed"](page) == page.read_text()


@PAGES
def test_every_name_of_the_library_exists(page):
    # Dispersions call the parameters of the surroundings `environment.NAME`, as the module is called.
    known = {name: getattr(fb, name) for name in fb.__all__ if name != "environment"}
    owners = {"fb": fb, "forms": fb.forms, **known}
    code = " ".join(re.findall(r"`([^`\n]+)`", page.read_text()) + blocks(page, "py(?:thon)?"))
    for owner, name in re.findall(r"(?<![\w./])([A-Za-z]\w*)\.([A-Za-z]\w*)", code):
        if owner in owners:
            assert name in attributes(owners[owner]), f"{owner}.{name}"


@PAGES
def test_internal_links_resolve(page):
    for target in re.findall(r"\]\((?!https?:)([^)#\s]*)[^)]*\)", page.read_text()):
        assert (page.parent / target).exists(), target


@PAGES
def test_every_whole_model_file_shown_is_valid(page, tmp_path):
    for text in blocks(page, "toml"):
        if "[model]" in text:
            path = tmp_path / "shown.toml"
            path.write_text(text)
            assert fb.load(path).x0 is not None


def architecture_tree() -> list[Path]:
    """The paths of ARCHITECTURE's tree."""
    (tree,) = blocks(ROOT / "ARCHITECTURE.md", "text")
    paths: list[Path] = []
    folders: list[str] = []
    for indent, name in re.findall(r"^( *)(\S+)", tree, re.MULTILINE):
        folders[len(indent) // 2 :] = [name]
        paths.append(ROOT.joinpath(*folders))
    return paths


def test_every_path_in_the_architectures_tree_exists():
    assert [path for path in architecture_tree() if not path.exists()] == []


@pytest.mark.parametrize("folder", ["crates/core/src", "python/freebody"])
def test_every_module_is_in_the_architectures_tree(folder):
    private = re.compile(r"_|lib\.rs|py\.typed|tests$")
    modules = {path for path in ROOT.joinpath(folder).iterdir() if not private.match(path.name)}
    assert modules - set(architecture_tree()) == set()


def test_the_readme_lists_the_shipped_models():
    shipped = {path.stem for path in ROOT.glob("models/*.toml")}
    listed = set(re.findall(r"`(\w+)`", README.read_text().split("## Models shipped")[1].split("##")[0]))
    assert listed == shipped


def test_the_readme_opens_with_the_two_commands():
    commands = [line for block in blocks(README, "sh") for line in block.splitlines()]
    assert [line.split("#")[0].strip() for line in commands[:2]] == ["make demo", "make test"]
