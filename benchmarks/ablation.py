# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""The worth of each rule of the sampler: the work, in samples a pixel, for the same error without it.

The first samples of every pixel are recorded once for a scene, since a sample depends on its pixel and its number alone. Only rules of
the emitter sampling change samples. The error is that against the mean of all recorded samples, of which a pixel gets at most a quarter."""

import dataclasses
import json
import math
import re
import subprocess
import tempfile

from benchmarks.front import geometric_mean
from benchmarks.lab import SCENES, TILT_LENS, Failed, digest
from tools import povray_run
from tools.repository import BUILD, ROOT

GALLERY = ROOT / "scenes" / "gallery"
OF_BENCHMARK = ("checks", "foliage", "town", "glass", "lights", "shadows", "landscape")  # radiosity is no function of the pixel
OF_GALLERY = tuple(path.stem for path in sorted(GALLERY.glob("*.pov")))
WITH_LAMPS = ("lights", "city_lights")
VARIANCES, VARIANCES_OF_PARTS = (4e-3, 1e-3, 2.5e-4), (1e-3, 2e-4, 4e-5)
# parts of large pictures have more even and more smoothly blurred surfaces
LARGE, PART = (1280, 720), (64, 48)
CORNERS = ((608, 336), (304, 504))
LEAST_KEPT = 1e-3  # the recorded samples suffice for this variance
TOO_FEW_SAMPLES = ("chess_at_night",)
NEVER, ALWAYS = "1e30", "0"

# rule, section of docs/sampling.md, settings without it
RULES = (
    ("rounds that end half-way between powers of two", 1, "halfRounds=0"),
    ("prior of the variance ratio", 3, f"varianceRatioPrior={ALWAYS}"),
    ("targets by deviation", 3, "deviationShare=0"),
    ("search for hidden emitters", 4, "hiddenEmitterSamples=0"),
    ("greatest and least risk", 5, f"greatestRisk={NEVER}"),
    ("near risk in full", 5, f"chanceRisk={NEVER}"),
    ("chance in the near risk", 5, f"chanceRisk={ALWAYS}"),
    ("samples that serve other pixels", 5, "spreadWeight=0"),
    ("more than four samples of a pixel that serve others", 5, "mostSentSamples=4"),
    ("preference of the spread estimate", 5, "spreadWeight=1"),
    ("the same where pixels missed something", 5, "missedWeight=0"),
    ("forecast of the reconstruction", 6, "forecasts=0"),
)
EMITTER_RULES = (
    ("choice of the film point", 4, f"lensPointBlur={ALWAYS}"),
    ("half of the samples at emitters, not a quarter", 4, "emitterShare=0.25"),
    ("several emitters of a pixel", 4, "emittersOfPixel=1"),
    ("emitter sampling", 4, "emittersOfPixel=0"),
)


@dataclasses.dataclass(frozen=True)
class Picture:
    scene: str
    size: tuple
    samples: int
    corner: tuple = None  # of a part of a large picture

    @property
    def name(self):
        return self.scene if self.corner is None else f"{self.scene}, part"

    def options(self):
        return [] if self.corner is None else povray_run.part(*self.corner, *self.size)

    @property
    def variances(self):
        return VARIANCES if self.corner is None else VARIANCES_OF_PARTS


def pictures(quick):
    size, samples = ((64, 48), 256) if quick else ((96, 64), 1024)
    scenes = OF_BENCHMARK + OF_GALLERY
    whole = [Picture(scene, size, samples) for scene in scenes]
    corners = CORNERS[:1] if quick else CORNERS
    return whole + [Picture(scene, PART, samples, corner) for corner in corners for scene in scenes]


def build_tools(lab):
    lab.say("Building the sampler with variable numbers")
    done = subprocess.run(["ninja", "-C", BUILD, "ablation_tools"], capture_output=True, text=True, check=False)
    if done.returncode != 0:
        raise Failed(f"the build of the ablation's tools failed:\n{done.stdout[-3000:]}")


def recording(lab, picture, settings=""):
    folder = SCENES if picture.scene in OF_BENCHMARK else GALLERY
    scene, program = folder / f"{picture.scene}.pov", lab.tools / "record_samples"
    key = digest(lab.hash_of(program), dataclasses.astuple(picture), scene.read_bytes(), settings)
    path = lab.work / "recordings" / f"{picture.scene}-{key}.samples"
    if path.is_file():
        return path
    lab.say(f"  samples of {picture.name} {settings}")
    path.parent.mkdir(parents=True, exist_ok=True)
    declared = [f"Declare=Form={TILT_LENS}", "Declare=Variance=0.001"] if folder == SCENES else []
    with tempfile.TemporaryDirectory() as folder_of_picture:
        command = povray_run.command(
            program,
            scene,
            f"{folder_of_picture}/picture.png",
            LARGE if picture.corner else picture.size,
            "-C",
            "-GA",
            "+WT1",
            "+FN",
            *picture.options(),
            *declared,
            library=[folder, povray_run.INCLUDE],
        )
        unfinished = path.with_suffix(".part")
        record = {"TILT_LENS_RECORD": str(unfinished), "TILT_LENS_RECORD_SAMPLES": str(picture.samples), "TILT_LENS_SETTINGS": settings}
        povray_run.run(command, folder_of_picture, povray_run.environment(**record), limit=None).succeeded()
    unfinished.rename(path)
    return path


def replay(lab, path, picture, lines):
    command = [
        lab.tools / "replay_samples",
        path,
        *picture.size,
        picture.samples,
        "--variances",
        ",".join(map(str, picture.variances)),
        "--denoise",
        "1" if picture.corner else "0,1",
    ]
    done = subprocess.run(
        list(map(str, command)), input="".join(line + "\n" for line in lines), capture_output=True, text=True, check=False
    )
    if done.returncode != 0:
        raise Failed(f"replay_samples {path} ended with {done.returncode}:\n{done.stderr[-2000:]}")
    found = {}
    for record in map(json.loads, done.stdout.splitlines()):
        found.setdefault((record["settings"], record["denoise"]), []).append(record)
    return found


def work_for(curve, mse):
    """On straight lines of logarithms, beyond the ends with the slope -1 of independent samples."""
    points = sorted((math.log(record["mse"]), math.log(record["samples"])) for record in curve if record["mse"] > 0)
    wanted = math.log(mse)
    if wanted <= points[0][0]:
        return math.exp(points[0][1] + points[0][0] - wanted)
    if wanted >= points[-1][0]:
        return math.exp(points[-1][1] + points[-1][0] - wanted)
    for (x, y), (u, v) in zip(points, points[1:]):
        if wanted <= u:
            return math.exp(y + (v - y) * (wanted - x) / (u - x)) if u > x else math.exp(min(y, v))
    return None


def ratio(base, other):
    """Work without over work with a rule: geometric mean over the errors reached without it."""
    logs = [math.log(record["samples"] / work_for(base, record["mse"])) for record in other if record["mse"] > 0]
    return math.exp(sum(logs) / len(logs)) if logs else 1.0


def kept(records):
    """The contract's limits: mean square error over V, and the share of pixels far off."""
    records = [record for record in records if record["variance"] >= LEAST_KEPT]
    return max(record["mse"] / record["variance"] for record in records), max(record["beyond"] for record in records)


def worst(found, name):
    row = max((row for row in found if row[name] is not None), key=lambda row: row[name])
    return row[name], row["scene"]


def summary(rule, found):
    name, section, settings = rule
    groups = ((False, False), (False, True), (True, True))
    return {
        "rule": name,
        "section": section,
        "settings": settings,
        "means": [geometric_mean(row["ratio"] for row in found if (row["part"], row["denoise"]) == group) for group in groups],
        **{figure: worst(found, figure) for figure in ("ratio", "error", "beyond")},
    }


def replays(lab, picture):
    """All rules that `picture` can tell something about."""
    found = replay(lab, recording(lab, picture), picture, ["", *(settings for _, _, settings in RULES)])
    if picture.scene in WITH_LAMPS and picture.corner is None:
        for _, _, settings in EMITTER_RULES:
            for (_, on), records in replay(lab, recording(lab, picture, settings), picture, [""]).items():
                found[settings, on] = records
    return found


def row(picture, found, settings, on):
    part = picture.corner is not None
    error, beyond = (None, None) if part or picture.scene in TOO_FEW_SAMPLES else kept(found[settings, on])
    work = ratio(found["", on], found[settings, on])
    return {"scene": picture.name, "part": part, "denoise": on, "ratio": work, "error": error, "beyond": beyond}


def measure(lab):
    build_tools(lab)
    rules = (("", 0, ""), *RULES, *EMITTER_RULES)
    rows = {rule: [] for rule in rules}
    measured = pictures(lab.quick)
    for picture in measured:
        found = replays(lab, picture)
        for rule in rules:
            rows[rule] += [row(picture, found, rule[2], on) for on in (False, True) if (rule[2], on) in found]
    whole = measured[0]
    return {"size": list(whole.size), "samples": whole.samples, "rules": [summary(rule, rows[rule]) for rule in rules]}


def settings_of_header(text):
    body = text[text.index("struct Settings") :]
    lines = re.findall(r"^ +(?:double|float|bool|std::uint32_t) (.*);$", body, re.MULTILINE)
    return [part.split(" = ")[0] for line in lines for part in line.split(", ")]
