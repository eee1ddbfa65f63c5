"""What the front page shows must be true: its program is in an example, and every file that it names is there."""
import pathlib
import re
import sys
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
README = (ROOT / "README.md").read_text(encoding="utf-8")


class Readme(unittest.TestCase):
    def test_its_program_stands_word_for_word_in_an_example_that_is_run(self):
        programs = re.findall(r"```cpp\n(.*?)```", README, re.S)
        self.assertEqual(len(programs), 1)
        self.assertIn(programs[0], (ROOT / "examples/01_cantilever.cpp").read_text(encoding="utf-8"))

    def test_every_file_that_it_the_contributing_page_or_a_how_to_page_names_is_there(self):
        text = README + (ROOT / "CONTRIBUTING.md").read_text(encoding="utf-8")
        text += "".join(path.read_text(encoding="utf-8") for path in (ROOT / "courseware/how-to").glob("*.md"))
        names = set(re.findall(r"`((?:examples|courseware|femoop|topology|ui|apps|tests)/[\w./-]*)`", text))
        names |= set(re.findall(r"\]\(([^):]+)\)", text))
        self.assertGreater(len(names), 5)
        missing = sorted(n for n in names if "NN_" not in n and not (ROOT / n).exists())
        self.assertEqual(missing, [])


if __name__ == "__main__":
    sys.exit(unittest.main(verbosity=2))
