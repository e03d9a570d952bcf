#!/usr/bin/env python3
"""Tries the container image of the simulator without a container engine: unpacks its layers, starts its entry point there as its user, and moves
the arm as a client on its ports. Needs root, and a network namespace of its own, so that nothing else has the ports.

try_image.py ARCHIVE FOLDER: an oci-archive, and an empty folder that is a file system of the image afterwards. Exit status 0: the arm moved."""
import fcntl
import json
import os
import pathlib
import re
import shutil
import signal
import socket
import struct
import subprocess
import sys
import tarfile
import time

LARGEST = 250 << 20  # bytes of the archive
TARGET = [30.0, -20.0, 100.0, 10.0, 80.0, -45.0]  # [deg]
PATIENCE = 30.0  # [s]


def read(archive, digest):
    return archive.extractfile(f"blobs/{digest.replace(':', '/')}")


def unpack(archive, folder):
    """Returns the configuration of the image."""
    manifest = json.load(read(archive, json.load(archive.extractfile("index.json"))["manifests"][0]["digest"]))
    for layer in manifest["layers"]:
        with tarfile.open(fileobj=read(archive, layer["digest"])) as files:
            kept = []
            for file in files:
                path = folder / file.name
                if path.name.startswith(".wh."):
                    remove(path)
                else:
                    kept.append(file)
            files.extractall(folder, kept, numeric_owner=True, **({"filter": "fully_trusted"} if hasattr(tarfile, "fully_trusted_filter") else {}))
    return json.load(read(archive, manifest["config"]["digest"]))["config"]


def remove(marker):
    """What a layer says is removed: the file whose name is after .wh., or all of a folder."""
    if marker.name == ".wh..wh..opq":
        targets = list(marker.parent.iterdir())
    else:
        targets = [marker.with_name(marker.name[len(".wh."):])]
    for target in targets:
        if target.is_dir() and not target.is_symlink():
            shutil.rmtree(target)
        else:
            target.unlink(missing_ok=True)


def enable_loopback():
    request = struct.pack("16sh22x", b"lo", 0x1)  # IFF_UP
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as any_socket:
        fcntl.ioctl(any_socket, 0x8914, request)  # SIOCSIFFLAGS


def frame(header, data):
    body = f"{header},{len(data)},{data},"
    check = 0
    for byte in body.encode():
        check ^= byte
    return f"${body}*{check:02X}\r\n".encode()


def wait_for(connection, pattern):
    deadline, received = time.monotonic() + PATIENCE, b""
    while not re.search(pattern, received):
        if time.monotonic() > deadline:
            raise TimeoutError(f"no {pattern} in {received[-200:]}")
        connection.settimeout(PATIENCE)
        received += connection.recv(65536)
    return re.search(pattern, received)


def move():
    """Returns where the arm was before and where it is afterwards [deg]."""
    with socket.create_connection(("127.0.0.1", 5890), PATIENCE) as script, socket.create_connection(("127.0.0.1", 5891), PATIENCE) as status:
        joints = rb'"Item":"Joint_Angle","Value":(\[[^\]]*\])'
        before = json.loads(wait_for(status, joints)[1])
        script.sendall(frame("TMSCT", 'first,PTP("JPP",%s,50,200,0,false)\r\nQueueTag(1)' % ",".join(f"{angle:g}" for angle in TARGET)))
        wait_for(script, rb"\$TMSCT,\d+,first,OK")
        wait_for(script, rb"\$TMSTA,\d+,01,01,true")
    with socket.create_connection(("127.0.0.1", 5891), PATIENCE) as status:
        return before, json.loads(wait_for(status, joints)[1])


def faults(archive, folder):
    size = archive.stat().st_size
    if size > LARGEST:
        yield f"it has {size >> 20} MiB; allowed are {LARGEST >> 20}"
    with tarfile.open(archive) as opened:
        config = unpack(opened, folder)
    print(f"user {config['User']}, ports {', '.join(sorted(config['ExposedPorts']))}, entry point {' '.join(config['Entrypoint'])}; {size >> 20} MiB")
    yield from faults_of(["chroot", f"--userspec={config['User']}", str(folder), *config["Entrypoint"], "--stream-format", "json"], folder)


def faults_of(command, folder):
    """As the first process of a namespace, as a container engine starts it: signals without a handler do not reach it."""
    enable_loopback()
    with subprocess.Popen(["unshare", "--pid", "--fork", "--kill-child", f"--mount-proc={folder}/proc", *command], stdout=subprocess.PIPE,
                          text=True) as program:
        started = program.stdout.readline().strip()
        print(started)
        if started.startswith("listening "):
            try:
                before, after = move()
            except OSError as error:  # of which a timeout is one
                program.kill()
                yield f"a client could not move the arm: {error}"
                return
            print(f"joints before {before}, after {after}")
            if max(abs(found - wanted) for found, wanted in zip(after, TARGET)) > 0.1:
                yield f"the arm is at {after}, and was sent to {TARGET}"
            first = pathlib.Path(f"/proc/{program.pid}/task/{program.pid}/children").read_text(encoding="ascii")
            os.kill(int(first), signal.SIGTERM)
    if program.returncode != 0:
        yield f"its program ended with {program.returncode}; needed is 0, after SIGTERM"


def main():
    found = list(faults(pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])))
    print("\n".join(found) or "The image starts, serves both ports, moves the arm and ends.")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
