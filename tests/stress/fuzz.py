# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""The long fuzz run: libFuzzer on the solver and the parser, and the grammar's blocks against the sanitized parser."""

import os
import pathlib
import re
import subprocess
import sys

import common

sys.path.insert(0, str(common.ROOT / "tests" / "fuzz"))
import blocks  # noqa: E402
import frames  # noqa: E402
import seeds  # noqa: E402

BLOCKS, SHARD, RUNS = 20_000, 1000, 2_000_000


def libfuzzer(program, corpus, runs, length):
    """Runs and new coverage; a finding ends in words."""
    settings = {"ASAN_OPTIONS": "detect_leaks=0", **os.environ}
    done = subprocess.run([str(program), f"-runs={runs}", f"-max_len={length}", "-seed=1", "-rss_limit_mb=4000",
                           f"-artifact_prefix={corpus}-finding-", str(corpus)], capture_output=True, text=True, check=False,
                          env=settings)
    covered = re.findall(r"cov: (\d+)", done.stderr)
    return {"runs": runs, "exit": done.returncode, "coverage": int(covered[-1]) if covered else 0,
            "finding": "" if done.returncode == 0 else done.stderr[-1500:]}


def grammar(setup, work, tree, count):
    """Blocks parsed, and the accepted ones rendered. A frame mostly waits, so many processes run at a time."""
    parser, povray = tree / "tests" / "fuzz" / "parse_blocks", tree / "bin" / "povray"

    def shard(seed):
        outcomes = blocks.run(str(parser), seed, min(SHARD, count))
        accepted = [o.text for o in outcomes if o.answer == "lens"]
        return {**blocks.tally(outcomes), "pictures": len(accepted), "bad_pictures": frames.render(povray, accepted)}

    tallies = common.in_parallel(4 * setup.jobs, lambda seed: common.once(work, f"blocks-{count}-{seed}", povray,
                                                                          lambda: shard(seed)),
                                 range(1, 1 + max(1, count // SHARD)))
    total = {"blocks": 0, "pictures": 0, "counts": {}, "bad": [], "sanitized": tree != setup.build}
    for tally in tallies:
        total["blocks"] += tally["blocks"]
        total["pictures"] += tally["pictures"]
        total["bad"] += tally["bad"] + tally["bad_pictures"]
        for key, n in tally["counts"].items():
            total["counts"][key] = total["counts"].get(key, 0) + n
    return total


def measure(setup, count=BLOCKS, runs=RUNS):
    """Programs of the presets asan and fuzz are used where they are built, else the release build's."""
    work = setup.work("fuzz")
    sanitized = setup.build / "asan"
    built = (sanitized / "tests" / "fuzz" / "parse_blocks").is_file() and (sanitized / "bin" / "povray").is_file()
    found = {"grammar": grammar(setup, work, sanitized if built else setup.build, count)}
    seeds.write(work / "solver")
    found["solver"] = libfuzzer(setup.build / "tests" / "fuzz" / "solver_fuzz", work / "solver", runs, 320)
    fuzzer = setup.build / "fuzz" / "tests" / "fuzz" / "parser_fuzz"
    if fuzzer.is_file():
        corpus = work / "parser"
        corpus.mkdir(exist_ok=True)
        for path in pathlib.Path(common.ROOT / "tests" / "fuzz" / "corpus" / "parser").iterdir():
            (corpus / path.name).write_bytes(path.read_bytes())
        found["parser"] = libfuzzer(fuzzer, corpus, runs // 20, 2000)
    return found


def faults(result):
    """What was found, in words."""
    found = [f"{bad['answer']}\n{bad['text']}" for bad in result["grammar"]["bad"]]
    found += [f"{name}: {result[name]['finding']}" for name in ("solver", "parser")
              if name in result and result[name]["exit"] != 0]
    return found
