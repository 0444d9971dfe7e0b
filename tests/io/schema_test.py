#!/usr/bin/env python3
"""docs/sinew.schema.json accepts every sound document at hand, and refuses what is malformed in a way a schema can see.

usage: schema_test.py SOURCE_FOLDER      exit status 77 (skipped) where python3-jsonschema is missing
"""
import json
import pathlib
import sys

try:
    import jsonschema
except ImportError:
    print("skipped: python3-jsonschema is not installed")
    sys.exit(77)

# What needs more than a schema: relations between nodes, and text that is not JSON at all.
BEYOND = {"id_twice", "parent_unknown", "parent_itself", "parent_cycle", "cone_at_a_branch", "lone_hemisphere",
          "link_unknown", "link_over_a_bone", "key_twice", "deep"}
NO_JSON = {"empty", "not_json", "truncated", "trailing_comma", "text_behind", "nan", "not_utf8", "utf16"}


def refuse_constant(name):
    raise ValueError(name)


def main():
    source = pathlib.Path(sys.argv[1])
    schema = json.loads((source / "docs/sinew.schema.json").read_text())
    jsonschema.Draft7Validator.check_schema(schema)
    validator = jsonschema.Draft7Validator(schema)
    failures = []

    sound = sorted((source / "tests/fuzz/corpus/sinew").glob("*.sinew")) + sorted((source / "examples").rglob("*.sinew"))
    for path in sound:
        for error in validator.iter_errors(json.loads(path.read_text(encoding="utf-8-sig"))):
            failures.append(f"{path}: refused at /{'/'.join(map(str, error.absolute_path))}: {error.message}")

    malformed = sorted((source / "tests/io/malformed").glob("*.sinew"))
    for path in malformed:
        try:
            document = json.loads(path.read_text(encoding="utf-8"), parse_constant=refuse_constant)
        except (ValueError, UnicodeDecodeError):
            if path.stem not in NO_JSON:
                failures.append(f"{path}: is not JSON, and should be")
            continue
        if validator.is_valid(document) != (path.stem in BEYOND):
            failures.append(f"{path}: valid is {validator.is_valid(document)}")

    print(*failures, sep="\n")
    print(f"{len(sound)} sound and {len(malformed)} malformed documents, {len(failures)} failures")
    return 1 if failures or not sound or not malformed else 0


sys.exit(main())
