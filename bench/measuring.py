"""What bench/renders and bench/peers/peers share: building, describing a scene, running variants in
alternation, medians, tables."""
import json, os, re, statistics, subprocess, sys, time

sys.dont_write_bytecode = True

TOP = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))


class Variant:
    """A way to render a picture. `run` is called once a round and returns seconds."""

    def __init__(self, name, run):
        self.name = name
        self.run = run
        self.seconds = []
        self.why_not = None  # it could not be run, or took too long

    def median(self):
        return statistics.median(self.seconds) if self.seconds and not self.why_not else None


def build(folder, targets):
    """Configures the build folder for benchmarks and builds the targets in it."""
    for command in (["cmake", "-S", TOP, "-B", folder, "-DPXM_BUILD_BENCH=ON"],
                    ["cmake", "--build", folder, "--target", *targets]):
        subprocess.run(command, check=True, stdout=subprocess.DEVNULL)


def program(folder, name):
    return os.path.join(folder, "bin", name)


def describe(folder, scene, size, zoom, path):
    """Writes the scene as the programs of bench/ read it."""
    with open(path, "w") as file:
        subprocess.run([program(folder, "bench_describe"), os.path.join(TOP, scene), size,
                        str(zoom)], check=True, stdout=file)


def render(folder, scene, size, zoom, threads, options, scratch, limit, out="out.png"):
    """The render phase of `pxm render`, ray and tile set-up inside."""
    stats = os.path.join(scratch, "stats.json")
    subprocess.run([program(folder, "pxm"), "render", os.path.join(TOP, scene), "-o",
                    os.path.join(scratch, out), "--size", size, "--zoom", str(zoom), "--threads",
                    str(threads), "--allow", TOP, "--quiet", "--stats", stats, *options],
                   check=True, stderr=subprocess.DEVNULL, timeout=limit)
    with open(stats) as file:
        return json.load(file)["seconds"]["render"]


def first_number(command, limit):
    """Seconds as a program of bench/ prints them first."""
    done = subprocess.run(command, check=True, capture_output=True, text=True, timeout=limit)
    return float(done.stdout.split()[0])


def takes(folder, scene, scratch, options):
    """Whether this pxm can render the scene with these options."""
    try:
        render(folder, scene, "16x16", 1, 1, options, scratch, 60)
        return True
    except subprocess.CalledProcessError:
        return False


def alternate(variants, runs):
    """A B C A B C ...; a variant that fails or takes too long is not run again."""
    for _ in range(runs):
        for variant in variants:
            if variant.why_not:
                continue
            try:
                variant.seconds.append(variant.run())
            except subprocess.TimeoutExpired as late:
                variant.why_not = f"> {late.timeout:.0f} s"
            except subprocess.CalledProcessError as failed:
                variant.why_not = "failed"
                print(failed, file=sys.stderr)


def show_seconds(variant):
    if variant is None:
        return "-"
    if variant.median() is None:
        return variant.why_not or "-"
    return f"{variant.median():.3g} s"


def show_ratio(slow, fast):
    """How many times faster `fast` is."""
    if slow is None or fast is None or slow.median() is None or fast.median() is None:
        return "-"
    return f"{slow.median() / fast.median():.2f}"


def peak_megabytes(process):
    """The most memory so far of a process that runs. Not what wait4() tells of one that has ended: that
    begins at what its parent had, which is this program with its interpreter."""
    try:
        with open(f"/proc/{process}/status") as status:
            return int(re.search(r"VmHWM:\s*(\d+)", status.read())[1]) / 1024
    except (OSError, TypeError):
        return 0


def empty_cache():
    """As root: what a first start after the computer's costs."""
    os.sync()
    with open("/proc/sys/vm/drop_caches", "w") as file:
        file.write("3")


def to_file(command, folder, watched=False):
    """Seconds on the clock of a whole command; if it is `watched`, the most megabytes that it had instead."""
    begin = time.perf_counter()
    child = subprocess.Popen(command, cwd=folder, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
                             stderr=subprocess.DEVNULL)
    memory = 0
    while watched and child.poll() is None:
        memory = max(memory, peak_megabytes(child.pid))
        time.sleep(0.0005)
    if child.wait() != 0:
        raise subprocess.CalledProcessError(child.returncode, command)
    return memory if watched else time.perf_counter() - begin


def header(columns):
    print("| " + " | ".join(columns) + " |")
    print("| --- |" + " ---: |" * (len(columns) - 1), flush=True)


def row(cells):
    print("| " + " | ".join(cells) + " |", flush=True)
