"""What the adapters in Python share: the cases, and the file of results."""

import pathlib
import tomllib

CORPUS = pathlib.Path(__file__).resolve().parent.parent


def ask(name, title, file, find):
    """Asks each case of a file, and writes what `find` says: a number, "miss", or None if it cannot be asked."""
    precision = "single" if file == "single.toml" else "double"
    lines = [f"# {title}", f"# {precision}"]
    cases = tomllib.loads((CORPUS / file).read_text(encoding="utf-8"))["case"]
    for case in cases:
        found = find(case)
        if found is not None:
            lines.append(f"{case['id']} {found if found == 'miss' else repr(float(found))}")
    results = CORPUS / "results" / f"{name}.txt"
    results.parent.mkdir(exist_ok=True)
    results.write_text("\n".join(lines) + "\n", encoding="utf-8")
    print(f"{results.name}: {len(lines) - 2} of {len(cases)}")


def mesh(case):
    """The corners and triangles of a mesh, equal corners once; None if the case is of another kind."""
    if "triangles" not in case or "under" in case:
        return None
    corners, faces = [], []
    for triangle in case["triangles"]:
        for corner in triangle:
            if corner not in corners:
                corners.append(corner)
        faces.append([corners.index(corner) for corner in triangle])
    return corners, faces


def is_in_range_of_embree(case):
    """Embree's documentation of `rtcCommitScene`: it ignores primitives with values above 1.844E18."""
    return all(abs(x) < 1.844e18 for triangle in case["triangles"] for corner in triangle for x in corner)
