"""XML files as trees whose elements know their lines.

The standard parser itself (expat): it loads nothing that a file refers to, and files that declare entities
are refused, so that nothing expands.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from pathlib import Path
from xml.parsers import expat

from freebody.errors import ModelFileError

__all__ = ["Node", "read_xml"]

_DEEPEST = 200


@dataclass
class Node:
    """An element: its name without namespace, attributes, own text, children, and where it stands."""

    tag: str
    attributes: dict[str, str]
    file: str
    line: int
    text: str = ""
    children: list[Node] = field(default_factory=list)

    def all(self, *tags: str) -> list[Node]:
        """The children of these names."""
        return [child for child in self.children if child.tag in tags]

    def child(self, *tags: str) -> Node | None:
        """The only child of these names, or none."""
        found = self.all(*tags)
        if len(found) > 1:
            raise found[1].error(
                f"<{self.tag}> of line {self.line} has another <{found[0].tag}>; one is allowed"
            )
        return found[0] if found else None

    def needed(self, *tags: str) -> Node:
        """The only child of these names."""
        found = self.child(*tags)
        if found is None:
            raise self.error(f"<{self.tag}> has no {' or '.join(f'<{tag}>' for tag in tags)}")
        return found

    def attribute(self, name: str) -> str:
        """An attribute that must be there."""
        if name not in self.attributes:
            raise self.error(f"<{self.tag}> has no attribute {name}")
        return self.attributes[name]

    def words(self) -> str:
        """The text in one line."""
        return " ".join(self.text.split())

    def error(self, message: str, key: str | None = None) -> ModelFileError:
        """The error that names the file and the line."""
        return ModelFileError(message, file=self.file, line=self.line, key=key)


def read_xml(path: Path) -> Node:
    """The root of an XML file; raises `ModelFileError`."""
    file = str(path)
    try:
        data = path.read_bytes()
    except OSError as fault:
        raise ModelFileError(f"cannot be read: {fault.strerror}", file=file) from None
    parser = expat.ParserCreate()
    parser.buffer_text = True
    top = Node("", {}, file, 0)
    stack = [top]

    def start(tag: str, attributes: dict[str, str]) -> None:
        stripped = {key: value.strip() for key, value in attributes.items()}
        node = Node(_local(tag), stripped, file, parser.CurrentLineNumber)
        if len(stack) > _DEEPEST:
            raise node.error(f"<{node.tag}> stands more than {_DEEPEST} levels deep")
        stack[-1].children.append(node)
        stack[-1].text += " "  # what stands before and behind an element or a comment is two words
        stack.append(node)

    def end(_: str) -> None:
        stack.pop()

    def text(data: str) -> None:
        stack[-1].text += data

    def space(_: str) -> None:
        stack[-1].text += " "

    def entity(name: str, *_: object) -> None:
        raise ModelFileError(
            f"declares the entity {name}; entities are not read: write out what they stand for",
            file=file,
            line=parser.CurrentLineNumber,
        )

    def unknown_entity(name: str, _: bool) -> None:
        stack[-1].text += f"&{name};"  # of a DTD that is not loaded: stays visible, and is no number

    parser.StartElementHandler = start
    parser.EndElementHandler = end
    parser.CharacterDataHandler = text
    parser.CommentHandler = space
    parser.EntityDeclHandler = entity
    parser.SkippedEntityHandler = unknown_entity
    try:
        parser.Parse(data, True)
    except expat.ExpatError as fault:
        reason = expat.errors.messages[fault.code]
        raise ModelFileError(f"no XML: {reason}", file=file, line=fault.lineno) from None
    return top.children[0]


def _local(tag: str) -> str:
    """The name without its prefix: files come with namespaces, with prefixes, and without either."""
    return tag.rpartition(":")[2]
