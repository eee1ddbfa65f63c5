"""What the front page shows must be true: its program is in an example, and every file that it names is there."""
import pathlib
import re
import sys
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
STANDS_FOR_A_NAME = re.compile(r"\b(NN_|APP\b|NAME\b)")
README = (ROOT / "README.md").read_text(encoding="utf-8")


class Readme(unittest.TestCase):
    def named_by(self, page):
        """Files that a page names from the top of the tree, and those that it links from where it stands."""
        text = re.sub(r"```.*?```", "", page.read_text(encoding="utf-8"), flags=re.S)
        from_top = re.findall(r"`((?:examples|courseware|femoop|topology|ui|apps|tests)/[\w./-]*)`", text)
        return {ROOT / name for name in from_top} | {page.parent / link for link in re.findall(r"\]\(([^):]+)\)", text)}

    def test_its_program_stands_word_for_word_in_an_example_that_is_run(self):
        programs = re.findall(r"```cpp\n(.*?)```", README, re.S)
        self.assertEqual(len(programs), 1)
        self.assertIn(programs[0], (ROOT / "examples/01_cantilever.cpp").read_text(encoding="utf-8"))

    def test_every_file_that_it_the_contributing_page_or_a_how_to_page_names_is_there(self):
        pages = [ROOT / "README.md", ROOT / "CONTRIBUTING.md", *(ROOT / "courseware/how-to").glob("*.md")]
        names = {place for page in pages for place in self.named_by(page)}
        self.assertGreater(len(names), 5)
        missing = sorted(str(n) for n in names if not STANDS_FOR_A_NAME.search(str(n)) and not n.exists())
        self.assertEqual(missing, [])


if __name__ == "__main__":
    sys.exit(unittest.main(verbosity=2))
