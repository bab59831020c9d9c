"""Every scene by its name in the data."""

from . import (conchoid, coupler, evans, filemon1970, filemon1973, five_positions, four_bars, four_positions,
               kaufman, known_roots, slider_crank, symmetric, watt, wunderlich1968)

SCENES = {}
for module in (conchoid, coupler, evans, filemon1970, filemon1973, five_positions, four_bars, four_positions,
               kaufman, known_roots, slider_crank, symmetric, watt, wunderlich1968):
    SCENES |= module.SCENES
