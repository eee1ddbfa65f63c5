#!/usr/bin/env python3
"""single_file.py SITE APP OUTPUT: the page of an app with all that it needs in one file, which opens from a disk without a
server. Program and files are compressed inside."""

import base64
import gzip
import json
import pathlib
import re
import string
import sys

# Five letters of 85 hold four bytes, with "/" for the "<" that Python takes: a page's text is nowhere cut by it.
LETTERS = string.digits + string.ascii_uppercase + string.ascii_lowercase + '!#$%&()*+-;/=>?@^_`{|}~'

UNPACK = 'const letters = ' + json.dumps(LETTERS) + ''';
function bytesOf(text) {
    const values = new Uint8Array(128);
    [...letters].forEach((letter, value) => { values[letter.charCodeAt(0)] = value; });
    const bytes = new DataView(new ArrayBuffer(4 * Math.ceil(text.length / 5)));
    for (let i = 0; i < text.length; i += 5) {
        let number = 0;
        for (let j = i; j < i + 5; ++j) number = 85 * number + (j < text.length ? values[text.charCodeAt(j)] : 84);
        bytes.setUint32(i / 5 * 4, number);
    }
    return new Uint8Array(bytes.buffer, 0, Math.floor(text.length * 4 / 5));
}
async function unpacked(id) {
    const bytes = new Blob([bytesOf(document.getElementById(id).textContent)]).stream().pipeThrough(new DecompressionStream('gzip'));
    return new Response(bytes).arrayBuffer();
}
async function begin() {
    if (typeof DecompressionStream === 'undefined') return tell(texts.old);
    const files = await unpacked('files');
    Module.getPreloadedPackage = () => files;
    Module.packedPortuguese = async () => new TextDecoder().decode(await unpacked('portuguese'));
    Module.wasmBinary = await unpacked('wasm');
    const program = document.createElement('script');
    program.textContent = new TextDecoder().decode(await unpacked('program'));
    document.body.append(program);
}
begin();
'''


def packed(part, path):
    text = base64.b85encode(gzip.compress(path.read_bytes(), 9, mtime=0)).replace(b'<', b'/').decode()
    return f'<script type="text/plain" id="{part}">{text}</script>\n'


def single_file(site, app):
    page = (site / f'{app}.html').read_text(encoding='utf-8')
    page = re.sub(r"script-src 'self'", "script-src 'unsafe-inline'", page)
    page = page.replace("connect-src 'self'", "connect-src 'none'")
    page = page.replace("; manifest-src 'self'; worker-src 'self'", '')
    for line in ('<link rel="manifest" href="manifest.webmanifest">\n', '<script src="offline.js"></script>\n'):
        page = page.replace(line, '')
    page = page.replace('<a href="index.html">Cremona</a>\n', '<span>Cremona</span>\n')
    parts = [packed('files', site / f'{app}.data'), packed('wasm', site / f'{app}.wasm'),
             packed('program', site / f'{app}.js'), packed('portuguese', site / 'pt_BR.po')]
    for script in ('share.js', 'qr.js', 'embed.js', 'page.js'):
        text = (site / script).read_text(encoding='utf-8')
        page = page.replace(f'<script src="{script}"></script>\n', f'<script>\n{text}</script>\n')
    return page.replace(f'<script src="{app}.js"></script>\n', ''.join(parts) + f'<script>{UNPACK}</script>\n')


if __name__ == '__main__':
    folder, name, output = sys.argv[1:]
    path = pathlib.Path(output)
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(single_file(pathlib.Path(folder), name), encoding='utf-8')
