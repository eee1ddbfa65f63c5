"""The folders and who links whom, drawn from the CMakeLists: courseware/pictures/architecture.svg.

    python3 tests/layering/architecture.py --write     draws it again, after a link line has changed

Run by CTest without an argument, it fails where the picture is not that of the link lines.
"""
import collections
import math
import pathlib
import re
import sys
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
PICTURE = ROOT / "courseware/pictures/architecture.svg"

TARGET = re.compile(r"(?:cremona_library|cremona_program|add_executable|add_library)\(\s*([\w]+)")
LINKS = re.compile(r"(?:cremona_library|cremona_program|target_link_libraries)\(\s*([\w]+)([^()]*)", re.S)

SAYS = {
    "topology": ["half-edges, Euler operators,", "sweeps, scripts, meshes"],
    "femoop": ["models, elements, analysis, results,", "sections, hand methods, files"],
    "ui": ["painter, window, widgets, commands,", "undo, texts, drafts, scenarios"],
    "apps/drawing": ["structures, loads and diagrams", "as pictures"],
    "apps/frame": ["draws, solves and changes", "frames, trusses, grillages"],
    "apps/cross": ["moment distribution", "joint by joint"],
    "apps/mohr": ["Mohr's circle,", "criteria of failure"],
    "apps/core": ["results and pictures", "as modules of pages"],
    "apps/plane": ["plates by their curves,", "regions, supports, loads"],
    "apps/euler": ["Euler operators", "step by step"],
    "apps/cli": ["cremona: all of it", "without a window"],
}
LIBRARIES = ["femoop", "ui", "topology"]


def lists(root):
    """The CMakeLists of the libraries and of the apps, by their folder."""
    folders = [*LIBRARIES, *(path.parent.relative_to(root).as_posix() for path in (root / "apps").glob("*/CMakeLists.txt"))]
    return {folder: re.sub(r"#.*", "", (root / folder / "CMakeLists.txt").read_text()) for folder in folders}


def arrows(cmake):
    """Who links whom, as a set of pairs of folders, of a dict from folder to the text of its CMakeLists."""
    home = {target: folder for folder, text in cmake.items() for target in TARGET.findall(text)}
    found = set()
    for folder, text in cmake.items():
        for _, words in LINKS.findall(text):
            for word in re.findall(r"[\w:]+", words):
                other = home.get(word, folder)
                if other != folder:
                    found.add((folder, other))
    return found


def reached(start, pairs):
    """Every folder that `start` links, at once or through others."""
    seen, waiting = set(), [start]
    while waiting:
        here = waiting.pop()
        for a, b in pairs:
            if a == here and b not in seen:
                seen.add(b)
                waiting.append(b)
    return seen


def reduced(pairs):
    """Without the arrows that follow from others; those between two folders that link each other stay."""
    mutual = {pair for pair in pairs if pair[::-1] in pairs}
    kept = set(pairs)
    for pair in sorted(pairs - mutual):
        if pair[1] in reached(pair[0], kept - mutual - {pair}):
            kept.discard(pair)
    return kept


def levels(folders, pairs):
    """How many steps each folder stands above the libraries; folders that reach each other stand side by side."""
    reach = {folder: reached(folder, pairs) for folder in folders}
    below = {f: {g for g in reach[f] if f not in reach[g]} for f in folders}
    result = {}
    for folder in sorted(folders, key=lambda f: len(below[f])):
        group = [f for f in folders if f == folder or (f in reach[folder] and folder in reach[f])]
        result[folder] = 1 + max((result[g] for f in group for g in below[f] if g in result), default=-1)
    for folder in folders:
        result[folder] = max([result[folder], *(result[g] for g in reach[folder] if folder in reach[g])])
    return result


WIDTH, BOX, HIGH, STEP, LANE = 960, (250, 74), 40, 134, 40


def width(rows):
    """Room for the boxes of the longest row and a lane beside each. `rows`: in which one each box stands."""
    return max(WIDTH, LANE + max(collections.Counter(rows).values()) * (BOX[0] + LANE))


def places(folders, pairs):
    """The upper left corner of each box."""
    level = levels(folders, pairs)
    top = max(level.values())
    result = {}
    for n in range(top + 1):
        order = {name: i for i, name in enumerate(SAYS)}
        row = sorted((f for f in folders if level[f] == n), key=lambda f: (order.get(f, 99), f))
        if n == 0:
            row = [f for f in LIBRARIES if f in row]
        gap = (width(level.values()) - len(row) * BOX[0]) / (len(row) + 1)
        for i, folder in enumerate(row):
            result[folder] = (gap + i * (BOX[0] + gap), HIGH + (top - n) * STEP)
    return result


def crosses(a, b, box):
    """Whether the segment from a to b runs through a box, sampled finely."""
    for i in range(1, 100):
        x, y = a[0] + (b[0] - a[0]) * i / 100, a[1] + (b[1] - a[1]) * i / 100
        if box[0] - 4 < x < box[0] + BOX[0] + 4 and box[1] - 4 < y < box[1] + BOX[1] + 4:
            return True
    return False


def line(pair, at, shares):
    """From the foot of the one box to the head of the other; along the margin where others are in the way."""
    (ax, ay), (bx, by) = at[pair[0]], at[pair[1]]
    middle_a = ay + BOX[1] / 2
    if ay == by:
        from_x, to_x = (ax + BOX[0], bx) if bx > ax else (ax, bx + BOX[0])
        return [(from_x, middle_a), (to_x, middle_a)]
    start, end = (ax + BOX[0] * shares[pair, 0], ay + BOX[1]), (bx + BOX[0] * shares[pair, 1], by)
    if not any(crosses(start, end, box) for folder, box in at.items() if folder not in pair):
        return [start, end]
    lane = 10 + 12 * shares[pair, 0]  # so that two arrows along one margin are told apart
    right = width(y for _, y in at.values())
    margin, edge = (lane, 0) if bx + BOX[0] / 2 < right / 2 else (right - lane, BOX[0])
    above = by - 16 - 6 * shares[pair, 1]
    return [(ax + edge, middle_a), (margin, middle_a), (margin, above), (end[0], above), end]


def head(line):
    """The triangle at the end of a line."""
    (ax, ay), (bx, by) = line[-2:]
    length = math.hypot(bx - ax, by - ay)
    ux, uy = (bx - ax) / length, (by - ay) / length
    return [(bx, by), (bx - 11 * ux - 5 * uy, by - 11 * uy + 5 * ux), (bx - 11 * ux + 5 * uy, by - 11 * uy - 5 * ux)]


def points(places):
    return " ".join(f"{x:.0f},{y:.0f}" for x, y in places)


def shares(pairs, at):
    """Where on the breadth of a box each of its arrows leaves and arrives, so that none lies on another."""
    result = {}
    for end in (0, 1):
        for folder in at:
            mine = sorted((p for p in pairs if p[end] == folder and at[p[0]][1] != at[p[1]][1]),
                          key=lambda p: (at[p[1 - end]][0], p))
            for i, pair in enumerate(mine):
                result[pair, end] = (i + 1) / (len(mine) + 1)
    return result


def drawn(pairs):
    """The picture as SVG; each arrow tells in a title who links whom."""
    folders = sorted({folder for pair in pairs for folder in pair})
    at = places(folders, pairs)
    kept = reduced(pairs)
    share = shares(kept, at)
    height = max(y for _, y in at.values()) + BOX[1] + 24
    breadth = width(y for _, y in at.values())
    lines = [f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {breadth} {height:.0f}" font-family="sans-serif">',
             "<title>The folders of the sources: an arrow points from a folder to what it links</title>",
             f'<rect width="{breadth}" height="{height:.0f}" fill="#fff"/>']
    for pair in sorted(kept):
        way = line(pair, at, share)
        lines.append(f'<polyline points="{points(way)}" fill="none" stroke="#444" stroke-width="1.6">'
                     f"<title>{pair[0]} links {pair[1]}</title></polyline>")
        lines.append(f'<polygon points="{points(head(way))}" fill="#444"/>')
    for folder in folders:
        x, y = at[folder]
        fill = "#dcebf7" if folder in LIBRARIES else "#f6ecd9"
        lines.append(f'<rect x="{x:.0f}" y="{y:.0f}" width="{BOX[0]}" height="{BOX[1]}" rx="6" fill="{fill}" '
                     'stroke="#444"/>')
        lines.append(f'<text x="{x + BOX[0] / 2:.0f}" y="{y + 24:.0f}" font-size="16" font-weight="bold" '
                     f'text-anchor="middle">{folder}/</text>')
        for i, words in enumerate(SAYS.get(folder, [])):
            lines.append(f'<text x="{x + BOX[0] / 2:.0f}" y="{y + 44 + 18 * i:.0f}" font-size="13" '
                         f'text-anchor="middle">{words}</text>')
    return "\n".join([*lines, "</svg>"]) + "\n"


class Arrows(unittest.TestCase):
    CMAKE = {
        "femoop": "cremona_library(femoop LINK_PUBLIC Eigen3::Eigen)",
        "apps/a": "cremona_library(a_model LINK_PUBLIC femoop)\ncremona_program(a SOURCES main.cpp LINK a_model)",
        "apps/b": "cremona_library(b_app LINK_PUBLIC a_model LINK_PRIVATE femoop)",
    }

    def test_every_link_line_to_another_folder_is_an_arrow(self):
        self.assertEqual(arrows(self.CMAKE), {("apps/a", "femoop"), ("apps/b", "apps/a"), ("apps/b", "femoop")})

    def test_an_arrow_that_follows_from_others_is_left_out(self):
        self.assertEqual(reduced(arrows(self.CMAKE)), {("apps/a", "femoop"), ("apps/b", "apps/a")})

    def test_two_folders_that_link_each_other_keep_both_arrows(self):
        pairs = {("a", "b"), ("b", "a"), ("b", "c"), ("a", "c")}
        self.assertEqual(reduced(pairs), pairs)

    def test_a_folder_stands_above_all_that_it_links(self):
        self.assertEqual(levels(["femoop", "apps/a", "apps/b"], arrows(self.CMAKE)),
                         {"femoop": 0, "apps/a": 1, "apps/b": 2})

    def test_every_app_of_a_long_row_has_a_place_of_its_own_on_the_picture(self):
        apps = [f"apps/{name}" for name in "abcde"]
        at = places([*apps, "femoop"], {(app, "femoop") for app in apps})
        lefts = sorted(at[app][0] for app in apps)
        self.assertGreater(lefts[0], 0)
        self.assertLess(lefts[-1] + BOX[0], width(y for _, y in at.values()))
        self.assertTrue(all(b - a > BOX[0] for a, b in zip(lefts, lefts[1:])))

    def test_no_library_links_an_app_or_another_library(self):
        self.assertEqual([pair for pair in arrows(lists(ROOT)) if pair[0] in LIBRARIES], [])

    def test_the_picture_is_that_of_the_link_lines(self):
        self.assertEqual(PICTURE.read_text(), drawn(arrows(lists(ROOT))),
                         "after a changed link line: python3 tests/layering/architecture.py --write")


if __name__ == "__main__":
    if "--write" in sys.argv:
        PICTURE.write_text(drawn(arrows(lists(ROOT))))
    else:
        unittest.main()
