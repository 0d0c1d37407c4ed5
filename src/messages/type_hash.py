"""The hash by which ROS 2 compares a type on two sides of a topic: RIHS01, version 1 of REP 2016.

It is the SHA-256 of the type's description as JSON: its fields, then the descriptions of the messages that it contains.
"""

import hashlib
import json

NESTED = 1
TYPE_IDS = {"int8": 2, "uint8": 3, "int16": 4, "uint16": 5, "int32": 6, "uint32": 7, "int64": 8, "uint64": 9, "float32": 10,
            "float64": 11, "char": 3, "bool": 15, "byte": 16, "string": 17}  # type_description_interfaces/msg/FieldType
BOUNDED_STRING = 21
ARRAY, BOUNDED_SEQUENCE, SEQUENCE = 48, 96, 144  # added to the number of the element's type


def describe_field(field):
    number = TYPE_IDS.get(field.kind, NESTED)
    if field.text_bound:
        number = BOUNDED_STRING
    if field.array:
        number += SEQUENCE if field.size is None else BOUNDED_SEQUENCE if field.bounded else ARRAY
    return {"name": field.name,
            "type": {"type_id": number, "capacity": field.size or 0, "string_capacity": field.text_bound or 0,
                     "nested_type_name": field.message.ros_type if field.message else ""}}


def describe(message):
    return {"type_name": message.ros_type, "fields": [describe_field(field) for field in message.fields]}


def type_hash(message, contained):
    """`contained`: the messages in it, each once."""
    inner = sorted((describe(each) for each in contained), key=lambda each: each["type_name"])
    whole = {"type_description": describe(message), "referenced_type_descriptions": inner}
    return "RIHS01_" + hashlib.sha256(json.dumps(whole).encode()).hexdigest()
