"""The facts of `patterns.toml` once more: places are found by following rays through parts of pixels, and numbers of
fields in fractions.
"""

import math
from fractions import Fraction

from check import check


def floor_at(column, row, eye=Fraction(0)):
    """Where the floor is met, exactly: the eye is 8 above it, and a pixel at distance 1 is 1/120 wide."""
    x, down = Fraction(column) - Fraction(319, 2), Fraction(row) - Fraction(239, 2)
    return eye + 8 * x / down, -8 * 120 / down


def is_white(x, z):
    return (math.floor(x) + math.floor(z)) % 2 == 1


def first_change(low, high, pattern):
    """Where the pattern has changed, from low to high."""
    before = pattern(low)
    assert pattern(high) != before
    for _ in range(80):
        middle = (low + high) / 2
        low, high = (middle, high) if pattern(middle) == before else (low, middle)
    return float(low)


def only_color(region, eye=Fraction(0)):
    """The colour that all corners of a region of pixels show, whose field they share."""
    x, y, width, height = region
    corners = [(c, r) for c in (x - 0.5, x + width - 0.5) for r in (y - 0.5, y + height - 0.5)]
    places = [floor_at(Fraction(c), Fraction(r), eye) for c, r in corners]
    fields = {(math.floor(x), math.floor(z)) for x, z in places}
    assert len(fields) == 1, fields
    return float(is_white(*places[0]))


def on_ball(column, row):
    """Longitude and latitude in degrees where a ray parallel to the axis meets the ball."""
    x, y = (column - 120) / 100, (120 - row) / 100
    z = math.sqrt(1 - x * x - y * y)
    return math.degrees(math.atan(x / z)), math.degrees(math.acos(-y)) - 90


def field_on_ball(column, row):
    return tuple(math.floor(degrees / 36) for degrees in on_ball(column, row))


def rows_longer_than(fields):
    """The first row whose pixels are no longer than these fields, from the one below that of the horizon."""
    row = 121
    while True:
        upper, lower = [floor_at(160, row + half)[1] for half in (Fraction(-1, 2), Fraction(1, 2))]
        if lower - upper <= fields:
            return row
        row += 1


HALF_BYTE = 0.5 / 255
PIXELS = 320 * 3
# Five standard deviations of a slope through four errors; that with one ray is exact.
WEIGHTS = [-0.3, -0.1, 0.1, 0.3]
NOISE = 5 * math.sqrt(sum(w * w for w in WEIGHTS[1:]) / (2 * PIXELS)) / math.log(4)
# Half a pixel to either side: 64 rays of which half see each colour.
EDGE = 5 * math.sqrt(0.25 / 64)

check(
    "patterns",
    {
        "corner": first_change(188, 199, lambda column: is_white(*floor_at(column, 211))) - 188,
        "negative": only_color((161, 209, 8, 4)),
        "horizon": 0.5,
        "noise": -0.5,
        "far": only_color((173, 209, 8, 4), Fraction(-3_000_000_000)),
        "meridian": first_change(150, 198, lambda column: field_on_ball(column, 95)) - 150,
        "latitude": 89 - first_change(89, 39, lambda row: field_on_ball(145, row)),
        "picture": (1 / 8 + 2 / 4) / 3,
        # The edge between two rows.
        "count": rows_longer_than(10) - 0.5 - 123,
    },
    least={
        "corner": EDGE,
        "negative": HALF_BYTE,
        "horizon": 5 * 0.5 / math.sqrt(64 * PIXELS) + 0.002,
        "noise": NOISE,
        "far": HALF_BYTE,
        "meridian": EDGE,
        "latitude": EDGE,
        "picture": 2 / 3 * HALF_BYTE,
    },
)
