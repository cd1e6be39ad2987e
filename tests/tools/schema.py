"""schema.py SCHEMA FILE - is FILE JSON that keeps to SCHEMA?  Says what is wrong."""
import json
import sys
import jsonschema

schema, value = (json.load(open(name, encoding="utf-8")) for name in sys.argv[1:])
wrong = jsonschema.Draft7Validator(schema).iter_errors(value)
sys.exit("\n".join(f"{list(e.path)}: {e.message}" for e in wrong) or 0)
