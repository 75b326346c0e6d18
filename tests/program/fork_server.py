# SPDX-License-Identifier: LGPL-2.1-or-later
"""Many short runs of one program: see fork_server.cc."""

import os
import pathlib
import subprocess


class ForkServer:
    """A program that has been loaded once, from which runs are forked, one at a time.

    library: what fork_server.cc is compiled to.
    """

    def __init__(self, program, library):
        self.server = subprocess.Popen(
            [program], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True,
            env={**os.environ, "LD_PRELOAD": library, "OPENBLAS_NUM_THREADS": "1"})

    def run(self, arguments, directory, time_limit, memory_limit):
        """Exit status, negative for a signal, and what was said on standard error.

        time_limit: seconds of processor time.
        memory_limit: bytes.
        """
        messages = pathlib.Path(directory) / "messages"
        fields = [directory, messages, time_limit, memory_limit, *arguments]
        fields = [str(field) for field in fields]
        if any(separator in field for field in fields for separator in "\t\n"):
            raise ValueError(f"no tabs and line breaks in {fields}")
        self.server.stdin.write("\t".join(fields) + "\n")
        self.server.stdin.flush()
        status = os.waitstatus_to_exitcode(int(self.server.stdout.readline()))
        return status, messages.read_text(errors="replace")

    def close(self):
        self.server.stdin.close()
        self.server.wait()
