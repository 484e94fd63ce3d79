"""One adapter a file: what a peer's user would write for the same case, in the mode that is best for it."""
