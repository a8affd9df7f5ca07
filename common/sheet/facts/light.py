"""The facts of the sheet on light that has been everywhere, by sums and integrals instead of the sheet's formulas."""

from fractions import Fraction as F
from math import cos, log, pi, sin, sqrt

from check import check

HALF_A_BYTE = 0.5 / 255


def furnace(reflectance, depth, factor):
    """The glow of each surface of a path, one after the other."""
    light, weight = 0, F(1)
    for _ in range(depth):
        light, weight = light + weight, weight * reflectance
    return float(light / factor)


def deep(reflectance, depth, factor):
    light = 0.0
    for _ in range(depth):
        light = 1 + reflectance * light
    return light / factor


def diffuse(sky, tilt=0.0, steps=400):
    """The mean over the directions of a half ball, by the cosine, and that of the square; x is across the tilt."""
    mean = square = 0
    for i in range(steps):
        angle = (i + 0.5) / steps * pi / 2
        for j in range(steps):
            turn = (j + 0.5) / steps * 2 * pi
            x, up, z = sin(angle) * cos(turn), cos(angle), sin(angle) * sin(turn)
            weight = 2 * cos(angle) * sin(angle) * (pi / 2) / steps**2
            light = sky(x, up * cos(tilt) - z * sin(tilt), up * sin(tilt) + z * cos(tilt))
            mean += weight * light
            square += weight * light**2
    return mean, square - mean**2


zenith, zenith_variance = diffuse(lambda x, y, z: y)
# The ball's normal has the height 1/2 in the middle of the region, and the mean of the heights is 1/2.
tilted, tilted_variance = diffuse(lambda x, y, z: y > 0, tilt=pi / 3)
half, half_variance = diffuse(lambda x, y, z: 2 * x + z > 0)
# How many surfaces a path meets: the n-th with the probability 0.9^(n - 1).
steps = float(sum(F(9, 10) ** n for n in range(400)))
squared_steps = float(sum((2 * n + 1) * F(9, 10) ** n for n in range(400)))
roulette_5 = 5 * sqrt(squared_steps - steps**2) / 20 / sqrt(64) / 100 + HALF_A_BYTE
check(
    "light",
    {
        "once": furnace(F(1, 2), 2, 2),
        "furnace": 0,
        "zenith": 0.9 * zenith,
        "tilted": 0.8 * tilted,
        "bias": 0.5 * half,
        "noise": 0.5 * sqrt(half_variance / 16),
        "slope": log(sqrt(1 / 1024) / 1) / log(1024),
        "deep": 0,
        "roulette": steps / 20,
        "steps": steps / 20,
    },
    {
        "once": HALF_A_BYTE,
        "furnace": HALF_A_BYTE,
        "zenith": 5 * 0.9 * sqrt(zenith_variance / 64) / 100 + HALF_A_BYTE,
        "tilted": 5 * 0.8 * sqrt(tilted_variance / 64 / 209) + HALF_A_BYTE,
        "bias": 5 * 0.5 * sqrt(half_variance) / 100 + HALF_A_BYTE,
        "noise": 5 * 0.5 * sqrt(half_variance / 16) / sqrt(2 * 100 * 100),
        # By the relative errors of the first and the last of the spreads.
        "slope": 5 * sqrt(2) / sqrt(2 * 100 * 100) / log(1024),
        "deep": HALF_A_BYTE,
        "roulette": roulette_5,
        "steps": roulette_5,
    },
    exact={"furnace": furnace(F(1, 2), 5, 2), "deep": deep(0.999, 10000, 2500)},
)
