"""Fails if a user's file that includes one of our headers takes much longer than a second.

Usage: check_compile_time.py SOURCE COMPILER. CPU time, so that other work on the machine does not
count; what seems slow is timed again, so that a cold disk does not.
"""
import pathlib
import resource
import subprocess
import sys

LIMIT = 2.0  # seconds on a slow machine; about half of it on a fast one
HEADERS = ["Sdf/Solid.hpp", "Shapes/Sphere.hpp", "Operations/Algebra.hpp", "Bvh/LinearBVH.hpp",
           "Surface/ReadSurface.hpp", "Mesh/DcelSDF.hpp", "Mesh/MeshSDF.hpp", "Grid/Fill.hpp"]


def cpu_seconds(command, text):
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    subprocess.run(command, input=text, text=True, check=True)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def best(command, text):
    """The first time within the limit, or else the best of three."""
    seconds = cpu_seconds(command, text)
    for _ in range(2):
        if seconds <= LIMIT:
            break
        seconds = min(seconds, cpu_seconds(command, text))
    return seconds


def main():
    source, compiler = pathlib.Path(sys.argv[1]) / "Source", sys.argv[2]
    command = [compiler, "-std=c++20", "-O2", f"-I{source}", "-c", "-x", "c++", "-", "-o", "/dev/null"]
    empty = best(command, "int main() {}\n")
    slow = []
    for header in HEADERS:
        text = f"#include <Cutwater/{header}>\nint main() {{}}\n"
        seconds = best(command, text)
        print(f"{header}: {seconds:.2f} s ({empty:.2f} s of it for an empty file)")
        if seconds > LIMIT:
            slow.append(header)
    if slow:
        sys.exit(f"more than {LIMIT} s: {' '.join(slow)}")


main()
