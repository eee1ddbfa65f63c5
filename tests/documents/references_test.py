"""Every source that the code cites as [Key] or [Key, place] stands in courseware/references.bib, and the other way."""
import pathlib
import re
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
SOURCE = re.compile(r"///\s+Source\s+(.*(?:\n\s*///(?: {4,}|\s*\[).*)*)")
CITED = re.compile(r"\[([A-Z][A-Za-z]+[0-9]*)(?:,[^\]]*)?\]")


def cited():
    keys = {}
    for folder in ("topology", "femoop", "ui", "apps"):
        for path in sorted((ROOT / folder).rglob("*.h")):
            for source in SOURCE.findall(path.read_text(encoding="utf-8")):
                for key in CITED.findall(source):
                    keys.setdefault(key, path.relative_to(ROOT))
    return keys


class References(unittest.TestCase):
    entries = re.findall(r"^@\w+\{(\w+),", (ROOT / "courseware/references.bib").read_text(encoding="utf-8"), re.M)

    def test_whatever_is_cited_is_listed(self):
        self.assertEqual({}, {key: str(path) for key, path in cited().items() if key not in self.entries})

    def test_whatever_is_listed_is_cited(self):
        self.assertEqual([], [key for key in self.entries if key not in cited()])

    def test_the_list_is_in_order_and_has_each_once(self):
        self.assertEqual(sorted(set(self.entries)), self.entries)


if __name__ == "__main__":
    unittest.main()
