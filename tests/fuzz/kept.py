# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Kept inputs: corpus/ reaches all known code, regressions/ once failed."""

import base64
import json
import os
import pathlib
import subprocess
import tempfile

from tools.povray_run import WITHOUT_LEAKS

HERE = pathlib.Path(__file__).resolve().parent
BYTES = (lambda data: base64.b64encode(data).decode(), base64.b64decode)
FORMS = {"solver": BYTES, "prescription": BYTES, "parser": (bytes.decode, str.encode)}


def load(where, name):
    path = HERE / where / f"{name}.json"
    return [FORMS[name][1](text) for text in json.loads(path.read_text())] if path.is_file() else []


def save(where, name, inputs):
    texts = sorted({FORMS[name][0](data) for data in inputs}, key=lambda text: (len(text), text))
    (HERE / where).mkdir(exist_ok=True)
    (HERE / where / f"{name}.json").write_text(json.dumps(texts, indent=0, ensure_ascii=False) + "\n")


def unpack(name, folder):
    folder.mkdir(parents=True, exist_ok=True)
    for where in ("corpus", "regressions"):
        for number, data in enumerate(load(where, name)):
            (folder / f"{where}{number:04}").write_bytes(data)


def minimise(name, program, found):
    with tempfile.TemporaryDirectory(prefix="tilt_lens.") as folder:
        subprocess.run(
            [str(program), "-set_cover_merge=1", folder, str(found)], capture_output=True, check=True, env={**WITHOUT_LEAKS, **os.environ}
        )
        save("corpus", name, [path.read_bytes() for path in pathlib.Path(folder).iterdir()])
