"""The facts of the sheet on a lamp with an area, from the geometry itself instead of the sheet's formulas."""

from fractions import Fraction as F
from math import log, pi, sqrt

from check import check

HALF_A_BYTE = 0.5 / 255


def x_of(column):
    return 2 + (F(column) - F(299, 2)) / 50


def share(x):
    """The share of the lamp that the floor sees at x: the last point behind the wall is bisected."""

    def is_hidden(lamp):
        # Both sides of the wall, and the height of the ray there.
        return any(0 < t < 1 and 5 * t < 2 for t in (x / (x - lamp), (x + F(1, 5)) / (x - lamp)))

    left, right = F(-15, 4), F(-9, 4)
    if not is_hidden(left) or is_hidden(right):
        return float(not is_hidden(left))
    for _ in range(40):
        middle = (left + right) / 2
        left, right = (middle, right) if is_hidden(middle) else (left, middle)
    return float((F(-9, 4) - left) / F(3, 2))


def crossing(level):
    """The column in which the share is at this level, linear between the pixels."""
    for column in range(110, 190):
        before, after = share(x_of(column)), share(x_of(column + 1))
        if before < level <= after:
            return column + (level - before) / (after - before)


def light(region, lamp, cells=50):
    """The mean light over a region, and five standard deviations of it by 256 random points of the lamp."""
    left, top, width, height = region
    mean = variance = 0
    for pixel in range(width * height):
        x = float(x_of(left + pixel % width))
        z = (top + pixel // width - 99.5) / 50
        lights = [lamp(x, z, (i + 0.5) / cells, (j + 0.5) / cells) for i in range(cells) for j in range(cells)]
        expected = sum(lights) / cells**2
        mean += expected / (width * height)
        variance += sum((light - expected) ** 2 for light in lights) / cells**2
    return mean, 5 * sqrt(variance / 256) / (width * height)


def lying(x, z, u, v):
    squared = (1 + 2 * u - x) ** 2 + 1 + (2 * v - 1 - z) ** 2
    return 4 / (pi * squared**2)


def standing(x, z, u, v):
    squared = x**2 + u**2 + (2 * v - 1 - z) ** 2
    return 2 * x * u / (pi * squared**2)


below, below_5 = light((146, 96, 8, 8), lying)
touch, touch_5 = light((60, 90, 10, 20), standing)


def deviation(p):
    """By how many pixels of a fiftieth a random share p of 256 samples, over 101 rows, moves a crossing."""
    return sqrt(p * (1 - p) / 256 / 101) * 50


def squares(k):
    """The error of k by k random points in squares, over the columns of the half-shadow."""
    fractions = [share(x_of(column)) * k % 1 for column in range(130, 170)]
    return sqrt(sum(f * (1 - f) / k**3 for f in fractions) / len(fractions))


check(
    "lamp",
    {
        "lit": share(x_of(190)),
        "umbra": share(x_of(115)),
        "middle": crossing(0.5) - 100,
        "width": crossing(0.9) - crossing(0.1),
        "below": below,
        "touch": touch,
        "back": 0,
        "slope": log(squares(8) / squares(2)) / log(64 / 4),
        "same": 0,
        "rays": 0,
    },
    {
        "lit": HALF_A_BYTE,
        "umbra": HALF_A_BYTE,
        "middle": 5 * deviation(0.5) + 50 * HALF_A_BYTE,
        "width": 5 * sqrt(2) * deviation(0.1) + 2 * 50 * HALF_A_BYTE,
        # By the relative errors of the first and the last of three spreads.
        "slope": 5 * sqrt(2) * sqrt(1 / (2 * 6400)) / log(16),
        "below": below_5 + HALF_A_BYTE,
        "touch": touch_5 + HALF_A_BYTE,
    },
    exact={"slope": [share(x_of(column)) for column in range(130, 170)]},
)
