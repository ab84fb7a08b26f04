"""Scenes, and rays through them."""
import os

import numpy as np

from . import _core
from ._arrays import number, rows, spread
from ._errors import UsageError
from ._geometry import Hits


class Scene:
    """What is drawn: objects, lights, cameras and surroundings. `aktina.load` reads one from a file.

    objects : dictionaries. A mesh has "vertices" (V, 3), "triangles" (T, 3), and may have "normals" (V, 3) and "uv"
        (V, 2, v down); an analytic shape has "shape", {"type": "sphere", "radius": 1} or another method of the family
        "primitive". Each may have "to_world" (4, 4) and "material".
    material : classic coefficients "ka", "kd", "ks", "kr", "kt" (colours), "exponent", "index"; or glTF's "base_colour",
        "metallic", "roughness", "ior", "transmission", "specular_weight", "specular_tint". Either may have "emission"
        (cd/m^2), "double_sided", "unlit", "alpha", and "texture", an (H, W, 3) array of linear colours that multiplies
        the colour, with "filter" "bilinear" or "nearest".
    lights : dictionaries as `aktina.irradiance` takes them.
    camera : "position", "target", "up", "vertical_fov" (rad).
    ambient, background, sky : colours; cd/m^2. Classic ambient light, what is seen beyond everything, even light from all
        around.
    Raises UsageError (a field, a shape), NoSuchMethod (a type), BadParam.

    >>> import aktina
    >>> scene = aktina.Scene([{"shape": {"type": "sphere", "radius": 1}, "material": {"kd": 0.5}}], sky=1)
    >>> scene
    <aktina.Scene: 0 triangles>
    """

    def __init__(self, objects=(), lights=(), camera=None, ambient=0.0, background=0.0, sky=0.0):
        self._scene = _core.Scene()
        for item in objects:
            self._scene.add_object(_checked(item))
        for light in lights:
            self._scene.add_light(dict(light))
        if camera is not None:
            self._scene.add_camera(dict(camera))
        self._scene.set_surroundings({"ambient": ambient, "background": background, "sky": sky})

    @property
    def triangles(self):
        """Number of triangles, instances counted each."""
        return self._scene.triangles

    @property
    def hash(self):
        """Of everything that affects a picture: 16 hexadecimal digits."""
        return self._scene.hash

    @property
    def warnings(self):
        """What reading the file has repaired or guessed: (text, count)."""
        return self._scene.warnings

    def __repr__(self):
        return f"<aktina.Scene: {self.triangles} triangles>"


def load(path):
    """A Scene from a file: glTF 2.0, OBJ, PLY, STL and what else Assimp reads.

    Raises FileError, BadInput, LimitExceeded, Unsupported.

    >>> import aktina
    >>> try:
    ...     aktina.load("nowhere.glb")
    ... except aktina.FileError as error:
    ...     print(error.code)
    io
    """
    scene = Scene()
    scene._scene = _core.load_scene(os.fspath(path))
    return scene


def trace(scene, origins, directions, near=0.0, far=np.inf):
    """What rays meet first in a scene. Both sides of a surface count.

    origins, directions : (..., 3); m, directions need not be unit.
    near, far : only hits between them count, in units of the directions' length.
    Returns Hits; `normal` is the geometric one, `uv` are the weights of a triangle's second and third vertex (0 on
    analytic shapes), `instance` and `triangle` say what was hit.

    >>> import aktina
    >>> scene = aktina.Scene([{"shape": {"type": "sphere", "radius": 1}}])
    >>> hits = aktina.trace(scene, [[0, 0, 3], [0, 2, 3]], [0, 0, -1])
    >>> hits.distance.tolist(), hits.instance.tolist()
    ([2.0, inf], [0, -1])
    """
    shape, (origins, directions) = _rays(origins, directions)
    distance = np.full(shape, np.inf, np.float32)
    normal, uv = np.full((*shape, 3), np.nan, np.float32), np.full((*shape, 2), np.nan, np.float32)
    indices = np.full((*shape, 2), -1, np.int32)
    _core.trace(scene._scene, origins, directions, number("near", near, 0), float(far), distance.reshape(-1), normal, uv,
                indices)
    with np.errstate(invalid="ignore"):
        point = (origins + distance.reshape(-1, 1) * directions).reshape(normal.shape)
    point[np.isinf(distance)] = np.nan
    instance, triangle = np.moveaxis(indices.astype(np.int64), -1, 0)
    return Hits(distance, point, normal, uv, instance, triangle)


def radiance(scene, origins, directions, method="path", samples=16, seed=0, progress=None):
    """Radiance that arrives at points from directions.

    origins, directions : (..., 3); m, from the point to where it looks.
    method : of the family "integrator", such as "whitted:depth=5".
    samples : rays averaged for each; `seed` chooses which.
    progress : called with (stage, unit, done, total, seconds), or None. Ctrl-C stops the work.
    Returns (..., 3) float32, cd/m^2.
    Raises NoSuchMethod, BadParam, UsageError, Cancelled.

    >>> import aktina
    >>> scene = aktina.Scene([{"shape": {"type": "sphere", "radius": 1}, "material": {"kd": 1}}], sky=2)
    >>> aktina.radiance(scene, [0, 5, 0], [0, 1, 0]).tolist()
    [2.0, 2.0, 2.0]
    """
    shape, (origins, directions) = _rays(origins, directions)
    out = np.empty((*shape, 3), np.float32)
    _core.radiance(scene._scene, origins, directions, method, int(samples), int(seed), out, progress)
    return out


def _rays(origins, directions):
    shape, flat = spread(origins=rows("origins", origins, 3, np.float32),
                         directions=rows("directions", directions, 3, np.float32))
    return shape, flat


_ARRAYS = {"vertices": (3, np.float32), "normals": (3, np.float32), "uv": (2, np.float32),
           "triangles": (3, np.uint32), "to_world": (4, np.float32)}


def _checked(item):
    """The object's arrays as the core takes them."""
    known = {*_ARRAYS, "shape", "material"}
    unknown = sorted(set(item) - known)
    if unknown:
        raise UsageError("no such field", f"object.{unknown[0]}", "there are: " + ", ".join(sorted(known)))
    if ("shape" in item) == ("vertices" in item):
        raise UsageError("needs either a shape or vertices", "object")
    checked = {"material": dict(item.get("material", {"kd": 0.8}))}
    if "texture" in checked["material"]:
        texture = rows("texture", checked["material"]["texture"], 3, np.float32)
        checked["material"]["texture"] = np.ascontiguousarray(texture)
    if "shape" in item:
        checked["shape"] = dict(item["shape"])
    for name, (columns, dtype) in _ARRAYS.items():
        if name in item:
            checked[name] = np.ascontiguousarray(rows(name, item[name], columns, dtype))
    return checked
