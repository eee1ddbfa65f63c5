"""Markdown to HTML, as much of it as the pages of courseware/ are written in: headings, paragraphs, lists in lists,
tables, fenced and indented programs, pictures, links, emphasis by asterisks, and anchors `<a id="name"></a>`. Whatever
else looks like HTML is text."""

import html
import re

ITEM = re.compile(r'( *)([-*+]|\d+[.)]) +')
FENCE = re.compile(r' *```(\w*)\s*$')
HEADING = re.compile(r'(#{1,6}) +(.*?) *#*$')
ANCHOR = re.compile(r'<a id="([\w-]+)"></a>')
RULE = re.compile(r'\|? *:?-+:? *(\| *:?-+:? *)*\|?$')
CELLS = re.compile(r'(?:\\.|`[^`]*`|[^|\\`]|[\\`])+')  # of a row, without its first and last bar
SPAN = re.compile(r'(?P<ticks>`+)(?P<code>.*?[^`])(?P=ticks)(?!`)'
                  r'|\\(?P<escaped>[\\`*_{}\[\]()#+.!|<>-])'
                  r'|(?P<anchor><a id="[\w-]+"></a>)'
                  r'|(?P<picture>!)?\[(?P<text>(?:[^\[\]`]|`[^`]*`|\[[^\]]*\])*)\]\((?P<to>[^()\s]+)\)'
                  r'|\*\*(?P<strong>(?=\S).+?(?<=\S))\*\*'
                  r'|(?<![\w*])\*(?P<emphasis>(?=[^\s*])(?:[^*`]|`[^`]*`)+?(?<=\S))\*(?![\w*])', re.S)
SCHEMES = ('http:', 'https:', 'mailto:')  # other addresses are files


def slug(text):
    """The name of a heading's anchor, as GitHub makes it."""
    plain = re.sub(r'\[([^\]]*)\]\([^)]*\)', r'\1', text).replace('`', '').replace('*', '')
    return re.sub(r'[^\w\- ]', '', plain.lower()).replace(' ', '-')


class Converter:
    """Of one page. `address`: what a link's or a picture's address becomes. `place_named`: where the words of a
    program's text lead. Both give None where there is nothing to go to."""

    def __init__(self, address=lambda to: to, place_named=lambda words: None):
        self.address, self.place_named = address, place_named
        self.is_in_link = False
        self.headings = []  # (level, anchor, text) of the page, in order
        self.anchors = set()

    # ---- within a line

    def inline(self, text):
        written, end = [], 0
        for found in SPAN.finditer(text):
            written += [html.escape(text[end:found.start()], quote=False), self.span(found)]
            end = found.end()
        return ''.join(written) + html.escape(text[end:], quote=False)

    def span(self, found):
        part = found.groupdict()
        if part['ticks']:
            return self.code(part['code'].strip())
        if part['escaped']:
            return html.escape(part['escaped'], quote=False)
        if part['anchor']:
            return self.anchor(ANCHOR.match(part['anchor']).group(1))
        if part['to']:
            return self.picture(part) if part['picture'] else self.link(part)
        if part['strong']:
            return f'<strong>{self.inline(part["strong"])}</strong>'
        return f'<em>{self.inline(part["emphasis"])}</em>'

    def code(self, words):
        text = f'<code>{html.escape(words, quote=False)}</code>'
        to = None if self.is_in_link else self.place_named(words)
        return text if to is None else f'<a href="{html.escape(to)}">{text}</a>'

    def anchor(self, name):
        self.anchors.add(name)
        return f'<a id="{name}"></a>'

    def allowed(self, address):
        """An address that is followed: never a script."""
        is_file = ':' not in address.split('#')[0].split('/')[0]
        return self.address(address) if is_file else address if address.startswith(SCHEMES) else None

    def link(self, part):
        to = self.allowed(part['to'])
        self.is_in_link = to is not None
        words = self.inline(part['text'])
        self.is_in_link = False
        return words if to is None else f'<a href="{html.escape(to)}">{words}</a>'

    def picture(self, part):
        to, words = self.allowed(part['to']), html.escape(part['text'])
        return words if to is None else f'<img src="{html.escape(to)}" alt="{words}">'

    # ---- blocks of lines

    def convert(self, text):
        return self.blocks(text.replace('\t', '    ').splitlines())

    def blocks(self, lines, is_tight=False):
        """`is_tight`: of an item of a list without blank lines; its paragraphs are plain text."""
        written, i = [], 0
        while i < len(lines):
            part, n = self.block(lines, i, is_tight)
            written.append(part)
            i += n
        return ''.join(written)

    def block(self, lines, i, is_tight):
        """The block that begins at line i, and how many lines it has."""
        line = lines[i]
        if not line.strip():
            return '', 1
        if fence := FENCE.match(line):
            return self.fenced(lines, i, fence.group(1))
        if heading := HEADING.match(line):
            return self.heading(len(heading.group(1)), heading.group(2)), 1
        if line.startswith('    '):
            return self.indented(lines, i)
        if ITEM.match(line):
            return self.list(lines, i)
        if '|' in line and i + 1 < len(lines) and '|' in lines[i + 1] and RULE.match(lines[i + 1]):
            return self.table(lines, i)
        return self.paragraph(lines, i, is_tight)

    def heading(self, level, text):
        name = slug(text)
        words = self.inline(text)
        self.headings.append((level, name, re.sub('<[^>]*>', '', words)))
        self.anchors.add(name)
        return f'<h{level} id="{name}">{words}</h{level}>\n'

    @staticmethod
    def fenced(lines, i, language):
        indent = len(lines[i]) - len(lines[i].lstrip())
        end = next((k for k in range(i + 1, len(lines)) if FENCE.match(lines[k])), len(lines))
        body = [line[min(indent, len(line) - len(line.lstrip())):] for line in lines[i + 1:end]]
        kind = f' class="language-{language}"' if language else ''
        return f'<pre><code{kind}>{html.escape(chr(10).join(body), quote=False)}\n</code></pre>\n', end + 1 - i

    @staticmethod
    def indented(lines, i):
        end = i
        while end < len(lines) and (lines[end].startswith('    ') or not lines[end].strip()):
            end += 1
        body = '\n'.join(line[4:] for line in lines[i:end]).rstrip()
        return f'<pre><code>{html.escape(body, quote=False)}\n</code></pre>\n', end - i

    def paragraph(self, lines, i, is_tight):
        end = i + 1
        while end < len(lines) and lines[end].strip() and not self.interrupts(lines[end]):
            end += 1
        text = self.inline('\n'.join(line.strip() for line in lines[i:end]))
        is_anchor = ANCHOR.fullmatch(lines[i].strip()) and end == i + 1
        return f'{text}\n' if is_tight or is_anchor else f'<p>{text}</p>\n', end - i

    @staticmethod
    def interrupts(line):
        """A paragraph: a number does so only as the first of a list."""
        item = ITEM.match(line)
        return bool(FENCE.match(line) or HEADING.match(line) or item and item.group(2)[:-1] in ('', '1'))

    def list(self, lines, i):
        first = ITEM.match(lines[i])
        indent, mark = len(first.group(1)), first.group(2)
        is_ordered = mark[-1] in '.)' and mark[:-1].isdigit()
        items, end = [], i
        while end < len(lines):
            item = ITEM.match(lines[end])
            if not item or len(item.group(1)) != indent or item.group(2)[-1] != mark[-1]:
                break
            begin, end = end, self.end_of_item(lines, end + 1, indent)
            items.append(self.inside(lines[begin:end], item.end()))
        is_tight = not any('' in item for item in items)
        tag = 'ol' if is_ordered else 'ul'
        start = f' start="{mark[:-1]}"' if is_ordered and mark[:-1] != '1' else ''
        body = ''.join(f'<li>{self.blocks(item, is_tight).strip()}</li>\n' for item in items)
        return f'<{tag}{start}>\n{body}</{tag}>\n', end - i

    @staticmethod
    def end_of_item(lines, i, indent):
        """One after the last line that belongs to an item: what is further in, and what goes on with its paragraph."""
        end = i
        while end < len(lines):
            line = lines[end]
            if not line.strip():
                k = next((k for k in range(end, len(lines)) if lines[k].strip()), None)
                if k is None or len(lines[k]) - len(lines[k].lstrip()) <= indent and not ITEM.match(lines[k]):
                    return end
                if ITEM.match(lines[k]) and len(ITEM.match(lines[k]).group(1)) <= indent:
                    return k
                end = k
                continue
            further_in = len(line) - len(line.lstrip()) > indent
            if not further_in and (ITEM.match(line) or HEADING.match(line) or FENCE.match(line)):
                return end
            end += 1
        return end

    @staticmethod
    def inside(lines, indent):
        """The lines of an item without its mark and indent; blank ones at its end belong to nobody."""
        cut = [lines[0][indent:]] + [line[min(indent, len(line) - len(line.lstrip())):] for line in lines[1:]]
        while cut and not cut[-1].strip():
            cut.pop()
        return [line if line.strip() else '' for line in cut]

    def table(self, lines, i):
        end = i + 2
        while end < len(lines) and '|' in lines[end]:
            end += 1
        sides = ['right' if rule.strip().endswith(':') else '' for rule in self.cells(lines[i + 1])]
        head = self.row(lines[i], 'th', sides)
        body = ''.join(self.row(line, 'td', sides) for line in lines[i + 2:end])
        return f'<table>\n<thead>\n{head}</thead>\n<tbody>\n{body}</tbody>\n</table>\n', end - i

    @staticmethod
    def cells(line):
        inner = re.sub(r'(?<!\\)\|$', '', line.strip().removeprefix('|'))
        cells, k = [], 0
        while k <= len(inner):
            found = CELLS.match(inner, k)
            cells.append(found.group().strip() if found else '')
            k = (found.end() if found else k) + 1
        return [cell.replace('\\|', '|') for cell in cells]

    def row(self, line, tag, sides):
        cells = self.cells(line)[:len(sides)]
        cells += [''] * (len(sides) - len(cells))
        sided = [f'<{tag}{" class=" + chr(34) + side + chr(34) if side else ""}>{self.inline(cell)}</{tag}>'
                 for side, cell in zip(sides, cells)]
        return f'<tr>{"".join(sided)}</tr>\n'
