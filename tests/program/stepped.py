# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs that go on step by step: each line that a run says waits in a pipe that holds
no other, so that the run is never more than a line ahead of who reads, however
fast or slow the machine is. So it can be stopped at a line, and has not ended.

usage: stepped.py PIPE COMMAND...    (the command, with its lines in the named pipe)
"""

import fcntl
import os
import signal
import subprocess
import sys

F_SETPIPE_SZ = 1031
LONGEST_LINE = 4096


class SteppedRun:
    """A program that says lines on standard output, alone or under mpirun."""

    def __init__(self, launcher, command, pipe, **options):
        os.mkfifo(pipe)
        self.process = subprocess.Popen(
            [*launcher, sys.executable, "-B", __file__, str(pipe), *command],
            stdin=subprocess.DEVNULL, stderr=subprocess.PIPE, universal_newlines=True,
            start_new_session=True, **options)
        # Until the program has opened it, too.
        self.pipe = os.open(pipe, os.O_RDONLY)

    def read(self):
        """The next line; nothing where the run has ended."""
        return os.read(self.pipe, LONGEST_LINE).decode()

    def advance(self, n_lines):
        """Let it say so many lines more; it stops at the second behind them."""
        for _ in range(n_lines):
            self.read()

    def send(self, number):
        """Send a signal to all processes, also to those which mpirun has started."""
        for name in os.listdir("/proc"):
            try:
                if name.isdigit() and os.getsid(int(name)) == self.process.pid:
                    os.kill(int(name), number)
            except ProcessLookupError:
                pass

    def finish(self):
        """Let it run to its end; status and message, and its remaining lines."""
        lines = list(iter(self.read, ""))
        os.close(self.pipe)
        _, message = self.process.communicate()
        return self.process.returncode, message.strip(), lines

    def kill(self):
        self.send(signal.SIGKILL)
        return self.finish()


def become(pipe, command):
    """Replace this process by the command, whose lines go into the pipe."""
    end = os.open(pipe, os.O_WRONLY)
    # Each write is a packet of its own, and there is room for one.
    fcntl.fcntl(end, fcntl.F_SETFL, os.O_DIRECT)
    fcntl.fcntl(end, F_SETPIPE_SZ, 1)
    os.dup2(end, sys.stdout.fileno())
    os.close(end)
    os.execvp(command[0], command)


if __name__ == "__main__":
    become(sys.argv[1], sys.argv[2:])
