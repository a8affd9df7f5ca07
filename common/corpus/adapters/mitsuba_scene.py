"""Mitsuba 3, variant `scalar_rgb`: single precision, from the origin of the ray on.

    pip install mitsuba==3.9.1 numpy && python3 common/corpus/adapters/mitsuba_scene.py

Shapes are placed by `to_world` where they have no coordinates of their own. Directions are normalised, as its
documentation asks, so that its t is a length. Its triangles are Embree's, in the fast mode
and in the robust one."""

import math

import mitsuba as mi
import numpy as np

mi.set_variant("scalar_rgb")

from cases import ask, is_in_range_of_embree, mesh  # noqa: E402


def shape_of(case):
    if "under" in case:
        return None
    if "sphere" in case:
        sphere = case["sphere"]
        # It warns that it does not take such a radius for a sphere.
        if sphere["radius"] < 1e-20:
            return None
        return {"type": "sphere", "center": sphere["center"], "radius": sphere["radius"]}
    if "tube" in case:
        tube = case["tube"]
        return {"type": "cylinder", "p0": tube["from"], "p1": tube["to"], "radius": tube["radius"]}
    if mesh(case) and is_in_range_of_embree(case):
        corners, faces = mesh(case)
        made = mi.Mesh("mesh", len(corners), len(faces))
        parameters = mi.traverse(made)
        parameters["vertex_positions"] = np.ravel(np.array(corners, np.float32))
        parameters["faces"] = np.ravel(np.array(faces, np.uint32))
        parameters.update()
        return made
    return None


def finder(is_robust):
    def find(case):
        shape, (low, high) = shape_of(case), case["within"]
        if shape is None or low != 0:
            return None
        options = {"embree_use_robust_intersections": is_robust}
        scene = mi.load_dict({"type": "scene", "shape": shape, **options})
        direction = case["ray"]["direction"]
        length = math.hypot(*direction)
        unit = mi.Vector3f([x / length for x in direction])
        ray = mi.Ray3f(mi.Point3f(case["ray"]["origin"]), unit)
        if high != math.inf:
            ray.maxt = high * length
        found = scene.ray_intersect_preliminary(ray)
        return found.t / length if found.is_valid() else "miss"

    return find


title = f"Mitsuba {mi.__version__}, `scalar_rgb`"
ask("mitsuba", title, "single.toml", finder(False))
ask("mitsuba-robust", f"{title}, `embree_use_robust_intersections`", "single.toml", finder(True))
