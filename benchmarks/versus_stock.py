# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Against stock focal blur, untilted: CPU seconds at equal error."""

import collections
import dataclasses
import math
import statistics

from benchmarks import suite
from benchmarks.front import seconds_for
from benchmarks.lab import GREATEST_NOISE, STOCK, TILT_LENS


SECONDS_OF_SETTING, MOST_REPETITIONS = 4.0, 7


def repetitions(first):
    """Some seconds in all: short runs differ by up to a half on shared machines."""
    return min(MOST_REPETITIONS, max(1, int(SECONDS_OF_SETTING / first["cpu"])))


def start_up(lab, program, scene, shot):
    return 0.0 if scene.part else lab.start_up(program, shot)


def with_fine_reference(lab, scene):
    """The scene with as many samples for its references as the errors compared at need."""
    batches, samples = scene.reference
    reference = lab.reference(scene.shot(TILT_LENS), batches, samples)
    errors = [lab.run(lab.stock, shot, reference) for name, shot in suite.stock_shots(scene, lab.quick) if name.isdigit()]
    finer = max(error["reference_mse"] / (GREATEST_NOISE * max(1e-12, error["mse"])) for error in errors)
    return dataclasses.replace(scene, reference=(batches, samples * max(1, math.ceil(finer))))


def first_runs(lab, scene, reference):
    stock = collections.deque(suite.stock_shots(scene, lab.quick))
    chains = [collections.deque(chain) for chain in suite.ours_chains(scene, 0, lab.quick)]
    done, errors = [], {}

    def run(program, binary, name, shot):
        record = lab.run(binary, shot, reference, program=program, setting=name, scene=scene.name)
        done.append((binary, shot, record))
        return record

    while stock or chains:
        if stock:
            name, shot = stock.popleft()
            errors[name] = run("stock", lab.stock, name, shot)["mse"]
        compared_at = [errors[str(target)] for target in scene.targets if str(target) in errors]
        to_come = any(name.isdigit() for name, _ in stock)
        for chain in list(chains):
            name, shot = chain.popleft()
            mse = run("tilt_lens", lab.ours, name, shot)["mse"]
            if not chain or (not to_come and mse < min(compared_at)):
                chains.remove(chain)
    return done


def measure(lab, scene):
    lab.say(f"{scene.name}: stock focal blur and tilt_lens")
    reference = lab.reference(scene.shot(TILT_LENS), *scene.reference)
    done = first_runs(lab, scene, reference)
    start = {lab.stock: start_up(lab, lab.stock, scene, scene.shot(STOCK)), lab.ours: start_up(lab, lab.ours, scene, scene.shot(TILT_LENS))}
    times = collections.defaultdict(list)
    for repetition in range(MOST_REPETITIONS):
        for program, shot, record in done:
            if repetition < repetitions(record):
                again = lab.run(program, shot, reference, repetition=repetition)
                times[record["key"]].append(scene.seconds(again))
    return [
        {
            **record,
            "tilted": 0,
            "cpu": statistics.median(times[record["key"]]),
            "runs": len(times[record["key"]]),
            "start_up": start[program],
            "rmse": math.sqrt(record["mse"]),
        }
        for program, _, record in done
    ]


def compare(scene, records):
    fronts = {
        program: [(record["cpu"], record["rmse"]) for record in records if record["program"] == program]
        for program in ("stock", "tilt_lens")
    }
    lines = []
    for target in scene.targets:
        found = [record for record in records if record["setting"] == str(target)]
        if found:
            error = found[0]["rmse"]
            stock, ours = (seconds_for(fronts[program], error) for program in ("stock", "tilt_lens"))
            lines.append(
                {
                    "target": target,
                    "rmse": error,
                    "noise": found[0]["reference_mse"] / found[0]["mse"],
                    "stock": stock,
                    "tilt_lens": ours,
                    "ratio": stock / ours if ours else None,
                }
            )
    return lines
