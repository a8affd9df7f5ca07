"""The facts of `glass.toml` once more: rays are followed in the plane by rotation of their direction, and Fresnel's
shares come from the condition that the fields on both sides of a surface are equal.
"""

import cmath
import math

from check import check

N = 1.5


def share(degrees):
    """The mirrored share: each polarisation is a line with an impedance."""
    outside = math.radians(degrees)
    inside = math.asin(math.sin(outside) / N)
    a, b = cmath.exp(1j * outside).real, cmath.exp(1j * inside).real
    mirrored = 0
    for before, behind in [(1 / a, 1 / (N * b)), (a, b / N)]:
        mirrored += ((behind - before) / (behind + before)) ** 2 / 2
    return mirrored


def shift(degrees):
    """How far a plate of thickness 1 displaces a ray, across its direction: the cross product of the direction with
    the way through the plate.
    """
    outside = math.radians(degrees)
    inside = math.asin(math.sin(outside) / N)
    way = (math.tan(inside), 1)
    return way[1] * math.sin(outside) - way[0] * math.cos(outside)


def direction_behind(height, radii):
    """The angle to the axis, upwards, of a ray that was parallel to it, behind balls of glass and air by turns."""
    angle, point = 0.0, (-9.0, height)
    indices = [1, *[N if i % 2 == 0 else 1 for i in range(len(radii))]]
    surfaces = [(r, indices[i], indices[i + 1], -1) for i, r in enumerate(radii)]
    surfaces += [(r, after, before, 1) for r, before, after, _ in reversed(surfaces)]
    for radius, before, after, root in surfaces:
        d = (math.cos(angle), math.sin(angle))
        half = point[0] * d[0] + point[1] * d[1]
        square = half * half - point[0] ** 2 - point[1] ** 2 + radius * radius
        t = -half + root * math.sqrt(square)
        point = (point[0] + t * d[0], point[1] + t * d[1])
        # The angle of the inner normal of a surface that the ray enters, of the outer one where it leaves.
        normal = math.atan2(-root * -point[1], -root * -point[0])
        angle = normal + math.asin(math.sin(angle - normal) * before / after)
    return math.degrees(angle)


def height_with(angle, radii, low, high):
    """The height from which a ray leaves under this angle."""
    rises = direction_behind(high, radii) > angle
    for _ in range(100):
        middle = (low + high) / 2
        if (direction_behind(middle, radii) > angle) == rises:
            high = middle
        else:
            low = middle
    return low


def rays(least):
    """The rays that are followed through a plate from straight ahead."""
    count, waiting = 0, [(1.0, False)]
    while waiting:
        weight, is_inside = waiting.pop()
        count += 1
        # The first ray and all inside meet a surface; what leaves meets none.
        if count == 1 or is_inside:
            for part, inside in [(0.04, is_inside), (0.96, not is_inside)]:
                if weight * part >= least:
                    waiting.append((weight * part, inside))
    return count


def shown(value):
    return math.floor(value * 255 + 0.5) / 255


ERRORS = [0.4 * (1 - share(80)) * share(80) ** (depth - 2) for depth in (2, 3, 4, 5)]
# The weights of the logarithms in the slope through four points at equal distances.
WEIGHTS = [-0.3, -0.1, 0.1, 0.3]
SLOPE = sum(weight * math.log(error) for weight, error in zip(WEIGHTS, ERRORS))
HALF_BYTE = 0.5 / 255

check(
    "glass",
    {
        "displaced": 50 + shift(45) / 0.01,
        "normal": (1 - share(0)) ** 2,
        "depth": SLOPE,
        "mirrored": share(80),
        "total": 1,
        "ball": 125 - height_with(-30, [1], 0.1, 0.9) / 0.01 - 40,
        # Below the axis the ray is turned down, so by symmetry it is turned up above it.
        "bubble": 125 + height_with(30, [1, 0.5], 0.1, 0.4999) / 0.01 - 155,
        "balance": 0.4 * (1 - share(80)) * share(80) ** 18,
        "grazing": shift(89.9) / 0.01,
        "count": rays(1e-6) / 64,
    },
    least={
        "displaced": 0.5,
        "normal": HALF_BYTE,
        "depth": sum(abs(w) * HALF_BYTE / error for w, error in zip(WEIGHTS, ERRORS)),
        "mirrored": HALF_BYTE,
        "total": HALF_BYTE,
        "ball": 0.5,
        "bubble": 0.5,
        "balance": HALF_BYTE,
        "grazing": 0.5,
        "count": HALF_BYTE,
    },
)
# What comes through at 89.9° has to be seen beside the bytes of rounding.
assert shown(5000 * (1 - share(89.9)) ** 2) > 0.5
# The critical angle lies nearer to the middle than the region beyond it.
assert 150.5 * math.tan(math.asin(1 / N)) < 286 - 150
