#!/usr/bin/env python3
"""entrance.py ROOT SITE: the entrance page in both languages, SITE/index.html and SITE/index.pt_BR.html: what each app is,
the examples as pictures, each of which opens in its app at a click, and the lessons."""

import html
import pathlib
import re
import sys

import gallery
from courseware_pages import Pages
from page import page

PAGES = {'en': 'index.html', 'pt_BR': 'index.pt_BR.html'}
OF_HTML = {'en': 'en', 'pt_BR': 'pt-BR'}  # languages as HTML names them

TEXTS = {
    'en': {
        'title': 'Cremona: structural analysis that teaches',
        'intro': 'Structures are drawn, solved exactly, and explained: each number says where it comes from. Everything '
                 'runs in this browser. Nothing is sent anywhere, and nothing needs to be installed.',
        'apps': 'The apps',
        'frame': ('Frame', 'a frame, truss or grillage at work: draw it, load it, see it bend'),
        'plane': ('Plane', 'a plate, a wall or a dam: stresses in the plane by finite elements'),
        'cross': ('Cross', 'moments of a beam or frame, distributed joint by joint as by hand'),
        'mohr': ('Mohr', 'the circle of stresses, strains and second moments of area'),
        'euler': ('Euler', 'solids made by Euler operators, step by step'),
        'examples': 'Examples',
        'lessons': 'Lessons',
        'more': 'All lessons, and a page of every program and file',
        'single': 'Without a server',
        'carry': 'Each app is also one file, which opens from a disk or a USB stick without a network. Save it, and '
                 'open it by a double click:',
        'free': 'Free software under the MIT licence; the lessons are under CC BY 4.0.',
    },
    'pt_BR': {
        'title': 'Cremona: análise de estruturas que ensina',
        'intro': 'Estruturas são desenhadas, resolvidas exatamente e explicadas: cada número diz de onde vem. Tudo '
                 'roda neste navegador. Nada é enviado a lugar algum, e nada precisa ser instalado.',
        'apps': 'Os programas',
        'frame': ('Frame', 'um pórtico, uma treliça ou uma grelha em ação: desenhe, carregue, veja fletir'),
        'plane': ('Plane', 'uma chapa, uma parede ou uma barragem: tensões no plano por elementos finitos'),
        'cross': ('Cross', 'os momentos de uma viga ou de um pórtico, distribuídos nó a nó como à mão'),
        'mohr': ('Mohr', 'o círculo das tensões, das deformações e dos momentos de inércia'),
        'euler': ('Euler', 'sólidos feitos por operadores de Euler, passo a passo'),
        'examples': 'Exemplos',
        'lessons': 'Lições (em inglês)',
        'more': 'Todas as lições, e uma página de cada programa e arquivo',
        'single': 'Sem servidor',
        'carry': 'Cada programa é também um só arquivo, que abre de um disco ou de um pendrive, sem rede. Salve o '
                 'arquivo e abra-o com um clique duplo:',
        'free': 'Software livre sob a licença MIT; as lições estão sob CC BY 4.0.',
    },
}
APPS = ('frame', 'plane', 'cross', 'mohr', 'euler')
EMPTY = {'euler': 'cube.eul'}  # what is opened where a new document shows nothing


def plain(text):
    return html.escape(text, quote=False)


def address(app, language, example=None):
    opened = f'open=/examples/{example}&' if example else ''
    return html.escape(f'{app}.html?{opened}lang={language}')


def app_list(texts, language):
    items = []
    for app in APPS:
        name, words = texts[app]
        items.append(f'<li><img src="pictures/cremona-{app}.svg" alt="" width="40" height="40"> '
                     f'<a href="{address(app, language, EMPTY.get(app))}">{name}</a>: {plain(words)}</li>\n')
    return f'<h2>{texts["apps"]}</h2>\n<ul class="apps">\n{"".join(items)}</ul>\n'


def example_list(texts, language, entries):
    items = []
    for entry in entries:
        picture = f'<img src="pictures/{gallery.picture_of(entry)}" alt="" width="640" height="400" loading="lazy">'
        to = address(entry['app'], language, entry.get('example'))
        items.append(f'<li><a href="{to}">{picture}<span>{plain(entry[language])}</span></a></li>\n')
    return f'<h2 id="examples">{texts["examples"]}</h2>\n<ul class="gallery">\n{"".join(items)}</ul>\n'


def lesson_list(texts, lessons):
    items = ''.join(f'<li><a href="{to}" hreflang="en">{plain(title)}</a></li>\n' for to, title in lessons)
    return (f'<h2>{texts["lessons"]}</h2>\n<ol>\n{items}</ol>\n'
            f'<p><a href="courseware/index.html" hreflang="en">{texts["more"]}</a></p>\n')


def file_list(texts):
    items = ''.join(f'<li><a href="single/{app}.html" download="cremona-{app}.html">cremona-{app}.html</a></li>\n'
                    for app in APPS)
    return f'<h2>{texts["single"]}</h2>\n<p>{texts["carry"]}</p>\n<ul>\n{items}</ul>\n'


def entrance(language, entries, lessons):
    texts = TEXTS[language]
    other = next(name for name in PAGES if name != language)
    named = {'en': 'English', 'pt_BR': 'Português'}[other]
    of_html = OF_HTML[other]
    heading = f'<a href="{PAGES[other]}?lang={other}" hreflang="{of_html}" lang="{of_html}">{named}</a>\n'
    body = (f'<h1>Cremona</h1>\n<p>{texts["intro"]}</p>\n' + app_list(texts, language)
            + example_list(texts, language, entries) + lesson_list(texts, lessons) + file_list(texts))
    return page(texts['title'], body, language=OF_HTML[language], heading=heading, footing=f'<p>{texts["free"]}</p>\n',
                head='<script src="entrance.js"></script>\n')


def lessons_of(root):
    """Of each the address in the site, and its title."""
    pages = Pages(root)
    for path in pages.sources:
        pages.convert(path)
    return [(source.removesuffix('.md') + '.html', title) for source, title in pages.titles.items()
            if re.fullmatch(r'courseware/\d[^/]*', source)]


def write(root, site):
    entries, lessons = gallery.entries(root), lessons_of(root)
    for language, name in PAGES.items():
        (site / name).write_text(entrance(language, entries, lessons), encoding='utf-8')


if __name__ == '__main__':
    write(pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2]))
