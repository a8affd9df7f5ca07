"""Open3D: `RaycastingScene`, triangles in single precision, from the origin of the ray on.

    pip install open3d==0.20.0 && python3 common/corpus/adapters/open3d_scene.py

It is built on Embree."""

import numpy as np
import open3d

from cases import ask, is_in_range_of_embree, mesh


def find(case):
    shape, (low, high) = mesh(case), case["within"]
    if shape is None or low != 0 or not is_in_range_of_embree(case):
        return None
    corners, faces = shape
    scene = open3d.t.geometry.RaycastingScene(nthreads=1)
    scene.add_triangles(np.array(corners, np.float32), np.array(faces, np.uint32))
    ray = np.array([case["ray"]["origin"] + case["ray"]["direction"]], np.float32)
    t = float(scene.cast_rays(open3d.core.Tensor(ray))["t_hit"][0].item())
    # It says infinity for a miss, and has no end of the interval.
    return t if t < high else "miss"


title = f"Open3D {open3d.__version__}, `RaycastingScene.cast_rays`"
ask("open3d", title, "single.toml", find)
