"""The facts of `tree.toml` once more: pixels and nodes are counted, and the slope is fitted."""

import math
from fractions import Fraction

from check import check


def covered():
    """The part of 100 pixels of a cell, 10 by 10, whose rays meet its ball."""
    radius = Fraction(42, 10)
    pixels = [(x, y) for x in range(-5, 5) for y in range(-5, 5)]
    return Fraction(sum(x * x + y * y < radius * radius for x, y in pixels), len(pixels))


def tests(count):
    """The tests of a ray that meets the first of these balls in a row: both children of each node on the way."""
    if count == 1:
        return 1
    return 2 + tests(count // 2)


def slope(errors):
    """Of the least squares line through these logarithms, by its normal equations."""
    rows = [(math.log(n), math.log(error)) for n, error in errors.items()]
    xs, ys = [sum(row[i] for row in rows) for i in (0, 1)]
    xy, xx = sum(x * y for x, y in rows), sum(x * x for x, _ in rows)
    return (len(rows) * xy - xs * ys) / (len(rows) * xx - xs * xs)


COUNTS = [10**k for k in (2, 3, 4, 5)]
HALF_BYTE = 0.5 / 255
# Tests with leaves of up to 16 balls, beside three for each level.
LEAF = {n: 3 * math.log2(n) + 16 for n in COUNTS}

check(
    "tree",
    {
        "none": 0.25,
        "same": 0,
        "first": 1,
        "many": float(covered() + (1 - covered()) / 4),
        # The root is tested, too. A thousand balls have 9 or 10 levels: count the deeper side.
        "nearer": (1 + tests(1024)) / 256,
        "growth": 0,
        "slope": slope({n: math.log(n) for n in COUNTS}),
    },
    least={
        "none": HALF_BYTE,
        "first": HALF_BYTE,
        "many": HALF_BYTE,
        "growth": 16 / 256,
        "slope": slope({n: math.log(n) for n in COUNTS}) - slope(LEAF),
    },
)
