# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Parts `display` and `lamps`: against stock focal blur, and tilted against the accumulation buffer."""

from benchmarks import accumulation, gallery, suite, tables, tilted, versus_stock


def compare(lab, scenes):
    found, runs = {"untilted": {}, "tilted": {}}, []
    for scene in (versus_stock.with_fine_reference(lab, scene) for scene in scenes):
        untilted = versus_stock.measure(lab, scene)
        lines = versus_stock.compare(scene, untilted)
        for line in lines:
            lab.say(f"  as stock with {line['target']}: {tables.ratio_cell(line)}")
        # with fewer frames, the accumulation buffer is far from the error
        errors = {line["target"]: line["rmse"] for line in lines if line["target"] <= 2 * accumulation.frames_of(lab, scene, 1)}
        leaning = tilted.measure(lab, scene, errors)
        found["untilted"][scene.name], found["tilted"][scene.name] = lines, tilted.compare(leaning, errors)
        runs += [*untilted, *leaning]
    return found, runs


def display(lab, names):
    scenes = [suite.of_gallery(name, gallery.copy(lab, name)) for name in names]
    found, runs = compare(lab, scenes)
    return {"part": [*scenes[0].size, scenes[0].part.columns, scenes[0].part.rows], **found}, runs
