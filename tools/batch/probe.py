# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Probes a scene: files, size, time, and whether pixels depend on the rendered rows, as with radiosity and stock's jittered area lights."""

import itertools
import re
import subprocess
import sys
import time

from tools.batch import key as keys, merge, povray
from tools.batch.store import BatchError, UsageError

SMALL_ROWS = 64
SMALL_COLUMNS = 128


class Probe:
    def __init__(self, work, description, picture):
        self.work, self.description, self.picture = work, description, picture
        self.read, self.missing = set(), set()
        self.small = None

    def render(self, name, rows, size=None):
        """Returns the folder, the log's text and the duration in seconds."""
        folder = self.work.probe / name
        folder.mkdir(parents=True, exist_ok=True)
        povray.clear_output(folder, also_state=True)
        (folder / "files").unlink(missing_ok=True)
        log = folder / "log"
        log.unlink(missing_ok=True)
        begun = time.monotonic()
        words = povray.arguments(self.description, self.picture, rows, size)
        if size is None:
            words += ["+SC1", "+EC2"]
        process = povray.start(self.description, folder, [*words, "-C"], log)
        status = self.wait(process, log)
        seconds = time.monotonic() - begun
        text = log.read_text(encoding="utf-8", errors="replace")
        if status < 0:
            raise BatchError(f"POV-Ray was ended by signal {-status} at its first look at the scene; call again.")
        if status != 0:
            kind = UsageError if "Problem with option setting" in text else BatchError
            raise kind(
                f"POV-Ray cannot render the scene (exit code {status}); nothing was started. It said:\n"
                + told(text)
                + f"\n(all of it: {log})"
            )
        read, missing = keys.listed_files(folder / "files", keys.Links(self.description["links"]))
        self.read |= read
        self.missing |= missing
        return folder, text, seconds

    def wait(self, process, log):
        begun, limit = time.monotonic(), self.description["limit"]
        for pause in itertools.chain((5, 25, 90), itertools.repeat(600)):
            spent = time.monotonic() - begun
            try:
                return process.wait(timeout=pause if limit is None else max(0.01, min(pause, limit - spent)))
            except subprocess.TimeoutExpired:
                spent = time.monotonic() - begun
            if limit is not None and spent >= limit:
                process.kill()
                process.wait()
                raise BatchError(f"the first look at the scene was ended after {limit} s, as --limit says; log: {log}")
            hint = "" if spent < 100 or limit else " If it hangs: Ctrl-C, and again with --limit TIME."
            print(f"first look at the scene: {spent:.0f} s so far; log: {log}.{hint}", file=sys.stderr)

    def picture_size(self):
        """Renders two pixels; their file list goes into the key."""
        folder, _, _ = self.render("whole", (1, 2))
        return povray.image_info(self.output(folder))["size"]

    def output(self, folder):
        return povray.outputs(folder)["." + self.description["key"]["extension"]]

    def small_size(self, size):
        rows = min(SMALL_ROWS, size[1])
        return [max(2, min(SMALL_COLUMNS, round(size[0] * rows / size[1]))), rows]

    def estimate(self, size):
        """Seconds for a whole picture, and for each start of POV-Ray."""
        small = self.small_size(size)
        self.small = self.render("small", (1, small[1]), small)
        _, text, seconds = self.small
        wall, processor = trace_seconds(text)
        pixels = size[0] * size[1] / (small[0] * small[1])
        return {"picture": processor * pixels / self.description["threads"], "start": max(0.1, seconds - wall)}

    def seam(self, size, aligned):
        small = self.small_size(size)
        cut = 32 if aligned else 19
        if small[1] <= cut or re.search(r"^Tilt Lens Sampling", self.small[1], re.MULTILINE):
            return False
        halves = [(1, cut), (cut + 1, small[1])]
        paths = [
            str(self.output(self.render(name, rows, small)[0]).relative_to(self.work.probe))
            for name, rows in zip(("upper", "lower"), halves)
        ]
        joined = self.work.probe / f"joined.{self.description['key']['extension']}"
        merge.join(self.work.probe, list(zip(paths, halves)), small[0], joined)
        return povray.image_info(joined)["pixels"] != povray.image_info(self.output(self.small[0]))["pixels"]

    def radiosity(self):
        return bool(re.search(r"^Radiosity", self.small[1], re.MULTILINE))


def trace_seconds(text):
    found = re.findall(r"Trace Time:.*?\(([0-9.]+) seconds\)\s+using.*?with ([0-9.]+) CPU-seconds", text)
    return (float(found[-1][0]), float(found[-1][1])) if found else (0.0, 0.0)


def told(text):
    lines = [line for line in text.replace("\r", "\n").splitlines() if line.strip()]
    errors = [i for i, line in enumerate(lines) if re.search(r"error", line, re.IGNORECASE)]
    first = max(0, errors[0] - 4) if errors else -8
    return "\n".join("  " + line for line in lines[first:][:14])
