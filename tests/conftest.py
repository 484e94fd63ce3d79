"""What all tests share: repeatable examples, figures drawn without a display, interrupts that are heard."""

import signal

import matplotlib
from hypothesis import settings

matplotlib.use("Agg")

# Who runs tests in the background makes them deaf to interrupts, and the commands that they start, too.
signal.signal(signal.SIGINT, signal.default_int_handler)

# The same examples on every machine and no deadline: a slow machine is not a broken law.
settings.register_profile("freebody", derandomize=True, deadline=None)
settings.load_profile("freebody")
