"""Scenarios (courseware/reference/scenarios.md) played by the mouse and the keyboard of a browser, and how far their
pictures lie from the golden ones. What a scenario expects of the app itself is left to the desktop: here pictures are
compared."""

import base64
import json
import pathlib
import re
import shlex

ROOT = pathlib.Path(__file__).resolve().parents[2]
KEYS = {'Esc': 'Escape', 'PageUp': 'PageUp', 'PageDown': 'PageDown', 'Enter': 'Enter', 'Tab': 'Tab', 'Delete': 'Delete',
        'Home': 'Home', 'End': 'End', 'Left': 'ArrowLeft', 'Right': 'ArrowRight', 'Up': 'ArrowUp', 'Down': 'ArrowDown',
        'Backspace': 'Backspace', **{f'F{n}': f'F{n}' for n in range(1, 13)}}

# How many of ten thousand pixels find none of about their colour at their place in the other picture, nor beside it.
DISTANCE = '''(async (one, other) => {
    const across = 1280, down = 800, near = 1, alike = 64; // pixels, and of 255 in each channel
    const pixels = async (kind, data) => {
        const image = new Image();
        image.src = `data:image/${kind};base64,${data}`;
        await image.decode();
        const canvas = document.createElement('canvas');
        [canvas.width, canvas.height] = [across, down];
        const context = canvas.getContext('2d', { willReadFrequently: true });
        context.drawImage(image, 0, 0);
        return context.getImageData(0, 0, across, down).data;
    };
    const [a, b] = [await pixels('png', one), await pixels('webp', other)];
    const isAlike = (p, q) => [0, 1, 2].every((i) => Math.abs(a[p + i] - b[q + i]) <= alike);
    let n = 0;
    for (let y = near; y < down - near; ++y)
        for (let x = near; x < across - near; ++x) {
            const here = 4 * (y * across + x);
            if (isAlike(here, here)) continue;
            let isThere = false, isBack = false;
            for (let dy = -near; dy <= near; ++dy)
                for (let dx = -near; dx <= near; ++dx) {
                    const there = here + 4 * (dy * across + dx);
                    isThere ||= isAlike(here, there);
                    isBack ||= isAlike(there, here);
                }
            if (!isThere || !isBack) ++n;
        }
    return n / across / down * 1e4;
})'''


def base64_of(path):
    return base64.b64encode(pathlib.Path(path).read_bytes()).decode()


class Player:
    """Plays scenarios in a page whose canvas is as large as the window of the golden pictures."""

    def __init__(self, page, pictures):
        self.page, self.pictures = page, pathlib.Path(pictures)
        page.value("document.body.classList.add('bare')")  # no foot
        page.wait(0.3)

    def play(self, name):
        """Returns the distance of each of its pictures."""
        distances = {}
        self.page.wait_for('!!Module.runCommand')
        self.page.move(1, 799)
        for line in (ROOT / f'tests/scenarios/{name}.scenario').read_text(encoding='utf-8').splitlines():
            step, _, rest = line.partition(' ')
            if step == 'picture':
                distances[rest] = self.distance(rest)
            elif step not in ('#', '', 'expect'):
                getattr(self, step)(rest)
        return distances

    def distance(self, name):
        self.page.wait(0.7)
        file = self.pictures / f'scenario_{name}.png'
        self.page.picture(file)
        golden = ROOT / f'tests/golden/pictures/{name}.webp'
        return self.page.value(f"{DISTANCE}('{base64_of(file)}', '{base64_of(golden)}')")

    def command(self, rest):
        name, _, argument = rest.partition(' ')
        if name == 'file.open':
            self.open(argument)
            return
        refused = self.page.value(f'Module.runCommand({json.dumps(name)}, {json.dumps(argument)})')
        if refused:
            raise AssertionError(f'{rest}: {refused}')
        self.page.wait(0.3)

    def open(self, name):
        """A file of the repository, as the page's button does."""
        path = f'/tmp/{pathlib.Path(name).name}'
        self.page.value(f"FS.writeFile('{path}', {json.dumps((ROOT / name).read_text(encoding='utf-8'))});"
                        f"Module.openedFiles.push('{path}')")
        self.page.wait_for(f"document.title.includes('{pathlib.Path(name).name}')", 10)
        self.page.wait(0.5)

    def key(self, rest):
        *held, key = rest.split('+') if len(rest) > 1 else [rest]
        name = KEYS.get(key, key if 'Shift' in held else key.lower())
        self.page.key(name, ctrl='Ctrl' in held, shift='Shift' in held)
        self.page.wait(0.3)

    def type(self, rest):
        self.page.type(shlex.split(rest)[0])

    def wait(self, rest):
        self.page.wait(float(rest) + 0.2)

    def hover(self, rest):
        self.page.move(*self.place(rest))

    def click(self, rest):
        self.page.click(*self.place(rest))

    @staticmethod
    def place(text):
        """In the window; of the model itself the page tells no places."""
        x, y = map(float, re.fullmatch(r'pixel (\S+) (\S+)', text).groups())
        return x, y
