# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Each patch in patches/fixes applies alone to Debian's source, and compiles.

usage: check_fixes.py apply|compile REPOSITORY WORK DOWNLOADS TARBALL=[FOLDER] [COMPILER COMPILE_COMMANDS]
   check_fixes.py master REPOSITORY CLONE

Prints each fault; the exit code is not 0 if there is one. "compile" checks touched files, or one that includes a touched header. "master"
applies each patch in patches/master to the commit that it names, in a clone of POV-Ray's GitHub repository.
"""

import json
import pathlib
import re
import shlex
import shutil
import subprocess
import sys
import tempfile

# folders of the installation, set by our build
FOLDERS = ['-DPOVLIBDIR="/usr/share/povray-3.7"', '-DPOVCONFDIR="/etc/povray/3.7"', '-DTILT_LENS_BUILD_NAME="a fix alone"']


def run(*command, folder=None):
    return subprocess.run(command, cwd=folder, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, errors="replace", check=False)


def debian_source(repository, work, downloads, tarball):
    shutil.rmtree(work, ignore_errors=True)
    (work / "none").mkdir(parents=True)
    (work / "none" / "series").write_text("", encoding="utf-8")
    settings = {"REPOSITORY": repository, "SERIES": work / "none", "WORK": work, "DOWNLOADS": downloads, "POVRAY_TARBALL": tarball}
    done = run("cmake", *(f"-D{name}={value}" for name, value in settings.items()), "-P", repository / "cmake" / "PrepareTree.cmake")
    if done.returncode != 0:
        sys.exit(done.stdout)
    return work / "povray"


def apply(patch, tree, *options):
    done = run(
        "patch", "-p1", "-F0", "-E", "--batch", "--no-backup-if-mismatch", "--reject-file=-", "--input", patch, *options, folder=tree
    )
    return done.stdout if done.returncode != 0 else ""


def touched(patch):
    text = patch.read_text(encoding="utf-8", errors="surrogateescape")
    return sorted(set(re.findall(r"^\+\+\+ b/(\S+)", text, re.MULTILINE)))


def to_compile(names, tree):
    sources = set()
    for name in names:
        path = tree / name
        if path.suffix == ".h":
            path = path.with_suffix(".cpp")
            if not path.is_file():
                users = (source for source in sorted(tree.rglob("*.cpp")) if f'/{pathlib.Path(name).name}"' in source.read_text("latin-1"))
                path = next(users, None)
        if path and path.suffix == ".cpp":
            sources.add(path)
    return sorted(sources)


def options(commands, target, build, tree):
    """A target's options, for this tree, without our files."""
    command = next(entry["command"] for entry in commands if f"/{target}.dir/" in entry["command"])
    words = iter(shlex.split(command))
    found = []
    for word in words:
        if word in ("-include", "-o", "-c"):
            next(words)
        elif word in ("-isystem", "-I"):
            found += [word, next(words)]
        elif re.match(r"-(I|D|f|std|W|w|pipe)", word):
            found.append(word)
    found = [word.replace(str(build / "upstream" / "povray"), str(tree)) for word in found]
    return [word for word in found if "povray-src" not in word and "prefix-map" not in word]


def faults_of_compilation(patch, tree, compiler, settings):
    for source in to_compile(touched(patch), tree):
        target = "povray_vfe" if source.relative_to(tree).parts[0] in ("vfe", "unix") else "povray_core"
        done = run(compiler, "-fsyntax-only", *settings[target], *FOLDERS, source, folder=tree)
        if done.returncode != 0:
            yield f"{patch.name}: {source.relative_to(tree)} does not compile:\n{done.stdout[-3000:]}"


def faults(kind, repository, tree, compiler=None, commands_file=None):
    settings = {}
    if kind == "compile":
        build = pathlib.Path(commands_file).parent
        commands = json.loads(pathlib.Path(commands_file).read_text(encoding="utf-8"))
        settings = {target: options(commands, target, build, tree) for target in ("povray_core", "povray_vfe")}
    patches = sorted((repository / "patches" / "fixes").glob("*.patch"))
    if not patches:
        yield "there is no patch in patches/fixes"
    for patch in patches:
        refused = apply(patch, tree, "--forward", *([] if settings else ["--dry-run"]))
        if refused:
            yield f"{patch.name} does not apply to Debian's source alone:\n{refused}"
        elif settings:
            yield from faults_of_compilation(patch, tree, compiler, settings)
            apply(patch, tree, "--reverse")


def faults_on_master(repository, clone):
    for patch in sorted((repository / "patches" / "master").glob("*.patch")):
        commit = re.search(r"master, ([0-9a-f]{10});", patch.read_text(encoding="utf-8", errors="surrogateescape")).group(1)
        with tempfile.TemporaryDirectory(prefix="tilt_lens.") as folder:
            git = ("git", "-C", clone)
            for name in touched(patch):
                shown = subprocess.run([*git, "show", f"{commit}:{name}"], stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, check=False)
                if shown.returncode == 0:
                    path = pathlib.Path(folder, name)
                    path.parent.mkdir(parents=True, exist_ok=True)
                    path.write_bytes(shown.stdout)
            refused = apply(patch, folder, "--forward")
        if refused:
            yield f"{patch.name} does not apply to {commit} alone:\n{refused}"


def told(found):
    for fault in found:
        print(fault)
    return 1 if found else 0


def main(arguments):
    if len(arguments) == 4 and arguments[1] == "master":
        return told(list(faults_on_master(pathlib.Path(arguments[2]).resolve(), arguments[3])))
    if len(arguments) not in (6, 8) or arguments[1] not in ("apply", "compile"):
        sys.exit(__doc__)
    repository, work = pathlib.Path(arguments[2]), pathlib.Path(arguments[3])
    tree = debian_source(repository, work, arguments[4], arguments[5].removeprefix("TARBALL="))
    found = list(faults(arguments[1], repository, tree, *arguments[6:]))
    shutil.rmtree(work)
    return told(found)


if __name__ == "__main__":
    sys.exit(main(sys.argv))
