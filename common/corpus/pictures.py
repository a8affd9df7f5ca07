"""Draws the failures of the page "Extreme cases" from the cases and the recorded answers.

    python3 common/corpus/pictures.py          writes book/src/pictures/corpus-*.svg

Positions are computed in fractions from the numbers of the files. Nothing else is needed than Python itself."""

import math
import pathlib
import re
import tomllib
from fractions import Fraction as F

from vectors import cross, dot, minus, vector

CORPUS = pathlib.Path(__file__).resolve().parent
PICTURES = CORPUS.parent.parent / "book" / "src" / "pictures"

STYLE = """svg{font:13px system-ui,sans-serif}.title{font-weight:600;font-size:16px}.small{font-size:11.5px}
.middle{text-anchor:middle}.end{text-anchor:end}path{fill:none}.dash{stroke-dasharray:5 4}
.thick{stroke-width:2.2}.face{opacity:.16}
rect{fill:#fff}text{fill:#282828}.small{fill:#6b6b6b}path{stroke:#282828}.grid{stroke:#e4e4e4}
path.c0{stroke:#0072b2}path.c1{stroke:#d55e00}path.c2{stroke:#009e73}path.c3{stroke:#b4558c}path.c5{stroke:#8a6100}
.f0{fill:#0072b2;stroke:none}.f1{fill:#d55e00;stroke:none}.f2{fill:#009e73;stroke:none}
text.c0{fill:#0072b2}text.c1{fill:#b34700}text.c2{fill:#00694d}text.c3{fill:#8f3b6d}text.c5{fill:#735000}
@media(prefers-color-scheme:dark){
rect{fill:#181a1b}text{fill:#e1e1e1}.small{fill:#a0a0a0}path{stroke:#e1e1e1}.grid{stroke:#393c3e}
path.c0{stroke:#56b4e9}path.c1{stroke:#e69f00}path.c2{stroke:#00be8c}path.c3{stroke:#e696c3}path.c5{stroke:#f0e442}
.f0{fill:#56b4e9}.f1{fill:#e69f00}.f2{fill:#00be8c}
text.c0{fill:#56b4e9}text.c1{fill:#e69f00}text.c2{fill:#00be8c}text.c3{fill:#e696c3}text.c5{fill:#f0e442}}"""


def cases():
    text = (CORPUS / "cases.toml").read_text(encoding="utf-8")
    return {case["id"]: case for case in tomllib.loads(text)["case"]}


def results(name):
    lines = (CORPUS / "results" / f"{name}.txt").read_text(encoding="utf-8").splitlines()[2:]
    return dict(line.split(" ") for line in lines)


DOUBLES = cases()


class Drawing:
    """An SVG file whose colours follow the reader's theme."""

    def __init__(self, name, title, subtitle, width=680, height=330):
        self.name, self.size = name, (width, height)
        self.parts = [f'<rect width="{width}" height="{height}"/>']
        self.title = title
        self.text(14, 27, title, "title")
        self.text(14, 46, subtitle, "small")

    def text(self, x, y, words, kind=""):
        words = words.replace("&", "&amp;").replace("<", "&lt;")
        self.parts.append(f'<text class="{kind}" x="{x:.1f}" y="{y:.1f}">{words}</text>')

    def line(self, points, kind="", closed=False):
        steps = "L".join(f"{x:.1f} {y:.1f}" for x, y in points)
        self.parts.append(f'<path class="{kind}" d="M{steps}{"Z" if closed else ""}"/>')

    def circle(self, x, y, radius, kind=""):
        self.parts.append(
            f'<path class="{kind}" d="M{x - radius:.1f} {y:.1f}a{radius:.1f} {radius:.1f} 0 1 0 {2 * radius:.1f} 0'
            f'a{radius:.1f} {radius:.1f} 0 1 0 {-2 * radius:.1f} 0Z"/>')

    def cross(self, x, y, kind, reach=6):
        self.line([(x - reach, y - reach), (x + reach, y + reach)], f"thick {kind}")
        self.line([(x - reach, y + reach), (x + reach, y - reach)], f"thick {kind}")

    def write(self):
        width, height = self.size
        head = (f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height}" width="{width}" '
                f'height="{height}" role="img">\n<title>{self.title}</title>\n<style>{STYLE}</style>\n')
        path = PICTURES / f"corpus-{self.name}.svg"
        path.write_text(head + "\n".join(self.parts) + "\n</svg>\n", encoding="utf-8")
        print(path.name)


def power(exponent):
    digits = str(exponent).translate(str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹"))
    return f"10{digits}"


def seen(case):
    """The plane across a ray: a function that gives a point's two coordinates in it, from the ray's point on."""
    o, d = vector(case["ray"]["origin"]), vector(case["ray"]["direction"])
    axis = [F(0), F(1), F(0)] if abs(d[1]) < abs(d[0]) + abs(d[2]) else [F(1), F(0), F(0)]
    u = minus(axis, [x * dot(axis, d) / dot(d, d) for x in d])
    v = cross(u, d)
    lengths = [math.sqrt(dot(u, u)), math.sqrt(dot(v, v))]

    def place(point):
        from_origin = minus(vector(point), o)
        return float(dot(from_origin, u)) / lengths[0], float(dot(from_origin, v)) / lengths[1]

    return place


def ball():
    """A ball that a ray passes by two radii: seen from the side, with the hit that is found."""
    case, found = DOUBLES["far-18"], results("parry")["far-18"]
    assert case["answer"] == "miss" and found != "miss" and results("protocol")["far-18"] != "miss"
    o, d = vector(case["ray"]["origin"]), vector(case["ray"]["direction"])
    middle = vector(case["sphere"]["center"])
    out = minus(middle, o)
    nearest = dot(out, d) / dot(d, d)
    aside = minus(out, [x * nearest for x in d])
    height = math.sqrt(dot(aside, aside))
    beyond = float(F(float(found)) - nearest) * math.sqrt(dot(d, d))
    picture = Drawing("ball", "A ball that is hit two radii beside it",
                      f"case far-18: the eye is 10¹⁰ to the left; the ray passes at {height:.4f} radii")
    scale, x, y = 55, 340, 250
    picture.circle(x, y, scale, "f0 face")
    picture.circle(x, y, scale, "thick c0")
    ray = y - height * scale
    picture.line([(40, ray), (640, ray)], "thick")
    picture.line([(630, ray - 5), (640, ray), (630, ray + 5)], "thick")
    picture.line([(x, y), (x, ray)], "dash")
    picture.cross(x + beyond * scale, ray, "c1", 8)
    picture.text(x + beyond * scale, ray - 18, f"parry3d-f64 and the protocol hit: t = {float(found):.0f}", "c1 middle")
    picture.text(x + 12, (y - scale + ray) / 2 + 5, f"{height:.4f}")
    picture.text(x, y + 22, "radius 1", "middle")
    picture.write()


def corner():
    """A ray through a corner of a closed mesh, so near that only a magnification shows where it passes."""
    case = DOUBLES["seam-08"]
    for name in ("moeller-trumbore", "parry"):
        assert results(name)["seam-08"] == "miss"
    place = seen(case)
    target = [F(o) + F(d) for o, d in zip(case["ray"]["origin"], case["ray"]["direction"])]
    corners = {tuple(point) for triangle in case["triangles"] for point in triangle}
    tip = min(corners, key=lambda point: dot(minus(vector(point), target), minus(vector(point), target)))
    at = place(tip)
    size = math.hypot(*at)
    picture = Drawing("corner", "A ray through the corner of a closed mesh",
                      "case seam-08, seen along the ray: the tetrahedron, and its corner more than 10¹⁶ times as large")
    scale = 22
    for triangle in case["triangles"]:
        points = [place(point) for point in triangle]
        picture.line([(150 + x * scale, 165 - y * scale) for x, y in points], "c0", closed=True)
    picture.circle(150, 165, 9, "c1 thick")
    middle, unit, radius = (470, 170), 34 / size, 100
    for point in corners - {tip}:
        x, y = place(point)
        x, y = x - at[0], y - at[1]
        x, y = x / math.hypot(x, y), y / math.hypot(x, y)
        start = (at[0] * unit, at[1] * unit)
        # To the circle around the ray: |start + length · (x, y)| = radius.
        along = start[0] * x + start[1] * y
        length = math.sqrt(along**2 + radius**2 - math.hypot(*start) ** 2) - along
        end = (start[0] + length * x, start[1] + length * y)
        picture.line([(middle[0] + x, middle[1] - y) for x, y in (start, end)], "c0 thick")
    picture.circle(*middle, 5, "f1")
    picture.circle(*middle, radius, "grid")
    picture.text(middle[0] - 12, middle[1] + 18, "the ray", "c1 end")
    picture.text(14, 292, f"The ray passes {size:.1e} beside the corner, which three triangles share.")
    picture.text(14, 314, "Möller-Trumbore and parry3d-f64 hit none of the three.", "c1")
    picture.write()


def sizes():
    """Sizes at which a shape is lost, with their squares and cubes, and the range of the numbers."""
    single = (math.log10(2.0**-126), math.log10(2.0**128))
    rows = [
        ("bvh", "size-08", "a triangle", -12, (math.log10(2.0**-52), 60)),
        ("embree", "size-05", "a triangle", -30, single),
        ("embree", "size-20", "a triangle", 18, single),
        ("mitsuba", "size-20", "a triangle", 18, single),
        ("mitsuba", "size-19", "a ball", 18, single),
    ]
    names = {"bvh": "bvh", "embree": "Embree, Open3D", "mitsuba": "Mitsuba"}
    picture = Drawing("sizes", "Sizes that are lost",
                      "s is the size; products of two and three lengths are near s² and s³; green: the numbers that are kept", height=350)
    place = lambda exponent: 440 + exponent * 2.4
    for exponent in range(-90, 91, 30):
        picture.line([(place(exponent), 66), (place(exponent), 318)], "grid")
        picture.text(place(exponent), 336, power(exponent), "small middle")
    for row, (name, id, words, exponent, (low, high)) in enumerate(rows):
        found = results(name)[id]
        assert found in ("miss", "inf"), id
        y = 92 + 50 * row
        picture.text(14, y - 4, names[name])
        picture.text(14, y + 12, f"{id}, {words}: {found}", "small")
        picture.line([(place(low), y + 6), (place(high), y + 6)], "c2 thick")
        picture.line([(place(low), y), (place(low), y + 12)], "c2 thick")
        if name != "bvh":
            picture.line([(place(high), y), (place(high), y + 12)], "c2 thick")
        picture.circle(place(exponent), y + 6, 4, "f0")
        picture.text(place(exponent), y - 4, "s", "c0 middle")
        for degree, label in ((2, "s²"), (3, "s³")):
            picture.cross(place(exponent * degree), y + 6, "c1", 4)
            picture.text(place(exponent * degree), y - 4, label, "c1 middle")
    picture.text(place(60), 92 + 26, "above 2.2·10⁻¹⁶, with which bvh compares", "small end")
    picture.write()


def greatest_error(found, ids, parameter, value):
    """The greatest error of t among the cases of a value, in units of the condition times one unit in the last place."""
    worst = 0.0
    for id in ids:
        case = DOUBLES[id]
        if parameter(id) != value or found.get(id, "miss") == "miss":
            continue
        exact = F(case["t"])
        ulp = F(math.ulp(float(exact)))
        worst = max(worst, float(abs(F(float(found[id])) - exact) / ulp) / case["condition"])
    return worst


def errors(name, title, subtitle, axis, ids, parameter):
    """The greatest errors of t by a parameter, in units of the condition times one unit in the last place."""
    who = [("protocol", "the protocol", "c0"), ("bvh", "bvh", "c1"), ("moeller-trumbore", "Möller-Trumbore", "c2"),
           ("parry", "parry3d-f64", "c3"), ("lesson", "the lesson", ""),
           ("woop-compensated", "Woop with exact products", "c5")]
    picture = Drawing(name, title, subtitle, height=380)
    values = sorted({parameter(id) for id in ids})
    first, last = values[0], values[-1]
    curves = [[greatest_error(results(file), ids, parameter, value) for value in values] for file, _, _ in who]
    all_errors = [ulps for curve in curves for ulps in curve]
    top = math.ceil(math.log10(max(all_errors)))
    x_of = lambda value: 80 + (value - first) * 380 / (last - first)
    y_of = lambda ulps: 320 - 260 * math.log10(max(ulps, 0.1) * 10) / (top + 1)
    for exponent in range(-1, top + 1):
        y = y_of(10.0**exponent)
        picture.line([(70, y), (470, y)], "grid")
        picture.text(62, y + 4, power(exponent), "small end")
    for value in values:
        picture.text(x_of(value), 340, power(value), "small middle")
    picture.text(270, 362, axis, "middle")
    if min(all_errors) < 0.1:
        picture.text(478, 340, "below 0.1: drawn at 0.1", "small")
    limit = y_of(16)
    picture.line([(70, limit), (470, limit)], "dash")
    picture.text(478, limit + 4, "16: still right", "small")
    ends = []
    for (_, label, color), curve in zip(who, curves):
        points = [(x_of(value), y_of(ulps)) for value, ulps in zip(values, curve)]
        picture.line(points, f"thick {color}")
        ends.append([points[-1][1], label, color])
    # Names keep their distance: those below another move down, then those below the axis up.
    ends.sort()
    for before, after in zip(ends, ends[1:]):
        after[0] = max(after[0], before[0] + 16)
    ends[-1][0] = min(ends[-1][0], 320)
    for after, before in zip(ends[::-1], ends[-2::-1]):
        before[0] = min(before[0], after[0] - 16)
    for y, label, color in ends:
        picture.text(478, y + (4 if abs(y - limit) > 14 else 18), label, color)
    picture.write()


def aspect(id):
    return round(math.log10(float(re.search("aspect (1e[0-9]+)", DOUBLES[id]["says"])[1])))


def half_size(id):
    return round(math.log10(max(abs(x) for triangle in DOUBLES[id]["triangles"] for corner in triangle for x in corner)))


ball()
corner()
sizes()
needles = [id for id in DOUBLES if id.startswith("needle") and DOUBLES[id]["answer"] == "hit"]
errors("needles", "Needles cost digits of t, but need not",
       "the greatest error of the needles, in units of the condition times one ulp",
       "aspect of the needle", needles, aspect)
errors("patch", "A patch much larger than the distance to it",
       "cases public-31 and public-32, in units of the condition times one ulp",
       "half size of the patch, 8.5 from the eye", ["public-31", "public-32"], half_size)
