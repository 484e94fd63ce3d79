"""What all tests share: repeatable examples, and figures drawn without a display."""

import matplotlib
from hypothesis import settings

matplotlib.use("Agg")

# The same examples on every machine and no deadline: a slow machine is not a broken law.
settings.register_profile("freebody", derandomize=True, deadline=None)
settings.load_profile("freebody")
