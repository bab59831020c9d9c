"""Configurations of the scenes of `data/papers`, constructed numerically from what their symbols mean.

A scene is a function of a random generator that gives the values of its symbols, or raises NoValue where
the numbers that were drawn close no such figure. Nothing here reads the formulas that are judged.
"""
