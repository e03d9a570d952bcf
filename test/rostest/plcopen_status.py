"""The PLCopen rules that every single command_status has to hold, and those between it and the one before; doc/plcopen.md
numbers them."""
from cobot_command.msg import CommandStatus

QUEUED_BLOCKS = {"move_absolute", "move_relative", "move_circle", "change_base", "change_tcp", "change_load",
                 "set_output", "wait_for_input", "wait_time", "exit_listen_node",
                 "run_script", "pick_and_place", "load_path"}
MOST_WAITING = 64


class StatusRules:
    """`table`: (block, error id) of all errors that can occur, of doc/errors.md."""

    def __init__(self, table):
        self._table = table
        self._last = None
        self._executed = set()
        self.lost = 0  # messages that never came here; what lies between them is not judged

    def check(self, status):
        """What is against the rules, in words."""
        faults = [fault for block in status.blocks for fault in self._block_faults(block)]
        faults += self._queue_faults(status)
        last = self._last
        if last is not None and status.header.seq == last.header.seq + 1:
            faults += self._changes(last, status)
        elif last is not None:
            self.lost += max(status.header.seq - last.header.seq - 1, 0)
        self._last = status
        name = f"command_status {status.header.seq} at {status.header.stamp.to_sec():.6f}"
        return [f"{name}: {fault}" for fault in faults]

    def start_anew(self):
        """Another node speaks from now on."""
        self._last = None
        self._executed = set()

    def _block_faults(self, block):
        name, on = block.block, [o for o in ("busy", "done", "error", "command_aborted") if getattr(block, o)]
        if on:
            self._executed.add(name)
        if len(on) > 1 or (not on and name in self._executed):
            yield f"R1, R3: {name} is {on or 'idle, though it was executed'}"
        exclusive = (block.active, block.done, block.error, block.command_aborted)
        if sum(exclusive) > 1 or (block.active and not block.busy):
            yield f"R2: {name} is active and {on}"
        if block.error != bool(block.error_id) or block.error != bool(block.error_description):
            yield f"{name} has error {block.error}, error_id {block.error_id}, '{block.error_description}'"
        if block.error and (name, block.error_id) not in self._table:
            yield f"{name} has 16#{block.error_id:X}, which its table does not have"
        if block.command_id_ack not in range(16):
            yield f"{name} acknowledges command {block.command_id_ack}"

    @staticmethod
    def _queue_faults(status):
        blocks = {block.block: block for block in status.blocks}
        busy = {name for name, block in blocks.items() if block.busy}
        queued = busy & QUEUED_BLOCKS
        active = [name for name in sorted(QUEUED_BLOCKS) if blocks[name].active]
        depth = status.commands_under_way + status.commands_waiting
        under_way, waiting = status.commands_under_way, status.commands_waiting
        if status.queue_depth != depth or under_way not in (0, 1) or waiting > MOST_WAITING:
            yield f"{under_way} under way, {waiting} wait, queue_depth {status.queue_depth}"
        # A set_output that is at_once has no turn.
        if (depth > 0 and not queued) or (depth == 0 and queued - {"set_output"}):
            yield f"R1: {depth} commands, and busy are {sorted(queued)}"
        if status.waiting_return != (depth > 0 or "stop" in busy):
            yield f"waiting_return is {status.waiting_return} with {depth} commands and {sorted(busy)} busy"
        if len(active) > 1 or len(active) > status.commands_under_way:
            yield f"R9: one robot executes {active}, {status.commands_under_way} are under way"
        if "stop" in busy and active:
            yield f"R9: {active} active in a stop"
        if status.link_state == CommandStatus.DISCONNECTED and busy - {"connect"}:
            yield f"busy without a connection: {sorted(busy)}"
        tags = list(status.open_tags)
        if len(set(tags)) != len(tags) or not set(tags) <= set(range(1, 16)):
            yield f"open tags {tags}"

    @staticmethod
    def _changes(before, after):
        for counter in ("late_replies", "decode_faults"):
            if getattr(after, counter) < getattr(before, counter):
                yield f"{counter} fell from {getattr(before, counter)} to {getattr(after, counter)}"
        for old, new in zip(before.blocks, after.blocks):
            if new.error and old.error and old.error_id == new.error_id:
                continue
            if old.error and not (new.busy or new.done or new.error or new.command_aborted):
                yield f"R3: {new.block} lost its error without another execution"
