"""Builds the project in Consumer/ the ways a user would, and compares what it prints.

Every way must print what the build under test prints, to the bit, and no compiler flag of this
repository may show in the consumer's commands. Installed headers give no warning. The variants:

  static        find_package on the installed build under test, moved after installation
  fast          the same, by a consumer with -O3 -march=native -ffast-math
  configured    add_subdirectory, without a build: it leaves the project's settings and flags alone
  subproject    the same, built unoptimised
  fastproject   add_subdirectory by a project with -O3 -march=native -ffast-math
  shared        find_package on a shared library
  plain         find_package on a library built file by file, with no optional dependency
  P4est         find_package on the installed build with this component, by an MPI program
  Render, Repair, Scene    the same with that component
"""
import argparse
import json
import pathlib
import re
import shlex
import shutil
import subprocess
import sys

FAST = "-O3 -march=native -ffast-math"
CAREFUL = ("-Wall -Wextra -Wpedantic -Wconversion -Wsign-conversion -Wshadow -Wold-style-cast "
           "-Werror").split()
NO_DEPENDENCIES = ["-DCUTWATER_UNITY=OFF", "-DCUTWATER_PRECOMPILE=OFF", "-DCUTWATER_OPENMP=OFF", "-DCUTWATER_ZLIB=OFF",
                   "-DCUTWATER_EXPAT=OFF", "-DCUTWATER_RENDER=OFF",
                   "-DCUTWATER_SCENE=OFF"]
LIBRARY_ONLY = ["-DCUTWATER_BUILD_TOOLS=OFF", "-DCUTWATER_BUILD_TESTS=OFF",
                "-DCUTWATER_BUILD_EXAMPLES=OFF"]


class Failure(Exception):
    pass


def run(*command):
    words = [str(word) for word in command]
    done = subprocess.run(words, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    if done.returncode != 0:
        raise Failure(f"{shlex.join(words)} failed:\n{done.stdout}")
    return done.stdout


def configure(source, build, compiler, *options):
    if shutil.which("ccache"):
        options += ("-DCMAKE_CXX_COMPILER_LAUNCHER=ccache",)
    run("cmake", "-S", source, "-B", build, "-G", "Ninja", f"-DCMAKE_CXX_COMPILER={compiler}",
        "-DCMAKE_EXPORT_COMPILE_COMMANDS=ON", *options)


def check_flags(build, compiler, include, own):
    """The consumer's compiler sees our include folder and the standard we need, nothing else."""
    entries = json.loads((build / "compile_commands.json").read_text())
    entry = next(e for e in entries if e["file"].endswith("Consumer/main.cpp"))
    words = shlex.split(entry["command"])
    flags = words[words.index(compiler) + 1:words.index("-o")]
    for flag in own.split():
        flags.remove(flag)
    text = " ".join(flags)
    if not re.fullmatch(rf"-(I|isystem ){re.escape(str(include))} -std=(gnu|c)\+\+20", text):
        raise Failure(f"flags leak to the consumer: {text}")
    link = run("ninja", "-C", build, "-t", "commands", "Consumer").splitlines()[-1]
    leaked = set(re.findall(r"\s-[fmWO]\S+", link.replace(own, "", 1)))
    leaked = [flag for flag in leaked if not flag.strip().startswith("-Wl,-rpath")]
    if leaked or "-o Consumer" not in link:
        raise Failure(f"flags leak to the consumer's link: {leaked} in {link}")


def check_warnings(args, build, include, name, header):
    """To users with many warnings on, our headers have none to give, in g++ nor in clang."""
    entries = json.loads((build / "compile_commands.json").read_text())
    entry = next(e for e in entries if e["file"].endswith(f"Consumer/{name}"))
    words = shlex.split(entry["command"])
    flags = words[words.index(args.compiler) + 1:words.index("-o")]
    if str(include) not in flags:
        raise Failure(f"{name} does not see {include}: {shlex.join(flags)}")
    flags[flags.index(str(include)) - 1] = "-I"  # the compiler is silent about system headers
    others = (shutil.which(compiler) for compiler in ("g++", "clang++-14", "clang++"))
    for compiler in dict.fromkeys([args.compiler, *filter(None, others)]):
        run(compiler, *flags, *CAREFUL, "-fsyntax-only", "-include", header, entry["file"])


def check_c(build, include):
    """A C program: it sees the header's folder only, and gets its answers and errors."""
    entries = json.loads((build / "compile_commands.json").read_text())
    words = shlex.split(next(e for e in entries if e["file"].endswith("main.c"))["command"])
    flags = " ".join(words[1:words.index("-o")])
    if not re.fullmatch(rf"-(I|isystem ){re.escape(str(include))}", flags):
        raise Failure(f"flags leak to the C consumer: {flags}")
    run(build / "ConsumerC")


def check_inline_arithmetic(build):
    """Arithmetic of ours that a user's file emits as a weak symbol, in its own flavour, could
    replace the library's: see Core/Inline.hpp. There must be none."""
    binaries = list(build.glob("CMakeFiles/Consumer.dir/*.o"))
    symbols = run("objdump", "-t", "-C", *binaries)
    code = run("objdump", "-d", "-C", "--no-show-raw-insn", *binaries)
    weak = set(re.findall(r"^\S+ +w +F \S+\s+\S+ +(.*\bcutwater::.*)$", symbols, re.MULTILINE))
    arithmetic = re.compile(r"\b(v?(add|sub|mul|div|sqrt|min|max)[sp][sd]|vfn?m)")
    bad = [name
           for name, body in re.findall(r"^\S+ <(.*\bcutwater::.*)>:\n((?:.+\n)+)", code, re.MULTILINE)
           if name in weak and arithmetic.search(body)]
    if bad:
        raise Failure("mark as CUTWATER_INLINE, or move to a .cpp:\n  " + "\n  ".join(bad))


def configured(args, name, include, flags="", *options):
    build = args.work / f"consumer-{name}"
    configure(args.source / "Tests/Package/Consumer", build, args.compiler,
              f"-DCMAKE_CXX_FLAGS={flags}", *options)
    check_flags(build, args.compiler, include, flags)
    return build


def consumer(args, name, includes, reference, flags="", *options):
    build = configured(args, name, includes[0], flags, *options)
    run("cmake", "--build", build)
    check_c(build, includes[1])
    check_inline_arithmetic(build)
    printed = run(build / "Consumer")
    if printed != reference:
        ours, theirs = reference.splitlines(), printed.splitlines()
        where = next((i for i, (a, b) in enumerate(zip(ours, theirs)) if a != b),
                     min(len(ours), len(theirs)))
        raise Failure(f"{name}: other answers from line {where + 1} on:\n"
                      f"  this build: {ours[where:where + 1]}\n  consumer:   {theirs[where:where + 1]}")
    print(f"{name}: {len(printed.splitlines())} lines, the same to the bit", flush=True)


def install(args, build, name, *components):
    """Installs a build and moves the result: a package must not know where it was installed."""
    first, prefix = args.work / f"installed-{name}", args.work / f"moved-{name}"
    for component in ("Cutwater", *components):
        run("cmake", "--install", build, "--prefix", first, "--component", component)
    first.rename(prefix)
    for file in prefix.rglob("*.cmake"):
        for place in (args.source, args.build, first):
            if str(place) in file.read_text():
                raise Failure(f"{file} names {place}")
    return prefix


def build_library(args, name, *options):
    build = args.work / f"library-{name}"
    configure(args.source, build, args.compiler, "-DCMAKE_BUILD_TYPE=None", "-DCMAKE_CXX_FLAGS=-O1",
              *LIBRARY_ONLY, *options)
    run("cmake", "--build", build)
    return install(args, build, name)


def check_part(args, part):
    """A library of its own beside the main one."""
    name = part.lower()
    prefix = install(args, args.build, name, f"Cutwater{part}")
    build = args.work / f"consumer-{name}"
    configure(args.source / "Tests/Package/Consumer", build, args.compiler,
              f"-DCMAKE_PREFIX_PATH={prefix}", f"-DCUTWATER_PART={part}")
    run("cmake", "--build", build, "--target", "ConsumerOfPart")
    check_warnings(args, build, prefix / "include", f"{part}.cpp", f"Cutwater/{part}.hpp")
    print(f"{name}: {run(build / 'ConsumerOfPart').strip()}", flush=True)


def check_example(args, prefix):
    """The project that is shown to users."""
    build = args.work / "example"
    configure(args.source / "Examples/FindPackage", build, args.compiler, f"-DCMAKE_PREFIX_PATH={prefix}")
    run("cmake", "--build", build)
    print(f"Examples/FindPackage: {run(build / 'keel').strip()}", flush=True)


def check(args):
    shutil.rmtree(args.work, ignore_errors=True)
    args.work.mkdir(parents=True)
    reference = run(args.reference)

    def packaged(name, prefix, flags=""):
        consumer(args, name, [prefix / "include"] * 2, reference, flags, f"-DCMAKE_PREFIX_PATH={prefix}")

    as_subproject = f"-DCUTWATER_SOURCE={args.source}"

    def subproject(name, flags):
        consumer(args, name, [args.source / "Source", args.source / "Bindings/C"], reference, flags,
                 as_subproject)

    prefix = None
    for variant in args.variants:
        if variant in ("static", "fast") and prefix is None:
            prefix = install(args, args.build, "tested")
        if variant == "static":
            packaged(variant, prefix)
            for name in ("main.cpp", "Arithmetic.cpp"):
                check_warnings(args, args.work / "consumer-static", prefix / "include", name,
                               "Cutwater/Cutwater.hpp")
            check_example(args, prefix)
        elif variant == "fast":
            packaged(variant, prefix, FAST)
        elif variant == "configured":
            configured(args, variant, args.source / "Source", "", as_subproject)
            print("configured: settings and flags stay as they are", flush=True)
        elif variant == "subproject":
            subproject(variant, "")
        elif variant == "fastproject":
            subproject(variant, FAST)
        elif variant == "shared":
            packaged(variant, build_library(args, variant, "-DBUILD_SHARED_LIBS=ON"))
        elif variant == "plain":
            packaged(variant, build_library(args, variant, *NO_DEPENDENCIES))
        elif variant in ("P4est", "Render", "Repair", "Scene"):
            check_part(args, variant)
        else:
            raise Failure(f"no variant {variant}")


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--source", type=pathlib.Path, required=True)
    parser.add_argument("--build", type=pathlib.Path, required=True, help="the build under test")
    parser.add_argument("--reference", required=True, help="program whose answers are right")
    parser.add_argument("--compiler", required=True)
    parser.add_argument("--work", type=pathlib.Path, required=True, help="folder to work in")
    parser.add_argument("variants", nargs="+")
    try:
        check(parser.parse_args())
    except Failure as failure:
        sys.exit(str(failure))


main()
