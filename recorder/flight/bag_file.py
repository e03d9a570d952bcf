"""A bag as a file: opened, and read message by message, with a sentence where it cannot be."""
import contextlib
import dataclasses
import pathlib
import typing

import genpy
import rosbag

from flight.run import RunError

LONGEST = 90 * 24 * 3600.0  # [s]; what lasts longer has times that are none


@dataclasses.dataclass(frozen=True)
class Received:
    """A message, when it was recorded [s since 1970], and the node that sent it ("" where the bag does not say)."""
    topic: str
    message: typing.Any
    time: float
    sender: str


class BagFile:
    """For a `with`. The library reads whatever sizes, names and definitions it finds, and so raises whatever Python raises."""

    def __init__(self, file):
        self.path = pathlib.Path(file)
        if not self.path.is_file():
            raise RunError(f"there is no bag {self.path}; give the file that flight_record.py has written")
        try:
            with damage_told(self.path):
                self.bag = rosbag.Bag(str(self.path))
        except rosbag.ROSBagUnindexedException:
            raise RunError(f"{self.path} was not closed, so its end may be missing; `rosbag reindex {self.path}` repairs it") from None

    def __enter__(self):
        try:
            with damage_told(self.path):
                if not self.bag.get_message_count():
                    raise RunError(f"{self.path} has no messages; record while the command node runs")
                self.began, self.ended = self.bag.get_start_time(), self.bag.get_end_time()
                self.types = {topic: kind.msg_type for topic, kind in self.bag.get_type_and_topic_info().topics.items()}
            if not 0 <= self.ended - self.began <= LONGEST:
                raise RunError(f"{self.path} is damaged: it begins at {self.began:.0f} s since 1970 and ends at {self.ended:.0f} s, and a"
                               f" recording lasts 0 to {LONGEST:.0f} s; use another copy of it")
        except RunError:
            self.bag.close()
            raise
        return self

    def __exit__(self, *_):
        self.bag.close()

    def messages(self):
        """Each message that there is, in the order of their times."""
        reading = self.bag.read_messages(return_connection_header=True)
        while True:
            with damage_told(self.path):
                try:
                    topic, message, received, header = next(reading)
                except StopIteration:
                    return
            self.check_definition(topic, message, text_of(header.get("md5sum", "")))
            yield Received(topic, message, received.to_sec(), text_of(header.get("callerid", "")))

    def check_definition(self, topic, message, recorded):
        """The bag itself says what its messages consist of, and the sum by which sender and recorder had agreed on it."""
        if message._md5sum != recorded:
            raise RunError(f"{self.path} is damaged: the definition of {message._type} of {topic} has the checksum {message._md5sum},"
                           f" but {recorded or 'none'} was recorded; use another copy of it")


@contextlib.contextmanager
def damage_told(path):
    """Whatever goes wrong in the library is said as a RunError; but that a bag was not closed is left to who knows what to do."""
    try:
        yield
    except (RunError, rosbag.ROSBagUnindexedException):
        raise
    except Exception as error:  # pylint: disable=broad-except
        why = " ".join(str(error).split()) or "no details"
        raise RunError(f"{path} cannot be read as a bag, or is damaged ({type(error).__name__}: {why[:300]}); use another copy of it, or record"
                       " again with flight_record.py") from None


@contextlib.contextmanager
def version_told(file):
    """A field that a message does not have is one of another version of this package."""
    try:
        yield
    except AttributeError as error:
        message = getattr(error, "obj", None)
        if not isinstance(message, genpy.Message):
            raise
        raise RunError(f"{file} has {message._type} without the field {error.name}: it was recorded with another version of cobot_command;"
                       " read it with that version") from None


def text_of(value):
    """Of a header's value, which some versions of the library leave as bytes."""
    return value.decode("utf-8", "backslashreplace") if isinstance(value, bytes) else str(value)
