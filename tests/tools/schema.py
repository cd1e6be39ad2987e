"""schema.py SCHEMA FILE - is FILE JSON that keeps to SCHEMA?  Says what is wrong."""
import json
import sys
import jsonschema


def once(pairs):
    """An object whose keys stand once."""
    keys = [key for key, _ in pairs]
    if len(keys) > len(set(keys)):
        sys.exit(f"a key stands twice: {keys}")
    return dict(pairs)


def no_number(word):
    """NaN and Infinity are none of JSON's, though Python reads them."""
    sys.exit(f"{word} is no number")


schema, value = (json.load(open(name, encoding="utf-8"), object_pairs_hook=once,
                           parse_constant=no_number) for name in sys.argv[1:])
wrong = jsonschema.Draft7Validator(schema).iter_errors(value)
sys.exit("\n".join(f"{list(e.path)}: {e.message}" for e in wrong) or 0)
