"""page_test.py SITE [PICTURES]: the pages in a real browser, by mouse and keyboard. Each test has a page of its own."""

import functools
import http.server
import json
import pathlib
import sys
import tempfile
import threading
import unittest

from browser import Browser
from well_formed import PageReader, leads_nowhere

SITE = pathlib.Path(sys.argv.pop(1)) if len(sys.argv) > 1 else pathlib.Path('build/web/site')
PICTURES = pathlib.Path(sys.argv.pop(1)) if len(sys.argv) > 1 else pathlib.Path(tempfile.mkdtemp())
APPS = ('frame', 'plane', 'cross', 'mohr', 'euler')
B, D = (392, 349), (774, 564)  # nodes of the portal frame in a page of 1280 x 800 [px]


class Quiet(http.server.SimpleHTTPRequestHandler):
    def log_message(self, *_):
        pass


class Pages(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        handler = functools.partial(Quiet, directory=str(SITE))
        cls.server = http.server.ThreadingHTTPServer(('127.0.0.1', 0), handler)
        threading.Thread(target=cls.server.serve_forever, daemon=True).start()
        cls.address = f'http://127.0.0.1:{cls.server.server_port}/'

    @classmethod
    def tearDownClass(cls):
        cls.server.shutdown()

    def picture(self, page, name):
        PICTURES.mkdir(parents=True, exist_ok=True)
        page.picture(PICTURES / f'{name}.png')

    def saved(self, page, name):
        """Saves the document as that file, and reads it from the page's memory."""
        page.key('S', ctrl=True, shift=True)
        page.wait(0.5)
        page.key('a', ctrl=True)
        page.type(f'/documents/{name}.json')
        page.key('Enter', text='\r')
        page.wait_for(f"FS.analyzePath('/documents/{name}.json').exists", 10)
        return json.loads(page.value(f"FS.readFile('/documents/{name}.json', {{ encoding: 'utf8' }})"))

    def test_every_app_opens_and_complains_of_nothing(self):
        for app in APPS:
            with self.subTest(app=app), Browser() as page:
                took = page.open(f'{self.address}{app}.html')
                print(f'{app}: {took:.1f} s until it draws')
                self.picture(page, app)
                self.assertEqual(page.complaints(), [])

    def test_a_member_is_drawn_by_two_clicks(self):
        with Browser() as page:
            page.open(f'{self.address}frame.html?open=/examples/portal.json')
            before = len(self.saved(page, 'before')['members'])
            page.key('m')
            page.click(*B)
            page.click(*D)
            page.key('Escape')
            page.move(640, 660)
            self.picture(page, 'member')
            self.assertTrue(page.value("document.title.startsWith('*')"))
            self.assertEqual(len(self.saved(page, 'after')['members']), before + 1)
            self.assertEqual(page.complaints(), [])

    def test_the_entrance_opens_an_example_at_one_click(self):
        with Browser() as page:
            page.read(f'{self.address}index.html')
            self.picture(page, 'entrance')
            loaded = "[...document.images].filter((image) => image.complete && image.naturalWidth > 0).length"
            page.value("document.querySelectorAll('img').forEach((image) => { image.loading = 'eager'; })")
            page.wait_for(f'{loaded} === document.images.length', 20)
            page.value("document.querySelector('.gallery a').click()")
            page.wait_for("document.title.includes('portal.json') && document.title.includes('\u2013')")
            self.assertEqual(page.complaints(), [])

    def test_who_speaks_portuguese_is_met_in_portuguese(self):
        with Browser(language='pt-BR') as page:
            page.read(f'{self.address}index.html')
            page.wait_for("document.documentElement.lang === 'pt-BR'", 10)
            page.value("document.querySelector('header a').click()")
            page.wait_for("document.documentElement.lang === 'en'", 10)
            page.wait(0.5)
            self.assertEqual(page.value('document.documentElement.lang'), 'en')

    def test_every_link_of_every_page_that_is_read_leads_somewhere(self):
        names = [path.relative_to(SITE).as_posix() for path in SITE.rglob('*.html') if path.parent.name != 'single']
        self.assertGreater(len(names), 30)
        for name in names:
            text = (SITE / name).read_text(encoding='utf-8')
            with self.subTest(page=name):
                self.assertEqual(leads_nowhere(SITE, name, text), [])
                self.assertEqual(PageReader(text).faults, [])

    def test_nothing_is_asked_of_another_machine(self):
        with Browser() as page:
            page.open(f'{self.address}frame.html')
            page.wait(1.0)
            others = [url for url in page.requests_made() if not url.startswith((self.address, 'blob:', 'data:'))]
            self.assertEqual(others, [])

    def test_what_was_saved_is_there_at_the_next_visit(self):
        with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as profile:
            with Browser(profile=profile) as page:
                page.open(f'{self.address}frame.html?open=/examples/truss.json')
                kept = self.saved(page, 'kept')
                page.value('new Promise((done) => FS.syncfs(false, done))')
                page.wait(1.0)
            with Browser(profile=profile) as page:
                page.open(f'{self.address}frame.html?open=/documents/kept.json')
                self.assertIn('kept.json', page.value('document.title'))
                again = page.value("FS.readFile('/documents/kept.json', { encoding: 'utf8' })")
                self.assertEqual(json.loads(again), kept)

    def test_the_single_file_opens_from_the_disk(self):
        for app in APPS:
            with self.subTest(app=app), Browser() as page:
                took = page.open((SITE / 'single' / f'{app}.html').resolve().as_uri())
                print(f'{app}: {took:.1f} s until its single file draws')
                self.picture(page, f'{app}_single')
                self.assertEqual(page.complaints(), [])


if __name__ == '__main__':
    unittest.main(verbosity=2)
