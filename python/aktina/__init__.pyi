"""Types of the package's public names; the docstrings stand in the modules."""
from collections.abc import Callable, Iterable, Mapping, Sequence
import os
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

__version__: str

class Error(Exception):
    code: str
    message: str
    where: str
    hint: str
    def __init__(self, message: str, where: str = "", hint: str = "") -> None: ...

class UsageError(Error, ValueError): ...
class BadParam(Error, ValueError): ...
class NoSuchMethod(Error, ValueError): ...
class BadInput(Error, ValueError): ...
class FileError(Error, OSError): ...
class LimitExceeded(Error, MemoryError): ...
class CheckFailed(Error): ...
class Unsupported(Error): ...
class Cancelled(Error): ...

def methods(family: str | None = None) -> list[dict[str, Any]]: ...
def set_thread_count(threads: int) -> None: ...
def thread_count() -> int: ...

# Illumination models and lights.
def albedo(model: str, material: dict[str, Any], cos_view: ArrayLike = 1.0) -> NDArray[np.float32]: ...
def reflected_share(model: str, material: dict[str, Any], cos_light: ArrayLike = 1.0) -> NDArray[np.float32]: ...
def reciprocity(model: str, material: dict[str, Any]) -> tuple[float, tuple[float, ...], tuple[float, ...]]: ...
def illuminate(
    model: str,
    material: dict[str, Any],
    n: ArrayLike,
    l: ArrayLike,
    v: ArrayLike | None = None,
    light: ArrayLike = 1.0,
    ambient: ArrayLike = 0.0,
) -> NDArray[np.float32]: ...
def highlight(model: str, n: ArrayLike, l: ArrayLike, v: ArrayLike, exponent: ArrayLike) -> NDArray[np.float32]: ...
def schlick_power(t: ArrayLike, exponent: ArrayLike) -> NDArray[np.float32]: ...
def interpolate(
    method: str,
    normals: ArrayLike,
    barycentric: ArrayLike,
    lights: list[dict[str, Any]],
    v: ArrayLike = (0, 0, 1),
    eye: ArrayLike | None = None,
    material: dict[str, Any] | None = None,
    model: str = "phong",
    ambient: ArrayLike = 0.0,
    positions: ArrayLike = ...,
    screen: ArrayLike | None = None,
    weights: ArrayLike = (1, 1, 1),
) -> NDArray[np.float32]: ...
def interpolate_samples(samples: ArrayLike, barycentric: ArrayLike) -> NDArray[np.float32]: ...
def slerp(a: ArrayLike, b: ArrayLike, t: ArrayLike) -> NDArray[np.float32]: ...
def arc_angle(a: ArrayLike, b: ArrayLike) -> NDArray[np.float32]: ...
def interpolate_cosine(
    method: str, p: ArrayLike, q: ArrayLike, t: ArrayLike, steps: float | None = None
) -> NDArray[np.float32]: ...
def fast_phong_series(screen: ArrayLike, normals: ArrayLike, l: ArrayLike) -> NDArray[np.float64]: ...
def facet_distribution(name: str, alpha: ArrayLike, width: float) -> NDArray[np.float32]: ...
def groove_masking(n: ArrayLike, l: ArrayLike, v: ArrayLike) -> NDArray[np.float32]: ...
def fresnel(cosine: ArrayLike, eta: float) -> NDArray[np.float32]: ...
def irradiance(light: dict[str, Any], points: ArrayLike, normals: ArrayLike) -> NDArray[np.float32]: ...
def spot_falloff(
    axis: ArrayLike, l: ArrayLike, outer_angle: float, inner_angle: float | None = None, exponent: float = 0.0
) -> NDArray[np.float32]: ...
def attenuation(
    distance: ArrayLike, a0: float = 0.0, a1: float = 0.0, a2: float = 1.0, clamp: bool = False
) -> NDArray[np.float32]: ...
def depth_cue(distance: ArrayLike, k1: float, k2: float) -> NDArray[np.float32]: ...

# Single shapes.
class Hits:
    distance: NDArray[Any]
    point: NDArray[Any]
    normal: NDArray[Any]
    uv: NDArray[Any]
    instance: NDArray[np.int64] | None
    triangle: NDArray[np.int64] | None
    def __init__(
        self,
        distance: NDArray[Any],
        point: NDArray[Any],
        normal: NDArray[Any],
        uv: NDArray[Any],
        instance: NDArray[np.int64] | None = None,
        triangle: NDArray[np.int64] | None = None,
    ) -> None: ...
    @property
    def hit(self) -> NDArray[np.bool_]: ...

def intersect(
    shape: str, origins: ArrayLike, directions: ArrayLike, near: float = 0.0, far: float = ..., **sizes: Any
) -> Hits: ...
def vertex_normal(method: str, vertex: ArrayLike, rim: ArrayLike, closed: bool = True) -> NDArray[np.float64]: ...
def mesh_normals(
    vertices: ArrayLike, triangles: ArrayLike, method: str = "angle", crease: float = ...
) -> dict[str, NDArray[Any]]: ...

# Radiosity.
def solve_radiosity(
    F: ArrayLike,
    E: ArrayLike,
    rho: ArrayLike,
    method: str = "matrix",
    tolerance: float = 1e-12,
    progress: Callable[[str, str, int, int, float], None] | None = None,
) -> NDArray[np.float64]: ...

# Form factors.
class ViewFactors:
    areas: NDArray[np.float64]
    names: list[str]
    data: NDArray[np.float64]
    indices: NDArray[np.int32]
    indptr: NDArray[np.int64]
    errors: NDArray[np.float32]
    transmittances: NDArray[np.float64] | None
    certificate: dict[str, Any]
    def __init__(self, arrays: Any) -> None: ...
    @property
    def shape(self) -> tuple[int, int]: ...
    @property
    def F(self) -> NDArray[np.float64]: ...
    def gray_body(
        self,
        emissivity: ArrayLike = 0.9,
        temperature: ArrayLike | None = None,
        flux: ArrayLike | None = None,
        surroundings: float = 0.0,
    ) -> dict[str, Any]: ...

def view_factors(
    scene: Scene | str | os.PathLike[str],
    by: str = "face",
    target_error: float = 1e-4,
    repair: bool = False,
    two_sided: bool = False,
    clear: bool = False,
    max_memory: float = 0.0,
    scratch: str | os.PathLike[str] | None = None,
    progress: Callable[[str, str, int, int, float], None] | None = None,
) -> ViewFactors: ...
def form_factor(
    a: ArrayLike | dict[str, Any],
    b: ArrayLike | dict[str, Any],
    method: str = "contour",
    occluders: Sequence[ArrayLike | dict[str, Any]] = (),
) -> float: ...
def form_factors(
    surfaces: Sequence[ArrayLike],
    occluders: Sequence[ArrayLike] = (),
    method: str = "contour",
    progress: Callable[[str, str, int, int, float], None] | None = None,
) -> tuple[NDArray[np.float64], NDArray[np.float64]]: ...
def polygon_area(polygon: ArrayLike) -> float: ...

# Pictures.
def read_image(path: str | os.PathLike[str]) -> NDArray[np.float32]: ...
def write_image(
    path: str | os.PathLike[str],
    image: ArrayLike,
    exposure: float | None = 1.0,
    curve: str = "none",
    bits: int = 8,
    metadata: dict[str, str] | None = None,
) -> None: ...
def compare(a: ArrayLike, b: ArrayLike, range: str = "auto") -> dict[str, Any]: ...

def reflect(incident: ArrayLike, normal: ArrayLike) -> NDArray[np.float64]: ...
def refract(
    incident: ArrayLike, normal: ArrayLike, n1: float, n2: float, form: str = "snell"
) -> tuple[NDArray[np.float64], NDArray[np.float64]]: ...

# Scenes.
class Scene:
    def __init__(
        self,
        objects: Iterable[dict[str, Any]] = (),
        lights: Iterable[dict[str, Any]] = (),
        camera: dict[str, Any] | None = None,
        ambient: ArrayLike = 0.0,
        background: ArrayLike = 0.0,
        sky: ArrayLike = 0.0,
        sky_rotation: float = 0.0,
    ) -> None: ...
    @property
    def triangles(self) -> int: ...
    @property
    def hash(self) -> str: ...
    @property
    def warnings(self) -> list[tuple[str, int]]: ...
    @property
    def bounds(self) -> tuple[tuple[float, float, float], tuple[float, float, float]] | None: ...
    @property
    def cameras(self) -> list[dict[str, Any]]: ...
    @property
    def lights(self) -> list[dict[str, Any]]: ...
    def render(
        self,
        method: str = "path",
        width: int = 0,
        height: int = 0,
        samples: int = 0,
        camera: int | dict[str, Any] = 0,
        seed: int = 0,
        shading: str = "phong",
        illumination: str = "phong",
        layers: Sequence[str] = (),
        radiosity: dict[str, Any] | None = None,
        progress: Callable[[str, str, int, int, float], object] | None = None,
        depth_cue: tuple[float, float] = (1, 0),
    ) -> Any: ...
    def radiosity(
        self,
        solver: str = "stochastic_jacobi",
        formfactor: str = "ray_cast",
        patch_size: float = 0.0,
        tolerance: float = 0.0,
        most_steps: int = 0,
        most_patches: int = 2_000_000,
        seed: int = 0,
        mesher: str = "uniform",
        quality: str = "normal",
        target_error: float = 0.0,
        indirect_size: float = 2.0,
        importance: dict[str, Any] | int | None = None,
        checkpoint: str | os.PathLike[str] | None = None,
        every: float = 60.0,
        resume: bool = False,
        progress: Callable[[str, str, int, int, float], object] | None = None,
    ) -> Solution: ...
    def radiosity_by_light(
        self,
        seed: int = 0,
        progress: Callable[[str, str, int, int, float], object] | None = None,
        **options: Any,
    ) -> dict[str, Solution]: ...
    def illuminance(
        self,
        points: ArrayLike,
        normals: ArrayLike,
        method: str = "path",
        samples: int = 64,
        seed: int = 0,
        progress: Callable[[str, str, int, int, float], object] | None = None,
    ) -> NDArray[np.float32]: ...
    def study(
        self,
        family: str = "shading",
        methods: Sequence[str] = (),
        reference: str = "",
        illumination: str = "phong",
        width: int = 0,
        height: int = 0,
        samples: int = 16,
        camera: int = 0,
        rounds: int = 7,
        growth: bool = True,
        seed: int = 0,
        folder: str | os.PathLike[str] = "",
        progress: Callable[[str, str, int, int, float], object] | None = None,
    ) -> dict[str, Any]: ...

class Solution:
    scene: Scene
    vertices: NDArray[np.float32]
    vertex_normals: NDArray[np.float32]
    vertex_irradiances: NDArray[np.float32]
    vertex_radiosities: NDArray[np.float32]
    patches: NDArray[np.uint32]
    areas: NDArray[np.float32]
    normals: NDArray[np.float32]
    reflectances: NDArray[np.float32]
    emissions: NDArray[np.float32]
    irradiances: NDArray[np.float32]
    illuminance_errors: NDArray[np.float32]
    radiosities: NDArray[np.float32]
    steps: int
    unshot: float
    converged: bool
    emitted: float
    absorbed: float
    escaped: float
    def __init__(self, scene: Scene, result: Any) -> None: ...
    def render(
        self,
        width: int,
        height: int,
        camera: int | dict[str, Any] = 0,
        samples: int = 4,
        two_pass: bool = False,
        gather: bool = False,
        seed: int = 0,
        progress: Callable[[str, str, int, int, float], object] | None = None,
    ) -> NDArray[np.float32]: ...
    def save(self, path: str | os.PathLike[str]) -> None: ...
    def lightmap(
        self,
        texel_size: float = 0.0,
        size: int = 1024,
        padding: int = 2,
        keep_uv: bool = True,
        direct_samples: int = 16,
        gather_samples: int = 0,
        seed: int = 0,
        progress: Callable[[str, str, int, int, float], object] | None = None,
    ) -> Lightmap: ...
    def bake(
        self,
        path: str | os.PathLike[str],
        form: str = "vertex",
        exposure: float = 0.0,
        texel_size: float = 0.0,
        size: int = 1024,
        padding: int = 2,
        keep_uv: bool = True,
        direct_samples: int = 16,
        gather_samples: int = 0,
        seed: int = 0,
        progress: Callable[[str, str, int, int, float], object] | None = None,
    ) -> list[str]: ...

class Lightmap:
    pages: list[NDArray[np.float32]]
    meshes: list[dict[str, Any]]
    texel_size: float
    seams: tuple[float, float]
    warnings: list[tuple[str, int]]
    def __init__(self, pages: Any, meshes: Any, texel_size: float, seams: Any, warnings: Any) -> None: ...

def mix(lights: Mapping[str, Solution], factors: Mapping[str, float] | None = None) -> Solution: ...
def load_solution(path: str | os.PathLike[str], scene: Scene) -> Solution: ...
def load(
    path: str | os.PathLike[str],
    normals: str | None = None,
    crease: float = ...,
    environment: str | os.PathLike[str] | None = None,
    environment_scale: float = 1.0,
    environment_rotation: float = 0.0,
) -> Scene: ...
def trace(scene: Scene, origins: ArrayLike, directions: ArrayLike, near: float = 0.0, far: float = ...) -> Hits: ...
def radiance(
    scene: Scene,
    origins: ArrayLike,
    directions: ArrayLike,
    method: str = "path",
    samples: int = 16,
    seed: int = 0,
    progress: Callable[[str, str, int, int, float], object] | None = None,
) -> NDArray[np.float32]: ...
