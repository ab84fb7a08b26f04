#!/usr/bin/env python3
"""Draws the picture of each method of the catalogue: docs/pictures/FAMILY/ID.png.

render_pictures.py BUILD [FAMILY...]    all families, or those named

One function a family draws the same scene by each of its methods, so that pictures of a family can be compared.
Accelerators have none: every one of them must give the same picture.
"""
import pathlib
import sys

import numpy as np

ROOT = pathlib.Path(__file__).resolve().parent.parent
sys.path.insert(0, str(pathlib.Path(sys.argv[1]).resolve() / "python"))
import aktina  # noqa: E402

WIDTH, HEIGHT = 240, 180
LAMP = {"type": "point", "position": [2.5, 3.5, 3], "intensity": 200}
QUAD = [[0, 1, 2], [0, 2, 3]]


def lattice(columns, rows, point):
    """A mesh over the unit square: point(u, v) -> position; smooth, normals from the facets."""
    u, v = np.meshgrid(np.linspace(0, 1, columns + 1), np.linspace(0, 1, rows + 1))
    vertices = np.stack(point(u.ravel(), v.ravel()), axis=-1)
    at = np.arange(rows * (columns + 1)).reshape(rows, -1)[:, :-1].ravel()
    up = at + columns + 1
    triangles = np.vstack([np.stack([at, at + 1, up + 1], -1), np.stack([at, up + 1, up], -1)])
    return vertices, triangles


def torus(columns, rows, large=0.62, small=0.27):
    def point(u, v):
        a, b = 2 * np.pi * u, -2 * np.pi * v
        r = large + small * np.cos(b)
        return r * np.cos(a), r * np.sin(a), small * np.sin(b)
    return mesh(*lattice(columns, rows, point), point_normal(lattice(columns, rows, lambda u, v: (
        np.cos(2 * np.pi * u) * np.cos(-2 * np.pi * v), np.sin(2 * np.pi * u) * np.cos(-2 * np.pi * v),
        np.sin(-2 * np.pi * v)))[0]))


def ball(columns, rows, radius=0.62):
    directions, triangles = lattice(columns, rows, lambda u, v: (
        np.sin(np.pi * v) * np.sin(2 * np.pi * u), np.cos(np.pi * v), np.sin(np.pi * v) * np.cos(2 * np.pi * u)))
    triangles = triangles[:, [0, 2, 1]]
    return mesh(radius * directions, triangles, directions)


def point_normal(vectors):
    return vectors / np.linalg.norm(vectors, axis=1, keepdims=True)


def mesh(vertices, triangles, normals):
    p = vertices[triangles]
    across = np.cross(p[:, 1] - p[:, 0], p[:, 2] - p[:, 0])
    front = np.einsum("ij,ij->i", across, normals[triangles].sum(axis=1))
    keep = np.linalg.norm(across, axis=1) > 1e-9
    triangles = np.where((front < 0)[:, None], triangles[:, [0, 2, 1]], triangles)[keep]
    return {"vertices": vertices, "triangles": triangles, "normals": normals}


def moved(item, x, y=0.0, z=0.0):
    matrix = np.eye(4)
    matrix[:3, 3] = x, y, z
    return item | {"to_world": matrix}


def ball_and_torus(material, coarse=False, back=(0.05, 0.055, 0.07)):
    columns, rows = (14, 8) if coarse else (96, 64)
    shapes = [moved(ball(columns, rows), -0.72), moved(torus(columns, rows // 2), 0.75)]
    return aktina.Scene([shape | {"material": material} for shape in shapes], [LAMP], ambient=0.6, background=back,
                        camera={"position": [0, 0.8, 4.2], "target": [0.1, 0, 0], "vertical_fov": 0.62})


def write(family, method, picture, exposure=1.0):
    path = ROOT / "docs/pictures" / family / f"{method}.png"
    path.parent.mkdir(parents=True, exist_ok=True)
    aktina.write_image(path, np.clip(picture, 0, None), exposure=exposure)
    print(path.relative_to(ROOT))


def light(methods):
    floor = {"vertices": [[-4, -1, 4], [4, -1, 4], [4, -1, -3], [-4, -1, -3]], "triangles": QUAD, "material": {"kd": 0.7}}
    wall = {"vertices": [[-4, -1, -3], [4, -1, -3], [4, 5, -3], [-4, 5, -3]], "triangles": QUAD, "material": {"kd": 0.7}}
    post = {"shape": {"type": "cylinder", "radius": 0.25, "height": 1.6}, "material": {"kd": [0.7, 0.3, 0.2]},
            "to_world": [[1, 0, 0, 0.3], [0, 1, 0, -1], [0, 0, 1, 0], [0, 0, 0, 1]]}
    gamma = np.radians(np.arange(0, 181, 5))
    lobes = 120 * np.clip(np.cos(gamma), 0, 1) ** 2 * (1.2 - np.cos(6 * gamma))
    lamps = {
        "point": {"type": "point", "position": [-1, 1.6, 0.8], "intensity": 40},
        "spot": {"type": "spot", "position": [-1, 2.6, 1.2], "direction": [0.45, -1, -0.4], "intensity": 120,
                 "inner_angle": 0.35, "outer_angle": 0.5},
        "directional": {"type": "directional", "direction": [0.6, -1, -0.5], "illuminance": 8},
        "luminaire": {"type": "luminaire", "position": [-1, 2.2, -0.6], "direction": [0, -1, 0], "c0": [1, 0, 0],
                      "c": [0], "gamma": np.degrees(gamma).tolist(), "candela": lobes.tolist()},
    }
    lamps |= {
        "warn": {"type": "warn", "position": [-1, 2.6, 1.2], "direction": [0.45, -1, -0.4], "intensity": 120,
                 "exponent": 4, "cone_angle": 0.6, "flap_low": [-1e30, -1e30, -0.6], "flap_high": [0.9, 1e30, 1e30]},
        "rectangle": {"type": "rectangle", "corner": [-1.6, 2.1, -0.4], "edge_u": [1.4, 0, 0], "edge_v": [0, 0, 0.8],
                      "radiance": 28},
        "disc": {"type": "disc", "position": [-1, 1.9, 0.3], "direction": [0.5, -0.8, -0.3], "radius": 0.5,
                 "radiance": 40},
    }
    for method in methods:
        scene = aktina.Scene([floor, wall, post], [lamps[method]],
                             camera={"position": [0, 1.2, 6], "target": [0, 0.4, 0], "vertical_fov": 0.7})
        way, samples = ("direct", 144) if method in ("rectangle", "disc") else ("whitted", 16)  # soft shadows
        write("light", method, scene.render(way, WIDTH, HEIGHT, samples=samples), 0.35)


def illumination(methods):
    material = {"ka": [0.12, 0.04, 0.03], "kd": [0.55, 0.16, 0.12], "ks": 0.5, "exponent": 40}
    scene = ball_and_torus(material)
    for method in methods:
        choice = {"cook_torrance": "cook_torrance:slope=0.25", "ward": "ward:along=0.1,across=0.35"}.get(method, method)
        if method == "ggx":
            scene = ball_and_torus({"base_colour": [0.9, 0.55, 0.35], "metallic": 1, "roughness": 0.35})
        write("illumination", method, scene.render("raster", WIDTH, HEIGHT, samples=16, illumination=choice), 0.11)
        if method != "ambient":  # dark
            write("illumination", f"lobe_{method}", lobes(method))


LOBE_MATERIAL = {"kd": 0.4, "ks": 0.4, "exponent": 20, "base_colour": [0.9] * 3, "metallic": 1, "roughness": 0.5}
LOBE_LIGHTS = {15: (0.9, 0.45, 0.1), 45: (0.1, 0.55, 0.35), 65: (0.15, 0.3, 0.8)}  # degrees off the normal -> colour


def lobes(method, width=320, height=176, finer=3):
    """Polar plot: radiance towards each direction of the plane of incidence, for three directions of the light.

    The light comes from the left, along the strokes. All lobes of a plot have one scale, that of the
    largest within 75 degrees of the normal; what is larger beyond, where some models grow without bound, is cut."""
    def radiance(light, angle):
        l, v = ([np.sin(a), 0 * a, np.cos(a)] for a in (-np.radians(light), angle))
        return aktina.illuminate(method, LOBE_MATERIAL, [0, 0, 1], np.stack(l), np.stack(v, -1))[..., 0]
    angles = np.linspace(-np.pi / 2, np.pi / 2, 1801)
    values = {light: radiance(light, angles) for light in LOBE_LIGHTS}
    scale = max(v[abs(angles) < 1.3].max() for v in values.values())
    y, x = np.mgrid[0:height * finer, 0:width * finer] / finer
    x, y = x - width / 2, height - 14 - y
    r, angle, full = np.hypot(x, y), np.arctan2(x, y), height - 26
    picture = np.ones((*x.shape, 3))
    for ring in (0.25, 0.5, 0.75, 1):
        picture[(abs(r - ring * full) < 0.4) & (y > 0)] = 0.75
    for light, values_of in values.items():
        edge = np.interp(angle, angles, np.minimum(values_of / scale, 1)) * full
        colour = np.array(LOBE_LIGHTS[light])
        inside = (r < edge) & (y > 0)
        picture[inside] = 0.75 * picture[inside] + 0.25 * colour
        picture[(abs(r - edge) < 0.9) & (y > 0) & (edge > 1)] = colour
        a = -np.radians(light)
        stroke = (abs(x * np.cos(a) - y * np.sin(a)) < 0.6) & (x * np.sin(a) + y * np.cos(a) > 0.88 * full) & (r < full)
        picture[stroke] = colour
    picture[(abs(y) < 0.6)] = 0.2
    return picture.reshape(height, finer, width, finer, 3).mean(axis=(1, 3)).astype(np.float32)


def shading(methods):
    scene = ball_and_torus({"ka": 0.1, "kd": [0.2, 0.35, 0.6], "ks": 0.6, "exponent": 30}, coarse=True)
    for method in methods:
        write("shading", method, scene.render("raster", WIDTH, HEIGHT, samples=16, shading=method), 0.11)


def normals(methods):
    """A tessellation of a ball that is fine on one side and coarse on the other."""
    def point(u, v):
        a, b = 2 * np.pi * u ** 1.8, np.pi * v
        return np.sin(b) * np.sin(a), np.cos(b), np.sin(b) * np.cos(a)
    vertices, triangles = lattice(16, 9, point)
    shape = mesh(vertices, triangles, vertices)
    keys = [tuple(np.round(p, 6) + 0.0) for p in vertices]
    for method in methods:
        result = np.empty_like(vertices)
        for i, q in enumerate(vertices):
            facets = [t for t in shape["triangles"] if keys[i] in {keys[k] for k in t}]
            total = np.zeros(3)
            for t in facets:
                at = next(k for k in range(3) if keys[t[k]] == keys[i])
                rim = [vertices[t[(at + 1) % 3]], vertices[t[(at + 2) % 3]]]
                total += weighted(method, q, rim)
            result[i] = total / np.linalg.norm(total)
        scene = aktina.Scene([shape | {"normals": result, "material": {"kd": [0.4, 0.5, 0.3], "ks": 0.5, "exponent": 40}}],
                             [LAMP], ambient=0.3, background=[0.05, 0.055, 0.07],
                             camera={"position": [0, 0.6, 4.2], "target": [0, 0, 0], "vertical_fov": 0.55})
        write("normals", method, scene.render("raster", WIDTH, HEIGHT, samples=16), 0.11)


def weighted(method, q, rim):
    """One facet's contribution: its unit normal by the method's weight, which the module does not give by itself."""
    a, b = rim[0] - q, rim[1] - q
    c = np.cross(a, b)
    length = np.linalg.norm(c)
    weight = {"plain": 1, "area": length, "angle": np.arctan2(length, a @ b), "max": length / (a @ a) / (b @ b)}[method]
    return c / length * weight


def primitive(methods):
    floor = {"vertices": [[-5, -1, 5], [5, -1, 5], [5, -1, -5], [-5, -1, -5]], "triangles": QUAD, "material": {"kd": 0.6}}
    for method in methods:
        low = -0.2 if method in ("sphere", "disc") else -1
        shape = {"shape": {"type": method} | ({"height": 1.6} if low == -1 else {}),
                 "material": {"base_colour": [0.75, 0.45, 0.2], "roughness": 0.4, "double_sided": True}}
        scene = aktina.Scene([floor, moved(shape, 0, low)], [LAMP], sky=0.5,
                             camera={"position": [2.2, 2.2, 4.2], "target": [0, -0.3, 0], "vertical_fov": 0.6})
        write("primitive", method, scene.render("path", WIDTH, HEIGHT, samples=64), 0.11)


def integrator(methods):
    scene = aktina.load(ROOT / "scenes/room.glb")
    for method in methods:
        samples = {"path": 256}.get(method, 16)
        write("integrator", method, scene.render(method, 300, 200, samples=samples), 0.006)


def box_room():
    """A closed room of 4 x 3 x 2.5 m with a block in it, lit by a panel."""
    def quad(corner, u, v, colour, emission=0.0):
        corner, u, v = (np.array(x, float) for x in (corner, u, v))
        return {"vertices": [corner, corner + u, corner + u + v, corner + v], "triangles": QUAD,
                "material": {"base_colour": colour, "metallic": 0, "specular_weight": 0, "emission": emission}}
    grey, red, blue = [0.7] * 3, [0.7, 0.2, 0.15], [0.2, 0.3, 0.65]
    walls = [quad([0, 0, 3], [4, 0, 0], [0, 0, -3], grey), quad([0, 2.5, 0], [4, 0, 0], [0, 0, 3], grey),
             quad([0, 0, 0], [4, 0, 0], [0, 2.5, 0], grey), quad([4, 0, 3], [-4, 0, 0], [0, 2.5, 0], grey),
             quad([0, 0, 3], [0, 0, -3], [0, 2.5, 0], red), quad([4, 0, 0], [0, 0, 3], [0, 2.5, 0], blue),
             quad([1.5, 2.49, 1], [1, 0, 0], [0, 0, 1], [0, 0, 0], 120)]
    x, z, high = (1.4, 2.2), (0.7, 1.5), 1.0
    block = [quad([x[0], high, z[1]], [x[1] - x[0], 0, 0], [0, 0, z[0] - z[1]], grey),
             quad([x[0], 0, z[1]], [x[1] - x[0], 0, 0], [0, high, 0], grey),
             quad([x[1], 0, z[0]], [x[0] - x[1], 0, 0], [0, high, 0], grey),
             quad([x[0], 0, z[0]], [0, 0, z[1] - z[0]], [0, high, 0], grey),
             quad([x[1], 0, z[1]], [0, 0, z[0] - z[1]], [0, high, 0], grey)]
    return aktina.Scene(walls + block, camera={"position": [2, 1.35, 2.95], "target": [2, 0.95, 0], "vertical_fov": 1.15})


def formfactor(methods):
    scene = box_room()
    quick = {"contour": "contour:tolerance=0.001", "analytic": "analytic:points=2",
             "cubature": "cubature:tolerance=0.001",
             "hemicube": "hemicube:resolution=64,hemicubes=1", "monte_carlo": "monte_carlo:samples=4096", "hemisphere": "hemisphere:points=4",
             "single_plane": "single_plane:points=1", "cubic_tetrahedron": "cubic_tetrahedron:points=4"}
    for method in methods:
        solution = scene.radiosity(solver="progressive", formfactor=quick.get(method, method), patch_size=0.7, tolerance=0.02,
                                   indirect_size=0)
        write("formfactor", method, solution.render(WIDTH, HEIGHT, samples=16), 0.03)


def radiosity(methods):
    scene = box_room()
    for method in methods:
        elements = {"mesher": "quadtree", "indirect_size": 0} if method == "substructured" else {}
        solution = scene.radiosity(solver=method, patch_size=0.25, tolerance=1e-3, **elements)
        write("radiosity", method, solution.render(WIDTH, HEIGHT, samples=16), 0.03)


def mesher(methods):
    """The light, and over it the edges of the patches that it was computed on."""
    scene = box_room()
    for method in methods:
        solution = scene.radiosity(mesher=method, patch_size=0.25)
        write("mesher", method, patch_edges(scene, solution, 2 * WIDTH, 2 * HEIGHT), 0.03)


def patch_edges(scene, solution, width, height):
    """Edges lie where pixels next to each other show different patches, each in a colour of its own."""
    colours = np.random.default_rng(1).uniform(0, 1, (len(solution.patches), 3))
    patches = [{"vertices": solution.vertices[patch], "triangles": QUAD if patch[2] != patch[3] else [[0, 1, 2]],
                "material": {"base_colour": colour, "unlit": True}}
               for patch, colour in zip(solution.patches, colours)]
    shown = aktina.Scene(patches, camera=scene.cameras[0]).render("raster", width, height, samples=1)
    edge = np.zeros((height, width, 1), bool)
    edge[:, 1:, 0] |= (abs(shown[:, 1:] - shown[:, :-1]) > 1e-4).any(axis=-1)
    edge[1:, :, 0] |= (abs(shown[1:] - shown[:-1]) > 1e-4).any(axis=-1)
    picture = solution.render(width, height, samples=1)
    return np.where(edge, 0.45 * picture, picture)


def specular(methods):
    scene = aktina.load(ROOT / "scenes/room.glb")
    for method in methods:
        picture = scene.render(method, 300, 200, samples=16, radiosity={"patch_size": 0.25, "tolerance": 0.01})
        write("specular", method, picture, 0.006)


def main():
    for family in {method["family"]: None for method in aktina.methods()}:
        if family == "accelerator" or (len(sys.argv) > 2 and family not in sys.argv[2:]):
            continue
        globals()[family]([method["id"] for method in aktina.methods(family)])


if __name__ == "__main__":
    main()
