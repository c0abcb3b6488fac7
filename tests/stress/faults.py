# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Killed renders, and failures of disk, memory or standard output."""

import os
import pathlib
import random
import resource
import signal
import subprocess
import tempfile
import time

from tests.render import rendering, scenes
from tools import povray_run

KILLS = 50
SIZE = {"width": 96, "height": 72}
LIMITS = "blur_samples 64, 300 variance 1/10000 "
SLOW = scenes.camera(samples="blur_samples 300 variance 0 ") + scenes.WORLD
WAYS = (
    SLOW,
    scenes.camera(samples=LIMITS) + scenes.WORLD,
    scenes.camera("tilt 4 swing 2 shift <2, -1> blades 5, 10 denoise off", samples=LIMITS) + scenes.WORLD,
)
QUICK = scenes.camera() + scenes.WORLD
OPTIONS = ("+WT2", "+BS8")


def use(setup):
    rendering.SETTINGS.povray, rendering.SETTINGS.compare = str(setup.povray), str(setup.compare)


def run(folder, scene, *options, through=(), **how):
    job = rendering.Job(scene, options, **how.pop("size", SIZE))
    job.write(folder)
    done = povray_run.run([*through, *job.command()], folder, **how)
    return done.code, "\n".join(line for line in done.said.splitlines() if "configuration file" not in line)


def is_whole(path, whole):
    try:
        found = rendering.read_picture(path, "")
    except povray_run.UnreadablePicture:
        return False
    return rendering.difference(found, whole)[1] == 0.0


def torn(folder, whole):
    path = folder / "picture.png"
    return path.exists() and path.stat().st_size > 0 and not is_whole(path, whole)


def killed(count, wholes, stop):
    r = random.Random(int(stop))
    found = {"tries": count, "same": 0, "torn": 0, "kept": 0, "before_first_block": 0, "after_end": 0}
    usual = []
    for scene in WAYS:
        begin = time.monotonic()
        with tempfile.TemporaryDirectory(prefix="tilt_lens.") as name:
            rendering.Job(scene, OPTIONS, **SIZE).run(pathlib.Path(name))
        usual.append(time.monotonic() - begin)
    for i in range(count):
        way = i % len(WAYS)
        with tempfile.TemporaryDirectory(prefix="tilt_lens.") as name:
            for key, value in one_kill(pathlib.Path(name), WAYS[way], wholes[way], stop, usual[way] * r.random()).items():
                found[key] += value
    return found


def one_kill(folder, scene, whole, stop, moment):
    process = rendering.Job(scene, OPTIONS, **SIZE).start(folder)
    time.sleep(moment)
    late = process.poll() is not None
    process.send_signal(stop)
    process.communicate()
    tear = torn(folder, whole)
    state = list(folder.glob("*.pov-state"))
    stored = state[0].stat().st_size if state else 0
    said = rendering.Job(scene, (*OPTIONS, "+C"), **SIZE).run(folder)
    kept = stored < 5000 or "Pixels:" in said and _pixels(said) < SIZE["width"] * SIZE["height"]
    return {"same": is_whole(folder / "picture.png", whole), "torn": tear, "kept": kept, "before_first_block": not state, "after_end": late}


def _pixels(said):
    return int(said.split("Pixels:")[1].split()[0])


def said_why(said, *words):
    return any(word.lower() in said.lower() for word in words)


def last_words(said):
    lines = [line.strip() for line in said.splitlines() if line.strip()]
    telling = [line for line in lines if said_why(line, "error:", "fatal error", "cannot", "failed", "no space", "out of memory", "abort")]
    return (telling or lines or [""])[0][:160]


def case(name, code, said, whole, folder, words):
    return {
        "name": name,
        "exit": code,
        "said": last_words(said.replace(str(folder), "FOLDER")),
        "clear": code not in (0, None) and said_why(said, *words),
        "torn": torn(folder, whole),
    }


def environment(whole):
    rows = []
    with tempfile.TemporaryDirectory(prefix="tilt_lens.") as name:
        folder = pathlib.Path(name) / "full"
        folder.mkdir()
        rows.append(full_disk(folder))
        folder = pathlib.Path(name) / "readonly"
        (folder / "out").mkdir(parents=True)
        (folder / "out").chmod(0o555)
        rows.append(read_only(folder, whole))
        folder = pathlib.Path(name) / "memory"
        folder.mkdir()
        code, said = run(
            folder,
            QUICK + _many_spheres(200_000),
            *OPTIONS,
            preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_AS, (260 << 20, 260 << 20)),
        )
        rows.append(case("260 MiB of address space, 200,000 spheres", code, said, whole, folder, ("memory", "bad_alloc", "thread")))
    rows += [listening(whole, kind) for kind in ("closed", "full", "gone")]
    rows.append(two_in_one_folder(whole))
    return rows


def _many_spheres(count):
    return f"#declare R = seed(1); #for (I, 1, {count}) sphere {{ <rand(R), rand(R), rand(R)>*9 - 4, 0.01 " "pigment { rgb 1 } } #end\n"


def full_disk(folder):
    """A small file system, else a limit on file sizes."""
    size = {"width": 320, "height": 240}
    whole = rendering.render(QUICK, *OPTIONS, **size)
    mounted = (
        subprocess.run(["mount", "-t", "tmpfs", "-o", "size=512k", "none", str(folder)], capture_output=True, check=False).returncode == 0
    )
    extra = {} if mounted else {"preexec_fn": _small_files}
    try:
        code, said = run(folder, QUICK, *OPTIONS, size=size, **extra)
        row = case("disk full" if mounted else "files limited to 192 KiB", code, said, whole, folder, ("no space", "too large"))
        if mounted:
            subprocess.run(["mount", "-o", "remount,size=16m", str(folder)], check=True)
        again, said = run(folder, QUICK, *OPTIONS, "+C", size=size)
        # 192 KiB: a tenth of the picture; 512: more
        left = (0.9 if mounted else 0.95) * size["width"] * size["height"]
        kept = again == 0 and _pixels(said) < left
        named = "picture.png" in row["said"] or "picture.pov-state" in row["said"]
        row["clear"] = row["clear"] and named and kept and is_whole(folder / "picture.png", whole)
    finally:
        if mounted:
            subprocess.run(["umount", str(folder)], check=False)
    return row


def _small_files():
    signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
    resource.setrlimit(resource.RLIMIT_FSIZE, (192 << 10, 192 << 10))


def read_only(folder, whole):
    code, said = run(folder, QUICK, *OPTIONS, "+Oout/picture.png", through=povray_run.held_to_permissions())
    return case("read-only output folder", code, said, whole, folder, ("cannot", "denied", "not permitted", "failed"))


def listening(whole, kind):
    with tempfile.TemporaryDirectory(prefix="tilt_lens.") as name:
        folder = pathlib.Path(name)
        if kind == "closed":
            how = {"preexec_fn": lambda: (os.close(1), os.close(2)), "stdout": None, "stderr": None}
        elif kind == "full":
            how = {"stdout": open("/dev/full", "wb"), "stderr": subprocess.STDOUT}
        else:
            reader, writer = os.pipe()
            os.close(reader)
            how = {"stdout": writer, "stderr": writer}
        code, said = run(folder, QUICK, *OPTIONS, size=SIZE, **how)
        if kind == "gone":
            os.close(how["stdout"])
        picture = folder / "picture.png"
        finished = picture.is_file() and is_whole(picture, rendering.render(QUICK, *OPTIONS, **SIZE))
        return {
            "name": f"standard output {kind}",
            "exit": code,
            "said": said,
            "torn": picture.exists() and not finished,
            "clear": code not in (0, None) or finished,
            "finished": finished,
        }


def two_in_one_folder(whole):
    with tempfile.TemporaryDirectory(prefix="tilt_lens.") as name:
        folder = pathlib.Path(name)
        job = rendering.Job(SLOW, OPTIONS, **SIZE)
        both = [job.start(folder), job.start(folder)]
        for process in both:
            process.communicate()
        codes = [process.returncode for process in both]
        fine = is_whole(folder / "picture.png", whole) if 0 in codes else not torn(folder, whole)
        return {
            "name": "two renders into one folder",
            "exit": max(codes),
            "said": "",
            "clear": fine,
            "torn": torn(folder, whole),
            "codes": codes,
        }


def measure(setup, kills=KILLS):
    use(setup)
    wholes = [rendering.render(scene, *OPTIONS, **SIZE) for scene in WAYS]
    return {
        "SIGKILL": killed(kills, wholes, signal.SIGKILL),
        "SIGTERM": killed(max(3, kills // 5), wholes, signal.SIGTERM),
        "environment": environment(wholes[0]),
    }


def faults(result):
    found = []
    for name in ("SIGKILL", "SIGTERM"):
        row = result[name]
        if row["same"] != row["tries"] or row["torn"] or row["kept"] != row["tries"]:
            found.append(f"{name}: {row}")
    found += [f"{row['name']}: {row}" for row in result["environment"] if row["torn"] or not row["clear"]]
    return found
