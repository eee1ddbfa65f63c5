"""What a source reads, and what has passed a check before. Shared by .ci/lone_headers and .ci/naming."""
import functools
import hashlib
import os
import re
import subprocess
import sys
import time
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
INCLUDE = re.compile(rb'^[ \t]*#[ \t]*include[ \t]*([<"])([^>"\n]+)[>"]', re.MULTILINE)
MONTH = 30 * 24 * 3600  # [s]
BASE = "fe4e9e9ff94a0952a5a0967674869a590a529d3a"  # a commit all of whose files have passed all checks


@functools.cache
def contents(path):
    return path.read_bytes()


@functools.cache
def included(path):
    """The files of ours that `path` includes, and the names of others, whatever the conditions around them say."""
    ours, others = [], []
    for bracket, name in INCLUDE.findall(contents(path)):
        name = name.decode()
        places = [] if bracket == b"<" else [path.parent / name, ROOT / name]
        found = next((place for place in places if place.is_file()), None)
        if found:
            ours.append(found)
        else:
            others.append(name)
    return tuple(ours), tuple(others)


@functools.cache
def read_by(path):
    """All files of ours that `path` reads, itself among them, and the names of all others that these include."""
    files, names, waiting = set(), set(), [path]
    while waiting:
        file = waiting.pop()
        if file in files:
            continue
        files.add(file)
        ours, others = included(file)
        names.update(others)
        waiting.extend(ours)
    return frozenset(files), frozenset(names)


def size_of(path):
    """Of all files of ours that `path` reads."""
    return sum(len(contents(file)) for file in read_by(path)[0])


class Compiler:
    """A compiler with its flags, which knows what files the headers of others consist of."""

    def __init__(self, command):
        self.command = tuple(command)  # with neither input nor output
        self.identity = _version(self.command[0])

    def files_of(self, names):
        """The files that including these headers of others reads."""
        return frozenset().union(*(_files_of(name, self._where_to_look()) for name in names))

    @functools.cache
    def _where_to_look(self):
        words = self.command
        flags = [word for word in words if word.startswith(("-I", "-std="))]
        for flag, folder in zip(words, words[1:]):
            if flag == "-isystem":
                flags += [flag, folder]
        return (words[0], *flags)


@functools.cache
def _version(program):
    return subprocess.run([program, "--version"], capture_output=True, check=True).stdout


@functools.cache
def _files_of(name, command):
    asked = subprocess.run([*command, "-M", "-w", "-x", "c++", "-"], input=f"#include <{name}>\n",
                           capture_output=True, text=True, check=False)
    # One that is not installed stands under a condition; its name is part of the key all the same.
    return frozenset(asked.stdout.replace("\\\n", " ").split()[1:]) - {"-"} if asked.returncode == 0 else frozenset()


def key_of(compiler, path):
    """Changes with what decides whether `path` has in sight what it uses: the compiler, its flags, the file itself, and
    what it reads and what that includes. Whether a name is still there in what it reads is seen by all that compile it."""
    ours, others = read_by(path)
    digest = hashlib.sha256(compiler.identity)
    for word in compiler.command:
        digest.update(word.replace(str(ROOT), "").encode() + b"\0")
    for file in sorted(ours):
        text = contents(file) if file == path else repr(INCLUDE.findall(contents(file))).encode()
        digest.update(str(file).replace(str(ROOT), "").encode() + b"\0" + hashlib.sha256(text).digest())
    for name in sorted(others):
        digest.update(name.encode() + b"\0")
    for file in sorted(compiler.files_of(others)):
        state = os.stat(file)
        digest.update(f"{file} {state.st_size} {state.st_mtime_ns}\0".encode())
    return digest.hexdigest()


def git(*words):
    """What it prints; nothing where it refuses."""
    return subprocess.run(["git", *words], cwd=ROOT, capture_output=True, check=False).stdout


@functools.cache
def same_as_in_base():
    """The paths of what is as it was in the base; nothing where this clone does not know it."""
    changed = set(git("diff", "--name-only", BASE).decode().splitlines())
    return set(git("ls-tree", "-r", "--name-only", BASE).decode().splitlines()) - changed


@functools.cache
def includes_as_in_base(path):
    """Whether a file of ours has the includes that it had there."""
    name = str(path.relative_to(ROOT))
    return name in same_as_in_base() or INCLUDE.findall(git("show", f"{BASE}:{name}")) == INCLUDE.findall(contents(path))


class Passed:
    """The keys of what passed: an empty file each, dropped when nothing has asked for it for a month."""

    def __init__(self, check):
        cache = os.environ.get("XDG_CACHE_HOME") or Path.home() / ".cache"
        self.folder = Path(cache) / "cremona" / "passed" / check
        try:
            self.folder.mkdir(parents=True, exist_ok=True)
        except OSError:  # a home that cannot be written to
            self.folder = ROOT / "build" / "passed" / check
            self.folder.mkdir(parents=True, exist_ok=True)
        for file in self.folder.iterdir():
            if time.time() - file.stat().st_mtime > MONTH:
                file.unlink(missing_ok=True)

    def __contains__(self, key):
        try:
            os.utime(self.folder / key)
        except FileNotFoundError:
            return False
        return True

    def add(self, key):
        (self.folder / key).touch()

    def new_among(self, keyed, name):
        """Those of which each has a `key` that has not passed."""
        new = [one for one in keyed if one.key not in self]
        print(f"{name}: {len(new)} of {len(keyed)} are new or changed since they passed", flush=True)
        return new


@dataclass
class Check:
    what: str
    key: str  # see key_of
    cost: int  # to be compared with that of others
    run: Callable[[], tuple[bool, str]]  # whether it passed, and what there is to say
    along: frozenset[str] = frozenset()  # the keys of what has passed when it has


def run_checks(name, checks, passed):
    """Runs them, the costly first, remembers those that passed, and returns whether all did."""

    def run(check):
        is_passed, words = check.run()
        if is_passed:
            for key in {check.key} | check.along:
                passed.add(key)
        if not is_passed:
            words += f"{name}: {check.what} failed\n"
        sys.stdout.write(words)
        sys.stdout.flush()
        return is_passed

    with ThreadPoolExecutor(os.cpu_count()) as pool:
        return all(list(pool.map(run, sorted(checks, key=lambda check: -check.cost))))
