"""Renders a scene by Cycles. Blender runs it: blender -b --factory-startup -noaudio -P cycles.py -- SCENE.json

SCENE.json: {"camera": {"fov": rad, "to_world": 16 numbers by columns}, "bounces": n,
             "meshes": [{"albedo": [r, g, b], "radiance": x, "positions": [[x, y, z]...], "triangles": [[i, j, k]...]}],
             "pictures": [{"size": px, "samples": n, "threads": n, "file": "x.exr"}]}
Prints `cycles SECONDS` for each picture: the whole call, with Cycles' own set-up of the scene in it.
"""
import json
import sys
import time

import bpy
import mathutils


def material_of(mesh):
    """Matt, or one that shines from its front as Aktina's lamps do."""
    material = bpy.data.materials.new("surface")
    material.use_nodes = True
    nodes, links = material.node_tree.nodes, material.node_tree.links
    nodes.clear()
    output = nodes.new("ShaderNodeOutputMaterial")
    if mesh["radiance"] > 0:
        shader, front, back = (nodes.new(f"ShaderNode{kind}") for kind in ("Emission", "Math", "NewGeometry"))
        front.operation = "MULTIPLY_ADD"
        links.new(back.outputs["Backfacing"], front.inputs[0])
        front.inputs[1].default_value, front.inputs[2].default_value = -mesh["radiance"], mesh["radiance"]
        links.new(front.outputs[0], shader.inputs["Strength"])
    else:
        shader = nodes.new("ShaderNodeBsdfDiffuse")
        shader.inputs["Color"].default_value = (*mesh["albedo"], 1)
    links.new(shader.outputs[0], output.inputs["Surface"])
    return material


def build(scene, description):
    for thing in list(bpy.data.objects):
        bpy.data.objects.remove(thing)
    scene.world.use_nodes = False
    scene.world.color = (0, 0, 0)
    for mesh in description["meshes"]:
        data = bpy.data.meshes.new("mesh")
        data.from_pydata(mesh["positions"], [], mesh["triangles"])
        data.materials.append(material_of(mesh))
        scene.collection.objects.link(bpy.data.objects.new("mesh", data))
    camera = bpy.data.objects.new("camera", bpy.data.cameras.new("camera"))
    camera.data.angle = description["camera"]["fov"]
    m = description["camera"]["to_world"]
    camera.matrix_world = mathutils.Matrix([m[row::4] for row in range(4)])
    camera.data.clip_start = 1e-3
    scene.collection.objects.link(camera)
    scene.camera = camera


def settings(scene, bounces):
    scene.render.engine = "CYCLES"
    scene.render.image_settings.file_format = "OPEN_EXR"
    scene.render.image_settings.color_depth = "32"
    scene.render.image_settings.color_mode = "RGB"
    cycles = scene.cycles
    cycles.device = "CPU"
    cycles.use_adaptive_sampling = cycles.use_denoising = False
    cycles.max_bounces = cycles.diffuse_bounces = bounces
    cycles.sample_clamp_indirect = 0
    cycles.pixel_filter_type = "BOX"
    cycles.filter_width = 1
    scene.render.threads_mode = "FIXED"


def main():
    with open(sys.argv[sys.argv.index("--") + 1], encoding="utf-8") as file:
        description = json.load(file)
    scene = bpy.context.scene
    settings(scene, description["bounces"])
    build(scene, description)
    for picture in description["pictures"]:
        scene.render.resolution_x = scene.render.resolution_y = picture["size"]
        scene.render.resolution_percentage = 100
        scene.render.threads = picture["threads"]
        scene.cycles.samples = picture["samples"]
        scene.render.filepath = picture["file"]
        begin = time.perf_counter()
        bpy.ops.render.render(write_still=True)
        print(f"cycles {time.perf_counter() - begin}", flush=True)


main()
