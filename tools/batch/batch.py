# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""The command `batch`: many pictures, or one large one, on this machine or on a Slurm cluster."""

import argparse
import os
import re
import signal
import subprocess
import sys
import time

from tools.batch import describe, local, merge, plan, povray, progress, sheet, slurm, status, task
from tools.batch.store import BatchError, UsageError, Work, little_room, locked, read_json, write_json, write_text

ENGINES = {"local": local, "slurm": slurm}
HELP = """Options of POV-Ray may follow, as for ./render: +W1920 +H1080 Declare=Tilt=4
The same command again goes on with whatever is missing. See docs/batch.md."""


def positive(text):
    if not text.isdigit() or int(text) < 1:
        raise argparse.ArgumentTypeError(f"{text!r}: expected a whole number, 1 or more")
    return int(text)


def whole(text):
    if not text.isdigit():
        raise argparse.ArgumentTypeError(f"{text!r}: expected a whole number, 0 or more")
    return int(text)


def seconds(text):
    found = re.fullmatch(r"(\d+)([smh]?)", text)
    if not found or int(found.group(1)) < 1:
        raise argparse.ArgumentTypeError(f"{text!r}: expected seconds, or a number with m or h, as in 30m")
    return int(found.group(1)) * {"": 1, "s": 1, "m": 60, "h": 3600}[found.group(2)]


def common_options(kind):
    kind.add_argument("scene", help="the scene file")
    kind.add_argument("--bands", type=positive, metavar="N", help="cut each picture into N bands of rows (default: from an estimate)")
    kind.add_argument("--on", choices=sorted(ENGINES), default="local", help="where to render (default: local)")
    kind.add_argument("--workers", type=positive, metavar="N", help="POV-Rays at once (default: one a core; Slurm: no limit)")
    kind.add_argument("--output", metavar="NAME", help="the picture; of a film or a sweep, the folder")
    kind.add_argument("--work", metavar="FOLDER", help="folder for parts and logs (default: the output's name with .batch)")
    kind.add_argument("--povray", default=os.environ.get("BATCH_POVRAY"), metavar="PROGRAM", help="this project's povray, built elsewhere")
    course_options(kind)
    site_options(kind)


def course_options(kind):
    kind.add_argument("--retries", type=whole, default=3, metavar="N", help="further tries of what fails (default: 3)")
    kind.add_argument(
        "--limit",
        type=seconds,
        metavar="TIME",
        help="end what takes longer for one picture or band: seconds, or 30m, 2h (default: no limit)",
    )
    kind.add_argument("--anew", action="store_true", help="throw away what an earlier call has left, and begin again")
    kind.add_argument("--then", metavar="COMMAND", help="run this in a shell when all pictures are in their places")
    kind.add_argument("--quiet", action="store_true", help="no progress, only the summary")


def site_options(kind):
    site = kind.add_argument_group("Slurm")
    for name in ("partition", "time", "account"):
        site.add_argument(f"--{name}", metavar=name.upper(), help=f"as for sbatch --{name}")
    site.add_argument("--sbatch", action="append", default=[], metavar="OPTION", help="further option for sbatch, as in --sbatch=--mem=4G")
    site.add_argument("--detach", action="store_true", help="submit, and do not wait")


def parser():
    top = argparse.ArgumentParser(prog="batch", allow_abbrev=False, epilog=HELP, description=__doc__.split("\n", maxsplit=1)[0])
    kinds = top.add_subparsers(dest="kind", required=True, metavar="still|film|sweep|status")
    for name, text in (
        ("still", "one picture, its rows in bands"),
        ("film", "the frames of an animation"),
        ("sweep", "one picture for each choice of values, and a contact sheet"),
    ):
        kind = kinds.add_parser(name, help=text, description=text, allow_abbrev=False, epilog=HELP)
        common_options(kind)
        if name == "film":
            kind.add_argument("--frames", type=positive, required=True, metavar="N", help="how many frames; clock goes from 0 to 1")
            kind.add_argument("--only", metavar="FRAMES", help="only these frames of the film, as in 5-8,12; with --anew again")
        if name == "sweep":
            kind.add_argument(
                "--set",
                action="append",
                required=True,
                metavar="NAME=VALUES",
                help='declare NAME with each value: -8:8:2 (from, to, step), 0.1,0.2 or \'"a","b"\'; repeat for more names',
            )
    kind = kinds.add_parser("status", help="where a batch stands, as JSON", allow_abbrev=False)
    kind.add_argument("folder", help="the work folder, or the picture or folder that it belongs to")
    return top


def finish(work, description):
    bands = len(description["key"]["bands"])
    complaints = []
    for name in work.names("running"):
        work.record("running", name).unlink(missing_ok=True)
    done = work.names("done")
    for picture in range(len(description["key"]["pictures"])):
        if merge.is_merged(work, description, picture):
            continue
        if all(plan.unit_name(picture * bands + band, bands) in done for band in range(bands)):
            try:
                with locked(work.units / f"{picture:05d}.lock"):
                    merge.merge_picture(work, description, picture)
            except (BatchError, OSError) as error:
                complaints.append(str(error))
    complaints += sorted(set(describe.changed_by_units(work)))
    state = progress.State(work, description)
    if not complaints and state.merged == state.pictures and description["key"]["kind"] == "sweep":
        complaints += make_sheet(work, description)
    return complaints


def make_sheet(work, description):
    record = work.folder / "sheet.json"
    try:
        with locked(work.folder / "sheet.lock"):
            told = read_json(record)
            target = os.path.join(description["output"], description["sheet"])
            if told and told["file"] == target and os.path.exists(target) and os.stat(target).st_mtime_ns == told["time"]:
                return []
            target = sheet.make(work, description)
            write_json(record, {"file": str(target), "time": target.stat().st_mtime_ns})
            return []
    except (BatchError, OSError) as error:
        return [f"the contact sheet failed: {error}"]


def work_through(work, description, settings, engine):
    line = progress.Progress(work, description, settings.quiet)
    complaints = []
    for _ in range(1 + settings.retries):
        missing = progress.State(work, description).missing()
        if missing:
            description["tasks"] = tasks_of(description, missing, settings, engine)
            description["begun"] = time.time()
            write_json(work.description, description)
            engine.run(work, description, list(range(len(description["tasks"]))), settings, line)
            if settings.detach and settings.on == "slurm":
                return None
        complaints = finish(work, description)
        if not progress.State(work, description).missing():
            break
    line.show(final=True)
    return complaints


def tasks_of(description, missing, settings, engine):
    """Tasks long enough to be worth their start, yet enough for all workers."""
    estimate, bands = description["estimate"], len(description["key"]["bands"])
    seconds = estimate["picture"] / bands + estimate["start"]
    parallel = engine.workers(settings, description["threads"])
    chunk = max(1, min(int(plan.SECONDS_A_TASK / seconds), -(-len(missing) // (4 * parallel))))
    if engine is slurm:
        chunk = max(chunk, -(-len(missing) // slurm.largest_array()))
    return [missing[i : i + chunk] for i in range(0, len(missing), chunk)]


def report(work, description, complaints, elapsed):
    state = progress.State(work, description)
    lines = [
        *complaints,
        *progress.failures(work, description),
        *progress.unfinished(work, description),
        *progress.summary(work, description, elapsed),
    ]
    complete = state.merged == state.pictures and not complaints
    if not complete:
        lines += little_room(work.folder)
        lines.append(f"NOT complete. The same command again goes on; logs: {str(work.logs)!r}")
    elif state.pictures == 1:
        lines.append("Picture: " + os.path.join(description["output"], description["key"]["pictures"][0]["name"]))
    elif description["key"]["kind"] == "sweep":
        lines.append("Contact sheet: " + os.path.join(description["output"], description["sheet"]))
    print("\n".join(lines), file=sys.stderr)
    write_text(work.folder / "summary.txt", "\n".join(lines) + "\n")
    return 0 if complete else 1


def afterwards(work, description, command):
    if not command:
        return 0
    names = {"BATCH_OUTPUT": description["output"], "BATCH_WORK": str(work.folder)}
    done = subprocess.run(command, shell=True, cwd=description["key"]["folder"], env={**os.environ, **names}, check=False)
    if done.returncode:
        print(f"batch: the pictures are complete, but --then ended with exit code {done.returncode}", file=sys.stderr)
    return 1 if done.returncode else 0


def batch(settings, words):
    if not settings.povray:
        raise UsageError("no program: give --povray PROGRAM, or call ./batch of the repository.")
    begun = time.monotonic()
    engine = ENGINES[settings.on]
    request = describe.understood(settings, words)
    povray.needed_programs()
    engine.check()
    work = Work(request.work)
    describe.refuse_foreign(work)
    work.folder.mkdir(parents=True, exist_ok=True)
    with locked(work.lock, wait=False) as got:
        if not got:
            raise BatchError(f"another call of batch is at work in {str(work.folder)!r}.")
        jobs = slurm.active_jobs(work)
        if jobs and settings.on != "slurm":
            raise BatchError(f"the jobs {' '.join(jobs)} of an earlier call are at work on this: wait, or scancel them.")
        if jobs:
            watch(work, jobs, settings)
        try:
            with describe.output_alone(work, request):
                description = describe.open_batch(work, request, engine)
                complaints = work_through(work, description, settings, engine)
            if complaints is None:
                return 0
            code = report(work, description, complaints, time.monotonic() - begun)
            return code or afterwards(work, description, settings.then)
        except (BatchError, OSError):
            for line in little_room(work.folder):
                print(line, file=sys.stderr)
            raise


def watch(work, jobs, settings):
    with slurm.interrupted_alone(jobs):
        print(f"jobs {' '.join(jobs)} of an earlier call are still at work: waiting for them", file=sys.stderr)
        slurm.wait(jobs, progress.Progress(work, read_json(work.description), settings.quiet))


def last_step(folder):
    work = Work(folder)
    description = read_json(work.description)
    code = report(work, description, finish(work, description), time.time() - description["begun"])
    describe.leave_output(work, description)
    return code or afterwards(work, description, description["then"])


def main(words):
    if words[:1] == ["task"]:
        return task.run(words[1], int(words[2]))
    if words[:1] == ["finish"]:
        return last_step(words[1])
    settings, rest = parser().parse_known_args(words)
    unknown = [word for word in rest if (word.startswith("--") and word != "--unrestricted") or settings.kind == "status"]
    if unknown:
        parser().error(f"unknown option {unknown[0]}")
    for number in (signal.SIGTERM, signal.SIGHUP):
        signal.signal(number, lambda signum, _: sys.exit(128 + signum))
    try:
        return status.show(settings.folder) if settings.kind == "status" else batch(settings, rest)
    except UsageError as error:
        print(f"batch: {error}", file=sys.stderr)
        return 2
    except BatchError as error:
        print(f"batch: {error}", file=sys.stderr)
    except OSError as error:
        print(f"batch: {error}. The same command again goes on from here.", file=sys.stderr)
    except KeyboardInterrupt:
        print("\nStopped. The same command again goes on from here.", file=sys.stderr)
        return 130
    return 1


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
