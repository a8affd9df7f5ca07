"""Compares the facts of a sheet with values and tolerances that its script has computed by another way."""

import pathlib
import tomllib

SHEETS = pathlib.Path(__file__).parent.parent / "sheets"


def check(sheet, values, least=None, exact=None):
    """Each value, and each exact value of a spread, is the computed one, to a hundredth of its tolerance, and no
    tolerance is below its least.
    """
    with open(SHEETS / f"{sheet}.toml", "rb") as file:
        facts = {fact["name"]: fact for fact in tomllib.load(file)["fact"]}
    assert facts.keys() == values.keys(), facts.keys() ^ values.keys()
    for name, fact in facts.items():
        value, within, allowed = fact["value"], fact["within"], (least or {}).get(name, 0)
        print(f"{name:10} {value:10.6g} {values[name]:10.6g}   within {within:8.3g}, at least {allowed:.3g}")
        assert abs(value - values[name]) <= within / 100, name
        assert allowed <= within, name
    for name, numbers in (exact or {}).items():
        stated = facts[name]["exact"]
        pairs = zip(stated, numbers, strict=True) if isinstance(stated, list) else [(stated, numbers)]
        assert all(abs(a - b) < 1e-3 for a, b in pairs), (name, numbers)
