"""The process data of a node, as the objects 1400h to 1BFFh define it at the moment; python-canopen does not implement it."""

import time

from canopen.sdo import SdoAbortedError

INVALID = 0x80000000
MAPPING_LENGTH, NO_MAPPING, WRONG_STATE = 0x06040042, 0x06040041, 0x08000022
EVENT_DRIVEN = 254  # and 255; smaller transmission types wait for SYNCs


class ProcessData:
    """Frames in and out of `node`, a canopen.LocalNode; `send(identifier, data)` sends one."""

    def __init__(self, node, send):
        self.node, self.send = node, send
        self.changed = True
        node.add_write_callback(self.check)
        self.receive, self.transmit = [], []

    def number(self, index, subindex):
        return int.from_bytes(self.node.get_data(index, subindex), "little")

    def check(self, index, subindex, data, **_):
        """Refuses, as a drive does, a change of a mapping in use, an object that cannot be mapped, and frames that are too long."""
        if not 0x1400 <= index < 0x1C00:
            return
        self.changed = True
        if not index & 0x200:
            return
        value = int.from_bytes(data, "little")
        if not self.number(index - 0x200, 1) & INVALID or (subindex and self.number(index, 0)):
            raise SdoAbortedError(WRONG_STATE)
        if subindex and value:
            objects = self.node.object_dictionary
            found = objects.get_variable(value >> 16, value >> 8 & 0xFF)
            writable = found is not None and (found.writable or index >= 0x1A00)
            if found is None or not writable or not found.pdo_mappable or len(found) != value & 0xFF:
                raise SdoAbortedError(NO_MAPPING)
        elif sum(self.number(index, entry) & 0xFF for entry in range(1, value + 1)) > 64:
            raise SdoAbortedError(MAPPING_LENGTH)

    def read(self, communication):
        """One frame as its objects define it; nothing when it is switched off."""
        identifier = self.number(communication, 1)
        if identifier & INVALID:
            return []
        entries = [self.number(communication + 0x200, entry + 1) for entry in range(self.number(communication + 0x200, 0))]
        frame = {"identifier": identifier & 0x7FF, "type": self.number(communication, 2), "pending": None,
                 "objects": [(entry >> 16, entry >> 8 & 0xFF, (entry & 0xFF) // 8) for entry in entries],
                 "syncs": 0, "sent": None, "time": 0.0}
        if communication >= 0x1800:
            frame |= {"inhibit": self.number(communication, 3) / 10000, "event": self.number(communication, 5) / 1000}
        return [frame]

    def refresh(self):
        if self.changed:
            self.changed = False
            present = [index for index in self.node.object_dictionary if 0x1400 <= index < 0x1A00 and not index & 0x200]
            self.receive = [frame for index in present if index < 0x1600 for frame in self.read(index)]
            self.transmit = [frame for index in present if index >= 0x1800 for frame in self.read(index)]

    def take(self, identifier, data):
        """A frame from the bus: applied now, or at the next SYNC."""
        self.refresh()
        for frame in self.receive:
            if frame["identifier"] == identifier and len(data) >= sum(size for _, _, size in frame["objects"]):
                frame["pending"] = data
                if frame["type"] >= EVENT_DRIVEN:
                    self.apply(frame)

    def apply(self, frame):
        data, frame["pending"] = frame["pending"], None
        for index, subindex, size in frame["objects"] if data is not None else ():
            try:
                self.node.set_data(index, subindex, bytes(data[:size]))
            except SdoAbortedError:
                pass  # a value out of range is ignored
            data = data[size:]

    def sync_in(self):
        self.refresh()
        for frame in self.receive:
            self.apply(frame)

    def sync_out(self):
        for frame in self.transmit:
            frame["syncs"] += 1
            data, kind = self.content(frame), frame["type"]
            if (1 <= kind <= 240 and frame["syncs"] % kind == 0) or (kind == 0 and data != frame["sent"]):
                frame["sent"] = data
                self.send(frame["identifier"], data)

    def events(self):
        """Event-driven frames that have changed or whose event timer has expired."""
        self.refresh()
        now = time.monotonic()
        for frame in self.transmit:
            if frame["type"] < EVENT_DRIVEN:
                continue
            data, age = self.content(frame), now - frame["time"]
            if (data != frame["sent"] and age >= frame["inhibit"]) or (frame["event"] and age >= frame["event"]):
                frame["sent"], frame["time"] = data, now
                self.send(frame["identifier"], data)

    def content(self, frame):
        return b"".join(self.node.get_data(index, subindex) for index, subindex, _ in frame["objects"])
