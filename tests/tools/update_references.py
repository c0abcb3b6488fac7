# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""The only program that makes reference pictures and their entries in MANIFEST.json.

Arguments: names (oracle/tilt) or folders (oracle, renders). --prune removes pictures and entries without a case or scene."""

import os
import argparse
import json
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

from tests.tools import manifest, pictures

ORACLE_BATCHES, ORACLE_SAMPLES, ORACLE_PROCESSES = 8, 512, 48


def arguments():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("names", nargs="*", metavar="NAME")
    parser.add_argument("--reason", required=True, help="why they change; kept in the manifest")
    parser.add_argument("--povray", type=os.path.abspath, help="the fork, for renders/")
    parser.add_argument("--stock", type=os.path.abspath, default="/usr/bin/povray", help="the unpatched program, for oracle/")
    parser.add_argument("--oracle", type=os.path.abspath, help="the oracle program, for oracle/")
    parser.add_argument("--compare", type=os.path.abspath, required=True, help="the comparison program")
    parser.add_argument("--prune", action="store_true", help="remove what nothing stands for any more")
    return parser.parse_args()


def version_and_compiler(povray):
    done = subprocess.run([povray, "--version"], stdin=subprocess.DEVNULL, capture_output=True, text=True, check=True)
    text = done.stdout + done.stderr
    version = re.findall(r"^(?:POV-Ray \d| povray-tilt-lens ).*$", text, re.MULTILINE)
    told = re.findall(r"^ *Compiler (?:version|flags): *(.*)$", text, re.MULTILINE)
    mark = re.search(rb"GCC: \([^)\0]*\) [\d.]+|clang version [^\0]+", pathlib.Path(povray).read_bytes())
    compiler = ([mark.group(0).decode()] if mark else []) + told
    return (", ".join(line.strip() for line in version) or "not told by the program", " ".join(compiler) or "not told by the program")


def series_sha256():
    folder = manifest.ROOT / "patches"
    names = [line.strip() for line in (folder / "series").read_text().splitlines() if line.strip() and not line.startswith("#")]
    lines = [f"{pictures.file_hash(folder / name)}  {name}\n" for name in names]
    return pictures.hashlib.sha256("".join(lines).encode()).hexdigest()


def upstream():
    """Without Debian's revision: accepted revisions hold the same patches."""
    pin = json.loads((manifest.ROOT / "povray-src" / "upstream.json").read_text())
    return " ".join(str(pin[field]) for field in ("package", "upstream_version"))


def make_oracle(entry, args, work):
    if not args.oracle:
        raise SystemExit(f"{entry.name}: give --oracle")
    output = work / "oracle.exr"
    command = [
        args.oracle,
        "render",
        str(entry.case),
        str(output),
        "--povray",
        args.stock,
        "--batches",
        str(ORACLE_BATCHES),
        "--samples",
        str(ORACLE_SAMPLES),
        "--processes",
        str(ORACLE_PROCESSES),
        "--work",
        str(work / "frames"),
    ]
    subprocess.run(command, check=True)
    told = ["oracle", "render", str(entry.case.relative_to(manifest.ROOT)), *command[3:-2]]
    told[3] = str(entry.file.relative_to(manifest.ROOT))
    return output, told, args.stock, ORACLE_BATCHES * ORACLE_SAMPLES


def make_render(entry, args, work):
    """Mean of pictures with different margins, and so different samples."""
    if not args.povray:
        raise SystemExit(f"{entry.name}: give --povray")
    files = []
    for batch in range(entry.batches):
        job = entry.job(args.povray, [f"Batch={batch}"])
        job.width += 2 * batch
        job.height += 2 * batch
        name = f"batch{batch}.exr"
        command = pictures.render(job, work, name)
        files.append(str(work / name))
    output = work / "mean.exr"
    subprocess.run([args.compare, "average", str(output), *files], check=True)
    return output, ["povray", *command[1:]], args.povray, entry.batches


def standard_error(compare, picture):
    done = subprocess.run([compare, "error", str(picture)], capture_output=True, text=True, check=True)
    return json.loads(done.stdout)["standard_error"]


def update(entry, args):
    with tempfile.TemporaryDirectory() as work:
        make = make_oracle if entry.case else make_render
        output, command, program, samples = make(entry, args, pathlib.Path(work))
        entry.file.parent.mkdir(parents=True, exist_ok=True)
        shutil.copyfile(output, entry.file)
    version, compiler = version_and_compiler(program)
    return {
        "file": str(entry.file.relative_to(manifest.FOLDER)),
        "pixels_sha256": pictures.pixel_hash(args.compare, entry.file),
        "scene": str((entry.case or entry.scene).relative_to(manifest.ROOT)),
        "sources_sha256": entry.sources_sha256(),
        "command": command,
        "binary": version,
        "upstream": upstream(),
        "series_sha256": "none: the unpatched program" if entry.case else series_sha256(),
        "compiler": compiler,
        "samples": samples,
        "standard_error": standard_error(args.compare, entry.file),
        "reason": args.reason,
        "comparison": entry.comparison,
    }


def prune(records, known):
    for name in sorted(set(records) - set(known)):
        (manifest.FOLDER / records.pop(name)["file"]).unlink(missing_ok=True)
        print("removed", name)
    kept = {manifest.FOLDER / record["file"] for record in records.values()}
    for path in manifest.FOLDER.glob("**/*.exr"):
        if path not in kept:
            path.unlink()
            print("removed", path.relative_to(manifest.FOLDER))


def main():
    args = arguments()
    known = manifest.entries()
    wanted = [name for name in known if name in args.names or name.split("/")[0] in args.names]
    folders = {name.split("/")[0] for name in known}
    unknown = [name for name in args.names if name not in known and name not in folders]
    if unknown:
        print("no such picture:", ", ".join(unknown), file=sys.stderr)
        return 1
    if not args.reason.strip():
        print("give the reason in words", file=sys.stderr)
        return 1
    records = manifest.load()
    for name in wanted:
        print("making", name, flush=True)
        try:
            records[name] = update(known[name], args)
        except (pictures.Trouble, subprocess.CalledProcessError) as error:
            print(f"{name}: {error}", file=sys.stderr)
            return 1
        manifest.save(records)
    if args.prune:
        prune(records, known)
        manifest.save(records)
    return 0


if __name__ == "__main__":
    sys.exit(main())
