"""Files that a reader finds as a whole or not at all."""

import contextlib
import os


@contextlib.contextmanager
def part_of(path):
    """The name of a file beside `path`, which takes its place at the end of the block, and goes where the block fails."""
    part = path + ".part"
    try:
        yield part
        os.replace(part, path)
    except BaseException:
        with contextlib.suppress(OSError):
            os.unlink(part)
        raise
