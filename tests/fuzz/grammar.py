# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Valid and broken tilt_lens blocks, reproducible by seed."""

import random

FAMILIES = (("tilt", "swing"), ("focus_tilt", "focus_swing"), ("focal_plane",), ("focal_points",), ("sharp_points",))
DISTANCES = ("focus_scale", "film_distance", "focus_on", "focus_at")  # the first one fits any scene
FREE = (
    "film_width",
    "focal_length",
    "scene_unit",
    "shift",
    "f_stop",
    "blades",
    "blade_curvature",
    "squeeze",
    "budget",
    "denoise",
    "sample_seed",
    "edge_light",
    "natural_vignetting",
    "optical_vignetting",
    "distortion",
    "field_curvature",
    "lateral_colour",
    "axial_colour",
    "prescription",
    "dispersion",
    "sharp_within",
    "circle_of_confusion",
)
AIDS = ("focus_peaking", "show_planes", "focus_map")  # the last one stands alone
WORDS = tuple(word for family in FAMILIES for word in family) + DISTANCES + FREE + AIDS
ODD_NUMBERS = (
    "0",
    "-0",
    "1e-320",
    "-1e-320",
    "1e308",
    "-1e308",
    "1e309",
    "-1e309",
    "1e309-1e309",
    "90",
    "-90",
    "89.999999",
    "1e-12",
    "0.1+0.2",
    "1/3",
    "pi",
    "2147483648",
    "1e12",
    "-7",
    "12345678901234567890",
)
STRANGE = (
    "{",
    "}",
    "<",
    ">",
    ",",
    ";",
    "(",
    ")",
    "[",
    "]",
    "+",
    "-",
    "*",
    "/",
    "=",
    "!",
    "tlit",
    "TILT",
    "angle",
    "aperture",
    "sphere",
    "rgb",
    "x",
    "clock",
    "blades_",
    "é",
    "\\",
    "@",
    "'",
    "//",
    "/* */",
    "..",
    "1..2",
    "0x1F",
    "tilt_lens",
    "location",
    "no_such_word_of_any_length_that_goes_on_and_on_and_on",
)


class Grammar:
    def __init__(self, seed):
        self.random = random.Random(seed)

    def number(self, low, high):
        r = self.random
        value = r.uniform(low, high)
        text = r.choice((f"{value:.3g}", f"{value:.6f}", f"{value:.17g}", f"{value:.2e}"))
        return r.choice((text,) * 6 + (f"({text})", f"{text}*1", f"1*({text}+0)", f"-(-({text}))", f"{text}/1.0"))

    def vector(self, size=3, low=-5, high=5):
        separator = self.random.choice((", ", ",", " , ", ",\n"))
        return "<" + separator.join(self.number(low, high) for _ in range(size)) + ">"

    def colour(self):
        r = self.random
        return r.choice(
            (
                f"rgb {self.vector(3, 0, 1)}",
                f"rgb {self.number(0, 1)}",
                f"rgbf {self.vector(4, 0, 1)}",
                f"color rgb {self.vector(3, 0, 2)}",
                f"red {self.number(0, 1)} green 0.5",
                self.vector(3, -1, 1),
                f"srgb {self.vector(3, 0, 1)}",
            )
        )

    def value(self, word):
        r = self.random
        if word in ("tilt", "swing"):
            return self.number(-20, 20)
        if word in ("focus_tilt", "focus_swing"):
            return self.number(-70, 70)
        if word == "focal_plane":
            return f"{{ {r.choice((self.vector(), 'y', 'z', '<0, 1, 0.3>', '-y'))}, {self.number(-3, 3)} }}"
        if word == "focal_points":
            return ", ".join(self.vector() for _ in range(3))
        if word == "sharp_points":
            points = (self.vector(), self.vector(), self.vector(), f"focus_at {self.vector(2, 0, 1)}", "focus_on Ball")
            return ", ".join(r.choice(points) for _ in range(r.randint(3, 7)))
        if word == "focus_at":
            return self.vector(2, 0, 1)
        if word == "focus_on":
            return r.choice(("Ball", "Nothing", "sphere { 0, 1 }"))
        if word == "sample_seed":
            return r.choice(("0", "1", "4294967295", str(r.randint(0, 10**9))))
        if word == "budget":
            return self.number(4, 12)
        if word == "shift":
            return self.vector(2, -30, 30)
        if word == "blades":
            return str(r.randint(3, 12)) + (f", {self.number(-90, 90)}" if r.random() < 0.5 else "")
        if word in ("denoise", "dispersion"):
            return r.choice(("on", "off", "yes", "no", "true", "1", "0", "0.5", "2 > 1"))
        if word == "prescription":
            return f'"lenses/{r.choice(("zeiss_planar_50.dat", "minolta_50.json"))}"' + (
                f", {self.number(5, 500)}" if r.random() < 0.5 else ""
            )
        if word == "focus_peaking":
            return self.colour() + (f", {self.number(0.1, 20)}" if r.random() < 0.5 else "")
        if word in AIDS:
            return ""
        return {
            "film_width": lambda: self.number(1, 300),
            "focal_length": lambda: self.number(5, 500),
            "scene_unit": lambda: self.number(0.1, 2000),
            "f_stop": lambda: self.number(0.5, 32),
            "blade_curvature": lambda: self.number(0, 1),
            "squeeze": lambda: self.number(0.1, 10),
            "edge_light": lambda: self.number(-0.9, 0.9),
            "natural_vignetting": lambda: self.number(0, 1),
            "optical_vignetting": lambda: self.number(0, 2),
            "distortion": lambda: ", ".join(self.number(-0.2, 0.5) for _ in range(r.choice((1, 2, 3)))),
            "field_curvature": lambda: self.number(-1, 1),
            "lateral_colour": lambda: self.number(-0.5, 0.5),
            "axial_colour": lambda: self.number(-0.5, 0.5),
            "film_distance": lambda: self.number(1, 500),
            "focus_scale": lambda: self.number(0.1, 20),
            "sharp_within": lambda: self.number(0.1, 20),
            "circle_of_confusion": lambda: self.number(0.001, 1),
        }[word]()

    def items(self):
        r = self.random
        words = [word for word in FREE if r.random() < 0.3]
        words = [word for word in words if word != "blade_curvature" or "blades" in words]
        words = [
            word
            for word in words
            if word not in ("focal_length", "f_stop", "prescription", "sharp_within", "circle_of_confusion") or r.random() < 0.1
        ]
        words = [word for word in words if word != "dispersion" or "prescription" in words]
        if r.random() < 0.9:
            family = r.choice(FAMILIES)
            words += [word for word in family if len(family) == 1 or r.random() < 0.7]
            if family == FAMILIES[0] and r.random() < 0.2:
                words.append(DISTANCES[0])
        if r.random() < 0.2:
            words += r.choice((AIDS[:1], AIDS[1:2], AIDS[:2], AIDS[2:]))
        r.shuffle(words)
        return [(word, self.value(word)) for word in words]

    def text(self, items):
        gap = self.random.choice((" ", "\n", "\n  ", "\t", " // a remark\n", " /* a remark */ "))
        return gap + gap.join(f"{word} {value}".strip() for word, value in items) + gap

    def broken(self, items):
        r = self.random
        items = list(items) or [("tilt", "3")]
        at = r.randrange(len(items))
        word, value = items[at]
        way = r.randrange(9)
        if way == 0:
            items.append(r.choice(items))
        elif way == 1:
            items[at] = (word, r.choice(ODD_NUMBERS))
        elif way == 2:
            items[at] = (word, "")
        elif way == 3:
            items.insert(at, (r.choice(STRANGE), ""))
        elif way == 4:
            items[at] = (word[:-1] + r.choice("abcdefgh"), value)
        elif way == 5:
            items.append((r.choice(WORDS), self.value(r.choice(WORDS))))
        elif way == 6:
            items[at] = (word, self.vector(r.choice((1, 2, 4, 5)), -1e9, 1e9))
        elif way == 7:
            text = self.text(items)
            return text[: r.randrange(len(text) + 1)]
        else:
            text = list(self.text(items))
            for _ in range(r.randint(1, 4)):
                text[r.randrange(len(text))] = r.choice("{}<>,;()+-*/=. \n0123456789abcxyz")
            return "".join(text)
        return self.text(items)

    def soup(self):
        r = self.random
        return " ".join(r.choice(WORDS + STRANGE + ODD_NUMBERS) for _ in range(r.randint(1, 30)))

    def block(self):
        """(kind, text): `valid` (perhaps without a solution), `broken`, `soup`."""
        kind = self.random.choices(("valid", "broken", "soup"), (5, 4, 1))[0]
        if kind == "valid":
            return kind, self.text(self.items())
        return kind, self.broken(self.items()) if kind == "broken" else self.soup()

    def blocks(self, count):
        return [self.block() for _ in range(count)]
