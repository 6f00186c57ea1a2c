"""clang-tidy over the files that differ from the branch this work started on, or, with
CUTWATER_TIDY=all in the environment, over all. Usage: check_tidy.py SOURCE BUILD CLANG_TIDY

A header is checked through the .cpp beside it, or else through the file that includes it alone. All files
are checked several at once, as unity builds compile them: most of the time goes into headers.
"""
import concurrent.futures
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys

SKIPPED = 77  # ctest's SKIP_RETURN_CODE


def git(source, *words):
    if shutil.which("git") is None:
        return None
    done = subprocess.run(["git", "-C", source, *words], capture_output=True, text=True)
    return done.stdout.split("\n")[:-1] if done.returncode == 0 else None


def changed(source):
    """Files changed since the branch left main (or in the last commit, on main itself); None if
    there is no history to tell."""
    head = git(source, "rev-parse", "HEAD")
    if head is None:
        return None
    base = head
    for main in ("origin/main", "main"):
        base = git(source, "merge-base", "HEAD", main) or base
        if base != head:
            break
    if base == head:
        base = git(source, "rev-parse", "--verify", "-q", "HEAD~1")
    files = git(source, "diff", "--name-only", "--relative", base[0]) if base else None
    untracked = git(source, "ls-files", "--others", "--exclude-standard")
    return None if files is None else {source / name for name in files + (untracked or [])}


def compiled(build):
    return {pathlib.Path(entry["file"])
            for entry in json.loads((build / "compile_commands.json").read_text())}


def everything(source, build):
    """What the build compiles of ours; headers are seen through the files that include them."""
    return {file for file in compiled(build) if file.suffix != ".f90" and
            (build not in file.parents or file.parent.name == "Unity")}


def written_out(unity):
    """Replaces the includes in a file of a unity build by the files themselves, because the analyzer follows
    paths only through what stands in the file that is compiled. Returns where each line comes from."""
    text, origins = [], []
    for file in re.findall(r'^#include "(.*)"$', unity.read_text(), re.MULTILINE):
        lines = pathlib.Path(file).read_text().splitlines()
        text += lines
        origins += [(file, number) for number in range(1, len(lines) + 1)]
    unity.write_text("\n".join(text) + "\n")
    return origins


def check(command, file):
    """What clang-tidy has to say about a file; nothing if it is clean."""
    origins = written_out(file) if file.parent.name == "Unity" else []
    folders = {pathlib.Path(origin).parent for origin, _ in origins}  # of headers included by name alone
    done = subprocess.run([*command, *(f"--extra-arg=-I{folder}" for folder in sorted(folders)), file],
                          capture_output=True, text=True)
    if done.returncode == 0:
        return ""
    return re.sub(rf"{re.escape(str(file))}:(\d+)",
                  lambda line: "{}:{}".format(*origins[int(line[1]) - 1]) if origins else line[0],
                  done.stdout or done.stderr)


def units(source, build):
    """What to compile for each source file of ours: itself, or a stand-in for a header."""
    files = compiled(build)
    result = {file: file for file in files
              if source in file.parents and build not in file.parents and file.suffix != ".f90"}
    alone = build / "Tests/Package/HeadersAlone"
    for file in files:
        if alone in file.parents:
            header = file.relative_to(alone).with_suffix("")
            header = next(folder / header for folder in
                          (source / "Source" / part for part in ("", "P4est", "Render", "Repair", "Scene"))
                          if (folder / header).exists())
            beside = header.with_suffix(".cpp")
            result[header] = beside if beside in files else file
    return result


def configured_plainly(source, build, unity):
    """Configures the build once more in a folder of its own, without precompiled headers, which are
    another compiler's; nothing is built there."""
    kept = re.findall(r"^((?:CUTWATER_|CMAKE_BUILD_TYPE|CMAKE_CXX_)\w*:\w+=.*)$",
                      (build / "CMakeCache.txt").read_text(), re.MULTILINE)
    folder = build / "tidy" / ("unity" if unity else "files")
    subprocess.run(["cmake", "-S", source, "-B", folder, "-G", "Ninja", *(f"-D{entry}" for entry in kept),
                    "-DCMAKE_EXPORT_COMPILE_COMMANDS=ON", "-DCUTWATER_PRECOMPILE=OFF",
                    f"-DCUTWATER_UNITY={'ON' if unity else 'OFF'}"], check=True, capture_output=True)
    # What a unity build compiles stands in the folder of its target: the rules of that folder hold.
    for rules in source.rglob(".clang-tidy"):
        if build not in rules.parents:
            copy = folder / rules.relative_to(source)
            copy.parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(rules, copy)
    return folder


def main():
    source, build = (pathlib.Path(word).resolve() for word in sys.argv[1:3])
    program = sys.argv[3] if len(sys.argv) > 3 else ""
    if not pathlib.Path(program).is_file():
        print("skipped: no clang-tidy here")
        sys.exit(SKIPPED)
    wanted = None if os.environ.get("CUTWATER_TIDY") == "all" else changed(source)
    build = configured_plainly(source, build, unity=wanted is None)
    if wanted is None:
        files = sorted(everything(source, build))
    else:
        files = sorted({unit for file, unit in units(source, build).items() if file in wanted})
    print(f"{len(files)} files")

    command = [program, "-p", build, "--quiet"]
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        said = [text for text in pool.map(lambda file: check(command, file), files) if text]
    print("\n".join(said) or "clean")
    sys.exit(bool(said))


main()
