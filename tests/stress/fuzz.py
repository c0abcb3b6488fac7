# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""The long fuzz run."""

import os
import re
import subprocess

from tests.fuzz import blocks, frames, grammar as grammar_of_blocks, kept, seeds
from tests.stress import results
from tools.povray_run import WITHOUT_LEAKS
from tools.repository import ROOT

BLOCKS, SHARD, SECONDS = 20_000, 1000, 600
SCRIPTS = sorted((ROOT / "tests" / "fuzz").glob("*.py"))


def drop_refused(corpus):
    """libFuzzer before LLVM 15 keeps inputs that parser_fuzz.cpp ignores."""
    for path in corpus.iterdir():
        data = path.read_bytes()
        if set(data) & set(b'#"') or any(not 32 <= byte < 127 and byte not in b"\n\t" for byte in data):
            path.unlink()


def libfuzzer(name, program, corpus, length, runs, seconds):
    """Without a number of runs: a fixed time, and new inputs are kept."""
    kept.unpack(name, corpus)
    words = corpus.parent / f"{name}.dict"
    words.write_text("".join(f'"{word}"\n' for word in (*grammar_of_blocks.WORDS, "rgb", "<", ">", "{", "}", ", ", "1e309")))
    ends = [f"-runs={runs}", "-seed=1"] if runs else [f"-max_total_time={seconds}"]
    dictionary = [f"-dict={words}"] if name == "parser" else []
    settings = {**WITHOUT_LEAKS, **os.environ}
    done = subprocess.run(
        [
            str(program),
            *ends,
            *dictionary,
            f"-max_len={length}",
            "-rss_limit_mb=4000",
            "-timeout=60",
            f"-artifact_prefix={corpus}-finding-",
            str(corpus),
        ],
        capture_output=True,
        text=True,
        check=False,
        env=settings,
    )
    covered = re.findall(r"cov: (\d+)", done.stderr)
    told = re.search(r"Done (\d+) runs in (\d+) second", done.stderr)
    if name == "parser":
        drop_refused(corpus)
    if not runs and done.returncode == 0:
        kept.minimise(name, program, corpus)
    return {
        "runs": int(told[1]) if told else 0,
        "seconds": int(told[2]) if told else 0,
        "exit": done.returncode,
        "coverage": int(covered[-1]) if covered else 0,
        "kept": len(kept.load("corpus", name)),
        "finding": "" if done.returncode == 0 else done.stderr[-1500:],
    }


def grammar(setup, work, tree, count):
    parser, povray = tree / "tests" / "fuzz" / "parse_blocks", tree / "bin" / "povray"

    def shard(seed):
        outcomes = blocks.run(str(parser), seed, min(SHARD, count))
        accepted = [o.text for o in outcomes if o.answer == "lens"]
        return {**blocks.tally(outcomes), "pictures": len(accepted), "bad_pictures": frames.render(povray, accepted)}

    def once(seed):
        return results.once(
            work,
            f"blocks-{count}-{seed}",
            [povray, parser, *SCRIPTS],
            lambda: shard(seed),
            lambda tally: tally["bad"] + tally["bad_pictures"],
        )

    tallies = results.in_parallel(4 * setup.jobs, once, range(1, 1 + max(1, count // SHARD)))
    total = {"blocks": 0, "pictures": 0, "counts": {}, "bad": [], "sanitized": tree != setup.build}
    for tally in tallies:
        total["blocks"] += tally["blocks"]
        total["pictures"] += tally["pictures"]
        total["bad"] += tally["bad"] + tally["bad_pictures"]
        for key, n in tally["counts"].items():
            total["counts"][key] = total["counts"].get(key, 0) + n
    return total


def measure(setup, count=BLOCKS, runs=0, seconds=SECONDS):
    work = setup.work("fuzz")
    sanitized = setup.build / "fuzz"
    built = (sanitized / "tests" / "fuzz" / "parse_blocks").is_file() and (sanitized / "bin" / "povray").is_file()
    found = {"grammar": grammar(setup, work, sanitized if built else setup.build, count)}
    targets = [
        ("solver", setup.build / "tests" / "sanitized" / "memory" / "solver_fuzz", 320, runs),
        ("parser", sanitized / "tests" / "fuzz" / "parser_fuzz", 2000, runs // 20),
    ]
    targets.append(("prescription", setup.build / "tests" / "sanitized" / "memory" / "prescription_fuzz", 4096, runs))
    seeds.write(work / "solver")
    seeds.write_lenses(work / "prescription")

    def fuzz(target):
        name, program, length, count_ = target
        return libfuzzer(name, program, work / name, length, count_, seconds)

    present = [target for target in targets if target[1].is_file()]
    found.update(zip([target[0] for target in present], results.in_parallel(setup.jobs, fuzz, present)))
    return found


def faults(result):
    found = [f"{bad['answer']}\n{bad['text']}" for bad in result["grammar"]["bad"]]
    found += [
        f"{name}: {result[name]['finding']}"
        for name in ("solver", "prescription", "parser")
        if name in result and result[name]["exit"] != 0
    ]
    return found
