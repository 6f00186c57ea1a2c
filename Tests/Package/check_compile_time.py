"""Fails if a user's file that includes one of our headers takes much longer than the standard library.

Usage: check_compile_time.py SOURCE COMPILER. The yardstick is a file that includes <filesystem> and
<functional>, as readers of files and bodies of loops have to: about a second on a slow machine. CPU
time, so that other work on the machine counts little; yardstick and header are timed in turns, and
what seems slow is timed again, so that a cold disk or a slow minute does not count.
"""
import pathlib
import resource
import subprocess
import sys

LIMIT = 1.75  # times the yardstick; the heaviest is at 1.4
HEADERS = ["Sdf/Solid.hpp", "Shapes/Sphere.hpp", "Operations/Algebra.hpp", "Bvh/LinearBVH.hpp",
           "Surface/ReadSurface.hpp", "Mesh/DcelSDF.hpp", "Mesh/MeshSDF.hpp", "Grid/Fill.hpp"]


def cpu_seconds(command, *headers):
    text = "".join(f"#include <{header}>\n" for header in headers) + "int main() {}\n"
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    subprocess.run(command, input=text, text=True, check=True)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def main():
    source, compiler = pathlib.Path(sys.argv[1]) / "Source", sys.argv[2]
    command = [compiler, "-std=c++20", "-O2", f"-I{source}", "-c", "-x", "c++", "-", "-o", "/dev/null"]
    slow = []
    for header in HEADERS:
        yardstick, seconds = float("inf"), float("inf")
        for _ in range(3):
            yardstick = min(yardstick, cpu_seconds(command, "filesystem", "functional"))
            seconds = min(seconds, cpu_seconds(command, f"Cutwater/{header}"))
            if seconds <= LIMIT * yardstick:
                break
        print(f"{header}: {seconds:.2f} s, {seconds / yardstick:.2f} times the standard library's {yardstick:.2f} s")
        if seconds > LIMIT * yardstick:
            slow.append(header)
    if slow:
        sys.exit(f"more than {LIMIT} times the standard library: {' '.join(slow)}")


main()
