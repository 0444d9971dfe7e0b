#!/usr/bin/env python3
"""The table of docs/limits.md says what the sources say.

usage: limits_test.py FOLDER_OF_THE_PROJECT
"""
import pathlib
import re
import sys
import unittest

PROJECT = pathlib.Path(".")
ROW = re.compile(r"^\| (?P<what>.+) \| (?P<number>\d+) \| `(?P<name>\w+)` \| `(?P<file>\S+)` \|$", re.MULTILINE)


def rows():
    return list(ROW.finditer((PROJECT / "docs/limits.md").read_text()))


def value_in_source(name, text):
    """Of `name = expression` or `name{expression}`; shifts and digits in groups are understood."""
    found = re.search(rf"\b{name} ?= ?([^;,]+)[;,]", text)
    if not found:
        raise AssertionError(f"{name} is not there")
    expression = re.sub(r"std::uint64_t\{(\d+)\}", r"\1", found[1]).replace("'", "")
    if not re.fullmatch(r"[\d <]+", expression):
        raise AssertionError(f"{name}: {expression} is no number")
    return eval(expression)  # digits and << only


class Limits(unittest.TestCase):
    def test_every_row_of_the_table_is_read(self):
        lines = [line for line in (PROJECT / "docs/limits.md").read_text().splitlines() if line.startswith("| ")]
        self.assertEqual(len(rows()), len(lines) - 1)  # without the head
        self.assertGreater(len(rows()), 10)

    def test_the_numbers_are_those_of_the_sources(self):
        for row in rows():
            with self.subTest(row["name"]):
                text = (PROJECT / row["file"]).read_text()
                self.assertEqual(value_in_source(row["name"], text), int(row["number"]))


if __name__ == "__main__":
    PROJECT = pathlib.Path(sys.argv.pop())
    unittest.main()
