"""Scenes, and rays through them."""
import json
import os

import numpy as np

from . import _core
from ._arrays import number, numbers, rows, spread, unit_vectors
from ._errors import BadParam, UsageError
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
    lights : dictionaries as `aktina.irradiance` takes them. Rectangles and discs become surfaces that emit.
    camera : "position", "target", "up", and "vertical_fov" (rad) or, for a parallel projection, "half_height" (m). Left
        out: one that frames the scene.
    ambient, background, sky : colours; cd/m^2. Classic ambient light, what is seen beyond everything, even light from all
        around. sky may be an (H, W, 3) array, too: an equirectangular picture, rows from the top, its middle towards -z.
    sky_rotation : of that picture, rad about +y.
    Raises UsageError (a field, a shape), NoSuchMethod (a type), BadParam.

    >>> import aktina
    >>> scene = aktina.Scene([{"shape": {"type": "sphere", "radius": 1}, "material": {"kd": 0.5}}], sky=1)
    >>> scene
    <aktina.Scene: 0 triangles>
    """

    def __init__(self, objects=(), lights=(), camera=None, ambient=0.0, background=0.0, sky=0.0, sky_rotation=0.0):
        self._scene = _core.Scene()
        for item in objects:
            self._scene.add_object(_checked(item))
        for light in lights:
            self._scene.add_light(dict(light))
        if camera is not None:
            self._scene.add_camera(dict(camera))
        picture = np.ndim(sky) == 3
        self._scene.set_surroundings({"ambient": ambient, "background": background, "sky": 0.0 if picture else sky})
        if picture:
            self._set_sky(sky, sky_rotation)
        self._scene.frame()

    def _set_sky(self, picture, rotation):
        picture = numbers("sky", picture, np.float32)
        if picture.shape[2] != 3 or not picture.size:
            raise UsageError(f"has shape {picture.shape}", "sky", "(H, W, 3)")
        if not (picture >= 0).all():
            raise BadParam("has values below 0", "sky")
        self._scene.set_sky(picture, number("sky_rotation", rotation))

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

    @property
    def bounds(self):
        """Lowest and highest corner of everything that is drawn, m; None where there is nothing."""
        return self._scene.bounds

    @property
    def cameras(self):
        """Dictionaries, as `Scene` takes them."""
        return self._scene.cameras

    @property
    def lights(self):
        """Dictionaries, as `aktina.irradiance` takes them; emissive surfaces are not among them."""
        return self._scene.lights

    def render(self, method="path", width=0, height=0, samples=0, camera=0, seed=0, shading="phong",
               illumination="phong", layers=(), radiosity=None, progress=None, depth_cue=(1, 0)):
        """A picture: linear radiance, cd/m^2.

        method : "raster", a method of the family "integrator" ("path", "direct", "whitted"; parameters follow a colon),
            "radiosity" or "two_pass".
        width, height : px; 0: from the camera's aspect, 960 px wide.  samples : a pixel; 0: the method's default.
        camera : number of one of the scene's, or a dictionary as `Scene` takes it.
        shading, illumination : of "raster", methods of those families.
        layers : names among "albedo", "N", "P", "Z", "direct", "indirect", "illuminance", as the method has them.
        radiosity : dictionary of what `Scene.radiosity` takes, for "radiosity" and "two_pass".
        depth_cue : (k1, k2), of "raster" and "whitted": diffuse and specular light times 1 / (k1 + k2 d), d m from the
            eye's plane.
        progress : called with (stage, unit, done, total, seconds) ten times a second. Ctrl-C stops the work.
        Returns (H, W, 3) float32; with layers a dictionary of arrays, the picture under "".
        Raises NoSuchMethod, UsageError, BadParam, LimitExceeded.

        >>> import aktina
        >>> scene = aktina.Scene([{"shape": {"type": "sphere", "radius": 1}}], sky=1)
        >>> scene.render(width=30, height=20, samples=1).shape
        (20, 30, 3)
        """
        options = {"method": method, "width": int(width), "height": int(height), "samples": int(samples),
                   "shading": shading, "illumination": illumination, "layers": list(layers), "k1": float(depth_cue[0]), "k2": float(depth_cue[1])}
        drawn = _core.render(self._scene, options, camera, dict(radiosity or {}), int(seed), progress)
        pictures = {name: np.asarray(pixels) for name, pixels in drawn}
        return pictures if layers else pictures[""]

    def radiosity(self, solver="stochastic_jacobi", formfactor="ray_cast", patch_size=0.0, tolerance=0.0, most_steps=0,
                  most_patches=2_000_000, seed=0, mesher="uniform", quality="normal", target_error=0.0,
                  indirect_size=2.0, importance=None, checkpoint=None, every=60.0, resume=False, progress=None):
        """The light between the diffuse surfaces, view independent.

        solver, formfactor, mesher : methods of the families "radiosity", "formfactor", "mesher".
        quality : "draft", "normal" or "fine": what a patch_size, tolerance or target_error of 0 stands for.
        patch_size : longest edge of a patch, m; 0: by quality and the scene's size.
        tolerance : stop when the light not yet distributed is below this share of the emitted.
        target_error : of the light on surfaces, relative, where a solver draws samples.
        indirect_size : longest edge of what exchanges indirect light, in patch sizes; 0: all light on all patches.
        importance : a camera, or the number of one of the scene's: what it does not show is computed no finer than its
            picture needs. Of solvers on trees ("hierarchical", "clustering", "wavelet_haar", ...).
        most_steps : 0: no limit.  most_patches : more are refused.
        checkpoint : file that keeps what is done so far, written about each `every` seconds.  resume : go on from it
            where it is there; the result has the same bytes as that of a run that was never ended.
        Returns Solution.  Raises NoSuchMethod, BadParam, BadInput (nothing shines), LimitExceeded.

        >>> import aktina
        >>> room = {"vertices": [[-1, 0, 1], [1, 0, 1], [1, 0, -1], [-1, 0, -1]], "triangles": [[0, 1, 2], [0, 2, 3]]}
        >>> scene = aktina.Scene([room], lights=[{"type": "point", "position": [0, 2, 0], "intensity": 40}])
        >>> solution = scene.radiosity(patch_size=0.25)
        >>> bool(abs(solution.irradiances.max() - 10) < 0.5)
        True
        """
        options = _radiosity_options(solver=solver, formfactor=formfactor, mesher=mesher, quality=quality,
                                     patch_size=patch_size, tolerance=tolerance, target_error=target_error,
                                     indirect_size=indirect_size, importance=importance, most_steps=most_steps,
                                     most_patches=most_patches, checkpoint=checkpoint, every=every, resume=resume)
        return Solution(self, _core.solve_scene(self._scene, options, int(seed), progress))

    def radiosity_by_light(self, seed=0, progress=None, **options):
        """Each lamp, each object that shines and the sky ("environment") by itself, on one set of patches and form
        factors: for lights that are dimmed and suns that move. Those of one name count as one light.

        options : as for `radiosity`; direct light must be computed apart (indirect_size above 0).
        Returns {name: Solution}; `mix` adds them up.  Raises as `radiosity` does, Unsupported, LimitExceeded.
        """
        lights = _core.solve_lights(self._scene, _radiosity_options(**options), int(seed), progress)
        return {name: Solution(self, result) for name, result in lights.items()}

    def illuminance(self, points, normals, method="path", samples=64, seed=0, progress=None):
        """Irradiance at points on the side of their normals, lx per channel: what a light meter reads there.

        points : (..., 3), m; a little off surfaces.  normals : (..., 3), unit.
        method : of the family "integrator": "direct" leaves out what other surfaces send.  samples : a point.
        Returns (..., 3) float32.

        >>> import aktina
        >>> lamp = {"type": "point", "position": [0, 2, 0], "intensity": 40}
        >>> aktina.Scene(lights=[lamp]).illuminance([0, 0, 0], [0, 1, 0], "direct").round(3).tolist()
        [10.0, 10.0, 10.0]
        """
        shape, (points, normals) = spread(points=rows("points", points, 3, np.float32),
                                          normals=unit_vectors("normals", normals))
        out = np.empty((*shape, 3), np.float32)
        _core.illuminance(self._scene, points, normals, method, int(samples), int(seed), progress, out.reshape(-1, 3))
        return out

    def study(self, family="shading", methods=(), reference="", illumination="phong", width=0, height=0, samples=16,
              camera=0, rounds=7, growth=True, seed=0, folder="", progress=None):
        """The methods of a family on one view: how far each picture is from a reference, and what it costs.

        family : "shading", "illumination", "normals", "integrator", "radiosity", "formfactor", "mesher" or "specular".
        methods : only these, as "quadratic:perspective=1"; empty: all.
        reference : a method of the family or an integrator; empty: the family's own (docs/study.md).
        samples : per pixel of what is compared.  rounds : of timing.  growth : finer meshes and larger pictures too.
        folder : where report.html, report.json and report.csv go; empty: nowhere.
        Returns report.json's study as a dict: "methods" is a list of dicts with "quality", "cost", "claims", ...

        >>> import aktina
        >>> ball = {"shape": {"type": "sphere"}, "material": {"kd": 0.6, "ks": 0.4, "exponent": 20}}
        >>> scene = aktina.Scene([ball], lights=[{"type": "point", "position": [2, 3, 4], "intensity": 40}])
        >>> found = scene.study(methods=["gouraud", "phong"], width=48, samples=1, rounds=1, growth=False)
        >>> [method["id"] for method in found["methods"]], found["methods"][1]["quality"]["rmse"]
        (['gouraud', 'phong'], 0.0)
        """
        options = {"family": family, "methods": list(methods), "reference": reference, "illumination": illumination,
                   "width": int(width), "height": int(height), "samples": int(samples), "camera": int(camera),
                   "rounds": int(rounds), "growth": bool(growth)}
        text = _core.study(self._scene, options, int(seed), os.fspath(folder), progress)
        return json.loads(text)["studies"][0]

    def __repr__(self):
        return f"<aktina.Scene: {self.triangles} triangles>"


class Solution:
    """The light on a scene's surfaces, from `Scene.radiosity` or `load_solution`. Arrays cannot be written to.

    Of P patches: `patches` (P, 4) vertices, the last two equal for triangles; `areas` (P,) m^2; `normals` (P, 3);
    `reflectances` (P, 3); `emissions`, `radiosities` (P, 3) lm/m^2; `irradiances` (P, 3) lx;
    `illuminance_errors` (P,) lx: estimated RMS difference between a patch's illuminance and that of its points.
    Of V vertices: `vertices` (V, 3) m, `vertex_normals`, `vertex_irradiances`, `vertex_radiosities` (V, 3).
    Facts: `steps`, `unshot` (share of the emitted light), `converged`, `emitted`, `absorbed`, `escaped` (lm).
    """

    def __init__(self, scene, result):
        self.scene, self._result = scene, result
        for name, values in _core.solution_arrays(result).items():
            setattr(self, name, np.asarray(values))
        for name, value in _core.solution_facts(result).items():
            setattr(self, name, value)

    def render(self, width, height, camera=0, samples=4, two_pass=False, gather=False, seed=0, progress=None):
        """The solution from a camera: linear radiance, cd/m^2.

        two_pass : adds mirrors, glass and sharp shadows of direct light by rays (Wallace 1987).
        gather : of two passes: indirect light by a ray for each sample, too (final gather).
        Returns (H, W, 3) float32.
        """
        method = "two_pass:gather=%d" % bool(gather) if two_pass or gather else ""
        return np.asarray(_core.draw_solution(self._result, self.scene._scene, camera, method, int(width),
                                              int(height), int(samples), int(seed), progress))

    def save(self, path):
        """By the extension: .aktina (for `load_solution`), .vtu (ParaView), .csv (a line a patch), .glb or .gltf (the
        lit model)."""
        _core.write_solution(self._result, self.scene._scene, os.fspath(path))

    def lightmap(self, texel_size=0.0, size=1024, padding=2, keep_uv=True, direct_samples=16, gather_samples=0, seed=0,
                 progress=None):
        """The light on the surfaces as pictures.

        texel_size : m; 0: the smallest at which all fits on one page.  size : largest width and height of a page.
        padding : texels about each chart that are nobody else's.
        keep_uv : second texture coordinates of the file are used where they can be.
        direct_samples : shadow rays a texel; 0: direct light as the solution has it.
        gather_samples : rays a texel that gather indirect light; 0: as the solution has it.
        Returns Lightmap.  Raises LimitExceeded (says what would fit), BadParam, Unsupported, Cancelled.

        >>> import aktina
        >>> floor = {"vertices": [[-1, 0, 1], [1, 0, 1], [1, 0, -1], [-1, 0, -1]], "triangles": [[0, 1, 2], [0, 2, 3]]}
        >>> scene = aktina.Scene([floor], lights=[{"type": "point", "position": [0, 2, 0], "intensity": 40}])
        >>> lightmap = scene.radiosity(patch_size=0.5).lightmap(texel_size=0.02)
        >>> bool(abs(lightmap.pages[0].max() - 10) < 0.05)  # 40 cd at 2 m
        True
        """
        options = _lightmap_options(texel_size, size, padding, keep_uv, direct_samples, gather_samples)
        return Lightmap(*_core.make_lightmap(self._result, self.scene._scene, options, int(seed), progress))

    def bake(self, path, form="vertex", exposure=0.0, texel_size=0.0, size=1024, padding=2, keep_uv=True,
             direct_samples=16, gather_samples=0, seed=0, progress=None):
        """Writes the scene with its light in it, for viewers that compute none (docs/baking.md).

        path : .glb or .gltf: the model; .exr: its lightmap alone, in lux.
        form : "vertex" (colours on unlit materials), "emissive" (a texture on black materials that shine) or
            "lightmap" (MOZ_lightmap on the materials as they are, and the .exr beside).
        exposure : factor from radiance in cd/m^2 to colours; 0: the largest at which 1 % of the area clips.
        The rest as for `lightmap`.
        Returns the names of the files.  Raises UsageError, FileError and as `lightmap` does.
        """
        options = _lightmap_options(texel_size, size, padding, keep_uv, direct_samples, gather_samples)
        return _core.bake(self._result, self.scene._scene, os.fspath(path), form, number("exposure", exposure, 0),
                          options, int(seed), progress)

    def __repr__(self):
        return f"<aktina.Solution: {len(self.areas)} patches, {'converged' if self.converged else 'not converged'}>"


_RADIOSITY_TYPES = {"patch_size": float, "tolerance": float, "target_error": float, "indirect_size": float,
                    "most_steps": int, "most_patches": int, "every": float, "resume": bool,
                    "checkpoint": lambda path: os.fspath(path) if path else ""}


def _radiosity_options(**options):
    return {name: _RADIOSITY_TYPES.get(name, lambda value: value)(value) for name, value in options.items()}


def _lightmap_options(texel_size, size, padding, keep_uv, direct_samples, gather_samples):
    return {"texel_size": float(texel_size), "size": int(size), "padding": int(padding), "keep_uv": bool(keep_uv),
            "direct_samples": int(direct_samples), "gather_samples": int(gather_samples)}


class Lightmap:
    """The light on a scene's surfaces as pictures, from `Solution.lightmap`. Arrays cannot be written to.

    `pages` : (H, W, 3) float32 each: irradiance, lx, rows from the top. `texel_size` : m.
    `meshes` : what stands on the pages, a dictionary each: `instance` (of the scene), `page`, `back` (of what is
        two-sided), `vertices` (V, 3) m, world, `uv` (V, 2) on the page, v down, `triangles` (T, 3).
    `seams` : root mean square of the differences at seams over the mean, before and after they were closed.
    `warnings` : [(text, count)].
    """

    def __init__(self, pages, meshes, texel_size, seams, warnings):
        names = ("instance", "page", "back", "vertices", "uv", "triangles")
        self.pages = [np.asarray(page) for page in pages]
        self.meshes = [dict(zip(names, (*mesh[:3], *map(np.asarray, mesh[3:])))) for mesh in meshes]
        self.texel_size, self.seams, self.warnings = texel_size, seams, warnings

    def __repr__(self):
        sizes = ", ".join(f"{page.shape[1]} x {page.shape[0]}" for page in self.pages)
        return f"<aktina.Lightmap: {sizes} texels of {self.texel_size:.3g} m>"


def mix(lights, factors=None):
    """The light of several lights together, each dimmed. Light is additive: nothing is solved again.

    lights : {name: Solution}, as `Scene.radiosity_by_light` gives them.
    factors : {name: factor of its flux, 0 ..}; 1 where a light has none.
    Returns Solution.  Raises UsageError (solutions of different runs, an unknown name), BadParam.

    >>> import aktina
    >>> floor = {"vertices": [[-1, 0, 1], [1, 0, 1], [1, 0, -1], [-1, 0, -1]], "triangles": [[0, 1, 2], [0, 2, 3]]}
    >>> lamps = [{"type": "point", "position": [0, 2, 0], "intensity": 40, "name": name} for name in "ab"]
    >>> lights = aktina.Scene([floor], lights=lamps).radiosity_by_light(patch_size=0.5)
    >>> both = aktina.mix(lights, {"b": 0.5})
    >>> bool(abs(both.emitted / lights["a"].emitted - 1.5) < 1e-6)
    True
    """
    factors = dict(factors or {})
    unknown = sorted(set(factors) - set(lights))
    if unknown:
        raise UsageError(f"no light {unknown[0]!r}", "mix", f"there are: {', '.join(lights)}")
    if not lights:
        raise UsageError("no lights", "mix")
    scene = next(iter(lights.values())).scene
    weighted = [(name, solution._result, number("factor", factors.get(name, 1), 0)) for name, solution in lights.items()]
    return Solution(scene, _core.mix(weighted))


def load_solution(path, scene):
    """A solution that `Solution.save` or `aktina radiosity` wrote, of the same scene.

    Raises FileError, BadInput (damaged, or of another scene).

    >>> import aktina
    >>> try:
    ...     aktina.load_solution("nowhere.aktina", aktina.Scene())
    ... except aktina.FileError as error:
    ...     print(error.code)
    io
    """
    return Solution(scene, _core.load_solution(scene._scene, os.fspath(path)))


def load(path, normals=None, crease=np.pi / 6, environment=None, environment_scale=1.0, environment_rotation=0.0):
    """A Scene from a file: glTF 2.0, OBJ, PLY, STL, OFF, FBX, COLLADA, 3DS.

    normals : a method of the family "normals" that makes the normals of all meshes anew; None: those of the file.
    crease : rad; edges sharper than this stay sharp where normals are made.
    environment : an equirectangular picture (HDR, EXR, PNG, ...) that shines on the scene in place of its own.
    environment_scale : from its values to cd/m^2.  environment_rotation : rad about +y.
    Raises FileError, BadInput, LimitExceeded, Unsupported, NoSuchMethod, BadParam.

    >>> import aktina
    >>> try:
    ...     aktina.load("nowhere.glb")
    ... except aktina.FileError as error:
    ...     print(error.code)
    io
    """
    scene = Scene()
    scene._scene = _core.load_scene(os.fspath(path), normals or "", number("crease", crease, 0, np.pi),
                                    os.fspath(environment) if environment else "",
                                    number("environment_scale", environment_scale, 0, 1e9),
                                    number("environment_rotation", environment_rotation))
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
