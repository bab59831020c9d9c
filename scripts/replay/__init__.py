"""The answers and the errata of `data/`, recomputed without the library; see docs/replay.md."""
