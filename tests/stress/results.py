# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later

import concurrent.futures
import dataclasses
import hashlib
import json
import os
import pathlib
import subprocess

from tools.repository import ROOT

RESULTS = ROOT / "docs" / "numerics"


@dataclasses.dataclass
class Setup:
    build: pathlib.Path
    jobs: int = os.cpu_count() or 1
    unfinished: pathlib.Path | None = None

    @property
    def povray(self):
        return self.build / "bin" / "povray"

    @property
    def compare(self):
        return self.build / "tests" / "tools" / "compare"

    def tool(self, name):
        return self.build / "tests" / "stress" / name

    def work(self, part):
        folder = (self.unfinished or self.build / "stress") / part
        folder.mkdir(parents=True, exist_ok=True)
        return folder


def save(part, result):
    """The same numbers give the same bytes."""
    RESULTS.mkdir(parents=True, exist_ok=True)
    text = json.dumps(result, indent=1, sort_keys=True)
    (RESULTS / f"{part}.json").write_text(text + "\n")


def load(part):
    path = RESULTS / f"{part}.json"
    return json.loads(path.read_text()) if path.is_file() else None


def once(folder, name, made_with, make, faults):
    """Results without faults are stored for the same program and scripts."""
    digest = hashlib.sha256()
    for path in made_with:
        digest.update(hashlib.sha256(pathlib.Path(path).read_bytes()).digest())
    path = folder / f"{name}-{digest.hexdigest()[:12]}.json"
    if path.is_file():
        return json.loads(path.read_text())
    text = json.dumps(make())
    result = json.loads(text)
    if not faults(result):
        part = path.with_suffix(".part")
        part.write_text(text)
        part.rename(path)
    return result


def output(command):
    done = subprocess.run([str(word) for word in command], capture_output=True, text=True, check=False)
    if done.returncode != 0:
        raise RuntimeError(f"{' '.join(map(str, command))}: exit code {done.returncode}\n{done.stdout}{done.stderr}")
    return json.loads(done.stdout)


def in_parallel(jobs, function, items):
    with concurrent.futures.ThreadPoolExecutor(jobs) as pool:
        return list(pool.map(function, items))
