#!/usr/bin/env python3
"""courseware_pages.py ROOT SITE: the pages of courseware/ as HTML in SITE/courseware, with what they show, and the
page that lists them. Where a page names an example or another page, it leads there."""

import html
import json
import pathlib
import posixpath
import re
import shutil
import sys

import markdown
from page import page

PLANE_ANALYSES = ('plane_stress', 'plane_strain', 'axisymmetric')
FOLDERS = (('', 'Lessons'), ('reference', 'Reference'), ('how-to', 'For those who change the programs'),
           ('decisions', 'Decisions, and what was rejected'))
BESIDE = {'.svg', '.json', '.png'}  # files that pages show or name


def app_of(example):
    """The app that opens a file of examples/; None where none does."""
    if example.suffix == '.eul':
        return 'euler'
    if example.suffix != '.json':
        return None
    return 'plane' if json.loads(example.read_text(encoding='utf-8')).get('analysis') in PLANE_ANALYSES else 'frame'


class Pages:
    def __init__(self, root):
        self.root = root
        self.folder = root / 'courseware'
        self.sources = sorted(self.folder.rglob('*.md'))
        self.is_shown = {path.relative_to(root).as_posix() for path in self.sources}
        self.titles, self.anchors = {}, {}  # by the path of the page
        self.written = {}  # path in the site: text

    def address(self, source, to):
        """Where a link of a page leads in the site. None: to nothing that the site has."""
        file, _, anchor = to.partition('#')
        if not file:
            return to
        place = posixpath.normpath(posixpath.join(posixpath.dirname(source), file))
        behind = '#' + anchor if anchor else ''
        if place in self.is_shown:
            return file.removesuffix('.md') + '.html' + behind
        is_beside = place.startswith('courseware/') and pathlib.PurePath(place).suffix in BESIDE
        return to if is_beside and (self.root / place).exists() else None

    def place_named(self, source, words):
        """Where the words of a program's text lead: a page of courseware/, or an example in its app."""
        top = '../' * source.count('/')
        if words in self.is_shown and words != source:
            return top + words.removesuffix('.md') + '.html'
        example = self.root / words
        if not re.fullmatch(r'examples/\w+\.(json|eul)', words) or not example.exists():
            return None
        return f'{top}{app_of(example)}.html?open=/{words}'

    def convert(self, path):
        source = path.relative_to(self.root).as_posix()
        converter = markdown.Converter(lambda to: self.address(source, to),
                                       lambda words: self.place_named(source, words))
        body = converter.convert(path.read_text(encoding='utf-8'))
        title = html.unescape(next((text for level, _, text in converter.headings if level == 1), path.stem))
        top = '../' * source.count('/')
        heading = (f'<a href="{top}index.html">Cremona</a>\n'
                   f'<a href="{top}courseware/index.html">Lessons and reference</a>\n')
        self.titles[source] = title
        self.anchors[source] = converter.anchors
        self.written[source.removesuffix('.md') + '.html'] = page(
            title, self.with_contents(body, converter.headings), top=top, heading=heading,
            footing='<p>Text: <a href="https://creativecommons.org/licenses/by/4.0/" rel="license">CC BY 4.0</a></p>\n')

    @staticmethod
    def with_contents(body, headings):
        """A long page begins with the list of its parts."""
        parts = [f'<li><a href="#{name}">{text}</a></li>\n' for level, name, text in headings if level == 2]
        if len(parts) < 6:
            return body
        contents = f'<nav aria-label="On this page">\n<ul>\n{"".join(parts)}</ul>\n</nav>\n'
        return body.replace('</h1>\n', '</h1>\n' + contents, 1)

    def list(self):
        body = '<h1>Lessons and reference</h1>\n'
        for folder, name in FOLDERS:
            at = self.folder / folder
            links = [f'<li><a href="{path.relative_to(self.folder).with_suffix(".html").as_posix()}">'
                     f'{html.escape(self.titles[path.relative_to(self.root).as_posix()], quote=False)}</a></li>\n'
                     for path in self.sources if path.parent == at]
            body += f'<h2>{name}</h2>\n<ul>\n{"".join(links)}</ul>\n'
        self.written['courseware/index.html'] = page('Cremona: lessons and reference', body, top='../',
                                                     heading='<a href="../index.html">Cremona</a>\n')

    def write(self, site):
        for path in self.sources:
            self.convert(path)
        self.list()
        for name, text in self.written.items():
            (site / name).parent.mkdir(parents=True, exist_ok=True)
            (site / name).write_text(text, encoding='utf-8')
        for path in self.folder.rglob('*'):
            if path.suffix in BESIDE:
                target = site / path.relative_to(self.root)
                target.parent.mkdir(parents=True, exist_ok=True)
                shutil.copyfile(path, target)


if __name__ == '__main__':
    Pages(pathlib.Path(sys.argv[1])).write(pathlib.Path(sys.argv[2]))
