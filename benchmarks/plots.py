# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later

import subprocess

from benchmarks.front import pareto
from benchmarks.lab import Failed

LOOKS = {  # program: title, point, colour
    "stock": ("stock focal blur", 4, "#b0413e"),
    "tilt_lens": ("tilt_lens", 7, "#1f5fa8"),
    "accumulation": ("accumulation buffer", 9, "#3c8c40"),
    "post-processed": ("blurred after the fact", 13, "#888888"),
}
HEAD = """set terminal svg size 560,400 font 'sans,12' noenhanced background '#ffffff'
set output '{output}'
set title "{title}"
set xlabel "{x}"
set ylabel "{y}"
set logscale xy
set format x "%g"
set format y "%g"
set grid lc rgb '#dddddd'
set key {key}
"""


def draw(script):
    done = subprocess.run(["gnuplot"], input=script, text=True, capture_output=True, check=False)
    if done.returncode != 0 or "error" in done.stderr:
        raise Failed(f"gnuplot: {done.stderr[-1000:]}")


def data(name, points):
    return f"${name} << end\n" + "\n".join(f"{x:.6g} {y:.6g}" for x, y in points) + "\nend\n"


def errors(path, title, records):
    script = HEAD.format(output=path, title=title, x="CPU seconds", y="RMSE", key="top right")
    curves = []
    for number, (program, (name, point, colour)) in enumerate(LOOKS.items()):
        points = [(record["cpu"], record["rmse"]) for record in records if record["program"] == program]
        if points:
            script += data(f"points{number}", points) + data(f"front{number}", pareto(points))
            style = f"pt {point} ps 0.6 lc rgb '{colour}'"
            curves.append(f"$points{number} with points {style} notitle")
            curves.append(f"$front{number} with linespoints {style} lw 1.5 title '{name}'")
    draw(script + "plot " + ", ".join(curves) + "\n")


def growth(path, name, rows):
    unit = rows[0]["unit"]
    script = HEAD.format(output=path, title=f"How cost grows with {name}", x=unit, y="seconds", key="top left")
    curves = []
    for number, program in enumerate(("tilt_lens", "stock")):
        points = [(row["x"], max(row["cpu"] - row["start_up"], 1e-3)) for row in rows if row["program"] == program]
        if points:
            title, point, colour = LOOKS[program]
            script += data(f"cpu{number}", points)
            curves.append(f"$cpu{number} with linespoints pt {point} ps 0.6 lc rgb '{colour}' title '{title}, CPU'")
    if name == "threads":
        script += data("clock", [(row["x"], row["seconds"]) for row in rows])
        curves.append("$clock with linespoints pt 6 lc rgb '#1f5fa8' dt 2 title 'tilt_lens, elapsed'")
    draw(script + "plot " + ", ".join(curves) + "\n")
