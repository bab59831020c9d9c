"""A second solver of five positions, its problems and the comparison; none of it shares code with the library."""
