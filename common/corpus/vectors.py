"""Vectors of fractions, as lists of three: their sums and products are exact."""

from fractions import Fraction as F


def vector(numbers):
    return [F(x) for x in numbers]


def minus(a, b):
    return [x - y for x, y in zip(a, b)]


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
