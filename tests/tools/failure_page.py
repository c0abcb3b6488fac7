# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""A local page about a failed picture."""

import html
import json
import shlex
import subprocess

STYLE = """body { font: 15px sans-serif; margin: 2em; background: #ddd; color: #111 }
figure { display: inline-block; margin: 0 1em 1em 0 } img { image-rendering: pixelated }
td, th { padding: 0 1em 0 0; text-align: right }
pre { background: #fff; padding: 0.6em; overflow: auto }"""


def write(folder, name, trouble, commands, picture, reference, compare):
    """`commands`: title to command line."""
    command = [str(compare), "preview", str(picture), str(reference), str(folder), "--zoom", "4"]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    parts = [f"<h1>{html.escape(name)}: {html.escape(trouble.outcome)}</h1>", f"<pre>{html.escape(str(trouble))}</pre>"]
    if done.returncode == 0:
        parts += [figure("new.png", "new"), figure("reference.png", "reference"), figure("difference.png", "difference × 16")]
        parts.append(worst_pixels(json.loads(done.stdout)))
    else:
        parts.append(f"<p>No pictures to show: {html.escape(done.stderr.strip())}</p>")
    for title, command in commands.items():
        text = command if isinstance(command, str) else shlex.join(command)
        parts.append(f"<h2>{html.escape(title)}</h2><pre>{html.escape(text)}</pre>")
    page = folder / "index.html"
    page.write_text(
        '<!DOCTYPE html><html lang="en"><head><meta charset="utf-8">'
        f"<title>{html.escape(name)}</title><style>{STYLE}</style></head><body>" + "\n".join(parts) + "</body></html>\n"
    )
    return page


def figure(file, title):
    return f'<figure><img src="{file}" alt="{title}"><figcaption>{title}</figcaption></figure>'


def worst_pixels(figures):
    rows = "".join(
        f"<tr><td>{pixel['x']}</td><td>{pixel['y']}</td>" f"<td>{pixel['difference']:+.5f}</td></tr>" for pixel in figures["worst"]
    )
    return (
        f"<p>RMSE {figures['rmse']:.5f}, signed mean {figures['mean']:+.6f}, "
        f"largest {figures['largest']:.5f}, "
        f"largest mean of 8 by 8 pixels {figures['largest_local_mean']:.5f}, "
        f"{figures['different_pixels']} pixels differ.</p><h2>Worst pixels</h2>"
        f"<table><tr><th>x</th><th>y</th><th>new - reference</th></tr>{rows}</table>"
    )
