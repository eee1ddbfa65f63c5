"""The converter of the site, and all pages of courseware/ through it."""

import pathlib
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / 'apps/web'))
sys.path.insert(0, str(ROOT / 'tests/web'))

from courseware_pages import Pages, app_of  # noqa: E402
from markdown import Converter, slug  # noqa: E402
from well_formed import PageReader, leads_nowhere  # noqa: E402


def converted(text):
    return Converter().convert(text)


class Markdown(unittest.TestCase):
    def test_what_looks_like_html_is_text(self):
        for text in ('<script>alert(1)</script>', 'a <b onclick="x">b</b>', '`<i>`', '# <img src=x onerror=y>',
                     '| <u>a</u> | b |\n|---|---|\n| `<p>` | <p> |', '```\n</code></pre><script>\n```'):
            with self.subTest(text=text):
                tags = {tag for tag, _ in PageReader(converted(text)).tags}
                self.assertFalse(tags & {'script', 'b', 'i', 'img', 'u'})

    def test_a_link_to_a_script_is_no_link(self):
        for address in ('javascript:alert`1`', 'JavaScript:x', 'data:text/html,x', 'vbscript:x'):
            self.assertEqual(converted(f'[here]({address})'), '<p>here</p>\n')

    def test_an_address_cannot_leave_its_attribute(self):
        self.assertIn('href="a&quot;onclick=&quot;b"', converted('[x](a"onclick="b)'))
        self.assertIn('alt="&quot;&gt;"', converted('!["\\>](a.png)').replace('\\', ''))

    def test_words_are_set_off_by_asterisks_and_products_are_not(self):
        self.assertEqual(converted('a *b c* **d**'), '<p>a <em>b c</em> <strong>d</strong></p>\n')
        self.assertEqual(converted('3 * 4 * 5, kN*m, a*b*c'), '<p>3 * 4 * 5, kN*m, a*b*c</p>\n')
        self.assertEqual(converted('K_ij and snake_case_name'), '<p>K_ij and snake_case_name</p>\n')

    def test_asterisks_in_a_program_are_its_own(self):
        self.assertEqual(converted('`a *b* c`'), '<p><code>a *b* c</code></p>\n')
        self.assertEqual(converted('*see `a*b` here*'), '<p><em>see <code>a*b</code> here</em></p>\n')

    def test_a_list_in_a_list_and_a_program_in_an_item(self):
        text = '1. one\n   more\n   - inner\n\n   ```sh\n   ls\n     -l\n   ```\n2. two\n'
        self.assertEqual(converted(text), '<ol>\n<li><p>one\nmore</p>\n<ul>\n<li>inner</li>\n</ul>\n'
                         '<pre><code class="language-sh">ls\n  -l\n</code></pre></li>\n<li><p>two</p></li>\n</ol>\n')

    def test_a_number_that_begins_a_line_of_a_sentence_begins_no_list(self):
        self.assertEqual(converted('nested up to\n64. More is refused'), '<p>nested up to\n64. More is refused</p>\n')

    def test_a_bar_in_a_cell_is_escaped_or_in_a_program(self):
        self.assertIn('<td><code>a|b</code></td><td>c|d</td>', converted('| x | y |\n|---|---|\n| `a\\|b` | c\\|d |'))

    def test_cells_that_are_missing_are_empty(self):
        self.assertIn('<tr><td>a</td><td></td><td>c</td></tr>', converted('|x|y|z|\n|-|-|-|\n| a | | c |'))
        self.assertIn('<tr><td>a</td><td></td></tr>', converted('|x|y|\n|-|-|\n| a |'))

    def test_headings_are_named_as_their_links_expect(self):
        self.assertEqual(slug('What `--why` says: *of a number*'), 'what---why-says-of-a-number')
        self.assertIn('<h2 id="natural-modes">Natural modes</h2>', converted('## Natural modes'))

    def test_no_text_makes_it_fail(self):
        for text in ('', '|', '| |\n|-|', '```', '*', '**', '[', '[](', '`', '- ', '-', '1.', '#', '\\',
                     '   - a\n - b\n- c'):
            with self.subTest(text=text):
                self.assertEqual(PageReader(converted(text)).faults, [])


class Courseware(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.site = pathlib.Path(cls.folder.name)
        cls.pages = Pages(ROOT)
        cls.pages.write(cls.site)
        for file in ('site.css', 'offline.js', 'manifest.webmanifest', 'index.html', 'frame.html', 'plane.html',
                     'euler.html'):
            (cls.site / file).write_text('', encoding='utf-8')  # of others

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def test_every_page_is_there_and_well_formed(self):
        self.assertEqual(len(self.pages.written), len(list((ROOT / 'courseware').rglob('*.md'))) + 1)
        for name, text in self.pages.written.items():
            with self.subTest(page=name):
                self.assertEqual(PageReader(text).faults, [])

    def test_every_link_leads_somewhere(self):
        lost = [link for name, text in self.pages.written.items() for link in leads_nowhere(self.site, name, text)]
        self.assertEqual(lost, [])

    def test_a_link_that_leads_nowhere_is_found(self):
        text = '<a href="index.html">a</a><a href="none.html">b</a><a href="index.html#none">c</a>'
        self.assertEqual(leads_nowhere(self.site, 'x.html', text), ['x.html: none.html', 'x.html: index.html#none'])

    def test_no_table_is_left_as_it_was_typed(self):
        for name, text in self.pages.written.items():
            with self.subTest(page=name):
                self.assertNotIn('|---', text)
                self.assertNotIn('<p>|', text)  # as after a blank line within a table

    def test_an_example_that_is_named_opens_in_its_app(self):
        lesson = self.pages.written['courseware/05-where-beam-theory-ends.html']
        self.assertIn('<a href="../plane.html?open=/examples/deep_beam.json"><code>examples/deep_beam.json</code></a>',
                      lesson)
        self.assertEqual(app_of(ROOT / 'examples/portal.json'), 'frame')
        self.assertEqual(app_of(ROOT / 'examples/cube.eul'), 'euler')
        self.assertIsNone(app_of(ROOT / 'examples/bracket.dxf'))


if __name__ == '__main__':
    unittest.main(verbosity=2)
