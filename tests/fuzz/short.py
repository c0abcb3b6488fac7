# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""The short fuzz run: tests.fuzz.short solver|prescription|blocks|frames|regressions."""

import argparse
import pathlib
import subprocess
import sys
import tempfile

from tests.fuzz import blocks, frames, grammar, kept, seeds
from tests.parse import items

RUNS, READER_RUNS, BLOCKS, FRAMES = 30_000, 10_000, 800, 60
SECONDS_OF_ONE = 60  # a file is read within a thousandth of it
# refused, and brighter than the file can hold
BAD = ("tilt", "tilt 3 } } sphere { 0, 50 hollow finish { ambient 1e9 } pigment { rgb 1 } } camera { location 9*y tilt_lens { tilt 3")


def run_libfuzzer(program, *arguments):
    done = subprocess.run([str(program), *map(str, arguments)], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False)
    print("\n".join(done.stdout.splitlines()[-3:]))
    if done.returncode != 0:
        sys.exit(done.stdout[-4000:])


def solver(settings):
    with tempfile.TemporaryDirectory(prefix="tilt_lens.") as name:
        folder = pathlib.Path(name)
        seeds.write(folder / "corpus")
        kept.unpack("solver", folder / "corpus")
        run_libfuzzer(settings.solver, f"-runs={RUNS}", "-seed=1", "-max_len=320", f"-artifact_prefix={name}/", folder / "corpus")


def prescription(settings):
    with tempfile.TemporaryDirectory(prefix="tilt_lens.") as name:
        folder = pathlib.Path(name)
        seeds.write_lenses(folder / "corpus")
        kept.unpack("prescription", folder / "corpus")
        run_libfuzzer(
            settings.prescription,
            f"-runs={READER_RUNS}",
            "-seed=1",
            "-max_len=4096",
            f"-timeout={SECONDS_OF_ONE}",
            f"-artifact_prefix={name}/",
            folder / "corpus",
        )


def grammar_blocks(settings):
    missing = {item.word for item in items.items(settings.parser)} ^ set(grammar.WORDS)
    if missing:
        sys.exit(f"the grammar and the parser know different words: {sorted(missing)}")
    found = blocks.tally(blocks.run(settings.parser, 1, BLOCKS))
    print(found["counts"])
    if found["bad"]:
        sys.exit("\n".join(f"{bad['answer']}\n{bad['text']}\n---" for bad in found["bad"][:10]))
    for answer in ("valid: lens", "valid: error", "broken: error", "broken: lens", "soup: error"):
        if found["counts"].get(answer, 0) < BLOCKS // 100:
            sys.exit(f"hardly any '{answer}': the grammar has lost its point: {found['counts']}")


def grammar_frames(settings):
    accepted = [o.text for o in blocks.run(settings.parser, 2, 3 * FRAMES) if o.answer == "lens"][:FRAMES]
    if len(accepted) < FRAMES:
        sys.exit(f"only {len(accepted)} of {3 * FRAMES} blocks accepted")
    half = FRAMES // 2
    alone = frames.render(settings.povray, accepted[:1])
    if alone:
        sys.exit(f"a block alone: {alone}")
    wrong = frames.render(settings.povray, accepted[:half] + [BAD[0]] + accepted[half:] + [BAD[1]])
    print("\n".join(f"{w['answer']}\n{w['text']}\n---" for w in wrong))
    if [w["text"] for w in wrong] != list(BAD):
        sys.exit("not just the two that are meant to be found")


def regressions(settings):
    cameras, texts = (kept.load("corpus", name) + kept.load("regressions", name) for name in ("solver", "parser"))
    if not cameras or not texts:
        sys.exit("no kept cameras or blocks")
    with tempfile.TemporaryDirectory(prefix="tilt_lens.") as name:
        kept.unpack("solver", pathlib.Path(name))
        run_libfuzzer(settings.solver, *sorted(pathlib.Path(name).iterdir()))
    blocks_ = [text.decode() for text in texts]
    bad = [
        (text, answer) for text, answer in zip(blocks_, blocks.parse(settings.parser, blocks_)) if answer.split()[0] in ("wrong", "crash")
    ]
    if bad:
        sys.exit("\n".join(f"{answer}\n{text}\n---" for text, answer in bad))
    print(f"{len(cameras)} cameras, {len(texts)} blocks")


def main():
    parts = {"solver": solver, "prescription": prescription, "blocks": grammar_blocks, "frames": grammar_frames, "regressions": regressions}
    parser = argparse.ArgumentParser()
    parser.add_argument("part", choices=parts)
    parser.add_argument("--solver", required=True, type=pathlib.Path)
    parser.add_argument("--prescription", required=True, type=pathlib.Path)
    parser.add_argument("--parser", required=True)
    parser.add_argument("--povray", required=True)
    settings = parser.parse_args()
    parts[settings.part](settings)


if __name__ == "__main__":
    main()
