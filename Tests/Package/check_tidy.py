"""clang-tidy over the files that differ from the branch this work started on, or, with
CUTWATER_TIDY=all in the environment, over all. Usage: check_tidy.py SOURCE BUILD CLANG_TIDY

A header is checked through the .cpp beside it, or else through the file that includes it alone.
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


def units(source, build):
    """What to compile for each source file of ours: itself, or a stand-in for a header."""
    files = {pathlib.Path(entry["file"])
             for entry in json.loads((build / "compile_commands.json").read_text())}
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


def configured_plainly(source, build):
    """Configures the build once more in a folder of its own, file by file and without precompiled
    headers, which are another compiler's; nothing is built there."""
    kept = re.findall(r"^((?:CUTWATER_|CMAKE_BUILD_TYPE|CMAKE_CXX_)\w*:\w+=.*)$",
                      (build / "CMakeCache.txt").read_text(), re.MULTILINE)
    folder = build / "tidy"
    subprocess.run(["cmake", "-S", source, "-B", folder, "-G", "Ninja", *(f"-D{entry}" for entry in kept),
                    "-DCMAKE_EXPORT_COMPILE_COMMANDS=ON", "-DCUTWATER_UNITY=OFF",
                    "-DCUTWATER_PRECOMPILE=OFF"], check=True, capture_output=True)
    return folder


def main():
    source, build = (pathlib.Path(word).resolve() for word in sys.argv[1:3])
    program = sys.argv[3] if len(sys.argv) > 3 else ""
    if not pathlib.Path(program).is_file():
        print("skipped: no clang-tidy here")
        sys.exit(SKIPPED)
    build = configured_plainly(source, build)
    compiled = units(source, build)
    wanted = None if os.environ.get("CUTWATER_TIDY") == "all" else changed(source)
    if wanted is None:  # headers are seen through the files that include them
        files = sorted(file for file, unit in compiled.items() if file == unit)
    else:
        files = sorted({unit for file, unit in compiled.items() if file in wanted})
    print(f"{len(files)} files")

    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        command = [program, "-p", build, "--quiet"]
        results = list(pool.map(
            lambda file: subprocess.run([*command, file], capture_output=True, text=True), files))
    failed = [result.stdout for result in results if result.returncode != 0]
    print("\n".join(failed) or "clean")
    sys.exit(bool(failed))


main()
