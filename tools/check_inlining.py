"""Checks that no kernel function lost its instruction set: `check_inlining.py LIBRARY`.

A generic function that the compiler does not inline into `Real::call` is compiled without the
instruction set of its caller. Its results stay right, but each intrinsic becomes a call and each
fused product a library call, 3 to 80 times slower. Both leave symbols in the built library, which
must therefore be unstripped.
"""

import argparse
import re
import subprocess
import sys

INTRINSIC = re.compile(r"\bcore(\[\w+\])?::core_arch::")
# Asking the processor what it has is a call by nature.
DETECTION = re.compile(r"::(__cpuid(_count)?|__get_cpuid_max|has_cpuid|_xgetbv)\b")

ADVICE = """\
A function between Real::call and these was not inlined, so it lost the instruction set. Mark it
#[inline(always)]; write a closure as a direct call argument, `#[inline(always)] || ...`; run code
on registers or Fused numbers only inside L::call."""


def symbols(library: str) -> list[tuple[str, str]]:
    """Kind and demangled name of every symbol of the library."""
    listing = subprocess.run(["nm", "--demangle", library], capture_output=True, text=True, check=False)
    if listing.returncode:
        sys.exit(f"check_inlining: cannot read {library}: {listing.stderr.strip()}")
    matches = re.finditer(r"^[0-9a-f ]+ (\w) (.+)$", listing.stdout, re.MULTILINE)
    return [(match[1], match[2]) for match in matches]


def main() -> None:
    parser = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    parser.add_argument("library", help="the built library, not stripped")
    library = parser.parse_args().library

    found = symbols(library)
    if not any(kind == "t" for kind, _ in found):
        sys.exit(f"check_inlining: {library} is stripped, so it shows nothing; build it with strip = false")
    outlined = [name for _, name in found if INTRINSIC.search(name) and not DETECTION.search(name)]
    # The library call comes from the C library or, on some targets, from the Rust runtime itself.
    outlined += [name for _, name in found if re.fullmatch(r"_?fma(@.*)?", name)]
    if outlined:
        listed = "\n".join(f"  {name}" for name in sorted(set(outlined)))
        sys.exit(f"check_inlining: {library} calls, instead of having inlined:\n{listed}\n{ADVICE}")
    print(f"check_inlining: {library}: every intrinsic is inlined")


if __name__ == "__main__":
    main()
