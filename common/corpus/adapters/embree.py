"""Embree 4.4 by `embreex`: triangles in single precision, from the origin of the ray on.

    pip install embreex==4.4.0.post1 numpy && python3 common/corpus/adapters/embree.py

Its documentation says that a ray in the plane of a triangle finds none, which these cases allow, and that
denormal numbers count as zero, which `single.toml` does not have. `embreex` chooses Embree's mode itself."""

import importlib.metadata

import numpy as np
from embreex.mesh_construction import TriangleMesh
from embreex.rtcore_scene import EmbreeScene

from cases import ask, is_in_range_of_embree, mesh


def find(case):
    shape, (low, high) = mesh(case), case["within"]
    # `embreex` has no lower end of the interval.
    if shape is None or low != 0 or not is_in_range_of_embree(case):
        return None
    corners, faces = shape
    scene = EmbreeScene()
    TriangleMesh(scene, np.array(corners, np.float32), np.array(faces, np.int32))
    origin = np.array([case["ray"]["origin"]], np.float32)
    direction = np.array([case["ray"]["direction"]], np.float32)
    end = np.array([min(high, 1e37)], np.float32)
    found = scene.run(origin, direction, end, output=1)
    return found["tfar"][0] if found["geomID"][0] >= 0 else "miss"


version = importlib.metadata.version("embreex")
ask("embree", f"Embree by `embreex` {version}", "single.toml", find)
