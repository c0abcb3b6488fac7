# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""The state of a batch as JSON for other programs: one entry for each picture or band.

    {"kind": "film", "output": "/home/me/film", "complete": false, "done": 1, "running": 1, "failed": 0, "waiting": 46,
     "units": [{"picture": "film0001.png", "rows": [1, 360], "state": "done", "host": "n1", "seconds": 12.5, "log": ...}]}

Further members: `percent` (running), POV-Ray's last report, and `reason` (failed).
"""

import json
import os

from tools.batch.plan import unit_name
from tools.batch.progress import Running, State
from tools.batch.store import UsageError, Work, read_json


def unit(work, description, state, number):
    key = description["key"]
    bands = len(key["bands"])
    name = unit_name(number, bands)
    entry = {"picture": key["pictures"][number // bands]["name"], "rows": key["bands"][number % bands], "state": "waiting"}
    for kind in ("done", "failed", "running"):
        if name in getattr(state, kind):
            entry["state"] = kind
            record = read_json(work.record(kind, name)) or {}
            entry.update((word, record[word]) for word in ("host", "seconds", "reason", "log") if word in record)
            break
    if entry["state"] == "running":
        running = Running(work, name, description)
        entry.update(seconds=round(running.seconds, 1), percent=running.percent())
    return entry


def show(folder):
    folder = os.path.abspath(folder)
    found = [name for name in (folder, folder + ".batch") if read_json(Work(name).description)]
    if not found:
        raise UsageError(f"{folder!r} is not the work folder of a batch, and has none beside it.")
    work = Work(found[0])
    description = {**read_json(work.description), "only": None}
    state = State(work, description)
    units = [unit(work, description, state, number) for number in state.units.values()]
    count = {kind: sum(entry["state"] == kind for entry in units) for kind in ("done", "running", "failed", "waiting")}
    told = {"kind": description["key"]["kind"], "output": description["output"], "complete": state.merged == state.pictures}
    print(json.dumps({**told, **count, "units": units}, indent=1))
    return 0
