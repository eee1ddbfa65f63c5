#!/usr/bin/env python3
"""join.py OUTPUT FILE...: the translations that a page fetches, without comments, with a form feed between two files."""

import pathlib
import sys


def without_comments(text):
    return '\n'.join(line for line in text.split('\n') if line and not line.startswith('#'))


if __name__ == '__main__':
    output, *files = map(pathlib.Path, sys.argv[1:])
    output.parent.mkdir(parents=True, exist_ok=True)
    texts = [without_comments(file.read_text(encoding='utf-8')) for file in files]
    output.write_text('\f'.join(texts), encoding='utf-8')
