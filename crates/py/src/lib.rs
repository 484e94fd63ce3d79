//! The Python face of freebody-core: converts and calls, no formula.
