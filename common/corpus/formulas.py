"""Exact answers of the laboratories' questions that are no rays, by their names in `asks`: the values with 1,000
digits, and their condition."""

from mpmath import matrix, mp, mpf

STEP = mpf(10) ** -120


def condition(formula, x):
    """The sum of |df/dx x| over all numbers x, of the value f that changes most, over the greatest value."""
    values = formula(x)
    moved = [mpf(0)] * len(values)
    for i in range(len(x)):
        ends = [formula(x[:i] + [x[i] * (1 + sign * STEP)] + x[i + 1 :]) for sign in (-1, 1)]
        moved = [sum_ + abs(b - a) / (2 * STEP) for sum_, a, b in zip(moved, *ends)]
    greatest = max(map(abs, values))
    return max(moved) / greatest if greatest else mpf(0)


def with_condition(formula):
    return lambda x: (formula(x), condition(formula, x))


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def unit(a):
    length = mp.sqrt(dot(a, a))
    return [x / length for x in a]


def reflected(x):
    """A direction d on a normal n."""
    d, n = x[:3], unit(x[3:])
    twice = 2 * dot(d, n)
    return [a - twice * b for a, b in zip(d, n)]


def angle(x):
    across = cross(x[:3], x[3:])
    return [mp.atan2(mp.sqrt(dot(across, across)), dot(x[:3], x[3:]))]


def projected(x):
    """A vector on another one."""
    a, b = x[:3], x[3:]
    return [dot(a, b) / dot(b, b) * y for y in b]


def solved(x):
    return list(mp.lu_solve(matrix([x[:3], x[3:6], x[6:9]]), matrix(x[9:])))


def mirrors(x):
    """The light 1 + k + ... + k^(n-1) that n mirrors of the reflectance k emit, and how it depends on their own light and
    on k."""
    k, n = x[1], x[3]
    if k in (0, 1):
        return [n if k else mpf(1)], 1 + ((n - 1) / 2 if k else 0)
    total = (1 - k**n) / (1 - k)
    slope = (-n * k ** (n - 1) + total) / (1 - k)
    return [total], 1 + k * slope / total


FORMULAS = {
    "unit": with_condition(unit),
    "reflected": with_condition(reflected),
    "reflected length": with_condition(lambda x: [mp.sqrt(dot(reflected(x), reflected(x)))]),
    "angle": with_condition(angle),
    "angle by the cosine": with_condition(angle),
    "projected": with_condition(projected),
    "radius of light": with_condition(lambda x: [mp.tan(x[0])]),
    "solved": with_condition(solved),
    "determinant": with_condition(lambda x: [dot(x[:3], cross(x[3:6], x[6:]))]),
    "u": with_condition(lambda x: unit(cross(unit(x[:3]), unit(x[3:])))),
    # A cosine above 1 is one that is rounded up.
    "highlight": lambda x: ([min(x[0], 1) ** x[1] if x[0] > 0 else mpf(0)], x[1]),
    "mirrors": mirrors,
    "mirrors, ours": mirrors,
}


def condition_of_normal(row):
    """Of a plane whose normal is divided by scales. A ball is seen along an axis through its middle: numbers but 0 do
    not turn its normal."""
    if "plane" not in row:
        return mpf(0)
    scales = [mpf(y) for step in row.get("under", []) for y in step.get("scale", [])]

    def formula(x):
        normal = x[:3]
        for i in range(3, len(x), 3):
            normal = [a / b for a, b in zip(normal, x[i : i + 3])]
        return unit(normal)

    return condition(formula, [mpf(y) for y in row["plane"]["normal"]] + scales)
