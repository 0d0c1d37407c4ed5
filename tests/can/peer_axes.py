"""The object dictionary of a drive with several axes, made of one with one axis: CiA 301, 7.4.1."""

import copy

import canopen

PROFILE, OBJECTS_OF_AXIS, PDOS_OF_AXIS, PDO_BLOCK, NOT_USED = 0x6000, 0x800, 64, 0x200, 0x80000000


def split(index):
    """The axis of an object, from 0, and its index as that of the first axis; objects of all axes are of the first."""
    axis = max(0, index - PROFILE) // OBJECTS_OF_AXIS
    return axis, index - axis * OBJECTS_OF_AXIS


def index_of(index, axis):
    if index >= PROFILE:
        return index + axis * OBJECTS_OF_AXIS
    return index + axis * PDOS_OF_AXIS if 0x1400 <= index < 0x1C00 else None


def variable_of(variable, index, axis):
    copied = copy.copy(variable)
    copied.index = index
    copied.name = f"{variable.name} of axis {axis + 1}"
    if 0x1400 <= index < 0x1C00 and not index & PDO_BLOCK and variable.subindex == 1:
        copied.default = copied.value = NOT_USED
    return copied


def with_axes(dictionary, axes):
    """Adds the objects of the axes 2 to `axes`."""
    for index, entry in list(dictionary.items()):
        for axis in range(1, axes) if index_of(index, 0) is not None else ():
            there = index_of(index, axis)
            if isinstance(entry, canopen.objectdictionary.ODVariable):
                dictionary.add_object(variable_of(entry, there, axis))
                continue
            group = type(entry)(f"{entry.name} of axis {axis + 1}", there)
            for variable in entry.values():
                group.add_member(variable_of(variable, there, axis))
            dictionary.add_object(group)
    return dictionary
