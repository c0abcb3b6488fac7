# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""The mean of pinhole pictures of the unpatched program, its only way to tilt the plane of sharp focus."""

import concurrent.futures
import dataclasses
import math
import os
import shutil

from benchmarks.lab import ACCUMULATE, TILT_LENS, Failed, cpu_of_rays, digest, run_measured

PROCESSES = os.cpu_count() or 1  # more would take the caches from each other


# a PNG would clip lights before they are averaged
def frames(lab, shot, first, last, count, folder):
    """CPU seconds of the rays alone, and of the process."""
    command = shot.command(
        lab.stock, folder / "f.exr", *lab.gathered_light(shot), "+FE", "+KFI1", f"+KFF{count}", f"+SF{first}", f"+EF{last}"
    )
    messages, cpu, _ = run_measured(command, folder)
    traced = cpu_of_rays(messages)
    if len(traced) != last - first + 1:
        raise Failed(f"{shot}: {len(traced)} trace times for frames {first} to {last}")
    return sum(traced), cpu


def cpu_of_frames(lab, shot, count, folder):
    step = math.ceil(count / PROCESSES)
    with concurrent.futures.ThreadPoolExecutor(PROCESSES) as pool:
        parts = [pool.submit(frames, lab, shot, first, min(count, first + step - 1), count, folder) for first in range(1, count + 1, step)]
        return [sum(sums) for sums in zip(*(part.result() for part in parts))]


def frames_of(lab, scene, tilted):
    return min(scene.quick_frames, scene.frames) if lab.quick else scene.frames if tilted else scene.frames // 4


def measure(lab, scene, tilted):
    count = frames_of(lab, scene, tilted)
    shot = scene.shot(ACCUMULATE, tilted)
    reference = lab.reference(dataclasses.replace(shot, form=TILT_LENS), *scene.reference)
    key = digest("accumulation of OpenEXR", lab.hashes[lab.stock], shot.settings(), shot.sources(), reference.name, count)
    record = lab.runs.get((key, 0))
    if record is None:
        lab.say(f"  accumulation buffer of {count} frames")
        folder = lab.work / "frames" / key
        shutil.rmtree(folder, ignore_errors=True)
        folder.mkdir(parents=True)
        rays, cpu = cpu_of_frames(lab, shot, count, folder)
        pictures = sorted(folder.glob("f*.exr"))
        counts = [2**k for k in range(3, count.bit_length())]
        lines = lab.tool("noise", "prefixes", reference, *pictures, "--counts", ",".join(map(str, counts)))
        shutil.rmtree(folder)
        record = {
            "key": key,
            "repetition": 0,
            "rays": rays,
            "cpu": cpu,
            "frames": count,
            "errors": [[line["count"], line["mse"]] for line in lines],
        }
        lab.keep(record)
    seconds, whole = record["rays"] / count, record["cpu"] / count
    return [
        {
            "program": "accumulation",
            "scene": scene.name,
            "tilted": tilted,
            "setting": str(used),
            "cpu": used * seconds,
            "start_up": used * (whole - seconds),
            "mse": mse,
            "rmse": math.sqrt(mse),
        }
        for used, mse in record["errors"]
    ]
