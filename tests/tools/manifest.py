# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""MANIFEST.json lists reference pictures.

The unpatched program makes oracle/NAME.exr from tests/oracle/cases/NAME.json; the fork makes renders/NAME.exr from scenes in
tests/reference/pictures.json."""

import dataclasses
import json
import pathlib

from tests.tools import pictures
from tools.povray_run import sources
from tools.repository import ROOT

FOLDER = ROOT / "reference-images"
ORACLE_CASES = ROOT / "tests" / "oracle" / "cases"
SCENES = ROOT / "tests" / "reference" / "scenes"
SCENE_LIST = ROOT / "tests" / "reference" / "pictures.json"

# with fewer independent pictures, Gaussian limits would fail correct pixels
BATCHES = 16
ORACLE_COMPARISON = {"kind": "limits", "rmse_max": 0.006, "mean_max": 0.0005}
FIELDS = [
    "file",
    "pixels_sha256",
    "scene",
    "sources_sha256",
    "command",
    "binary",
    "upstream",
    "series_sha256",
    "compiler",
    "samples",
    "standard_error",
    "reason",
    "comparison",
]


@dataclasses.dataclass
class Entry:
    name: str
    scene: pathlib.Path
    case: pathlib.Path  # None for a picture of the fork's own
    width: int
    height: int
    options: list
    batches: int  # independent pictures behind a reference of the fork's own
    comparison: dict

    @property
    def file(self):
        return FOLDER / (self.name + ".exr")

    @property
    def output(self):
        return "new.png" if self.case else "new.exr"

    def job(self, povray, declare=()):
        form = ["+FN16", "File_Gamma=1.0"] if self.case else ["+FE"]
        return pictures.Render(
            str(povray), self.scene, self.width, self.height, form + self.options + ["Declare=" + item for item in declare]
        )

    def sources_sha256(self):
        """The fork's scene is under test, so it does not count."""
        files = [self.case, self.case.parent / json.loads(self.case.read_text())["scene"]] if self.case else sources(self.scene)
        return {str(path.relative_to(ROOT)): pictures.file_hash(path) for path in sorted(files)}


def entries():
    found = []
    for case in sorted(ORACLE_CASES.glob("*.json")):
        width, height = json.loads(case.read_text())["picture"]
        found.append(Entry("oracle/" + case.stem, case.with_suffix(".pov"), case, width, height, [], 0, ORACLE_COMPARISON))
    for name, item in json.loads(SCENE_LIST.read_text()).items():
        width, height = item["picture"]
        found.append(
            Entry(
                "renders/" + name,
                SCENES / (name + ".pov"),
                None,
                width,
                height,
                item.get("options", []),
                item.get("batches", BATCHES),
                item["comparison"],
            )
        )
    return {entry.name: entry for entry in found}


def load(folder=FOLDER):
    path = folder / "MANIFEST.json"
    return json.loads(path.read_text()) if path.is_file() else {}


def save(manifest, folder=FOLDER):
    text = json.dumps(dict(sorted(manifest.items())), indent=2) + "\n"
    draft = folder / "MANIFEST.json.new"
    draft.write_text(text)
    draft.replace(folder / "MANIFEST.json")


def complaints(manifest, folder, names, compare):
    found = []
    for name in sorted(set(names) - set(manifest)):
        found.append(f"{name}: has no entry in MANIFEST.json; make it with tests.tools.update_references")
    for name in sorted(set(manifest) - set(names)):
        found.append(f"{name}: is in MANIFEST.json, but no such case or scene exists")
    listed = {folder / entry.get("file", "") for entry in manifest.values()}
    for path in sorted(folder.glob("**/*.exr")):
        if path not in listed:
            found.append(f"{path.relative_to(folder)}: is no entry's picture")
    for name, entry in sorted(manifest.items()):
        missing = [field for field in FIELDS if entry.get(field) in (None, "", [], {})]
        if missing:
            found.append(f"{name}: lacks {', '.join(missing)}")
            continue
        path = folder / entry["file"]
        if not path.is_file():
            found.append(f"{name}: its picture {entry['file']} is missing")
        elif pictures.pixel_hash(compare, path) != entry["pixels_sha256"]:
            found.append(f"{name}: the pixels of {entry['file']} are not those of the manifest")
    return found
