"""page_test.py SITE [PICTURES]: the pages in a real browser, by mouse and keyboard. Each test has a page of its own."""

import base64
import functools
import http.server
import json
import pathlib
import re
import sys
import tempfile
import threading
import unittest
import urllib.parse
import zlib

from browser import Browser
from scenario import Player
from well_formed import PageReader, leads_nowhere

SITE = pathlib.Path(sys.argv.pop(1)) if len(sys.argv) > 1 else pathlib.Path('build/web/site')
PICTURES = pathlib.Path(sys.argv.pop(1)) if len(sys.argv) > 1 else pathlib.Path(tempfile.mkdtemp())
APPS = ('frame', 'plane', 'cross', 'mohr', 'euler')
SCENARIOS = ('diagrams', 'thrust', 'zero_bars', 'counting', 'palette', 'keys_sheet', 'projector', 'typical_inserted',
             'keyboard_only', 'plane/reactions', 'plane/range', 'cross/topics', 'cross/two_storeys_loads', 'mohr/exercise',
             'euler/cube', 'euler/faulty_script')
FARTHEST = 0.5  # of ten thousand pixels so many may differ from the picture of the desktop
B, D = (392, 349), (774, 564)  # nodes of the portal frame in a page of 1280 x 800 [px]


def fragment(data, version=1):
    return f'#m={version}.' + base64.urlsafe_b64encode(data).decode().rstrip('=')


def link(document):
    return fragment(zlib.compress(document.encode()))


class Quiet(http.server.SimpleHTTPRequestHandler):
    def log_message(self, *_):
        pass


class Pages(unittest.TestCase):
    @staticmethod
    def serve():
        server = http.server.ThreadingHTTPServer(('127.0.0.1', 0), functools.partial(Quiet, directory=str(SITE)))
        threading.Thread(target=server.serve_forever, daemon=True).start()
        return server, f'http://127.0.0.1:{server.server_port}/'

    @classmethod
    def setUpClass(cls):
        cls.server, cls.address = cls.serve()
        PICTURES.mkdir(parents=True, exist_ok=True)

    @classmethod
    def tearDownClass(cls):
        cls.server.shutdown()

    def picture(self, page, name):
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

    def test_fingers_draw_and_move_and_zoom(self):
        with Browser() as page:
            page.call('Emulation.setTouchEmulationEnabled', enabled=True, maxTouchPoints=2)
            page.open(f'{self.address}frame.html?open=/examples/portal.json')
            before = json.loads(page.value('Module.copyOfDocument()[0]'))
            self.picture(page, 'touch_before')
            page.touch('Start', (500, 420), (600, 420))
            for step in range(1, 9):  # apart, and to the left
                page.touch('Move', (500 - 15 * step, 420), (600 + 5 * step, 420))
            page.touch('End')
            self.picture(page, 'touch_zoomed')
            self.assertEqual(json.loads(page.value('Module.copyOfDocument()[0]')), before)
            page.key('m')
            page.tap(*B)
            page.tap(*D)
            page.key('Escape')
            after = json.loads(page.value('Module.copyOfDocument()[0]'))
            self.assertEqual(len(after['members']), len(before['members']) + 1)
            page.touch('Start', B)
            page.wait(1.0)
            page.touch('End')
            self.picture(page, 'touch_menu')
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
            page.wait_for("document.documentElement?.lang === 'pt-BR'", 10)
            page.value("document.querySelector('header a').click()")
            page.wait_for("document.documentElement?.lang === 'en'", 10)
            page.wait(0.5)
            self.assertEqual(page.value('document.documentElement?.lang'), 'en')

    def test_every_link_of_every_page_that_is_read_leads_somewhere(self):
        names = [path.relative_to(SITE).as_posix() for path in SITE.rglob('*.html') if path.parent.name != 'single']
        self.assertGreater(len(names), 30)
        for name in names:
            text = (SITE / name).read_text(encoding='utf-8')
            with self.subTest(page=name):
                self.assertEqual(leads_nowhere(SITE, name, text), [])
                self.assertEqual(PageReader(text).faults, [])

    def test_a_document_that_another_page_hands_over_is_opened(self):
        text = (SITE / '../page_files/examples/three_spans.json').read_text(encoding='utf-8')
        with Browser() as page:
            page.open(f'{self.address}frame.html')
            page.value(f'localStorage.setItem("cremona.handed.1", {json.dumps(text)})')
            page.open(f'{self.address}cross.html?handed=cremona.handed.1')
            self.assertIn('Continuous beam of three unequal spans', page.value('Module.copyOfDocument()[0]'))
            self.assertEqual(page.value('localStorage.length'), 0)

    def copied_link(self, page):
        page.value("document.getElementById('copy').click()")
        page.wait_for("document.getElementById('message').textContent !== ''", 10)
        self.assertIn('was copied', page.value("document.getElementById('message').textContent"))
        return page.value('navigator.clipboard.readText()')

    def test_a_link_opens_the_same_document_and_view_in_another_browser(self):
        with Browser() as page:
            page.open(f'{self.address}frame.html?open=/examples/portal.json&show=loads,V&lang=pt_BR')
            page.key('m')
            page.click(*B)
            page.click(*D)
            page.key('Escape')
            page.value("texts.copied = 'The link was copied'")  # it speaks Portuguese
            copied = self.copied_link(page)
            drawn = self.saved(page, 'drawn')
            self.picture(page, 'link_of')
        self.assertLess(len(copied), 3000)
        with Browser() as page:
            page.open(copied)
            self.picture(page, 'link_opened')
            self.assertIn('show=loads%2CV', page.value('location.search'))
            self.assertIn('lang=pt', page.value('location.search'))
            self.assertEqual(page.value('texts.copy'), 'Copiar link')
            self.assertEqual(self.saved(page, 'opened'), drawn)
            self.assertEqual(page.complaints(), [])

    def test_a_link_is_shown_as_a_code_for_a_telephone(self):
        with Browser() as page:
            page.open(f'{self.address}frame.html?open=/examples/truss.json')
            self.copied_link(page)
            page.value("document.querySelector('#message button').click()")
            page.wait(0.5)
            self.picture(page, 'code')
            self.assertTrue(page.value("document.getElementById('code').open"))
            self.assertGreater(page.value("document.querySelector('#code canvas').width"), 200)
            page.value("document.querySelector('#code button').click()")
            self.assertFalse(page.value("document.getElementById('code').open"))
            self.assertEqual(page.complaints(), [])

    def test_every_app_and_every_single_file_gives_a_link_that_it_opens(self):
        other = {'frame': 'truss.json', 'plane': 'dam.json', 'cross': 'three_spans.json', 'euler': 'torus.eul'}
        for app in APPS:
            for address in (f'{self.address}{app}.html', (SITE / 'single' / f'{app}.html').resolve().as_uri()):
                with self.subTest(address=address), Browser() as page:
                    page.open(address + (f'?open=/examples/{other[app]}' if app in other else ''))
                    document = page.value('Module.copyOfDocument()[0]')
                    copied = self.copied_link(page)
                    self.assertTrue(copied.startswith(address + '?lang=en'), copied)
                    page.open(copied)
                    self.assertEqual(page.value('Module.copyOfDocument()[0]'), document)
                    self.assertEqual(self.copied_link(page), copied)
                    self.assertEqual(page.complaints(), [])

    def test_a_link_that_is_no_good_opens_the_app_and_says_so(self):
        portal = link((SITE / '../page_files/examples/portal.json').read_text(encoding='utf-8'))
        for bad, words in ((portal[:200], 'cut off'), (portal.replace('#m=1', '#m=2'), 'later version'),
                           (fragment(zlib.compress(bytes(10 << 20))), 'too large'), ('#m=1.<b>', 'cut off')):
            with self.subTest(link=bad[:40]), Browser() as page:
                page.open(f'{self.address}frame.html{bad}')
                self.assertIn(words, page.value("document.getElementById('message').textContent"))
                self.assertEqual([text for text in page.complaints() if text.startswith('exception')], [])

    def test_what_a_document_holds_never_runs(self):
        script = '<img src=x onerror="window.ran = true"></script><script>window.ran = true</script>'
        model = json.loads((SITE / '../page_files/examples/portal.json').read_text(encoding='utf-8'))
        model['title'] = script
        model['notes'] = script
        for document in (json.dumps(model), script):
            with self.subTest(document=document[:30]), Browser() as page:
                page.open(f'{self.address}frame.html{link(document)}')
                page.wait(0.5)
                self.assertEqual('onerror' in page.value('Module.copyOfDocument()[0]'), document != script)
                self.assertIsNone(page.value('window.ran'))
                self.assertEqual(page.value("document.querySelectorAll('img').length"), 0)
        with Browser() as page:  # in the address; the program ends, and says why
            page.read(f'{self.address}frame.html?case={urllib.parse.quote(script)}{link(json.dumps(model))}x')
            page.wait(3.0)
            self.assertIsNone(page.value('window.ran'))

    def test_a_link_that_is_pasted_over_an_open_page_is_opened(self):
        with Browser() as page:
            page.open(f'{self.address}frame.html')
            text = (SITE / '../page_files/examples/truss.json').read_text(encoding='utf-8')
            page.value(f"window.before = true; location.hash = '{link(text)}'")
            page.wait_for("!window.before && document.title.includes('\u2013')")
            self.assertEqual(len(self.saved(page, 'pasted')['members']), len(json.loads(text)['members']))

    def test_what_was_visited_opens_without_a_network(self):
        server, address = self.serve()
        with Browser() as page:
            page.open(f'{address}frame.html?open=/examples/truss.json')
            page.wait_for("caches.keys().then((names) => names.length === 1)", 20)
            kept = "caches.keys().then((names) => caches.match('frame.wasm').then((found) => !!found))"
            page.wait_for(kept, 20)
            page.wait_for("caches.match('courseware/06-a-hole.html').then((found) => !!found)", 20)
            server.shutdown()
            server.server_close()
            page.open(f'{address}frame.html?open=/examples/portal.json')
            self.assertIn('portal.json', page.value('document.title'))
            page.read(f'{address}courseware/06-a-hole.html')
            self.assertEqual(page.value("document.querySelector('h1').textContent"), 'A hole')
            self.picture(page, 'offline')

    def host(self, query):
        """A page of another origin around the frame app: the messages that it hears are `heard`, `ask` sends one."""
        folder = tempfile.TemporaryDirectory(ignore_cleanup_errors=True)
        self.addCleanup(folder.cleanup)
        server = http.server.ThreadingHTTPServer(('127.0.0.1', 0), functools.partial(Quiet, directory=folder.name))
        self.addCleanup(server.server_close)
        self.addCleanup(server.shutdown)
        threading.Thread(target=server.serve_forever, daemon=True).start()
        origin = f'http://127.0.0.1:{server.server_port}'
        (pathlib.Path(folder.name) / 'host.html').write_text(
            '<!DOCTYPE html><title>course</title><link rel="icon" href="data:,"><iframe width="900" height="600" '
            f'src="{self.address}{query.format(origin=origin)}"></iframe><script>'
            "var heard = []; window.onmessage = (event) => heard.push(event.data);"
            "function ask(message) { message.cremona = 1; message.id = heard.length + 1000 * Math.random();"
            "  frames[0].postMessage(message, '*'); return new Promise((done) => {"
            "    const wait = () => { const answer = heard.find((one) => one.id === message.id);"
            "      if (answer) done(answer); else setTimeout(wait, 20); }; wait(); }); }</script>", encoding='utf-8')
        return f'{origin}/host.html'

    def test_a_page_of_a_course_sets_a_model_and_gets_its_results(self):
        portal = (SITE / '../page_files/examples/portal.json').read_text(encoding='utf-8')
        address = self.host('index.html?app=frame&model=/examples/truss.json&panels=none&allow={origin}')
        with Browser() as page:
            page.read(address)
            page.wait_for("heard.some((one) => one.event === 'ready')")
            self.assertIn('truss', page.value("ask({ get: 'description' }).then((answer) => answer.value)"))
            self.assertEqual(page.value(f'ask({{ set: {portal} }}).then((answer) => answer.ok)'), True)
            results = page.value("ask({ get: 'results' }).then((answer) => answer.value)")
            self.assertEqual(set(results['cases']), {'G', 'Q', 'W', 'ULS', 'SLS'})
            model = json.loads(page.value("ask({ get: 'model' }).then((answer) => answer.value)"))
            self.assertEqual(len(model['members']), len(json.loads(portal)['members']))
            self.assertTrue(page.value("ask({ run: 'view.fit' }).then((answer) => answer.ok)"))
            self.assertIn('no.such', page.value("ask({ run: 'no.such' }).then((answer) => answer.reason)"))
            self.assertFalse(page.value("ask({ set: '{' }).then((answer) => answer.ok)"))
            self.assertFalse(page.value("ask({ get: 'constructor' }).then((answer) => answer.ok)"))
            page.wait_for("heard.some((one) => one.event === 'change' && one.app === 'frame')", 10)
            page.wait(0.5)
            self.picture(page, 'embedded')
            self.assertEqual(page.complaints(), [])

    def test_a_page_of_another_origin_is_not_heard(self):
        for query in ('frame.html?panels=none', 'frame.html?allow=https://course.example'):
            with self.subTest(query=query), Browser() as page:
                page.read(self.host(query))
                page.wait(6.0)
                page.value("void ask({ get: 'model' })")
                page.wait(2.0)
                self.assertEqual(page.value('heard.length'), 0)

    def test_what_is_locked_is_looked_at_and_not_changed(self):
        with Browser() as page:
            page.open(f'{self.address}frame.html?model=/examples/portal.json&locked=1')
            before = page.value('Module.copyOfDocument()[0]')
            self.picture(page, 'locked')
            page.key('m')
            page.click(300, 300)
            page.click(900, 600)
            page.key('Delete')
            page.move(640, 400)
            page.press(640, 400)
            page.move(700, 440, buttons=1)
            page.release(700, 440)
            page.wait(0.5)
            self.picture(page, 'locked_moved')
            self.assertEqual(page.value('Module.copyOfDocument()[0]'), before)
            self.assertFalse(page.value("document.title.startsWith('*')"))
            self.assertEqual(page.complaints(), [])

    def test_scenarios_look_as_they_do_on_the_desktop(self):
        n_pictures = 0
        for name in SCENARIOS:
            app = name.split('/')[0] if '/' in name else 'frame'
            with self.subTest(scenario=name), Browser(height=800) as page:
                page.open(f'{self.address}{app}.html')
                for picture, distance in Player(page, PICTURES).play(name).items():
                    self.assertLess(distance, FARTHEST, picture)
                    n_pictures += 1
                self.assertEqual(page.complaints(), [])
        self.assertGreaterEqual(n_pictures, 12)

    def test_a_report_is_printed_to_paper(self):
        with Browser() as page:
            page.call('Page.addScriptToEvaluateOnNewDocument',  # in every frame
                      source='window.print = () => { top.printed = document.documentElement.outerHTML; };')
            page.open(f'{self.address}frame.html?open=/examples/portal.json')
            page.wait_for('!!Module.runCommand')
            page.value("Module.runCommand('file.export', '')")
            page.wait(0.5)
            page.key('a', ctrl=True)
            page.type('/documents/report.html')
            page.key('Enter', text='\r')
            page.wait_for("!!document.querySelector('#message button')", 20)
            page.value("document.querySelector('#message button').click()")
            page.wait_for('!!window.printed', 10)
            report = page.value('printed')
            self.assertEqual(page.complaints(), [])
        with Browser() as page:
            frame = page.call('Page.getFrameTree')['frameTree']['frame']['id']
            page.call('Page.setDocumentContent', frameId=frame, html=report)
            page.wait(0.5)
            pdf = base64.b64decode(page.call('Page.printToPDF', preferCSSPageSize=True)['data'])
            (PICTURES / 'report.pdf').write_bytes(pdf)
            self.assertTrue(pdf.startswith(b'%PDF'))
            self.assertGreater(len(re.findall(rb'/Type\s*/Page\b', pdf)), 5)
            widest = "Math.max(...[...document.querySelectorAll('table, svg')].map((part) => part.getBoundingClientRect().right))"
            page.call('Emulation.setEmulatedMedia', media='print')
            page.call('Emulation.setDeviceMetricsOverride', width=718, height=1000, deviceScaleFactor=1, mobile=False)
            self.assertLess(page.value(widest), 1.1 * 718)  # A4 between its margins [px]; browsers shrink what is wider

    def test_the_document_stands_beside_the_picture_in_words(self):
        with Browser() as page:
            page.open(f'{self.address}frame.html?open=/examples/portal.json')
            page.wait_for("document.getElementById('words').textContent.includes('A plane frame: 4 nodes, 3 members')", 10)
            self.assertEqual(page.value("document.getElementById('words').getAttribute('aria-live')"), 'polite')
            page.value("document.querySelector('#words p').kept = true")
            page.key('m')
            page.click(*B)
            page.click(*D)
            page.key('Escape')
            page.wait_for("document.getElementById('words').textContent.includes('4 nodes, 4 members')", 10)
            self.assertTrue(page.value("document.querySelector('#words p').kept"))  # what has not changed stays

    def test_a_field_is_typed_into_by_keys_of_the_page_where_the_screen_is_touched(self):
        with Browser() as page:
            page.call('Emulation.setTouchEmulationEnabled', enabled=True, maxTouchPoints=2)
            page.open(f'{self.address}frame.html?open=/examples/portal.json')
            self.assertTrue(page.value("document.getElementById('keypad').hidden"))
            for _ in range(5):  # a tap that lasts as long as a slow frame opens the menu instead
                page.tap(1080, 95)  # the title of the model
                page.wait(1.0)
                if not page.value("document.getElementById('keypad').hidden"):
                    break
            self.assertFalse(page.value("document.getElementById('keypad').hidden"))
            self.picture(page, 'keypad')
            place = page.value("(({ x, y, width, height }) => [x + width / 2, y + height / 2])"
                               "(document.querySelectorAll('#keypad button')[6].getBoundingClientRect())")
            page.tap(*place)
            page.key('Enter', text='\r')
            page.wait(0.5)
            self.assertIn('7', json.loads(page.value('Module.copyOfDocument()[0]'))['title'])

    def test_who_changes_the_language_meets_portuguese(self):
        for address in (f'{self.address}frame.html', (SITE / 'single/frame.html').resolve().as_uri()):
            with self.subTest(address=address), Browser() as page:
                page.open(f'{address}?lang=pt_BR&open=/examples/portal.json')
                self.assertIn('Um pórtico plano', page.value('Module.description()'))
                page.open(f'{address}?lang=en&open=/examples/portal.json')
                page.wait_for('Module.portuguese !== undefined', 10)
                self.assertIsNone(page.value("Module.runCommand('view.language.pt', '')"))
                page.wait(0.5)
                self.assertIn('Um pórtico plano', page.value('Module.description()'))

    def test_who_wants_little_motion_sees_a_mechanism_at_rest_until_it_is_animated(self):
        for wish in ('no-preference', 'reduce'):
            with self.subTest(wish=wish), Browser() as page:
                page.call('Emulation.setEmulatedMedia', features=[{'name': 'prefers-reduced-motion', 'value': wish}])
                page.open(f'{self.address}frame.html?open=/examples/mechanism.json')
                page.wait(1.0)

                def moves():
                    pictures = []
                    for _ in range(3):
                        pictures.append(page.call('Page.captureScreenshot', format='png')['data'])
                        page.wait(0.4)
                    return len(set(pictures)) > 1
                self.assertEqual(moves(), wish == 'no-preference')
                self.picture(page, f'motion_{wish}')
                if wish == 'reduce':
                    page.key('a')
                    self.assertTrue(moves())
                self.assertEqual(page.complaints(), [])

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

    def test_a_browser_that_is_too_old_says_so(self):
        with Browser() as page:
            page.call('Page.addScriptToEvaluateOnNewDocument', source='WebAssembly.validate = () => false;'
                      'WebAssembly.instantiateStreaming = WebAssembly.instantiate ='
                      ' () => Promise.reject(new Error("no"));')
            page.read(f'{self.address}euler.html')
            page.wait_for("document.getElementById('message').textContent.includes('too old')", 20)

    def test_the_single_file_opens_from_the_disk(self):
        for app in APPS:
            with self.subTest(app=app), Browser() as page:
                took = page.open((SITE / 'single' / f'{app}.html').resolve().as_uri())
                print(f'{app}: {took:.1f} s until its single file draws')
                self.picture(page, f'{app}_single')
                self.assertEqual(page.complaints(), [])


if __name__ == '__main__':
    unittest.main(verbosity=2)
