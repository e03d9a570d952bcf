"""What a replay has found."""
import dataclasses


@dataclasses.dataclass(frozen=True)
class Difference:
    time: float  # [s] since the recording began
    what: str
    recorded: str
    came: str

    def __str__(self):
        return f"{self.time:10.3f} s  {self.what}\n{'recorded:':>22} {self.recorded}\n{'received:':>22} {self.came}"


@dataclasses.dataclass
class Verdict:
    """Of one replay: how many were compared, and what was otherwise."""
    name: str
    compared: int = 0
    not_compared: int = 0
    differences: list = dataclasses.field(default_factory=list)
    remarks: list = dataclasses.field(default_factory=list)

    @property
    def agrees(self):
        return not self.differences

    def __str__(self):
        beside = f", {self.not_compared} may differ" if self.not_compared else ""
        return f"{self.name}: {self.compared} compared{beside}, {len(self.differences)} differ"
