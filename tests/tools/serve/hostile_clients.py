"""Starts `specula serve` and treats it as nobody should: wrong hosts, broken requests, slow and many clients.

usage: hostile_clients.py SPECULA CACHE_FOLDER

SPECULA_SERVE_REQUESTS  how many malformed requests are sent (default 500; the long form is 10000)
"""
import collections
import concurrent.futures
import json
import os
import random
import re
import signal
import socket
import subprocess
import sys
import threading
import time

N_MALFORMED = int(os.environ.get("SPECULA_SERVE_REQUESTS", "500"))
CHIRP = b'{"material": "wood", "tilt_deg": 3.5}'


class Server:
    """The program under test, on a port that is free."""

    def __init__(self, program, cache):
        environment = dict(os.environ, XDG_CACHE_HOME=cache)
        self.process = subprocess.Popen([program, "serve", "--port", "0"], env=environment, text=True,
                                        stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        line = self.process.stdout.readline()
        found = re.search(r"http://127\.0\.0\.1:(\d+)/", line)
        assert found, f"no address in {line!r}: {self.process.stderr.read()}"
        self.port = int(found.group(1))
        self.host = f"127.0.0.1:{self.port}".encode()

    def connect(self, timeout=20):
        return socket.create_connection(("127.0.0.1", self.port), timeout)

    def send(self, data, timeout=20, is_all=False):
        """Sends bytes as they are; the status, the headers and the body of what comes back, or status 0.

        is_all tells the server that nothing follows, which it may take for the end of the connection."""
        with self.connect(timeout) as connection:
            answer = b""
            try:
                connection.sendall(data)
                if is_all:
                    connection.shutdown(socket.SHUT_WR)
                while part := connection.recv(65536):
                    answer += part
            except TimeoutError:
                raise
            except OSError:  # cut off, be it in the middle
                pass
        head, _, body = answer.partition(b"\r\n\r\n")
        status = re.match(rb"HTTP/1\.[01] (\d{3})", head)
        return int(status.group(1)) if status else 0, head, body

    def request(self, method=b"GET", path=b"/", body=b"", headers=None, host=None):
        lines = {b"Host": host or self.host, b"Connection": b"close", **(headers or {})}
        if method == b"POST":
            lines.setdefault(b"Content-Type", b"application/json")
            lines[b"Content-Length"] = str(len(body)).encode()
        head = b"".join(key + b": " + value + b"\r\n" for key, value in lines.items() if value is not None)
        return method + b" " + path + b" HTTP/1.1\r\n" + head + b"\r\n" + body

    def ask(self, *arguments, **options):
        return self.send(self.request(*arguments, **options))

    def memory_kb(self):
        with open(f"/proc/{self.process.pid}/status") as status:
            return int(re.search(r"VmRSS:\s+(\d+)", status.read()).group(1))

    def n_descriptors(self):
        return len(os.listdir(f"/proc/{self.process.pid}/fd"))


def expect(what, condition, seen=""):
    if not condition:
        print(f"FAILED: {what} {seen}")
        raise SystemExit(1)
    print(f"  {what}")


def check_answers(server):
    status, head, body = server.ask()
    expect("the page comes with its policy",
           status == 200 and b"default-src 'self'" in head and b"nosniff" in head and b"<title>" in body, head)
    status, _, body = server.ask(b"POST", b"/api/chirp", CHIRP)
    answer = json.loads(body)
    expect("a chirp has codes, profile and an answer of every model",
           status == 200 and len(answer["adc"][0]) == 128 and len(answer["models"]) >= 4, body[:200])
    expect("probabilities add up to one",
           all(abs(sum(each["probability"]) - 1) < 1e-5 for each in answer["models"]))
    again = server.ask(b"POST", b"/api/chirp", CHIRP)[2]
    expect("the same request gives the same bytes", body == again)


def check_pace(server, n=200):
    """How long the engine takes for a frame, request and answer included, as tilt is dragged."""
    times = []
    with server.connect() as connection:
        for i in range(n):
            body = json.dumps({"material": "wood", "tilted": "sample", "tilt_deg": 20 * i / n - 10}).encode()
            start = time.monotonic()
            connection.sendall(server.request(b"POST", b"/api/chirp", body, {b"Connection": b"keep-alive"}))
            head, _, rest = connection.recv(65536).partition(b"\r\n\r\n")
            left = int(re.search(rb"Content-Length: (\d+)", head).group(1)) - len(rest)
            while left > 0:
                left -= len(connection.recv(65536))
            times.append(1e3 * (time.monotonic() - start))
    times.sort()
    expect(f"a chirp over one connection takes {times[n // 2]:.1f} ms (median), {times[n * 95 // 100]:.1f} ms "
           "(95th percentile)", times[n // 2] < 50.0, times[n // 2])


def check_guard(server):
    for host in (b"evil.example", b"evil.example:%d" % server.port, b"127.0.0.1.evil.example:%d" % server.port,
                 b"127.0.0.1", b"127.0.0.1:1", b"[::1", b"localhost:%d.evil" % server.port, b""):
        status = server.ask(host=host or b" ")[0]
        expect(f"Host {host!r} is refused", status in (400, 403), status)
    expect("localhost is served", server.ask(host=b"localhost:%d" % server.port)[0] == 200)
    expect("no Host is refused", server.send(b"GET / HTTP/1.1\r\n\r\n")[0] in (400, 403))
    two = b"GET / HTTP/1.1\r\nHost: " + server.host + b"\r\nHost: evil\r\n\r\n"
    expect("two Hosts are refused", server.send(two)[0] in (400, 403))
    for origin in (b"http://evil.example", b"null", b"https://" + server.host):
        status = server.ask(b"POST", b"/api/chirp", CHIRP, {b"Origin": origin})[0]
        expect(f"Origin {origin!r} is refused", status == 403, status)
    own = server.ask(b"POST", b"/api/chirp", CHIRP, {b"Origin": b"http://" + server.host})
    expect("our own Origin is served, without any permission for others",
           own[0] == 200 and b"access-control" not in own[1].lower())
    for kind in (b"text/plain", b"application/x-www-form-urlencoded", b"application/jsonp"):
        status = server.ask(b"POST", b"/api/chirp", CHIRP, {b"Content-Type": kind})[0]
        expect(f"a body of {kind!r} is refused", status == 415, status)
    for method in (b"PUT", b"DELETE", b"OPTIONS", b"TRACE", b"PROPFIND", b"CONNECT"):
        expect(f"{method!r} is refused", server.ask(method)[0] in (400, 405, 501))
    expect("a chirp is no matter of GET", server.ask(b"GET", b"/api/chirp")[0] == 405)


def check_paths(server):
    for path in (b"/../../etc/passwd", b"/%2e%2e/%2e%2e/etc/passwd", b"//etc/passwd", b"/..%2f..%2fetc/passwd",
                 b"/main.js/../../../etc/passwd", b"/etc/passwd%00.js", b"/.git/config", b"/MAIN.JS"):
        status, _, body = server.ask(b"GET", path)
        expect(f"{path!r} is not there", status in (400, 404) and b"root:" not in body, status)


def check_sizes(server):
    status = server.ask(b"POST", b"/api/chirp", b" " * 70_000)[0]
    expect("a long body is refused", status in (0, 413), status)
    announced = server.request(b"POST", b"/api/chirp", headers={}).replace(b"Content-Length: 0",
                                                                         b"Content-Length: 999999999999")
    expect("a body announced as a terabyte is refused at once", server.send(announced)[0] in (400, 413))
    head = b"POST /api/chirp HTTP/1.1\r\nHost: " + server.host + b"\r\nContent-Type: application/json\r\n"
    endless = head + b"Transfer-Encoding: chunked\r\n\r\n" + b"1000\r\n" + (b"x" * 4096 + b"\r\n1000\r\n") * 64
    expect("a body in endless chunks is cut off", server.send(endless)[0] in (0, 400, 413))
    long_header = server.ask(headers={b"X-Long": b"y" * 1_000_000})[0]
    expect("a header of a megabyte is refused", long_header in (0, 400, 413, 431), long_header)
    many = server.ask(headers={b"X-%d" % i: b"z" for i in range(20_000)})[0]
    expect("twenty thousand headers are refused", many in (0, 400, 413, 431), many)
    deep = server.ask(b"POST", b"/api/chirp", b"[" * 30_000)
    expect("thirty thousand brackets are refused", deep[0] == 400, deep[0])


def check_fields(server):
    cases = [({"height_mm": 1e9}, "height_mm", "mm"), ({"tilt_deg": "steep"}, "tilt_deg", "deg"),
             ({"session": 1.5}, "session", "whole"), ({"material": "irom"}, "material", "iron"),
             ({"materiel": "iron"}, "materiel", "material"), ({"leakage": 1}, "leakage", "true"),
             ({"radar": "../../etc/passwd"}, "radar", "use"), ({"size_mm": [300, 300]}, "size_mm", "mm"),
             ({"slope_mhz_us": 400}, "slope_mhz_us", ""), ({"tilted": "both"}, "tilted", "sensor"),
             ({"roughness_um": 900, "thickness_mm": 0.2}, "roughness_um", "")]
    for request, field, word in cases:
        status, _, body = server.ask(b"POST", b"/api/chirp", json.dumps(request).encode())
        told = json.loads(body)["error"] if status == 400 else {}
        expect(f"{request} is refused by name", field in told.get("field", "") and told.get("problem")
               and word in told.get("remedy", ""), body[:300])


def broken(rng, server):
    """A request with something wrong in it."""
    data = bytearray(server.request(b"POST", rng.choice([b"/api/chirp", b"/api/scene.toml", b"/", b"/api/page"]), CHIRP))
    for _ in range(rng.choice([1, 2, 4, 16])):
        kind = rng.randrange(5)
        at = rng.randrange(len(data) + 1)
        if kind == 0:
            data[at:at + 1] = bytes([rng.randrange(256)])
        elif kind == 1:
            del data[at:at + rng.randrange(1, 20)]
        elif kind == 2:
            data[at:at] = bytes(rng.randrange(256) for _ in range(rng.randrange(1, 40)))
        elif kind == 3:
            data[at:at] = rng.choice([b"\r\n\r\n", b"\0", b"%00", b"HTTP/9.9", b"Content-Length: -1\r\n", b"\xff" * 9])
        else:
            data = data[:at] or bytearray(b"\0")
    return bytes(data)


def check_malformed(server):
    rng = random.Random(20260101)
    counts = collections.Counter()

    def send(data):
        counts[server.send(data, is_all=True)[0]] += 1

    with concurrent.futures.ThreadPoolExecutor(24) as senders:
        list(senders.map(send, [broken(rng, server) for _ in range(100)]))  # the first use of everything
        before, descriptors = server.memory_kb(), server.n_descriptors()
        counts.clear()
        list(senders.map(send, [broken(rng, server) for _ in range(N_MALFORMED)]))
    grown = server.memory_kb() - before
    time.sleep(0.3)
    expect(f"{N_MALFORMED} malformed requests do no harm (answers: {dict(sorted(counts.items()))}; memory +{grown} kB)",
           grown < 64 * 1024 and server.process.poll() is None and 500 not in counts, grown)
    expect("and leave no descriptor open", server.n_descriptors() <= descriptors + 2, server.n_descriptors())


def check_crowd(server, n_clients=50, n_each=4):
    times, failures = [], []

    def client(number):
        request = json.dumps({"material": "limestone", "height_mm": 400 + number}).encode()
        for _ in range(n_each):
            start = time.monotonic()
            for _ in range(600):
                status, head, _ = server.ask(b"POST", b"/api/chirp", request)
                if status != 503:
                    break
                assert b"Retry-After" in head
                time.sleep(0.02)
            times.append(time.monotonic() - start)
            if status != 200:
                failures.append(status)

    threads = [threading.Thread(target=client, args=(i,)) for i in range(n_clients)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    times.sort()
    expect(f"{n_clients} clients at once are served (median {times[len(times) // 2]:.2f} s, worst {times[-1]:.2f} s)",
           not failures and len(times) == n_clients * n_each, failures)


def check_slow(server):
    slow = [server.connect() for _ in range(64)]
    for i, connection in enumerate(slow):
        if i % 2:
            connection.sendall(b"POST /api/chirp HTTP/1.1\r\nHost: ")
    start = time.monotonic()
    status = server.ask(b"POST", b"/api/chirp", CHIRP)[0]
    took = time.monotonic() - start
    expect(f"beside 64 slow clients a request takes {took:.2f} s", status == 200 and took < 1.0, (status, took))
    dripping, start = slow[1], time.monotonic()
    dripping.settimeout(1.0)
    ended = False
    while not ended and time.monotonic() - start < 25:
        try:
            dripping.sendall(b"1")
            ended = dripping.recv(1) == b""
        except TimeoutError:
            continue
        except OSError:
            ended = True
    expect(f"who drips a byte a second is cut off after {time.monotonic() - start:.0f} s", ended)
    for connection in slow:
        connection.close()


def check_end(server, program):
    taken = subprocess.run([program, "serve", "--port", str(server.port)], capture_output=True, text=True, timeout=60)
    expect("a taken port is told, with the way out",
           taken.returncode == 2 and "--port 0" in taken.stderr and taken.stderr.count("\n") == 1, taken.stderr)
    with server.connect() as idle:
        start = time.monotonic()
        server.process.send_signal(signal.SIGINT)
        status = server.process.wait(timeout=10)
        idle.close()
    took = time.monotonic() - start
    rest = server.process.stderr.read()
    expect(f"Ctrl-C ends it cleanly in {took:.2f} s", status == 0 and took < 2.0 and "rror" not in rest, (status, rest))


def main():
    program, cache = sys.argv[1:]
    server = Server(program, cache)
    try:
        for check in (check_answers, check_pace, check_guard, check_paths, check_sizes, check_fields, check_malformed,
                      check_crowd, check_slow):
            print(check.__name__)
            check(server)
        expect("after all that the page is still there", server.ask()[0] == 200)
        check_end(server, program)
    finally:
        if server.process.poll() is None:
            server.process.kill()


main()
