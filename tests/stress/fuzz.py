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
import seeds  # noqa: E402

BLOCKS, SHARD, RUNS = 20_000, 1000, 2_000_000


def libfuzzer(program, corpus, runs, length):
    """Runs and new coverage; a finding ends in words."""
    settings = {"ASAN_OPTIONS": "new_delete_type_mismatch=0:detect_leaks=0", **os.environ}
    done = subprocess.run([str(program), f"-runs={runs}", f"-max_len={length}", "-seed=1", "-rss_limit_mb=4000",
                           f"-artifact_prefix={corpus}-finding-", str(corpus)], capture_output=True, text=True, check=False,
                          env=settings)
    covered = re.findall(r"cov: (\d+)", done.stderr)
    return {"runs": runs, "exit": done.returncode, "coverage": int(covered[-1]) if covered else 0,
            "finding": "" if done.returncode == 0 else done.stderr[-1500:]}


def measure(setup, count=BLOCKS, runs=RUNS):
    """Programs of the presets asan and fuzz are used where they are built, else the release build's."""
    work = setup.work("fuzz")
    sanitized = setup.build / "asan" / "tests" / "fuzz" / "parse_blocks"
    parser = sanitized if sanitized.is_file() else setup.build / "tests" / "fuzz" / "parse_blocks"
    tallies = common.in_parallel(setup.jobs, lambda seed: blocks.tally(blocks.run(str(parser), seed, min(SHARD, count))),
                                 range(1, 1 + max(1, count // SHARD)))
    total = {"blocks": 0, "counts": {}, "bad": [], "sanitized": parser == sanitized}
    for tally in tallies:
        total["blocks"] += tally["blocks"]
        total["bad"] += tally["bad"]
        for key, n in tally["counts"].items():
            total["counts"][key] = total["counts"].get(key, 0) + n
    found = {"grammar": total}
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
