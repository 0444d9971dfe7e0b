#!/usr/bin/env python3
"""The headers for users (cmake/public_headers.cmake) include each other, the standard library, Eigen and tl::expected, and
nothing else; docs/library.md names them all."""
import pathlib
import re
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
LIST = (ROOT / "cmake/public_headers.cmake").read_text()
HEADERS = re.findall(r"^    (\w+/\w+\.h)\b", LIST, re.MULTILINE)
OF_OTHERS = re.compile(r"Eigen/\w+|tl/expected\.hpp|[a-z_]+")  # the last: the standard library


class PublicHeaders(unittest.TestCase):
    def test_there_are_some_and_each_once(self):
        self.assertGreater(len(HEADERS), 20)
        self.assertEqual(len(HEADERS), len(set(HEADERS)))

    def test_each_includes_public_ones_only(self):
        for header in HEADERS:
            text = (ROOT / "src/sinew" / header).read_text()
            for bracket, name in re.findall(r'^\s*#\s*include\s*([<"])([^>"]+)', text, re.MULTILINE):
                with self.subTest(header, includes=name):
                    if bracket == '"':
                        self.assertIn(name.removeprefix("sinew/"), HEADERS)
                    else:
                        self.assertRegex(name, f"^({OF_OTHERS.pattern})$")

    def test_the_library_comes_without_the_renderer(self):
        own = re.search(r"SINEW_PUBLIC_HEADERS(.*?)\)", LIST, re.DOTALL).group(1)
        self.assertNotIn("render/", own)
        for header in re.findall(r"\w+/\w+\.h", own):
            self.assertNotIn('"sinew/render', (ROOT / "src/sinew" / header).read_text(), header)

    def test_the_page_names_them_all_and_no_others(self):
        named = re.findall(r"`(\w+/\w+\.h)`", (ROOT / "docs/library.md").read_text())
        self.assertEqual(sorted(set(named)), sorted(HEADERS))

    def test_what_the_page_says_one_calls_is_there(self):
        for line in (ROOT / "docs/library.md").read_text().splitlines():
            cells = line.split("|")
            headers = re.findall(r"`(\w+/\w+\.h)`", line)
            if len(cells) != 5 or not headers:
                continue
            text = "".join((ROOT / "src/sinew" / header).read_text() for header in headers)
            for name in re.findall(r"`(\w+)`", cells[3]):
                with self.subTest(name):
                    self.assertRegex(text, rf"\b{name}\b")


if __name__ == "__main__":
    unittest.main()
