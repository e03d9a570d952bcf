"""A Listen node that says yes to everything and moves nothing: for what a simulated controller would never do."""
import functools
import operator
import socketserver
import threading


def frame(header, content):
    body = f"{header},{len(content)},{content},"
    return f"${body}*{functools.reduce(operator.xor, body.encode()):02X}\r\n".encode()


class ListenNode:
    """With `port`, on which it takes scripts; a context."""

    def __init__(self):
        self.scripts = []
        node = self

        class Client(socketserver.StreamRequestHandler):
            def handle(self):
                self.wfile.write(frame("TMSCT", "0,Listen1"))
                while True:
                    line = self._frame()
                    if not line:
                        return
                    header, _, content = line.split(",", 2)
                    content = content.rsplit(",", 1)[0]
                    if header == "$TMSTA":
                        self.wfile.write(frame("TMSTA", "00,true,Listen1" if content == "00" else f"{content},none"))
                    else:
                        script_id, lines = content.split(",", 1)
                        node.scripts.append(lines)
                        self.wfile.write(frame("TMSCT", f"{script_id},OK"))

            def _frame(self):
                """Up to the checksum; the lines of a script are ended as the frame is."""
                text = ""
                while True:
                    line = self.rfile.readline().decode()
                    text += line
                    if not line:
                        return ""
                    if line[-5:-4] == "*":
                        return text[:-5]

        self._server = socketserver.ThreadingTCPServer(("127.0.0.1", 0), Client)
        self._server.daemon_threads = True
        self.port = self._server.server_address[1]

    def __enter__(self):
        threading.Thread(target=self._server.serve_forever, daemon=True).start()
        return self

    def __exit__(self, *_):
        self._server.shutdown()
        self._server.server_close()
