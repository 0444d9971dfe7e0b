"""On a terminal: progress, colours, Ctrl-C. The program's standard error is a pseudo terminal here."""
import os
import pty
import re
import select
import signal
import subprocess
import time
import unittest

from program import SINEW, ProgramTest

PATIENCE = 60  # seconds, for slow machines; nothing waits that long


class OnTerminal(ProgramTest):
    def start(self, *words, **environment):
        """Starts the program with a terminal as standard error."""
        self.terminal, theirs = pty.openpty()
        self.addCleanup(os.close, self.terminal)
        variables = {key: value for key, value in os.environ.items() if key != "NO_COLOR"}
        process = subprocess.Popen([str(SINEW), *words], cwd=self.folder, stdin=subprocess.PIPE, stdout=subprocess.PIPE,
                                   stderr=theirs, env={**variables, "TERM": "xterm", **environment})
        os.close(theirs)
        self.addCleanup(process.wait)
        self.addCleanup(process.kill)
        self.addCleanup(process.stdout.close)
        self.addCleanup(process.stdin.close)
        return process

    def shown(self, until=None):
        """What the terminal shows: all of it, or up to a pattern."""
        text = ""
        end = time.monotonic() + PATIENCE
        while time.monotonic() < end:
            if until and re.search(until, text):
                return text
            if select.select([self.terminal], [], [], 0.1)[0]:
                try:
                    text += os.read(self.terminal, 4096).decode()
                except OSError:  # the program has closed it
                    return text
        self.fail(f"the terminal shows {text!r} only")

    def big_tree(self, nodes=400_000):
        """A skeleton that takes a while: a comb of long teeth."""
        lines = []
        for tooth in range(nodes // 1000):
            lines += [f"n {3 * tooth} 0 {3 * k} 1" for k in range(1000)]
        lines += [f"c {i} {i + 1}" for i in range(nodes - 1) if (i + 1) % 1000]
        lines += [f"c {i} {i + 1000}" for i in range(0, nodes - 1000, 1000)]
        self.write("big.graph", "\n".join(lines) + "\n")


class Colours(OnTerminal):
    def test_errors_are_red(self):
        self.start("skin", "nobody.graph", "-o", "a.obj")
        self.assertIn("\033[1;31msinew:\033[0m nobody.graph", self.shown())

    def test_not_if_unwanted(self):
        for variable, value in [("NO_COLOR", "1"), ("TERM", "dumb")]:
            self.start("skin", "nobody.graph", "-o", "a.obj", **{variable: value})
            self.assertNotIn("\033", self.shown())


class Work(OnTerminal):
    def test_progress_is_shown_and_wiped(self):
        self.big_tree()
        process = self.start("skin", "tube.graph", "big.graph", "-o", "out/", "--quiet")
        self.assertNotIn("[", self.shown())  # --quiet
        self.assertEqual(process.wait(PATIENCE), 0)
        process = self.start("skin", "tube.graph", "big.graph", "-o", "out/")
        text = self.shown()
        self.assertRegex(text, r"2/2 big\.graph \[=* *\] +\d+% [a-z]+")
        self.assertTrue(text.endswith("\r\033[K"), text[-80:])

    def test_interrupted_work_writes_nothing(self):
        self.big_tree()
        self.write("out.obj", "the old file")
        before = self.files()
        process = self.start("skin", "big.graph", "-o", "out.obj")
        self.shown(until=r"\d+% [a-z]")
        process.send_signal(signal.SIGINT)
        self.assertIn("stopped on request", self.shown())
        self.assertEqual(process.wait(PATIENCE), 3)
        self.assertEqual(process.stdout.read(), b"")
        self.assertEqual(self.read("out.obj"), "the old file")
        self.assertEqual(self.files(), before)

    def test_interrupted_while_it_waits_for_input(self):
        for number in (signal.SIGINT, signal.SIGTERM):
            process = self.start("skin", "-", "--from", "graph", "-o", "out.obj")
            process.stdin.write(b"n 0 0 0 1\n")
            process.stdin.flush()
            time.sleep(0.5)  # until it reads
            process.send_signal(number)
            self.assertIn("stopped on request", self.shown())
            self.assertEqual(process.wait(PATIENCE), 3)
            self.assertNotIn("out.obj", self.files())


if __name__ == "__main__":
    unittest.main()
