# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""The whole program under AddressSanitizer with UndefinedBehaviorSanitizer, ThreadSanitizer and valgrind.

Builds the presets fuzz (clang) and tsan (gcc).
"""

import os
import pathlib
import subprocess
import tempfile

from tests.render import scenes, test_light
from tests.stress import reports, results
from tools import povray_run
from tools.repository import ROOT, module_command

TUTORIAL = sorted((ROOT / "scenes" / "tutorial").glob("*.pov"))
MODULES = ("light", "noise")  # radiosity, photons, media, bokeh, all users of random numbers
LIT = {name: test_light.Renders.WORLDS[name] for name in ("radiosity", "photons", "media", "fog")}


def environment(tool_suppressions=True):
    named = f":suppressions={reports.SUPPRESSIONS}/ubsan.txt" if tool_suppressions else ""
    return {
        **os.environ,
        # upstream keeps parsed objects until the end; soak.py covers leaks
        "ASAN_OPTIONS": "detect_leaks=0:halt_on_error=0",
        "UBSAN_OPTIONS": f"print_stacktrace=1{named}",
        "TSAN_OPTIONS": "halt_on_error=0:second_deadlock_stack=1:exitcode=0:history_size=7",
    }


def listener(program, folder, options=""):
    """Not all sanitizers support log_path. Later options take precedence."""
    script = folder / "povray"
    script.write_text(f'#!/bin/bash\nexec "{program}" "$@" {options} 2> >(tee "{folder}/log.$$" >&2)\n')
    script.chmod(0o755)
    return script


def build(setup, preset):
    for command in (
        ["cmake", "--preset", preset],
        ["cmake", "--build", "--preset", preset, "-j", str(setup.jobs), "--target", "povray", "parse_blocks", "compare"],
    ):
        subprocess.run(command, cwd=ROOT, check=True)
    return ROOT / "build" / preset


def watched(what, tool, commands, folder, work, suppressions=True):
    def run(command):
        done = povray_run.run(command, work, environment(suppressions), limit=None)
        return "" if done.code == 0 else done.told()

    failed = [words for words in results.in_parallel(4, run, commands) if words]
    ours, others, met = reports.findings(folder, suppressions)
    return {
        "what": what,
        "tool": tool,
        "runs": len(commands),
        "failed": len(failed),
        "ours": len(ours),
        "others": len(others),
        "known": met,
        "first": (ours + others)[:3],
        "said": failed[:3],
    }


def tutorial(povray, threads):
    return [
        povray_run.command(povray, scene, f"{scene.stem}.png", (48, 36), f"+WT{threads}", "+BS8", library=[povray_run.INCLUDE])
        for scene in TUTORIAL
    ]


def lit(povray, threads, work):
    commands = []
    for name, world in LIT.items():
        scene = work / f"{name}.pov"
        scene.write_text(
            "#version 3.7; global_settings { assumed_gamma 1 }\n"
            + scenes.camera("tilt 4 swing 2", samples="blur_samples 16, 64 ")
            + world
            + scenes.WORLD
        )
        commands.append(povray_run.command(povray, scene, f"{name}.png", (64, 48), f"+WT{threads}", "+BS8"))
    return commands


def battery(povray, tree, module):
    return [module_command(f"tests.render.test_{module}", "--povray", povray, "--compare", tree / "tests" / "tools" / "compare")]


def parser(povray):
    cases = sorted((ROOT / "tests" / "parse" / "cases").glob("*.txt"))
    return [module_command("tests.parse.check_messages", "--povray", povray, path) for path in cases]


def valgrind(setup, folder, work):
    log = folder / "log.valgrind"
    command = [
        "valgrind",
        f"--log-file={log}",
        f"--suppressions={reports.SUPPRESSIONS}/valgrind.txt",
        "--error-exitcode=0",
        *tutorial(setup.povray, 1)[0],
    ]
    return watched(TUTORIAL[0].name, "valgrind", [command], folder, work)


def groups(tree, tool, threads, work):
    """(words, commands, options). The first case shows that findings are detected."""
    return [
        ("a tutorial scene, nothing suppressed", lambda povray: tutorial(povray, threads)[:1], ""),
        ("tutorial scenes", lambda povray: tutorial(povray, threads), ""),
        ("parser battery", parser, f"+WT{threads}"),
        (", ".join(LIT), lambda povray: lit(povray, threads, work), ""),
        *((f"tests/render/test_{module}.py", lambda povray, module=module: battery(povray, tree, module), "") for module in MODULES),
    ]


def program_rows(setup, tree, tool, threads):
    rows, program = [], tree / "bin" / "povray"
    for number, (what, commands, options) in enumerate(groups(tree, tool, threads, setup.work("sanitizers"))):

        def run(what=what, commands=commands, options=options, number=number):
            with tempfile.TemporaryDirectory(prefix="tilt_lens.") as name:
                folder = pathlib.Path(name)
                povray = listener(program, folder, options)
                return watched(what, tool, commands(povray), folder, folder, suppressions=number > 0)

        rows.append(
            results.once(
                setup.work("sanitizers"),
                f"{tree.name}{number}",
                [program, __file__, reports.__file__, *sorted(reports.SUPPRESSIONS.iterdir())],
                run,
                lambda row: faults({"rows": [row]}),
            )
        )
    return rows


def measure(setup):
    rows = []
    for preset, tool, threads in (("fuzz", "ASan, UBSan", 2), ("tsan", "TSan", 4)):
        rows += program_rows(setup, build(setup, preset), tool, threads)
    with tempfile.TemporaryDirectory(prefix="tilt_lens.") as name:
        rows.append(valgrind(setup, pathlib.Path(name), pathlib.Path(name)))
    return {"rows": rows}


def faults(result):
    found = []
    for row in result["rows"]:
        if row["what"].endswith("nothing suppressed"):
            found += [f"{row['tool']} finds nothing where it must"] if not row["others"] else []
        elif row["ours"] or row["others"] or row["failed"]:
            found.append(f"{row['what']}, {row['tool']}: {row}")
    return found
