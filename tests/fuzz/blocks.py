# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Sends the grammar's blocks through POV-Ray's parser."""

import collections
import dataclasses
import os
import subprocess

from tests.fuzz import grammar
from tools.povray_run import PATIENCE, WITHOUT_LEAKS

BATCH = 500


@dataclasses.dataclass
class Outcome:
    kind: str
    text: str
    answer: str  # "lens", "none", "error ...", "wrong ...", or "crash ..."


def parse(parser, texts):
    """After a crash, a new process continues behind its block."""
    answers = []
    while len(answers) < len(texts):
        data = b"".join(text.encode() + b"\0" for text in texts[len(answers) :])
        settings = {**WITHOUT_LEAKS, **os.environ}
        done = subprocess.run([parser], input=data, capture_output=True, check=False, timeout=PATIENCE, env=settings)
        answers += done.stdout.decode(errors="replace").splitlines()
        if len(answers) < len(texts):
            said = done.stderr.decode(errors="replace").strip().splitlines()
            telling = [line for line in said if "ERROR" in line or "error" in line] or said or ["no word"]
            answers.append(f"crash {done.returncode}: {telling[0][:200]}")
    return answers


def run(parser, seed, count):
    made = grammar.Grammar(seed).blocks(count)
    answers = []
    for start in range(0, count, BATCH):
        answers += parse(parser, [text for _, text in made[start : start + BATCH]])
    return [Outcome(kind, text, answer) for (kind, text), answer in zip(made, answers)]


def tally(outcomes):
    counts = collections.Counter((o.kind, o.answer.split()[0]) for o in outcomes)
    bad = [o for o in outcomes if o.answer.split()[0] in ("wrong", "crash")]
    return {
        "counts": {f"{kind}: {answer}": n for (kind, answer), n in sorted(counts.items())},
        "messages": len({o.answer[:40] for o in outcomes if o.answer.startswith("error")}),
        "blocks": len(outcomes),
        "bad": [{"text": o.text, "answer": o.answer} for o in bad],
    }
