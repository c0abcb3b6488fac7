# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""The box scene through a glass lens. A thin lens gets the properties of the glass one by one; each remainder is at most the rays'
displacement (pixels) times the picture's steepness."""

import dataclasses

from experiments import gauss
from experiments.box import LINES, VIEW, state
from experiments.laboratory import OWN_SCENES, SCENES, Claim

F_STOP = 8  # the glass's own aberrations are small there
SAME_SCENE = 0.5  # levels: the ideal lens in the glass's program against tilt_lens, as Table 1
PRESCRIPTION = 0.3  # levels: through the same surfaces
CHARACTER = 1.0  # levels: the ideal lens with the numbers that are fitted to the glass
MODELS = ("thin", "distortion", "field", "pupil", "glass")
STEPS = ("distortion", "field", "pupil", "rest")
REAL_VARIANCE = 6e-7  # their noise is 0.2 level
REACH = 3.0  # pixels beside a line whose steepness counts
PINHOLE = 1e6


@dataclasses.dataclass
class Tracer:
    lab: object
    letter: str
    lens: object
    lines: list

    def picture(self, model, f_stop=F_STOP, measure=False, whole=False):
        view, kind = self.lens.view, "whole" if whole else "sharp" if f_stop > F_STOP else "lines"
        made = self.lab.work / f"{model}_{self.letter}_{kind}.exr"
        made.parent.mkdir(parents=True, exist_ok=True)
        report = self.lab.json(
            [
                self.lab.tool("glass"),
                made,
                "--width",
                view.width,
                "--height",
                view.height,
                "--samples",
                128 if whole else 2048,
                "--f-stop",
                f_stop,
                "--tilt",
                self.lens.tilt(),
                "--film-distance",
                self.lens.film_distance * view.scene_unit,
                "--model",
                model,
                *([] if whole else ["--line", *[x for line in self.lines for x in line], "--reach", REACH + 2]),
                *(["--measure"] if measure else []),
            ]
        )
        return made, report


def real_lenses(lab, letter, size, fitted):
    k1, k2, near = fitted["distortion"]
    lenses = {
        "character": [("Glass", 0), ("K1", k1), ("K2", k2), ("Near", near), ("Bent", fitted["field_curvature"])],
        "prescription": [("Glass", 1)],
    }
    gauss.write(lab.work)
    return [
        lab.render(
            OWN_SCENES / "box_real.pov",
            f"{name}_{letter}.exr",
            size,
            [("State", "abc".index(letter)), *items, ("Stop", F_STOP), ("Quality", 1), ("Variance", REAL_VARIANCE)],
            [f"+L{lab.work}"],
        )
        for name, items in lenses.items()
    ]


def levels(lab, first, others, line):
    report = lab.json([lab.tool("profile"), "line", first, *others, "--from-to", *line, "--points", 400])
    return [curve["average_difference"] for curve in report["curves"]]


def compare(lab):
    view = dataclasses.replace(VIEW, f_stop=F_STOP)
    if lab.quick:
        view = dataclasses.replace(view, width=120, height=80)
    rows, real, fits = [], [], []
    for letter in "b" if lab.quick else "abc":
        lens = state(letter, view)
        lines = {colour: [*lens.pixel(start), *lens.pixel(end)] for colour, (_, _, start, end) in LINES.items()}
        tracer = Tracer(lab, letter, lens, list(lines.values()))
        ours = lab.render(
            SCENES / f"box_{letter}.pov",
            f"stopped_{letter}.exr",
            (view.width, view.height),
            [("Stop", F_STOP), ("Quality", 1), ("Variance", 2e-6)],
        )
        shots = {model: tracer.picture(model)[0] for model in MODELS[:-1]}
        glass, told = tracer.picture("glass", measure=True)
        like = real_lenses(lab, letter, (view.width, view.height), told["character"])
        sharp, _ = tracer.picture("thin", f_stop=PINHOLE)
        if not lab.quick:
            lab.png(tracer.picture("glass", whole=True)[0])
            lab.png(ours)
        for (colour, line), rays in zip(lines.items(), told["lines"]):
            whole, *left = levels(lab, glass, [ours, *shots.values()], line)
            (same,) = levels(lab, ours, [shots["thin"]], line)
            steep = float(lab.run([lab.tool("profile"), "steepness", sharp, "--from-to", *line, "--reach", REACH]))
            rows.append([letter, colour, same, whole, *left[1:], *(rays[step] for step in STEPS), rays["all"], rays["vignetted"], steep])
            yield from claims(f"glass ({letter}) {colour}", same, whole, left, rays, steep)
            character, prescription = levels(lab, glass, like, line)
            real.append([letter, colour, whole, character, rays["character"], prescription])
            yield Claim(
                f"glass ({letter}) {colour}: tilt_lens with distortion and field curvature, rays {rays['character']:.2g} " "pixels aside",
                character,
                min(CHARACTER, SAME_SCENE + steep * rays["character"]),
                "levels",
            )
            yield Claim(f"glass ({letter}) {colour}: through the prescription", prescription, PRESCRIPTION, "levels")
        fitted = told["character"]
        fits.append([letter, *fitted["distortion"], *fitted["left"], fitted["field_curvature"]])
    lab.table(
        "real.csv",
        ["state", "line", "ideal lens, levels", "with character, levels", "its rays aside, pixels", "through the glass, levels"],
        real,
    )
    lab.table(
        "fits.csv",
        ["state", "`distortion` K1", "K2", "NEAR", "left without NEAR, pixels", "left with it, pixels", "`field_curvature`, mm"],
        fits,
    )
    lab.table(
        "glass.csv",
        [
            "state",
            "line",
            "ideal lens, levels",
            "glass, levels",
            "with its distortion",
            "with its field",
            "with its pupil",
            *(f"{step}, pixels" for step in STEPS),
            "all, pixels",
            "vignetted",
            "steepness, levels per pixel",
        ],
        rows,
    )


def claims(text, same, whole, left, rays, steep):
    yield Claim(f"{text}: the same scene, ideal lens", same, SAME_SCENE, "levels")
    yield Claim(f"{text}: glass against tilt_lens, rays {rays['all']:.2g} pixels aside", whole, SAME_SCENE + steep * rays["all"], "levels")
    aside = sum(rays[step] for step in STEPS[1:])
    for i, (model, step) in enumerate(zip(MODELS[1:], STEPS[1:]), 1):
        yield Claim(f"{text}: left with the glass's {model}, rays {aside:.2g} pixels aside", left[i], SAME_SCENE + steep * aside, "levels")
        aside -= rays[step]
