#!/usr/bin/env python3
"""Types a line and a Tab into an interactive shell: tab.py SHELL MANUAL LINE WANTED

Fails if the terminal does not show WANTED then.
"""
import os
import pty
import re
import select
import signal
import sys
import tempfile
import time

SHELLS = {
    "bash": (["bash", "--norc", "--noprofile", "-i"],
             "PS1='%%'; bind 'set enable-bracketed-paste off'; source {manual}/bash/snell\n"),
    "zsh": (["zsh", "-f", "-i"],
            "PS1='%%%%'; unset zle_bracketed_paste; fpath=({manual}/zsh $fpath); autoload -Uz compinit; "
            "compinit -u -d {home}/dump\n"),
    "fish": (["fish", "--no-config", "-i"], "function fish_prompt; echo '%%'; end; source {manual}/fish/snell.fish\n"),
}


class Terminal:
    def __init__(self, command, environment):
        self.process, self.master = pty.fork()  # fish wants a controlling terminal
        if self.process == 0:
            os.execvpe(command[0], command, environment)
        self.text = ""

    def write(self, text):
        os.write(self.master, text.encode())

    def read_for(self, seconds, until=None):
        """Reads until the text matches, or nothing comes for so long."""
        end = time.monotonic() + seconds
        while time.monotonic() < end and not (until and re.search(until, self.text)):
            if select.select([self.master], [], [], .1)[0]:
                self.text += os.read(self.master, 65536).decode(errors="replace")

    def seen(self):
        """The text without bells and escape sequences."""
        return re.sub(r"\x1b\[[0-9;?]*[A-Za-z]|[\r\x07]", "", self.text)


def main(shell, manual, line, wanted):
    command, setup = SHELLS[shell]
    with tempfile.TemporaryDirectory() as home:
        environment = {**os.environ, "HOME": home, "TERM": "dumb" if shell != "fish" else "xterm", "COLUMNS": "200",
                       "XDG_CONFIG_HOME": home, "XDG_DATA_HOME": home}
        terminal = Terminal(command, environment)
        try:
            terminal.read_for(1)
            terminal.write(setup.format(manual=manual, home=home))
            terminal.read_for(2)
            terminal.write("echo ready\n")
            terminal.read_for(20, r"\nready|ready\r\n[^\n]*$")
            terminal.read_for(1)
            terminal.text = ""
            terminal.write(line + "\t")
            end = time.monotonic() + 20
            while wanted.strip() not in terminal.seen() and time.monotonic() < end:
                terminal.read_for(.2)
            if wanted.strip() not in terminal.seen():
                print(f"{shell} completes '{line}' without '{wanted}':\n{terminal.text!r}")
                return 1
        finally:
            os.kill(terminal.process, signal.SIGKILL)
            os.waitpid(terminal.process, 0)
    return 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:5]))
