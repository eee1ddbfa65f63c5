#!/usr/bin/env python3
"""offline.py ROOT SITE: what makes the site one that is kept by a browser: SITE/service_worker.js, with the version of
all that the site has and the list of the pages that are kept at the first visit, and SITE/manifest.webmanifest."""

import hashlib
import json
import pathlib
import sys

NOT_KEPT_AT_ONCE = ('single/', 'service_worker.js')
OF_APPS = ('.wasm', '.data')  # large, kept when the app is opened


def files_of(site):
    return {path.relative_to(site).as_posix(): path for path in sorted(site.rglob('*')) if path.is_file()}


def version(files):
    """Another one whenever any file is another."""
    whole = hashlib.sha256()
    for name, path in files.items():
        if name != 'service_worker.js':
            whole.update(name.encode() + b'\0' + hashlib.sha256(path.read_bytes()).digest())
    return whole.hexdigest()[:16]


def kept_at_once(files):
    programs = {name.removesuffix('.wasm') + '.js' for name in files if name.endswith('.wasm')}
    return [name for name in files
            if not name.startswith(NOT_KEPT_AT_ONCE) and not name.endswith(OF_APPS) and name not in programs]


def manifest():
    return {
        'name': 'Cremona: structural analysis that teaches',
        'short_name': 'Cremona',
        'start_url': 'index.html',
        'display': 'standalone',
        'background_color': '#ffffff',
        'icons': [{'src': 'pictures/cremona-frame.svg', 'sizes': 'any', 'type': 'image/svg+xml'}],
        'shortcuts': [{'name': app.capitalize(), 'url': f'{app}.html',
                       'icons': [{'src': f'pictures/cremona-{app}.svg', 'sizes': 'any', 'type': 'image/svg+xml'}]}
                      for app in ('frame', 'plane', 'cross', 'mohr', 'euler')],
    }


def write(root, site):
    (site / 'manifest.webmanifest').write_text(json.dumps(manifest(), indent=1), encoding='utf-8')
    files = files_of(site)
    worker = (root / 'apps/web/service_worker.js').read_text(encoding='utf-8')
    worker = worker.replace('@version@', version(files)).replace('@pages@', json.dumps(kept_at_once(files)))
    (site / 'service_worker.js').write_text(worker, encoding='utf-8')


if __name__ == '__main__':
    write(pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2]))
