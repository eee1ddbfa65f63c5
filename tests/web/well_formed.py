"""What stands in a page: its elements in order, each closed, and where it leads."""

from html.parser import HTMLParser

EMPTY = {'meta', 'link', 'img', 'br', 'input'}


class PageReader(HTMLParser):
    def __init__(self, text):
        super().__init__()
        self.open, self.faults, self.links, self.ids, self.tags = [], [], [], [], []
        self.feed(text)
        self.close()
        self.faults += [f'<{tag}> is not closed' for tag in self.open]

    def handle_starttag(self, tag, attributes):
        values = dict(attributes)
        self.tags.append((tag, values))
        self.links += [values[name] for name in ('href', 'src') if name in values]
        self.ids += [values['id']] if 'id' in values else []
        if tag == 'a' and 'href' in values and 'a' in self.open:
            self.faults.append(f'a link in a link: {values["href"]}')
        if tag not in EMPTY:
            self.open.append(tag)

    def handle_endtag(self, tag):
        if not self.open or self.open.pop() != tag:
            self.faults.append(f'</{tag}> closes nothing, in line {self.getpos()[0]}')


def leads_nowhere(site, name, text):
    """The links of a page of the site whose file or place in it is not there. `site`: its folder."""
    lost = []
    for link in PageReader(text).links:
        if link.startswith(('http:', 'https:', 'data:')):
            continue
        file, _, anchor = link.partition('#')
        place = (site / name).parent / file.partition('?')[0] if file else site / name
        is_there = place.is_file() and (not anchor or anchor in PageReader(place.read_text(encoding='utf-8')).ids)
        if not is_there:
            lost.append(f'{name}: {link}')
    return lost
