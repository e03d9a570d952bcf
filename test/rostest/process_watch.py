"""What a running node takes of the machine, as /proc tells it."""
import collections
import os
import xmlrpc.client

import rosgraph

Counts = collections.namedtuple("Counts", "descriptors threads kibibytes")


def pid_of(node):
    """Of a running node; raises when there is none."""
    address = rosgraph.Master("/process_watch").lookupNode(rosgraph.names.script_resolve_name("/process_watch", node))
    code, message, pid = xmlrpc.client.ServerProxy(address).getPid("/process_watch")
    if code != 1:
        raise RuntimeError(f"{node}: {message}")
    return pid


def counts_of(pid):
    """Raises FileNotFoundError when the process has ended."""
    lines = open(f"/proc/{pid}/status", encoding="utf-8").read().splitlines()
    fields = dict(line.split(":", 1) for line in lines)
    return Counts(len(os.listdir(f"/proc/{pid}/fd")), int(fields["Threads"]), int(fields["VmRSS"].split()[0]))
