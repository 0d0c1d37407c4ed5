"""The IDL of a message, for compilers of DDS."""

PRIMITIVES = {"bool": "boolean", "byte": "octet", "char": "uint8", "float32": "float", "float64": "double"}  # others have the same name


def idl_type(field):
    inner = field.message
    kind = f"{inner.package}::{inner.folder}::dds_::{inner.name}_" if inner else PRIMITIVES.get(field.kind, field.kind)
    if field.array and (field.bounded or field.size is None):
        return f"sequence<{kind}, {field.size}>" if field.bounded else f"sequence<{kind}>"
    return f"string<{field.text_bound}>" if field.text_bound else kind


def idl_of(message):
    """With the names that ROS 2 gives its types on DDS: PACKAGE::msg::dds_::Name_."""
    lines = [f'#include "{path}.idl"' for path in sorted({field.message.path for field in message.fields if field.message})]
    lines += [f"module {message.package} {{ module {message.folder} {{ module dds_ {{", "  @final", f"  struct {message.name}_ {{"]
    for field in message.fields:
        size = f"[{field.size}]" if field.array and field.size is not None and not field.bounded else ""
        # a trailing underscore, as ROS 2 itself writes: some names are keywords of IDL
        lines.append(f"    {idl_type(field)} {field.name}_{size};")
    guard = f"MRROC_{message.package}_{message.name}".upper()
    return "\n".join([f"#ifndef {guard}", f"#define {guard}", *lines, "  };", "}; }; };", "#endif", ""])
