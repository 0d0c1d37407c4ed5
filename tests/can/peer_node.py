"""One node of the bus over python-canopen, with the network management and the heartbeats of CiA 301; its profile is a subclass."""

import threading
import time

import canopen
from canopen.sdo import SdoAbortedError

from peer_pdo import ProcessData
from peer_states import error_register

HEARTBEAT_LOST, WRONG_VALUE = 0x8130, 0x06090030
OPERATIONAL, PRE_OPERATIONAL = 5, 127
STOP, RESET_NODE, RESET_COMMUNICATION = 2, 129, 130


class PeerNode:
    def __init__(self, network, number, eds, cycle=None):
        """`cycle`: s by which each SYNC advances an operational device; None: it runs in real time."""
        self.network, self.lock, self.silent, self.cycle = network, threading.RLock(), False, cycle
        self.node = network.create_node(number, self.dictionary(eds, number))
        for identifier, handler in ((0, self.node.nmt.on_command), (self.node.sdo.rx_cobid, self.node.sdo.on_request)):
            network.unsubscribe(identifier, handler)  # on_frame handles them, because it can suppress an answer
        self.node.add_read_callback(self.read)
        self.node.add_write_callback(self.written)
        self.data = ProcessData(self.node, self.send)
        self.restart()

    # --- objects
    def number(self, index, subindex=0):
        return self.node.object_dictionary.get_variable(index, subindex).decode_raw(self.node.get_data(index, subindex))

    def read(self, index, subindex, **_):
        if index == 0x1001:
            return error_register(self.error)
        if index == 0x1003:
            return len(self.history) if subindex == 0 else (self.history + [0] * 8)[subindex - 1]
        return self.actual(index, subindex)

    def written(self, index, subindex, data, **_):
        if index == 0x1003:
            if any(data):
                raise SdoAbortedError(WRONG_VALUE)
            self.history = []
        self.change(index, subindex, data)

    # --- the profile
    def dictionary(self, eds, number):
        return canopen.import_od(eds, number)

    def power_on(self):
        """The device as after power-on."""

    def actual(self, index, subindex):
        """The present value of an object; None: the one that was written."""

    def change(self, index, subindex, data):
        """An object has been written; an exception refuses it."""

    def step(self, seconds):
        """Time passes."""

    def react(self):
        """The device fails."""

    def stopped(self):
        """The node has been stopped (NMT)."""

    # --- faults
    def fault(self, code):
        with self.lock:
            self.error = code
            self.history = [code, *self.history][:8]
            self.react()
            self.send_emergency()

    def heal(self):
        """The fault has ended."""
        self.error = 0
        self.send_emergency()

    def send_emergency(self):
        if self.node.nmt._state in (OPERATIONAL, PRE_OPERATIONAL) and not self.silent:
            self.node.emcy.send(self.error, error_register(self.error))

    # --- network management
    def restart(self, whole=True):
        """Power on and the reset of the node, or the reset of its communication."""
        with self.lock:
            if whole:
                self.power_on()
                self.error, self.history = 0, []
            self.node.data_store = {index: stored for index, stored in self.node.data_store.items()
                                    if not whole and not 0x1000 <= index < 0x2000}
            self.data.changed = True
            self.heard = {}  # producer: time of its last heartbeat
            self.stepped = time.monotonic()
            self.node.nmt.stop_heartbeat()
            self.node.nmt.state = "INITIALISING"  # the boot-up message
            self.node.nmt.state = "PRE-OPERATIONAL"

    def set_silent(self, silent):
        with self.lock:
            self.silent = silent
            self.node.nmt.start_heartbeat(0 if silent else self.number(0x1017))

    def watch_producers(self, now):
        for entry in range(1, self.number(0x1016, 0) + 1):
            producer, limit = self.number(0x1016, entry) >> 16 & 0x7F, (self.number(0x1016, entry) & 0xFFFF) / 1000
            if limit and now - self.heard.get(producer, now) > limit:
                del self.heard[producer]  # watched again from its next heartbeat on
                if self.node.nmt._state == OPERATIONAL:
                    self.node.nmt.state = "PRE-OPERATIONAL"  # the default of 1029h
                self.fault(HEARTBEAT_LOST)

    # --- what comes in
    def on_frame(self, message):
        with self.lock:
            identifier, data, state = message.arbitration_id, bytes(message.data), self.node.nmt._state
            if self.silent or message.is_remote_frame or message.is_extended_id or message.is_error_frame:
                return
            if identifier == 0 and len(data) >= 2 and data[1] in (0, self.node.id):
                self.node.nmt.on_command(identifier, data, message.timestamp)
                self.data.changed = True
                if data[0] == STOP:
                    self.stopped()
                if data[0] in (RESET_NODE, RESET_COMMUNICATION):
                    self.restart(data[0] == RESET_NODE)
            elif identifier == self.node.sdo.rx_cobid and state in (OPERATIONAL, PRE_OPERATIONAL):
                self.node.sdo.on_request(identifier, bytearray(data), message.timestamp)
            elif 0x700 < identifier < 0x780:
                self.heard[identifier - 0x700] = time.monotonic()
            elif identifier == self.number(0x1005) & 0x7FF and state == OPERATIONAL:
                self.data.sync_in()
                self.step(self.cycle if self.cycle else self.passed())
                self.data.sync_out()
            elif state == OPERATIONAL:
                self.data.take(identifier, data)

    def passed(self):
        """s since the last call."""
        before, self.stepped = self.stepped, time.monotonic()
        return self.stepped - before

    def tick(self):
        with self.lock:
            passed, operational = self.passed(), self.node.nmt._state == OPERATIONAL
            if not self.cycle or not operational:  # without SYNC there are no cycles
                self.step(passed)
            self.watch_producers(time.monotonic())
            if operational:
                self.data.events()

    def send(self, identifier, data):
        if not self.silent:
            self.network.send_message(identifier, data)
