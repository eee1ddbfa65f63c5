"""The fonts of a page (.cmake/web/Page.cmake) have every character that the programs write, and those of European names."""

import pathlib
import re
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
NAMES = 'Ångström Škoda Çengel Ćirković Łódź Þór Őrs Şahin Ștefan Ωmega Čapek Müller-Breslau Maxwell–Betti Navarro Núñez João'


def kept():
    text = (ROOT / '.cmake/web/Page.cmake').read_text(encoding='utf-8')
    listed = re.search(r'set\(characters\s+([0-9A-F,\s-]+)\)', text).group(1)
    ranges = [part.split('-') for part in re.split(r'[,\s]+', listed.strip())]
    return {chr(code) for part in ranges for code in range(int(part[0], 16), int(part[-1], 16) + 1)}


def written():
    """Each character of a text in quotes of the programs and their translation, with a file that has it."""
    found = {}
    for folder, kind in (('ui', '*.cpp'), ('ui', '*.h'), ('ui', '*.po'), ('apps', '*.cpp'), ('apps', '*.h'), ('femoop', '*.cpp'),
                         ('femoop', '*.h'), ('topology', '*.cpp'), ('examples', '*.json'), ('examples', '*.eul')):
        for path in (ROOT / folder).rglob(kind):
            for line in path.read_text(encoding='utf-8').splitlines():
                line = line if path.suffix == '.eul' else ''.join(re.findall(r'"(?:[^"\\]|\\.)*"', line))
                found.update((letter, path.relative_to(ROOT)) for letter in line)
    return found


class Characters(unittest.TestCase):
    def test_what_the_programs_write_is_in_the_fonts_of_a_page(self):
        letters, kept_ones = written(), kept() | {'\t'}
        self.assertGreater(len(letters), 150)
        self.assertEqual({letter: str(path) for letter, path in letters.items() if letter not in kept_ones}, {})

    def test_european_names_are_in_the_fonts_of_a_page(self):
        self.assertEqual(set(NAMES) - kept(), set())


if __name__ == '__main__':
    unittest.main()
