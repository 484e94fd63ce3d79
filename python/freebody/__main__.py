"""`python -m freebody`."""

from freebody.cli import main

main()
