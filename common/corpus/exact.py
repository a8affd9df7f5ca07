"""Exact answers of rays and shapes.

Decisions are signs of fractions: triangles by Cramer's rule, boxes by six rectangles, round shapes by substituted
values of their equation. Digits and conditions come from mpmath at 1,000 digits, conditions by central
differences.
"""

import math
from fractions import Fraction as F

from mpmath import inf, mp, mpf

from vectors import cross, dot, minus, vector

mp.dps = 1000
STEP = mpf(10) ** -120
SHAPES = ("plane", "sphere", "box", "disc", "tube")


def determinant(a, b, c):
    return dot(a, cross(b, c))


def real(x):
    return mpf(x.numerator) / mpf(x.denominator) if isinstance(x, F) else mpf(x)


def flat(shape):
    """All numbers of a shape in a row, and how to build it again."""
    kind, numbers = shape
    row = []
    for value in numbers:
        row.extend(value if isinstance(value, list) else [value])
    sizes = [len(value) if isinstance(value, list) else 0 for value in numbers]

    def again(row):
        values, at = [], 0
        for size in sizes:
            values.append(row[at : at + size] if size else row[at])
            at += max(size, 1)
        return kind, values

    return row, again


def shapes_of(case):
    """The shape as kind and numbers; a mesh is a list of triangles."""
    if "plane" in case:
        return [("plane", [vector(case["plane"]["point"]), vector(case["plane"]["normal"])])]
    if "sphere" in case:
        return [("sphere", [vector(case["sphere"]["center"]), F(case["sphere"]["radius"])])]
    if "box" in case:
        return [("box", [vector(case["box"]["low"]), vector(case["box"]["high"])])]
    if "disc" in case:
        disc = case["disc"]
        return [("disc", [vector(disc["center"]), vector(disc["normal"]), F(disc["radius"])])]
    if "tube" in case:
        tube = case["tube"]
        return [("tube", [vector(tube["from"]), vector(tube["to"]), F(tube["radius"])])]
    return [("triangle", [vector(corner) for corner in corners]) for corners in case["triangles"]]


def steps_of(case):
    return [(name, vector(step[name])) for step in case.get("under", []) for name in step]


def into(steps, o, d):
    for name, by in steps:
        if name == "translate":
            o = minus(o, by)
        else:
            o = [x / y for x, y in zip(o, by)]
            d = [x / y for x, y in zip(d, by)]
    return o, d


def at(o, d, t):
    return [x + t * y for x, y in zip(o, d)]


def quadratic(kind, numbers, o, d):
    """a, b, c of a t^2 + b t + c = 0 at a round shape, from three values of its equation."""

    def value(t):
        p = at(o, d, t)
        if kind == "sphere":
            center, radius = numbers
            out = minus(p, center)
            return dot(out, out) - radius * radius
        start, end, radius = numbers
        axis, out = minus(end, start), minus(p, start)
        moment = cross(out, axis)
        return dot(moment, moment) - radius * radius * dot(axis, axis)

    zero, one, other = value(0), value(1), value(-1)
    return (one + other) / 2 - zero, (one - other) / 2, zero


def plane_of(kind, numbers):
    if kind == "triangle":
        a, b, c = numbers
        return a, cross(minus(b, a), minus(c, a))
    return numbers[0], numbers[1]


def candidates(kind, numbers, o, d):
    """Each meeting of the line and the shape as (part, exact t or None, t as mpf)."""
    if kind in ("sphere", "tube"):
        a, b, c = quadratic(kind, numbers, o, d)
        square = b * b - 4 * a * c
        if a == 0 or square < 0:
            return []
        found = []
        for sign in (-1, 1):
            t = (-real(b) + sign * mp.sqrt(real(square))) / (2 * real(a))
            exact = None
            # Fractions where they can be, for the comparison with the ends of the interval.
            if square == 0:
                exact = -b / (2 * a)
            elif c == 0:
                exact = max(F(0), -b / a) if sign > 0 else min(F(0), -b / a)
                t = real(exact)
            if kind == "tube":
                start, end, _ = numbers
                axis = minus(end, start)
                along = dot(map(real, minus(o, start)), map(real, axis)) + t * dot(map(real, d), map(real, axis))
                if not 0 <= along <= real(dot(axis, axis)):
                    continue
            found.append((sign, exact, t))
        return found
    if kind == "box":
        low, high = numbers
        found = []
        for axis in range(3):
            for face, side in ((low, 0), (high, 1)):
                if d[axis] == 0:
                    continue
                t = (face[axis] - o[axis]) / d[axis]
                p = at(o, d, t)
                if all(low[i] <= p[i] <= high[i] for i in range(3) if i != axis):
                    found.append(((axis, side), t, real(t)))
        return found
    point, normal = plane_of(kind, numbers)
    if dot(d, normal) == 0:
        return []
    if kind == "triangle":
        # o + t d = a + beta (b - a) + gamma (c - a), by Cramer's rule.
        a, b, c = numbers
        ab, ac, ao = minus(b, a), minus(c, a), minus(o, a)
        back = [-x for x in d]
        whole = determinant(ab, ac, back)
        beta = determinant(ao, ac, back) / whole
        gamma = determinant(ab, ao, back) / whole
        t = determinant(ab, ac, ao) / whole
        return [(0, t, real(t))] if beta >= 0 and gamma >= 0 and beta + gamma <= 1 else []
    t = (dot(point, normal) - dot(o, normal)) / dot(d, normal)
    if kind == "disc":
        out = minus(at(o, d, t), point)
        if dot(out, out) > numbers[2] ** 2:
            return []
    return [(0, t, real(t))]


def is_within(exact, t, within):
    low, high = within
    t = t if exact is None else exact
    ends = [end if abs(end) == float("inf") else (F(end) if exact is not None else mpf(end)) for end in within]
    return (low == -float("inf") or ends[0] < t) and (high == float("inf") or t < ends[1])


def is_coplanar(kind, numbers, o, d, within):
    """Whether the ray lies in the plane of a flat shape and meets it."""
    if kind not in ("plane", "disc", "triangle"):
        return False
    point, normal = plane_of(kind, numbers)
    if dot(d, normal) != 0 or dot(minus(o, point), normal) != 0:
        return False
    if kind == "plane":
        return True
    if kind == "disc":
        a, b, c = quadratic("sphere", [point, numbers[2]], o, d)
        square = b * b - 4 * a * c
        if square < 0:
            return False
        ends = [(-real(b) + sign * mp.sqrt(real(square))) / (2 * real(a)) for sign in (-1, 1)]
    else:
        # The t of the crossings with the edges, in the plane of the two greatest extents.
        drop = max(range(3), key=lambda i: abs(normal[i]))
        x, y = (i for i in range(3) if i != drop)
        across = lambda p: (p[x] - o[x]) * d[y] - (p[y] - o[y]) * d[x]
        length = d[x] * d[x] + d[y] * d[y]
        along = lambda p: ((p[x] - o[x]) * d[x] + (p[y] - o[y]) * d[y]) / length
        ends = []
        for p, q in zip(numbers, numbers[1:] + numbers[:1]):
            s, e = across(p), across(q)
            if s == 0:
                ends.append(along(p))
            if s * e < 0:
                ends.append(along(p) + (along(q) - along(p)) * s / (s - e))
        if not ends:
            return False
    return max(ends) > within[0] and min(ends) < within[1]


def is_question(case):
    """Whether all numbers are finite, and shape and ray have a size, an area and a direction."""
    numbers = [case["ray"]["origin"], case["ray"]["direction"]]
    for kind in SHAPES:
        numbers.extend(case.get(kind, {}).values())
    for corners in case.get("triangles", []):
        numbers.extend(corners)
    for number in numbers:
        if not all(math.isfinite(x) for x in (number if isinstance(number, list) else [number])):
            return False
    if not any(case["ray"]["direction"]):
        return False
    for kind, numbers in shapes_of(case):
        if kind in ("sphere", "disc", "tube") and numbers[-1] <= 0:
            return False
        if kind in ("plane", "disc", "triangle") and not any(plane_of(kind, numbers)[1]):
            return False
    return True


def hits_of(case, shapes, steps):
    """All hits within the interval as (t, triangle, part), and the ray in the space of the shape."""
    o, d = into(steps, vector(case["ray"]["origin"]), vector(case["ray"]["direction"]))
    hits = []
    for index, (kind, numbers) in enumerate(shapes):
        for part, exact, t in candidates(kind, numbers, o, d):
            if is_within(exact, t, case["within"]):
                hits.append((t, index, part))
    return hits, o, d


def answer(case):
    """The answer, t, the normal, and the condition, of several parts at the same t the greatest one."""
    shapes, steps = shapes_of(case), steps_of(case)
    hits, o, d = hits_of(case, shapes, steps)
    if not hits:
        coplanar = any(is_coplanar(kind, numbers, o, d, case["within"]) for kind, numbers in shapes)
        return ("coplanar" if coplanar else "miss"), None, None, mpf(0)
    nearest = min(t for t, _, _ in hits)
    first = [(index, part) for t, index, part in hits if abs(t - nearest) <= abs(nearest) * mpf(10) ** -600]
    conditions = [condition(case, index, part) for index, part in first]
    return "hit", nearest, normal(case, shapes, steps, o, d, nearest, first), max(conditions)


def normal(case, shapes, steps, o, d, t, first):
    """The unit normal, or None where two parts with different normals are hit."""
    p = at([real(x) for x in o], [real(x) for x in d], t)
    found = []
    for index, part in first:
        kind, numbers = shapes[index]
        if kind == "sphere":
            n = minus(p, map(real, numbers[0]))
        elif kind == "tube":
            axis = [real(x) for x in minus(numbers[1], numbers[0])]
            out = minus(p, map(real, numbers[0]))
            share = dot(out, axis) / dot(axis, axis)
            n = [x - share * y for x, y in zip(out, axis)]
        elif kind == "box":
            # All faces at this point, also those along the ray.
            exact = at(o, d, F(case_t(case, index, part, shapes, o, d)))
            faces = [(i, s) for i in range(3) for s in (0, 1) if exact[i] == numbers[s][i]]
            if len(faces) != 1:
                return None
            n = [mpf(0)] * 3
            n[faces[0][0]] = mpf(2 * faces[0][1] - 1)
        else:
            n = [real(x) for x in plane_of(kind, numbers)[1]]
        for name, by in reversed(steps):
            if name == "scale":
                n = [x / real(y) for x, y in zip(n, by)]
        length = mp.sqrt(dot(n, n))
        # Below its accuracy, a coordinate is the 0 of another formula.
        found.append([x / length if abs(x) > length * mpf(10) ** -900 else mpf(0) for x in n])
    one = found[0]
    same = all(abs(x - y) < mpf(10) ** -300 for other in found for x, y in zip(one, other))
    return one if same else None


def case_t(case, index, part, shapes, o, d):
    kind, numbers = shapes[index]
    return next(exact for found, exact, _ in candidates(kind, numbers, o, d) if found == part)


def condition(case, index, part):
    """The sum of |dt/dx x / t| over all numbers x, by central differences."""
    shapes, steps = shapes_of(case), steps_of(case)
    # All numbers in one row. The other triangles do not move this one.
    row, again = flat(shapes[index])
    row = list(row)
    sizes = [len(by) for _, by in steps]
    for _, by in steps:
        row.extend(by)
    row.extend(vector(case["ray"]["origin"]) + vector(case["ray"]["direction"]))
    row = [real(x) for x in row]

    def t_of(row):
        kind, numbers = again(row)
        at_row = len(flat(shapes[index])[0])
        moved = []
        for (name, _), size in zip(steps, sizes):
            moved.append((name, row[at_row : at_row + size]))
            at_row += size
        o, d = into(moved, row[at_row : at_row + 3], row[at_row + 3 : at_row + 6])
        if kind in ("sphere", "tube"):
            a, b, c = quadratic(kind, numbers, o, d)
            square = b * b - 4 * a * c
            return None if square <= 0 else (-b + part * mp.sqrt(square)) / (2 * a)
        if kind == "box":
            axis, side = part
            return (numbers[side][axis] - o[axis]) / d[axis]
        point, n = plane_of(kind, numbers)
        return dot(minus(point, o), n) / dot(d, n)

    t, total = t_of(row), mpf(0)
    if t is None:
        return inf
    for i, x in enumerate(row):
        if x == 0:
            continue
        ends = [t_of(row[:i] + [x * (1 + sign * STEP)] + row[i + 1 :]) for sign in (-1, 1)]
        if None in ends:
            return inf
        total += abs((ends[1] - ends[0]) / (2 * STEP * t))
    return total
