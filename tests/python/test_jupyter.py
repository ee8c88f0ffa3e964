"""Laws of a real notebook: a kernel of Jupyter is started and asked as a page would."""
import time
import unittest

from jupyter_client.manager import start_new_kernel

PATIENCE = 120  # seconds, on a computer that is busy with other tests


class Notebook(unittest.TestCase):
    def setUp(self):
        self.manager, self.client = start_new_kernel(startup_timeout=PATIENCE)
        self.addCleanup(self.manager.shutdown_kernel, now=True)
        self.addCleanup(self.client.stop_channels)

    def begin(self, code, stop_on_error=True):
        return self.client.execute(code, stop_on_error=stop_on_error)

    def messages(self, asked):
        """What a page is told until the cell is done."""
        told = []
        end = time.monotonic() + PATIENCE
        while time.monotonic() < end:
            message = self.client.get_iopub_msg(timeout=PATIENCE)
            if message["parent_header"].get("msg_id") != asked:
                continue
            if message["msg_type"] == "status" and message["content"]["execution_state"] == "idle":
                return told
            told.append(message)
        self.fail("the cell does not end")

    def of_type(self, told, kind):
        return [message["content"] for message in told if message["msg_type"] == kind]

    def test_a_long_render_shows_a_bar_that_goes(self):
        told = self.messages(self.begin("import pxm\np = pxm.render('tetra', size=(2048, 2048), samples=16, threads=1)"))
        self.assertEqual(self.of_type(told, "error"), [])
        (shown,) = self.of_type(told, "display_data")
        updates = self.of_type(told, "update_display_data")
        self.assertRegex(shown["data"]["text/html"], r'^<progress value="0\.\d+"></progress> \d+ %$')
        name = shown["transient"]["display_id"]
        self.assertTrue(updates)
        for update in updates:
            self.assertEqual(update["transient"]["display_id"], name)
        self.assertEqual(updates[-1]["data"]["text/html"], "")
        shares = [float(update["data"]["text/html"][17:22]) for update in updates[:-1]]
        self.assertEqual(shares, sorted(shares))

    def test_a_picture_shows_itself(self):
        told = self.messages(self.begin("import pxm\npxm.render('tetra', size=(32, 24))"))
        (result,) = self.of_type(told, "execute_result")
        self.assertTrue(result["data"]["image/png"].startswith("iVBOR"))  # base64 of a PNG's first bytes
        self.assertRegex(result["data"]["text/plain"], r"^<pxm\.Picture of 32x24 pixels, \d+ hit>$")

    def test_the_button_to_interrupt_ends_a_render(self):
        # A kernel drops what waits behind a cell that ended in an error, and for a moment what comes after.
        asked = self.begin(
            "import pxm\nprint('begins', flush=True)\npxm.render('tetra', size=(1024, 1024), samples=4096)",
            stop_on_error=False,
        )
        while (message := self.client.get_iopub_msg(timeout=PATIENCE))["msg_type"] != "stream":
            pass
        self.assertEqual(message["content"]["text"], "begins\n")
        time.sleep(1)
        self.manager.interrupt_kernel()
        told = self.messages(asked)
        (error,) = self.of_type(told, "error")
        self.assertEqual(error["ename"], "KeyboardInterrupt")
        updates = self.of_type(told, "update_display_data")
        if updates:
            self.assertEqual(updates[-1]["data"]["text/html"], "", "the bar of a render that was ended stays")
        told = self.messages(self.begin("pxm.render('tetra', size=(32, 24)).shape"))  # and the kernel goes on
        (result,) = self.of_type(told, "execute_result")
        self.assertEqual(result["data"]["text/plain"], "(24, 32)")


if __name__ == "__main__":
    unittest.main()
