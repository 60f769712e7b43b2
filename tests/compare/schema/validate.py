#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""validate.py SCHEMA DOCUMENTS: for each line of DOCUMENTS, a JSON text, prints a line: where it breaks the schema and
how, or nothing if it fits."""
import json
import sys

import jsonschema

with open(sys.argv[1], encoding="utf-8") as file:
    schema = json.load(file)
jsonschema.Draft7Validator.check_schema(schema)
validator = jsonschema.Draft7Validator(schema)
with open(sys.argv[2], encoding="utf-8") as documents:
    for line in documents:
        faults = sorted(f"/{'/'.join(map(str, error.absolute_path))}: {error.message}"
                        for error in validator.iter_errors(json.loads(line)))
        print(faults[0].replace("\n", " ") if faults else "")
