"""Rays a second of Embree and of the engine, in a scene of triangles, on one thread.

    pip install embreex numpy
    cargo bench -p engine --bench peers -- hills --threads 1
    python3 common/engine/benches/peers/embree.py

Embree has single precision and finds the hits alone: one ray to each pixel, and from each hit one to
the light. The engine has double precision, and its time is that of the whole picture, with these same
rays, shading and rounding to bytes. The scene is the one that the benchmark has written for Tachyon.
"""

import re
import subprocess
import time

import numpy
from embreex.mesh_construction import TriangleMesh
from embreex.rtcore_scene import EmbreeScene

WIDTH, HEIGHT = 1280, 960
# The tangent of half the angle of view, upwards.
HALF_TANGENT = 0.41421356237309503
ROUNDS = 5
# The least distance of a shadow ray's origin from its surface: single precision has seven digits.
OFFSET = 1e-4


def numbers_after(word, text, count):
    values = text.split(f"{word} ")[1].split()[:count]
    return numpy.array([float(value) for value in values])


def triangles_of(text):
    corners = re.findall(r"V0 (\S+ \S+ \S+) V1 (\S+ \S+ \S+) V2 (\S+ \S+ \S+)", text)
    return numpy.array([[corner.split() for corner in three] for three in corners], numpy.float32)


def camera_directions(text):
    ahead, upwards = numbers_after("VIEWDIR", text, 3), numbers_after("UPDIR", text, 3)
    to_the_right = numpy.cross(ahead, upwards)
    x = (numpy.arange(WIDTH) - (WIDTH - 1) / 2) / (HEIGHT / 2) * HALF_TANGENT
    y = ((HEIGHT - 1) / 2 - numpy.arange(HEIGHT)) / (HEIGHT / 2) * HALF_TANGENT
    x, y = numpy.meshgrid(x, y)
    directions = ahead + x[..., None] * to_the_right + y[..., None] * upwards
    return directions.reshape(-1, 3).astype(numpy.float32)


def vectors_to_light(text, points):
    if "DIRECTIONAL_LIGHT" in text:
        away = numbers_after("DIRECTIONAL_LIGHT DIRECTION", text, 3)
        return numpy.tile(-away, (len(points), 1)).astype(numpy.float32)
    return (numbers_after("LIGHT CENTER", text, 3) - points).astype(numpy.float32)


def seconds(work):
    """The least time of all rounds, and the last result."""
    times = []
    for _ in range(ROUNDS):
        start = time.perf_counter()
        result = work()
        times.append(time.perf_counter() - start)
    return min(times), result


def engine_seconds(name):
    command = "cargo bench -q -p engine --bench peers -- --alone --threads 1 --rounds 5"
    table = subprocess.run([*command.split(), name], capture_output=True, text=True, check=True)
    rows = [[cell.strip() for cell in line.split("|")] for line in table.stdout.splitlines()]
    head = next(row for row in rows if "trace ms" in row)
    return float(rows[-1][head.index("trace ms")]) / 1000


NAME = "hills"
with open(f"target/tmp/peers/{NAME}-Tachyon.scene", encoding="utf-8") as file:
    text = file.read()
scene = EmbreeScene()
triangles = triangles_of(text)
TriangleMesh(scene, triangles)

directions = camera_directions(text)
eye = numbers_after("CENTER", text, 3).astype(numpy.float32)
eyes = numpy.tile(eye, (len(directions), 1))
scene.run(eyes[:1], directions[:1])  # builds the tree
to_hits, found = seconds(lambda: scene.run(eyes, directions, output=True))

hit = found["geomID"] != -1
points = eyes[hit] + directions[hit] * found["tfar"][hit][:, None]
to_light = vectors_to_light(text, points)
normals = found["Ng"][hit]
normals /= numpy.linalg.norm(normals, axis=1)[:, None]
faces_light = numpy.sign((normals * to_light).sum(axis=1))
origins = (points + normals * (faces_light * OFFSET)[:, None]).astype(numpy.float32)
to_lights, occluded = seconds(lambda: scene.run(origins, to_light, query="OCCLUDED"))

rays = len(eyes) + len(origins)
embree, engine = rays / (to_hits + to_lights) / 1e6, rays / engine_seconds(NAME) / 1e6
print(f"{NAME}: {len(triangles):,} triangles, {len(eyes):,} rays to pixels, {len(origins):,} to the light")
print(f"  million rays a second: Embree {embree:.2f}, engine {engine:.2f}")
