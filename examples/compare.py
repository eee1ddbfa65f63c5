"""Runs an example and compares what it prints with what its opening comment says under "Prints".

usage: compare.py PROGRAM SOURCE
"""
import difflib
import subprocess
import sys


def promised(source):
    """The lines of the comment after "// Prints", without their "//   ", up to the end of the comment."""
    lines = []
    seen = False
    for line in open(source, encoding="utf-8"):
        if seen:
            if not line.startswith("//   "):
                break
            lines.append(line[5:].rstrip())
        seen = seen or line.startswith("// Prints")
    return lines


def main(program, source):
    wanted = promised(source)
    if not wanted:
        sys.exit(f'{source}: its comment has no "// Prints" with lines that start with "//   "')
    run = subprocess.run([program], capture_output=True, text=True, check=False, timeout=60)
    printed = [line.rstrip() for line in run.stdout.splitlines()]
    if run.returncode != 0:
        sys.exit(f"{program} ended with status {run.returncode}\n{run.stderr}")
    if printed != wanted:
        sys.exit("\n".join(difflib.unified_diff(wanted, printed, "promised in " + source, "printed", lineterm="")))
    print("\n".join(printed))


if __name__ == "__main__":
    main(*sys.argv[1:])
