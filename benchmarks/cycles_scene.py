# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Runs within Blender: builds the emissive checks and renders them with Cycles. Each render prints a line `Cycles: ` with JSON.

Exchanging y and z turns POV-Ray's left-handed axes into Blender's."""

import json
import math
import pathlib
import resource
import sys

try:
    import bpy
    import mathutils
except ImportError:  # outside of Blender it can only be read
    bpy = mathutils = None

# edges within 2e-4 of the radius
SUBDIVISIONS = 6


def exchanged(vector):
    return (vector[0], vector[2], vector[1])


def emitting(name, colour):
    material = bpy.data.materials.new(name)
    material.use_nodes = True
    nodes, links = material.node_tree.nodes, material.node_tree.links
    nodes.clear()
    emission, output = nodes.new("ShaderNodeEmission"), nodes.new("ShaderNodeOutputMaterial")
    links.new(emission.outputs[0], output.inputs["Surface"])
    links.new(colour(nodes, links), emission.inputs["Color"])
    return material


def checkered(nodes, links):
    """1 and 0.1 in squares of 0.5; the third coordinate keeps off the pattern's edges."""
    place, checker = nodes.new("ShaderNodeNewGeometry"), nodes.new("ShaderNodeTexChecker")
    lifted = nodes.new("ShaderNodeVectorMath")
    lifted.inputs[1].default_value = (0, 0, 0.25)
    links.new(place.outputs["Position"], lifted.inputs[0])
    links.new(lifted.outputs[0], checker.inputs["Vector"])
    checker.inputs["Scale"].default_value = 2
    for number, grey in ((1, 0.1), (2, 1.0)):
        checker.inputs[f"Color{number}"].default_value = (grey, grey, grey, 1)
    return checker.outputs["Color"]


def colour_of_object(nodes, links):
    return nodes.new("ShaderNodeObjectInfo").outputs["Color"]


def build(scene, told):
    for thing in list(bpy.data.objects):
        bpy.data.objects.remove(thing)
    bpy.ops.mesh.primitive_plane_add(size=20000)
    bpy.context.object.data.materials.append(emitting("checks", checkered))
    bpy.ops.mesh.primitive_ico_sphere_add(subdivisions=SUBDIVISIONS, radius=0.3)
    first = bpy.context.object
    first.data.materials.append(emitting("spheres", colour_of_object))
    for number, (*centre, red, green, blue) in enumerate(told["spheres"]):
        sphere = first if number == 0 else first.copy()  # they share one mesh
        sphere.location, sphere.color = exchanged(centre), (red, green, blue, 1)
        if number:
            scene.collection.objects.link(sphere)
    scene.world.use_nodes = True
    scene.world.node_tree.nodes["Background"].inputs["Color"].default_value = (0.3, 0.5, 0.9, 1)
    place_camera(scene, told)


def place_camera(scene, told):
    camera = bpy.data.cameras.new("camera")
    camera.sensor_fit, camera.sensor_width = "HORIZONTAL", 36
    camera.angle = math.radians(told["angle"])
    camera.clip_end = 1e6
    camera.dof.use_dof, camera.dof.focus_distance = True, told["focus"]
    camera.dof.aperture_fstop = camera.lens * 1e-3 / (2 * told["radius"])
    holder = bpy.data.objects.new("camera", camera)
    holder.location = exchanged(told["eye"])
    holder.rotation_euler = mathutils.Vector(exchanged(told["axis"])).to_track_quat("-Z", "Y").to_euler()
    scene.collection.objects.link(holder)
    scene.camera = holder


def adjust(scene, size):
    scene.render.engine = "CYCLES"
    scene.render.resolution_x, scene.render.resolution_y, scene.render.resolution_percentage = *size, 100
    scene.render.threads_mode, scene.render.threads = "FIXED", 1
    scene.render.image_settings.file_format, scene.render.image_settings.color_depth = "OPEN_EXR", "32"
    scene.cycles.device, scene.cycles.use_denoising, scene.cycles.max_bounces = "CPU", False, 0
    scene.cycles.pixel_filter_type = "BOX"  # the mean over a pixel's square, as in POV-Ray
    scene.cycles.filter_width = 1.0
    scene.cycles.sample_clamp_direct = scene.cycles.sample_clamp_indirect = 0.0


def render(scene, setting, picture):
    _, scene.cycles.samples, threshold, scene.cycles.adaptive_min_samples = setting
    scene.cycles.use_adaptive_sampling = threshold > 0
    if threshold > 0:
        scene.cycles.adaptive_threshold = threshold
    scene.render.filepath = str(picture)
    before = resource.getrusage(resource.RUSAGE_SELF)
    bpy.ops.render.render(write_still=True)
    after = resource.getrusage(resource.RUSAGE_SELF)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def main():
    told = json.loads(pathlib.Path(sys.argv[-1]).read_text())
    scene, folder = bpy.context.scene, pathlib.Path(sys.argv[-1]).parent
    adjust(scene, told["size"])
    build(scene, told)
    for _ in range(told["repetitions"]):
        for number, setting in enumerate(told["settings"]):
            seconds = render(scene, setting, folder / f"{number}.exr")
            print("\nCycles: " + json.dumps({"setting": setting[0], "cpu": seconds}), flush=True)


if __name__ == "__main__":
    main()
