"""kernel_symbols_test.py NM OBJECT...: what is compiled for one kind of processor shares no function with the others.

A linker keeps one of several functions of one name: one compiled for AVX2 would then run on every machine.
"""
import subprocess
import sys

nm, *objects = sys.argv[1:]
shared = {}
for name in objects:
    lines = subprocess.run([nm, "--defined-only", "--extern-only", "--demangle", name],
                           capture_output=True, text=True, check=True).stdout.splitlines()
    for symbol in {line.split(maxsplit=2)[2] for line in lines}:
        if not symbol.startswith("DW.ref."):  # a pointer to the personality routine, the same for all
            shared.setdefault(symbol, []).append(name)
    assert any("eliminate" in line for line in lines), f"{name} has no kernel"
twice = sorted(symbol for symbol, names in shared.items() if len(names) > 1)
sys.exit("defined in more than one kernel:\n  " + "\n  ".join(twice) if twice else 0)
