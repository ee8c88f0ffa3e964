"""Laws of processes that were forked: none hangs."""
import multiprocessing
import os
import signal
import subprocess
import sys
import threading
import time
import unittest

import pxm

PATIENCE = 120  # seconds, on a computer that is busy with other tests


def hits(name):
    return int(pxm.render(name, size=(64, 48), threads=2).hit.sum())


def error_of_render():
    try:
        return hits("tetra")
    except pxm.PxmError as error:
        return str(error)


class Fork(unittest.TestCase):
    def in_child(self, function, *arguments):
        """What the function returns in a forked process."""
        context = multiprocessing.get_context("fork")
        receiver, sender = context.Pipe(duplex=False)
        process = context.Process(target=lambda: sender.send(function(*arguments)))
        process.start()
        sender.close()
        self.assertTrue(receiver.poll(PATIENCE), "the forked process hangs")
        answer = receiver.recv()
        process.join(PATIENCE)
        self.assertEqual(process.exitcode, 0)
        return answer

    def test_after_renders_a_child_renders(self):
        expected = hits("tetra")
        for _ in range(3):
            self.assertEqual(self.in_child(hits, "tetra"), expected)
            self.assertEqual(hits("tetra"), expected)

    def test_a_pool_renders(self):
        expected = [hits(name) for name in ("tetra", "menger")]
        with multiprocessing.get_context("fork").Pool(2) as pool:
            self.assertEqual(pool.map_async(hits, ["tetra", "menger"] * 4).get(PATIENCE), expected * 4)

    def test_a_child_of_a_render_refuses(self):
        done = threading.Event()

        def render():
            while not done.is_set():
                pxm.render("tetra", size=(1024, 1024), samples=16, threads=2)
                break

        thread = threading.Thread(target=render)
        thread.start()
        time.sleep(0.3)
        told = self.in_child(error_of_render)
        still = thread.is_alive()
        done.set()
        thread.join()
        if not still:
            self.skipTest("the render was over before the fork")
        self.assertRegex(told, "forked while pxm was at work")
        self.assertGreater(hits("tetra"), 0)

    def test_spawned_processes_render(self):
        with multiprocessing.get_context("spawn").Pool(1) as pool:
            self.assertEqual(pool.map_async(hits, ["tetra"]).get(PATIENCE), [hits("tetra")])


class Interrupt(unittest.TestCase):
    def test_a_program_ends_by_control_c_as_python_programs_do(self):
        code = (
            "import pxm, signal; signal.signal(signal.SIGINT, signal.default_int_handler); print('begins', flush=True); "
            "pxm.render('tetra', size=(1024, 1024), samples=4096)"
        )
        process = subprocess.Popen([sys.executable, "-c", code], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        self.assertEqual(process.stdout.readline(), "begins\n")
        time.sleep(0.3)
        process.send_signal(signal.SIGINT)
        _, told = process.communicate(timeout=PATIENCE)
        self.assertEqual(process.returncode, -signal.SIGINT)
        self.assertIn("KeyboardInterrupt", told)


class Terminal(unittest.TestCase):
    def test_a_line_of_progress_on_a_terminal_alone(self):
        import pty

        master, slave = pty.openpty()
        code = "import pxm; pxm.render('tetra', size=(2048, 2048), samples=16, threads=1)"
        process = subprocess.Popen([sys.executable, "-c", code], stderr=slave)
        os.close(slave)
        seen = b""
        try:
            while chunk := os.read(master, 4096):
                seen += chunk
        except OSError:
            pass  # the end of a terminal
        os.close(master)
        self.assertEqual(process.wait(PATIENCE), 0)
        self.assertRegex(seen, rb"\r\[#*-+\] +\d+ %")
        quiet = subprocess.run([sys.executable, "-c", code], capture_output=True, check=True)
        self.assertEqual(quiet.stderr, b"")


if __name__ == "__main__":
    unittest.main()
