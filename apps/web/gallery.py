#!/usr/bin/env python3
"""gallery.py ROOT SITE COMMAND...: the pictures of the entrance page, in SITE/pictures. COMMAND is the program cremona,
which draws the examples; what it does not draw is copied."""

import json
import pathlib
import shutil
import subprocess
import sys

SIZE = '640x400'
DONE = (0, 3)  # of a structure that can move cremona draws the motion, with the status 3


def entries(root):
    return json.loads((root / 'apps/web/gallery.json').read_text(encoding='utf-8'))


def picture_of(entry):
    """The name of its file in the site."""
    if 'picture' in entry:
        return pathlib.PurePath(entry['picture']).name
    return entry['example'].removesuffix('.json') + '.svg'


def draw(entry, root, output, command):
    words = [*command, 'render', str(root / 'examples' / entry['example']), '-o', str(output), '--size', SIZE,
             '--show', entry['show']]
    done = subprocess.run(words, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
    if done.returncode not in DONE or not output.is_file():
        sys.exit(f'gallery: {entry["example"]} was not drawn: {done.stderr}')
    output.chmod(0o644)  # under node it is its owner's alone


def write(root, site, command):
    folder = site / 'pictures'
    folder.mkdir(parents=True, exist_ok=True)
    for entry in entries(root):
        output = folder / picture_of(entry)
        if 'picture' in entry:
            shutil.copyfile(root / entry['picture'], output)
        else:
            draw(entry, root, output, command)
    for icon in root.glob('apps/*/cremona-*.svg'):
        shutil.copyfile(icon, folder / icon.name)


if __name__ == '__main__':
    write(pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2]), sys.argv[3:])
