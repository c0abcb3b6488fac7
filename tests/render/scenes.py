# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
WORLD = """
plane { y, 0 pigment { checker rgb <0.9, 0.8, 0.7> rgb <0.1, 0.3, 0.5> } finish { ambient 0.1 diffuse 0.8 } }
sphere { <0.3, 0.6, 0>, 0.6 pigment { rgb <0.8, 0.2, 0.1> } finish { reflection 0.3 phong 0.5 } }
box { <-2, 0, 1>, <-1, 1.6, 2> pigment { gradient y color_map { [0.5 rgb 0.9][0.5 rgb 0.1] } scale 0.4 } }
light_source { <4, 8, -6>, rgb 1 }
background { rgb <0.3, 0.5, 0.8> }
"""
VIEW = "location <0.4, 1.5, -4> look_at <0, 0.5, 0.5> angle 45 "
SAMPLES = "blur_samples 8, 64 confidence 0.9 variance 1/2000 "


def camera(lens="tilt 4 swing 2 shift <2, -1> blades 5, 10", aperture=0.3, samples=SAMPLES, view=VIEW, tail=""):
    return f"camera {{ {view}aperture {aperture} {samples}tilt_lens {{ {lens} }} {tail} }}\n"


# With `brilliance 0` a surface has the same radiance at any angle, unless it is parallel to their common direction.
UNKNOWN_LIGHTS = "".join(f"light_source {{ {side}e6*<1, 2, 3>, rgb 1e-4 shadowless }}\n" for side in (-1, 1))


def unknown_glow(red, green, blue):
    """A texture of even radiance in which no lamp is sought, as it does not glow by itself: in a scene with UNKNOWN_LIGHTS alone."""
    colour = f"rgb <{red:.6g}, {green:.6g}, {blue:.6g}>"
    return f"texture {{ pigment {{ {colour} }} finish {{ ambient 0 emission 0 diffuse 1e4 brilliance 0 }} }}"


SIX = [(x, y) for x in (-3, 0.5, 4) for y in (-1, 2)]


def six(glow, z=8, radius=0.15):
    return "".join(f"disc {{ <{x}, {y}, {z}>, z, {radius} {glow} }}\n" for x, y in SIX)


def painted(glow=30, radius=0.15):
    """The same by colours of a wall."""
    inside = ", ".join(f"{radius**2} - pow(x - {x}, 2) - pow(y - {y}, 2)" for x, y in SIX)
    return (
        f"plane {{ -z, -8 pigment {{ function {{ select(max({inside}), 0, 1) }} color_map {{ [0.5 rgb 0] [0.5 rgb 1e3*<1, 0.8, 0.5>] }} }}"
        f" finish {{ ambient 0 diffuse 0 emission 1e-3*{glow} }} }}\n"
    )


TILTED = camera() + WORLD
