"""The oracle of the corpus: answers each case by exact arithmetic, and compares or writes the answers.

What 16 rounding errors of the given numbers can change is tried. `exact.py` beside this file answers rays, and
`formulas.py` other questions of the laboratories.

    pip install mpmath
    python3 common/corpus/check.py            fails if an answer in a file is another one
    python3 common/corpus/check.py --write    writes the answers, and single.toml
"""

import itertools
import math
import pathlib
import random
import re
import struct
import sys
import tomllib
from fractions import Fraction as F

from mpmath import mp, mpf

from exact import SHAPES, answer, candidates, hits_of, into, is_question, real, shapes_of, steps_of, vector
from formulas import FORMULAS, condition_of_normal

CORPUS = pathlib.Path(__file__).resolve().parent

# The keys that this program writes; all others are the question.
WRITTEN = ("answer", "t", "normal", "condition", "border", "between")
# How many changes of the numbers are tried, and by how many rounding errors of a number at most.
TRIALS, ROUNDINGS = 64, 16


def changed(case, unit, chance, with_zeros):
    """The question with each number changed by up to 16 rounding errors of itself, and on request each zero by those
    of the greatest number beside it. Corners that triangles share stay shared."""

    def change(size):
        share = chance.uniform(-1, 1) if chance.random() < 0.5 else chance.choice((-1, 1))
        return F(size) * F(share) * ROUNDINGS * unit

    def three(numbers, otherwise):
        size = (max(map(abs, numbers)) or otherwise) if with_zeros else 0
        return [F(x) + change(abs(x) or size) for x in numbers]

    size = max(map(abs, lengths_of(case)))
    new = {"within": case["within"], "under": []}
    for kind in SHAPES:
        for key, x in case.get(kind, {}).items():
            new.setdefault(kind, {})[key] = three(x, size) if isinstance(x, list) else F(x) + change(x)
    if "triangles" in case:
        corners = {}
        for corner in (corner for triangle in case["triangles"] for corner in triangle):
            if tuple(corner) not in corners:
                corners[tuple(corner)] = three(corner, size)
        new["triangles"] = [[corners[tuple(corner)] for corner in triangle] for triangle in case["triangles"]]
    for step in case.get("under", []):
        new["under"].append({name: three(by, size) for name, by in step.items()})
    new["ray"] = {"origin": three(case["ray"]["origin"], size), "direction": three(case["ray"]["direction"], size)}
    return new


def lengths_of(case):
    """All numbers of shape and origin."""
    rows = [case["ray"]["origin"]]
    rows += [x if isinstance(x, list) else [x] for kind in SHAPES for x in case.get(kind, {}).values()]
    rows += [corner for triangle in case.get("triangles", []) for corner in triangle]
    rows += [by for step in case.get("under", []) for by in step.values()]
    return [x for row in rows for x in row]


def trials(case, unit, t):
    """Whether some changes hit and others miss, and the least and the greatest t of all hits.

    Changed zeros count for decisions alone, as the condition counts none, unless they make the only hits."""
    found, misses = [], t is None
    if t is not None:
        found.append(t)
    # A hit at an end of the interval, such as the ray's own origin, counts for those who close the interval.
    o, d = into(steps_of(case), vector(case["ray"]["origin"]), vector(case["ray"]["direction"]))
    ends = [F(end) for end in case["within"] if math.isfinite(end)]
    for kind, numbers in shapes_of(case):
        found += [end for _, exact, end in candidates(kind, numbers, o, d) if exact in ends]
    chance = random.Random(case["id"])
    with mp.workdps(60):
        for n in range(TRIALS):
            with_zeros = n % 2 == 1
            other = changed(case, unit, chance, with_zeros)
            hits, _, _ = hits_of(other, shapes_of(other), steps_of(other))
            if not hits:
                misses = True
            elif t is None or not with_zeros:
                found.append(min(t for t, _, _ in hits))
    if not found:
        return False, None
    least, greatest = min(found), max(found)
    # No condition says how far a hit that is none may be off: as far again as the trials.
    width = greatest - least if t is None else 0
    return misses, (least - width, greatest + width)


def number(x):
    """The shortest decimal that is read as the same double."""
    mantissa, _, exponent = repr(x).partition("e")
    return f"{mantissa.removesuffix('.0')}e{int(exponent)}" if exponent else mantissa


def digits(x):
    """40 significant digits, without zeros at their end."""
    if x == 0:
        return "0"
    sign, exponent = "-" if x < 0 else "", int(mp.floor(mp.log10(abs(x))))
    whole = str(int(mp.nint(abs(x) * mpf(10) ** (39 - exponent))))
    exponent, text = exponent + len(whole) - 40, whole.rstrip("0")
    if 0 <= exponent < 21:
        text = text.ljust(exponent + 1, "0")
        return sign + text[: exponent + 1] + ("." + text[exponent + 1 :] if text[exponent + 1 :] else "")
    if -5 <= exponent < 0:
        return sign + "0." + "0" * (-1 - exponent) + text
    return f"{sign}{text[0]}{'.' + text[1:] if text[1:] else ''}e{exponent}"


def answer_lines(case, unit):
    """The lines of a case that this program writes."""
    said, t, n, bound = answer(case)
    lines = [f'answer = "{said}"']
    if t is not None:
        lines.append(f't = "{digits(t)}"')
    if n is not None:
        lines.append("normal = [" + ", ".join(f'"{digits(x)}"' for x in n) + "]")
    lines.append(f"condition = {number(float(mp.nstr(bound, 3)))}")
    if said != "coplanar":
        is_border, between = trials(case, unit, t)
        if is_border:
            lines.append("border = true")
        # Only where t moves farther than its condition explains.
        allowed = 0 if t is None else abs(t) * max(bound, 1) * 2 * ROUNDINGS * real(unit)
        if between and max(abs(end - (t or 0)) for end in between) > allowed:
            lines.append("between = [" + ", ".join(number(float(end)) for end in between) + "]")
    return lines


def in_single_precision(block):
    """The text of a case with each number rounded to single precision; None if no shape or ray is left."""
    is_normal = True

    def rounded(match):
        nonlocal is_normal
        try:
            x = struct.unpack("f", struct.pack("f", float(match[0])))[0]
        except OverflowError:
            x = math.inf
        is_normal &= math.isfinite(x) and (abs(x) >= 2.0**-126 or float(match[0]) == 0)
        return number(x)

    lines = []
    for line in block.split("\n"):
        is_of_numbers = re.match(r"(plane|sphere|box|disc|tube|under|ray|within) = |    \[", line)
        lines.append(re.sub(r"-?\d[\d.e-]*", rounded, line) if is_of_numbers else line)
    text = "\n".join(lines)
    return text if is_normal and is_question(tomllib.loads(text)["case"][0]) else None


def answered(block, unit):
    """The text of a case with its answer."""
    question = [line for line in block.split("\n") if line.split(" = ")[0] not in WRITTEN]
    return "\n".join(question + answer_lines(tomllib.loads("\n".join(question))["case"][0], unit))


def exact_of(row):
    """The exact outcome of a row of a laboratory and its condition, or none if it is up to the author."""
    asks = row.get("asks", "distance")
    if row["exact"] in ("refused", True, False) or asks == "unchecked":
        return None
    if "ray" not in row:
        if row["exact"] == "none" or asks not in FORMULAS:
            return None
        values, condition = FORMULAS[asks]([real(F(x)) for x in row["numbers"]])
        # Below its accuracy, a value is 0.
        values = [x if abs(x) > max(map(abs, values)) * mpf(10) ** -900 else mpf(0) for x in values]
        return values, condition if any(values) else None
    said, t, n, condition = answer({"within": [0.0, math.inf], **row})
    if said != "hit":
        return None, None
    if asks == "normal":
        return n, condition_of_normal(row)
    length = mp.sqrt(sum(mpf(x) ** 2 for x in row["ray"]["direction"]))
    return [t if asks == "t" else t * length], condition


def answered_row(block):
    """The text of a row of a laboratory with its exact outcome."""
    exact = exact_of(tomllib.loads(block)["case"][0])
    if exact is None:
        return block
    values, condition = exact
    if values is None:
        text = '"none"'
    else:
        texts = [f'"{digits(x)}"' for x in values]
        text = texts[0] if len(texts) == 1 else f"[{', '.join(texts)}]"
    lines = []
    for line in block.split("\n"):
        if line.startswith("exact = "):
            lines.append(f"exact = {text}")
            if condition is not None:
                lines.append(f"condition = {number(float(mp.nstr(condition, 3)))}")
        elif not line.startswith("condition = "):
            lines.append(line)
    return "\n".join(lines)


def texts():
    """Each file with its text as it should be."""
    doubles, singles = CORPUS / "cases.toml", CORPUS / "single.toml"
    head, *blocks = doubles.read_text(encoding="utf-8").rstrip("\n").split("\n\n")
    yield doubles, [head] + [answered(block, F(2) ** -53) for block in blocks]
    head = singles.read_text(encoding="utf-8").split("\n\n")[0]
    rounded = filter(None, map(in_single_precision, blocks))
    yield singles, [head] + [answered(block, F(2) ** -24) for block in rounded]
    for rows in sorted(CORPUS.parents[1].glob("a0*/lab/cases.toml")):
        head, *blocks = rows.read_text(encoding="utf-8").rstrip("\n").split("\n\n")
        yield rows, [head] + [answered_row(block) for block in blocks]


def main():
    differ = 0
    for path, blocks in texts():
        before, text = path.read_text(encoding="utf-8"), "\n\n".join(blocks) + "\n"
        if "--write" in sys.argv:
            path.write_text(text, encoding="utf-8")
        else:
            for old, new in itertools.zip_longest(before.rstrip("\n").split("\n\n"), blocks):
                if old != new:
                    differ += 1
                    print(f"{path} has\n{old}\ninstead of\n{new}\n")
        print(f"{path}: {text.count('[[case]]')} cases")
    return 1 if differ else 0


if __name__ == "__main__":
    sys.exit(main())
