#!/usr/bin/env python3
"""Writes Aktina's own scenes, room.glb and cornell.glb, beside this file. Standard library only; same bytes every time.

room      a furnished room, lit by a ceiling panel and a reading lamp; wood, mirror, chrome, glass and cloth
cornell   the box of Goral, Torrance, Greenberg and Battaile (1984) as Cornell University later measured it
"""
import json
import math
import pathlib
import random
import struct
import zlib

FOLDER = pathlib.Path(__file__).resolve().parent


class Mesh:
    """Triangles with normals and texture coordinates; faces counter-clockwise seen from the front."""

    def __init__(self):
        self.positions, self.normals, self.uv, self.indices = [], [], [], []

    def add(self, vertices, triangles):
        """vertices: (position, normal, uv)"""
        first = len(self.positions)
        for position, normal, uv in vertices:
            self.positions.append(position)
            self.normals.append(normal)
            self.uv.append(uv)
        self.indices += [first + corner for triangle in triangles for corner in triangle]
        return self

    def quad(self, corner, u, v, scale=1.0):
        """Parallelogram whose front is towards u x v; texture coordinates in metres times `scale`."""
        normal = unit(cross(u, v))
        points = [corner, plus(corner, u), plus(plus(corner, u), v), plus(corner, v)]
        width, height = length(u) * scale, length(v) * scale
        uv = [(0, height), (width, height), (width, 0), (0, 0)]
        return self.add([(p, normal, t) for p, t in zip(points, uv)], [(0, 1, 2), (0, 2, 3)])

    def box(self, low, high, turn=0.0, scale=1.0):
        """Box about a vertical axis turned by `turn` radians."""
        centre = [(a + b) / 2 for a, b in zip(low, high)]
        size = [b - a for a, b in zip(low, high)]
        x = (math.cos(turn) * size[0], 0, -math.sin(turn) * size[0])
        y = (0, size[1], 0)
        z = (math.sin(turn) * size[2], 0, math.cos(turn) * size[2])
        origin = minus(centre, half(plus(plus(x, y), z)))
        far = plus(plus(plus(origin, x), y), z)
        self.quad(plus(origin, z), x, y, scale).quad(plus(origin, x), negative(x), y, scale)
        self.quad(far, negative(y), negative(z), scale).quad(origin, z, y, scale)
        self.quad(plus(plus(origin, y), z), x, negative(z), scale)
        return self.quad(origin, x, z, scale)

    def lathe(self, profile, centre, sides=48):
        """Surface of revolution about y: profile is (radius, height) with the outside on its right going up."""
        normals = profile_normals(profile)
        count, vertices, triangles = len(profile), [], []
        for i in range(sides + 1):
            c, s = math.cos(2 * math.pi * i / sides), math.sin(2 * math.pi * i / sides)
            for j, ((radius, height), (nr, ny)) in enumerate(zip(profile, normals)):
                position = (centre[0] + radius * c, centre[1] + height, centre[2] - radius * s)
                vertices.append((position, (nr * c, ny, -nr * s), (2 * i / sides, 1 - j / (count - 1))))
        for i in range(sides):
            for j in range(count - 1):
                a, b = i * count + j, (i + 1) * count + j
                if profile[j][0] > 0:
                    triangles.append((a, b, a + 1))
                if profile[j + 1][0] > 0:
                    triangles.append((b, b + 1, a + 1))
        return self.add(vertices, triangles)

    def ball(self, radius, centre, rings=32):
        angles = [math.pi * (j / rings - 0.5) for j in range(rings + 1)]
        profile = [(0.0 if j in (0, rings) else radius * math.cos(a), radius * math.sin(a)) for j, a in enumerate(angles)]
        return self.lathe(profile, centre, 2 * rings)

    def torus(self, major, minor, centre, rings=48, sides=24):
        vertices, triangles = [], []
        for i in range(rings + 1):
            a = 2 * math.pi * i / rings
            for j in range(sides + 1):
                b = 2 * math.pi * j / sides
                normal = (math.cos(a) * math.cos(b), math.sin(b), -math.sin(a) * math.cos(b))
                ring = (centre[0] + major * math.cos(a), centre[1], centre[2] - major * math.sin(a))
                vertices.append((plus(ring, tuple(minor * n for n in normal)), normal, (4 * i / rings, j / sides)))
        for i in range(rings):
            for j in range(sides):
                a, b = i * (sides + 1) + j, (i + 1) * (sides + 1) + j
                triangles += [(a, b, a + 1), (b, b + 1, a + 1)]
        return self.add(vertices, triangles)


def plus(a, b):
    return tuple(x + y for x, y in zip(a, b))


def minus(a, b):
    return tuple(x - y for x, y in zip(a, b))


def negative(a):
    return tuple(-x for x in a)


def half(a):
    return tuple(x / 2 for x in a)


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def length(a):
    return math.sqrt(sum(x * x for x in a))


def unit(a):
    return tuple(x / length(a) for x in a)


def profile_normals(profile):
    """Outward normals (radial, vertical) of a profile: mean of the two neighbouring segments."""
    normals = []
    for j in range(len(profile)):
        before, after = profile[max(j - 1, 0)], profile[min(j + 1, len(profile) - 1)]
        normals.append(unit((after[1] - before[1], before[0] - after[0])))
    return normals


def smooth(points, steps=6):
    """Catmull-Rom spline through profile points."""
    result = []
    for k in range(len(points) - 1):
        p0, p1, p2, p3 = (points[min(max(k + i, 0), len(points) - 1)] for i in (-1, 0, 1, 2))
        for i in range(steps):
            t = i / steps
            result.append(tuple(
                0.5 * (2 * b + (c - a) * t + (2 * a - 5 * b + 4 * c - d) * t * t + (3 * b - a - 3 * c + d) * t ** 3)
                for a, b, c, d in zip(p0, p1, p2, p3)))
    return [(max(r, 0.0), y) for r, y in result] + [points[-1]]


def png(width, height, pixel):
    """8-bit sRGB PNG; pixel(x, y) -> (r, g, b)"""
    rows = b"".join(b"\0" + bytes(channel for x in range(width) for channel in pixel(x, y)) for y in range(height))

    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    header = struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0)
    return b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", zlib.compress(rows, 9)) + chunk(b"IEND", b"")


def planks(width=256, height=256):
    """Wooden planks, four across, with a faint grain; tiles in both directions."""
    noise = random.Random(7)
    tones = [noise.uniform(0.82, 1.0) for _ in range(8)]
    phases = [[noise.uniform(0, 6.28) for _ in range(3)] for _ in range(8)]

    def pixel(x, y):
        board = x * 4 // width
        part = (y + board * 96) % height * 2 // height
        kind = board * 2 + part
        a, b, c = phases[kind]
        t, s = 2 * math.pi * x / width, 2 * math.pi * y / height
        grain = 0.05 * math.sin(24 * t + 1.5 * math.sin(s + a) + b) + 0.03 * math.sin(57 * t + math.sin(2 * s + c) + a)
        seam = x % (width // 4) < 1 or (y + board * 96) % (height // 2) < 1
        shade = (0.45 if seam else 1) * (tones[kind] + grain)
        return tuple(max(0, min(255, round(255 * shade * k))) for k in (0.72, 0.53, 0.36))

    return png(width, height, pixel)


def weave(width=64, height=64):
    """A rug: two tones in a lattice of diamonds."""

    def pixel(x, y):
        diamond = (abs(x - width / 2) + abs(y - height / 2)) / (width / 2)
        thread = 0.94 + 0.06 * ((x + y) % 2)
        tone = (0.30, 0.36, 0.52) if 0.45 < diamond < 0.75 else (0.80, 0.76, 0.66)
        return tuple(round(255 * thread * k) for k in tone)

    return png(width, height, pixel)


class Scene:
    """A glTF 2.0 scene, written as one .glb."""

    def __init__(self, generator):
        self.json = {"asset": {"version": "2.0", "generator": generator}, "scene": 0, "scenes": [{"nodes": []}],
                     "nodes": [], "meshes": [], "materials": [], "accessors": [], "bufferViews": []}
        self.data = b""

    def view(self, data, target=None):
        self.data += b"\0" * (-len(self.data) % 4)
        view = {"buffer": 0, "byteOffset": len(self.data), "byteLength": len(data)}
        self.json["bufferViews"].append(view | ({"target": target} if target else {}))
        self.data += data
        return len(self.json["bufferViews"]) - 1

    def accessor(self, rows, kind, component, code, target, bounds=False):
        flat = [value for row in rows for value in row]
        accessor = {"bufferView": self.view(struct.pack(f"<{len(flat)}{code}", *flat), target),
                    "componentType": component, "count": len(rows), "type": kind}
        if bounds:
            single = [[struct.unpack("<f", struct.pack("<f", value))[0] for value in row] for row in rows]
            accessor |= {"min": [min(column) for column in zip(*single)], "max": [max(column) for column in zip(*single)]}
        self.json["accessors"].append(accessor)
        return len(self.json["accessors"]) - 1

    def texture(self, name, data):
        self.json.setdefault("images", []).append({"name": name, "mimeType": "image/png", "bufferView": self.view(data)})
        self.json.setdefault("textures", []).append({"source": len(self.json["images"]) - 1})
        return {"index": len(self.json["textures"]) - 1}

    def material(self, name, colour=(1, 1, 1), metallic=0, roughness=1, texture=None, **more):
        pbr = {"baseColorFactor": [*colour, 1], "metallicFactor": metallic, "roughnessFactor": roughness}
        if texture:
            pbr["baseColorTexture"] = texture
        self.json["materials"].append({"name": name, "pbrMetallicRoughness": pbr} | more)
        for extension in more.get("extensions", {}):
            self.use(extension)
        return len(self.json["materials"]) - 1

    def use(self, extension):
        used = self.json.setdefault("extensionsUsed", [])
        if extension not in used:
            used.append(extension)

    def mesh(self, name, mesh, material):
        attributes = {"POSITION": self.accessor(mesh.positions, "VEC3", 5126, "f", 34962, bounds=True),
                      "NORMAL": self.accessor(mesh.normals, "VEC3", 5126, "f", 34962),
                      "TEXCOORD_0": self.accessor(mesh.uv, "VEC2", 5126, "f", 34962)}
        indices = self.accessor([(i,) for i in mesh.indices], "SCALAR", 5123, "H", 34963)
        primitive = {"attributes": attributes, "indices": indices, "material": material}
        self.json["meshes"].append({"name": name, "primitives": [primitive]})
        self.node({"name": name, "mesh": len(self.json["meshes"]) - 1})

    def node(self, node):
        self.json["nodes"].append(node)
        self.json["scenes"][0]["nodes"].append(len(self.json["nodes"]) - 1)

    def camera(self, name, eye, target, vertical_fov, aspect):
        perspective = {"yfov": vertical_fov, "aspectRatio": aspect, "znear": 0.05}
        self.json.setdefault("cameras", []).append({"name": name, "type": "perspective", "perspective": perspective})
        self.node({"name": name, "camera": len(self.json["cameras"]) - 1, "matrix": look_at(eye, target)})

    def spot(self, name, position, target, candela, inner, outer, colour=(1, 1, 1)):
        self.use("KHR_lights_punctual")
        lights = self.json.setdefault("extensions", {}).setdefault("KHR_lights_punctual", {"lights": []})["lights"]
        lights.append({"name": name, "type": "spot", "color": list(colour), "intensity": candela,
                       "spot": {"innerConeAngle": inner, "outerConeAngle": outer}})
        self.node({"name": name, "matrix": look_at(position, target),
                   "extensions": {"KHR_lights_punctual": {"light": len(lights) - 1}}})

    def write(self, path):
        self.json["buffers"] = [{"byteLength": len(self.data)}]
        text = json.dumps(self.json, separators=(",", ":")).encode()
        text += b" " * (-len(text) % 4)
        data = self.data + b"\0" * (-len(self.data) % 4)
        chunks = struct.pack("<II", len(text), 0x4E4F534A) + text + struct.pack("<II", len(data), 0x004E4942) + data
        path.write_bytes(struct.pack("<III", 0x46546C67, 2, 12 + len(chunks)) + chunks)


def look_at(eye, target):
    """Column-major matrix of a camera or spot that looks along -z, +y up."""
    back = unit(minus(eye, target))
    right = unit(cross((0, 1, 0) if abs(back[1]) < 0.999 else (0, 0, 1), back))
    up = cross(back, right)
    return [*right, 0, *up, 0, *back, 0, *eye, 1]


def lamp(luminance):
    """Material of a lamp: luminance in cd/m^2, black itself."""
    return {"emissiveFactor": [1, 1, 1], "extensions": {"KHR_materials_emissive_strength": {"emissiveStrength": luminance}}}


def room():
    scene = Scene("Aktina scenes/generate.py")
    wood = scene.texture("planks", planks())
    white = scene.material("white plaster", (0.78, 0.76, 0.72))
    terracotta = scene.material("terracotta plaster", (0.60, 0.24, 0.16))
    sage = scene.material("sage plaster", (0.36, 0.47, 0.36))
    floor = scene.material("oak floor", roughness=0.6, texture=wood)
    oak = scene.material("oak", (0.9, 0.85, 0.8), roughness=0.5, texture=wood)
    cloth = scene.material("blue cloth", (0.13, 0.22, 0.40))
    cushion = scene.material("ochre cloth", (0.66, 0.43, 0.10))
    rug = scene.material("rug", texture=scene.texture("weave", weave()))
    glaze = scene.material("glazed clay", (0.10, 0.36, 0.42), roughness=0.25)
    chrome = scene.material("chrome", (0.95, 0.95, 0.95), metallic=1, roughness=0)
    mirror = scene.material("mirror", (0.92, 0.93, 0.93), metallic=1, roughness=0)
    brass = scene.material("brass", (0.78, 0.57, 0.25), metallic=1, roughness=0.3)
    glass = scene.material("glass", (0.97, 0.99, 0.98), roughness=0,
                           extensions={"KHR_materials_transmission": {"transmissionFactor": 1}, "KHR_materials_ior": {"ior": 1.5}})
    panel = scene.material("ceiling panel", (0, 0, 0), **lamp(1800))

    # The room: x from -2.2 to 2.2 m, y up to 2.7 m, z from -2.5 to 2.8 m.
    x, y, back, front = 2.2, 2.7, -2.5, 2.8
    depth = front - back
    scene.mesh("floor", Mesh().quad((-x, 0, front), (2 * x, 0, 0), (0, 0, -depth)), floor)
    scene.mesh("ceiling", Mesh().quad((-x, y, back), (2 * x, 0, 0), (0, 0, depth)), white)
    scene.mesh("back wall", Mesh().quad((-x, 0, back), (2 * x, 0, 0), (0, y, 0)), white)
    scene.mesh("front wall", Mesh().quad((x, 0, front), (-2 * x, 0, 0), (0, y, 0)), white)
    scene.mesh("left wall", Mesh().quad((-x, 0, front), (0, 0, -depth), (0, y, 0)), terracotta)
    scene.mesh("right wall", Mesh().quad((x, 0, back), (0, 0, depth), (0, y, 0)), sage)
    scene.mesh("ceiling panel", Mesh().quad((-0.6, y - 0.02, -0.6), (1.2, 0, 0), (0, 0, 0.7)), panel)
    scene.mesh("rug", Mesh().box((-1.1, 0, -0.9), (1.2, 0.012, 0.7), 0.0, 2.0), rug)

    # A table with a vase, a glass ball, a chrome ball and a ring.
    table = Mesh().box((-0.55, 0.43, -0.55), (0.65, 0.47, 0.25))
    for leg in ((-0.5, -0.5), (0.56, -0.5), (-0.5, 0.16), (0.56, 0.16)):
        table.box((leg[0], 0.012, leg[1]), (leg[0] + 0.05, 0.43, leg[1] + 0.05))
    scene.mesh("table", table, oak)
    vase = smooth([(0.0, 0.0), (0.07, 0.0), (0.10, 0.05), (0.125, 0.14), (0.09, 0.25), (0.045, 0.32), (0.045, 0.36), (0.07, 0.40)])
    inside = [(0.06, 0.40), (0.037, 0.36), (0.037, 0.32), (0.03, 0.30), (0.0, 0.30)]
    scene.mesh("vase", Mesh().lathe(vase + inside, (-0.28, 0.47, -0.25)), glaze)
    scene.mesh("glass ball", Mesh().ball(0.12, (0.10, 0.59, 0.02)), glass)
    scene.mesh("chrome ball", Mesh().ball(0.10, (0.40, 0.57, -0.22)), chrome)
    scene.mesh("ring", Mesh().torus(0.075, 0.025, (-0.20, 0.495, 0.10)), brass)

    # A bench along the left wall, a shelf with books at the back, a mirror on the right wall.
    bench = Mesh().box((-2.1, 0.06, -1.5), (-1.35, 0.38, 0.6)).box((-2.19, 0.06, -1.5), (-2.02, 0.78, 0.6))
    scene.mesh("bench", bench, cloth)
    scene.mesh("cushions", Mesh().box((-1.96, 0.38, -1.35), (-1.80, 0.72, -0.95), 0.25).box((-1.96, 0.38, 0.1), (-1.80, 0.70, 0.46), -0.2), cushion)
    shelf = Mesh().box((0.55, 0.0, -2.48), (0.59, 1.5, -2.18)).box((1.81, 0.0, -2.48), (1.85, 1.5, -2.18))
    for height in (0.10, 0.55, 1.0, 1.46):
        shelf.box((0.59, height, -2.48), (1.81, height + 0.04, -2.18))
    scene.mesh("shelf", shelf, oak)
    books = random.Random(3)
    covers = [scene.material(f"book cover {i}", colour) for i, colour in
              enumerate([(0.45, 0.08, 0.07), (0.08, 0.20, 0.30), (0.50, 0.42, 0.25), (0.10, 0.25, 0.14)])]
    stacks = [Mesh() for _ in covers]
    for height in (0.14, 0.59, 1.04):
        place = 0.60
        while place < 1.70:
            width, tall = books.uniform(0.02, 0.05), books.uniform(0.24, 0.36)
            if books.random() < 0.88:
                books.choice(stacks).box((place, height, -2.46), (place + width, height + tall, -2.46 + books.uniform(0.16, 0.22)))
            place += width + 0.003
    for i, stack in enumerate(stacks):
        scene.mesh(f"books {i}", stack, covers[i])
    scene.mesh("mirror frame", Mesh().box((2.17, 0.75, -1.65), (2.195, 2.05, -0.55)), oak)
    scene.mesh("mirror", Mesh().quad((2.168, 0.81, -1.59), (0, 0, 0.98), (0, 1.18, 0)), mirror)

    # A reading lamp by the bench: a spot within an open shade.
    scene.mesh("lamp stand", Mesh().lathe(smooth([(0.0, 0.03), (0.15, 0.03), (0.15, 0.02), (0.15, 0.0)][::-1], 2) + [(0.012, 0.04), (0.012, 1.45)], (-1.75, 0, 0.95), 32), brass)
    shade = scene.material("lamp shade", (0.75, 0.68, 0.55), doubleSided=True)
    scene.mesh("lamp shade", Mesh().lathe([(0.19, 1.33), (0.10, 1.62)], (-1.75, 0, 0.95), 40), shade)
    scene.spot("reading lamp", (-1.75, 1.5, 0.95), (-1.70, 0, 0.93), 220, 0.3, 0.85, (1.0, 0.83, 0.62))
    scene.camera("view", (1.45, 1.45, 2.6), (-0.25, 0.78, -0.7), 0.83, 1.5)
    scene.write(FOLDER / "room.glb")


def cornell():
    """Dimensions and colours: Cornell University Program of Computer Graphics, "The Cornell Box", in metres here."""
    scene = Scene("Aktina scenes/generate.py")
    white = scene.material("white", (0.73, 0.73, 0.73))
    red = scene.material("red", (0.61, 0.06, 0.06))
    green = scene.material("green", (0.12, 0.45, 0.15))
    light = scene.material("light", (0, 0, 0), **lamp(3000))
    size, high, deep = 0.556, 0.5488, 0.5592
    scene.mesh("floor", Mesh().quad((0, 0, 0), (size, 0, 0), (0, 0, -deep)), white)
    scene.mesh("ceiling", Mesh().quad((0, high, -deep), (size, 0, 0), (0, 0, deep)), white)
    scene.mesh("back wall", Mesh().quad((0, 0, -deep), (size, 0, 0), (0, high, 0)), white)
    scene.mesh("left wall", Mesh().quad((0, 0, 0), (0, 0, -deep), (0, high, 0)), red)
    scene.mesh("right wall", Mesh().quad((size, 0, -deep), (0, 0, deep), (0, high, 0)), green)
    scene.mesh("short block", Mesh().box((0.2885, 0, -0.2505), (0.4535, 0.165, -0.0855), -0.2934), white)
    scene.mesh("tall block", Mesh().box((0.1055, 0, -0.4340), (0.2705, 0.330, -0.2690), 0.2956), white)
    scene.mesh("light", Mesh().quad((0.213, high - 0.0005, -0.332), (0.130, 0, 0), (0, 0, 0.105)), light)
    scene.camera("view", (0.278, 0.273, 0.800), (0.278, 0.273, -0.2795), 0.6860, 1)
    scene.write(FOLDER / "cornell.glb")


if __name__ == "__main__":
    room()
    cornell()
