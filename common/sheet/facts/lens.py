"""The facts of the sheet on a lens, by counting the points of a fine grid on the lens."""

from math import comb, log, sqrt

from check import check

HALF_A_BYTE = 0.5 / 255
GRID = 1000
POINTS = [(2 * i + 1) / GRID - 1 for i in range(GRID)]
# How many points of a grid in a disc of radius 1 lie in each of its columns.
COLUMNS = [sum(x * x + y * y < 1 for y in POINTS) for x in POINTS]
TOTAL = sum(COLUMNS)


def white(column, depth, focus):
    """The share of a lens of radius 1/2 from which a pixel sees the left of the vertical edge at this depth."""
    aim = (column - 149.5) / 100
    # From x of the lens the ray is at x + depth (aim - x / focus).
    return sum(n for x, n in zip(POINTS, COLUMNS) if x / 2 + depth * (aim - x / 2 / focus) < 0) / TOTAL


def crossing(level, depth, focus):
    for column in range(100, 200):
        before, after = white(column, depth, focus), white(column + 1, depth, focus)
        if before >= level > after:
            return column + (before - level) / (before - after)


def width(depth, focus):
    return crossing(0.1, depth, focus) - crossing(0.9, depth, focus)


def tolerance(depth, focus, levels):
    """Five standard deviations of crossings by 256 random rays and 31 rows, and the rounding to bytes."""
    variance = rounding = 0
    for level in levels:
        place = round(crossing(level, depth, focus))
        slope = (white(place - 1, depth, focus) - white(place + 1, depth, focus)) / 2
        variance += level * (1 - level) / 256 / 31 / slope**2
        rounding += HALF_A_BYTE / slope
    return 5 * sqrt(variance) + rounding


def alike(column):
    """The chance that two pixels of a column have the same number of white rays, of 16 random ones."""
    share = white(column, 5, 2)
    chances = [comb(16, k) * share**k * (1 - share) ** (16 - k) for k in range(17)]
    return sum(chance * chance for chance in chances)


own = sum(alike(column) for column in range(145, 155)) / 10

# The lamp at the depth 5 is seen from the points x of the lens with |x (1 - 5/2)| < 0.12.
share = sum(x * x + y * y < (0.12 / 1.5 / 0.5) ** 2 for x in POINTS for y in POINTS) / TOTAL
check(
    "lens",
    {
        "pinhole": 0,
        "focus": 0.8,
        "middle": crossing(0.5, 5, 2) - 110,
        "behind": width(5, 2),
        "before": width(1.25, 2),
        "infinity": width(5, float("inf")),
        "light": 10 * share,
        "own": own,
        "slope": log(sqrt(4 / 256)) / log(256 / 4),
        "rays": 1 / 64,
    },
    {
        "middle": tolerance(5, 2, [0.5]),
        "behind": tolerance(5, 2, [0.1, 0.9]),
        "before": tolerance(1.25, 2, [0.1, 0.9]),
        "infinity": tolerance(5, float("inf"), [0.1, 0.9]),
        "light": 5 * 10 * sqrt(share * (1 - share) / 256) / 15 + HALF_A_BYTE,
        "own": 5 * sqrt(own * (1 - own) / 300),
        # By the relative errors of the first and the last of the spreads of 620 pixels.
        "slope": 5 * sqrt(2) / sqrt(2 * 620) / log(64),
        "rays": HALF_A_BYTE,
    },
    exact={"slope": [white(column, 5, 2) for column in range(140, 160)]},
)
