"""Opens a page in Chromium and prints the text that the page posts to /results.

usage: serve.py CHROMIUM PAGE PROFILE [OPTION...]
"""
import http.server
import pathlib
import subprocess
import sys


def main():
    chromium, page, profile, *options = sys.argv[1:]
    results = []

    class Handler(http.server.BaseHTTPRequestHandler):
        def do_GET(self):
            found = self.path == "/"
            body = pathlib.Path(page).read_bytes() if found else b""
            self.send_response(200 if found else 404)
            self.send_header("Content-Type", "text/html; charset=utf-8")
            self.send_header("Content-Length", str(len(body)))
            self.end_headers()
            self.wfile.write(body)

        def do_POST(self):
            length = int(self.headers["Content-Length"])
            results.append(self.rfile.read(length).decode())
            self.send_response(204)
            self.end_headers()

        def log_message(self, *_):
            pass

    server = http.server.HTTPServer(("127.0.0.1", 0), Handler)
    server.timeout = 5
    browser = subprocess.Popen([chromium, f"--user-data-dir={profile}", *options,
                                f"http://127.0.0.1:{server.server_port}/"],
                               stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    while not results and browser.poll() is None:
        server.handle_request()
    browser.kill()
    print("".join(results))


main()
