"""The entrance page: the same in both languages, and each picture opens what it shows."""

import pathlib
import re
import sys
import tempfile
import unittest
import urllib.parse

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / 'apps/web'))
sys.path.insert(0, str(ROOT / 'tests/web'))

import entrance  # noqa: E402
import gallery  # noqa: E402
from courseware_pages import app_of  # noqa: E402
from well_formed import PageReader, leads_nowhere  # noqa: E402


class Entrance(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.site = pathlib.Path(cls.folder.name)
        entrance.write(ROOT, cls.site)
        cls.texts = {language: (cls.site / name).read_text(encoding='utf-8')
                     for language, name in entrance.PAGES.items()}
        cls.read = {language: PageReader(text) for language, text in cls.texts.items()}

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def test_it_is_well_formed_and_says_its_language(self):
        for language, page in self.read.items():
            self.assertEqual(page.faults, [])
            self.assertIn(('html', {'lang': entrance.OF_HTML[language]}), page.tags)

    def test_both_languages_have_the_same_parts(self):
        parts = [[tag for tag, _ in page.tags] for page in self.read.values()]
        self.assertEqual(parts[0], parts[1])
        self.assertEqual(*(set(texts) for texts in entrance.TEXTS.values()))

    def test_every_app_and_every_example_is_there_in_its_language(self):
        for language, page in self.read.items():
            opened = [urllib.parse.urlsplit(link) for link in page.links
                      if '.html?' in link and not link.startswith('index')]
            self.assertEqual(len(opened), len(entrance.APPS) + len(gallery.entries(ROOT)))
            self.assertEqual({link.path for link in opened}, {f'{app}.html' for app in entrance.APPS})
            for link in opened:
                self.assertEqual(urllib.parse.parse_qs(link.query)['lang'], [language])

    def test_each_example_is_a_file_that_its_app_opens(self):
        for entry in gallery.entries(ROOT):
            with self.subTest(entry=entry):
                self.assertEqual(set(entry) - {'example', 'show', 'picture'}, {'app', 'en', 'pt_BR'})
                self.assertNotEqual('show' in entry, 'picture' in entry)
                if 'picture' in entry:
                    self.assertTrue((ROOT / entry['picture']).is_file())
                if 'example' in entry:
                    opens = app_of(ROOT / 'examples' / entry['example'])
                    self.assertIn(entry['app'], ('frame', 'cross') if opens == 'frame' else (opens,))

    def test_every_link_leads_somewhere(self):
        for folder, names in (('pictures', map(gallery.picture_of, gallery.entries(ROOT))),
                              ('pictures', (f'cremona-{app}.svg' for app in entrance.APPS)),
                              ('single', (f'{app}.html' for app in entrance.APPS)),
                              ('courseware', ['index.html']),
                              ('courseware', (path.stem + '.html' for path in (ROOT / 'courseware').glob('*.md'))),
                              ('', (f'{app}.html' for app in entrance.APPS)),
                              ('', ['site.css', 'entrance.js', 'offline.js', 'manifest.webmanifest'])):
            (self.site / folder).mkdir(exist_ok=True)
            for name in names:
                (self.site / folder / name).touch()
        lost = [link for language, text in self.texts.items()
                for link in leads_nowhere(self.site, entrance.PAGES[language], text)]
        self.assertEqual(lost, [])

    def test_all_lessons_are_listed(self):
        listed = [link for link in self.read['en'].links if re.match(r'courseware/\d', link)]
        self.assertEqual(len(listed), len(list((ROOT / 'courseware').glob('[0-9]*.md'))))


if __name__ == '__main__':
    unittest.main(verbosity=2)
