"""Our runner, the kernels, and what they were built with."""

import json
import pathlib
import platform
import shutil
import subprocess

ROOT = pathlib.Path(__file__).resolve().parents[2]
KERNELS = pathlib.Path(__file__).resolve().parent / "kernels"
PLACE = ROOT / "target" / "peers"
FLAGS = ["-O3", "-march=native", "-fno-math-errno", "-fno-trapping-math", "-fopenmp-simd"]
# FLINT 3 holds Arb; before, Arb was a library of its own, which Debian calls flint-arb.
ARB = [
    ("FLINT with Arb", ["-lflint"], []),
    ("Arb by itself", ["-lflint-arb", "-lflint"], ["-DARB_ALONE"]),
    ("Arb by itself", ["-larb", "-lflint"], ["-DARB_ALONE"]),
]
# A symbol that only GMP's assembly brings: portable C does without.
ASSEMBLY = b"__gmpn_addlsh1_n"


class Unbuilt(Exception):
    """Why there is no program."""


def runner():
    """The path of benches/peers.rs as built."""
    return built("--bench", "peers")


def command():
    """The path of the command as built."""
    return built("--bin", "burmester")


def built(kind, name):
    command = ["cargo", "build", "--release", kind, name, "--message-format=json-render-diagnostics"]
    if shutil.which("cargo") is None:
        raise Unbuilt("cargo is missing")
    done = subprocess.run(command, cwd=ROOT, stdout=subprocess.PIPE, text=True)
    for line in done.stdout.splitlines():
        message = json.loads(line)
        if message.get("executable") and message.get("target", {}).get("name") == name:
            return pathlib.Path(message["executable"])
    raise Unbuilt(f"cargo build ended with status {done.returncode}")


def gmp_of(program):
    """How the GMP that a program holds was built."""
    return "assembly (m4 was there)" if ASSEMBLY in program.read_bytes() else "portable C (no m4)"


def compiler(source):
    names = ("c++", "g++", "clang++") if source.suffix == ".cpp" else ("cc", "gcc", "clang")
    found = next(filter(shutil.which, names), None)
    if found is None:
        raise Unbuilt(f"no {'C++' if source.suffix == '.cpp' else 'C'} compiler")
    return found


def kernel(name):
    """The path of a kernel as built."""
    source = KERNELS / name
    program = PLACE / "kernels" / source.stem
    program.parent.mkdir(parents=True, exist_ok=True)
    base = [compiler(source), *FLAGS, source, "-o", program]
    if source.suffix == ".cpp":
        compiled([*base, "-std=c++17", "-lm"])
        return program
    libraries, defines = arb(base[0])
    compiled([*base, *defines, *libraries, "-lmpfr", "-lgmp", "-lm"])
    return program


def arb(cc):
    """How Arb is included and linked."""
    for _, libraries, defines in ARB:
        if attempt(cc, ["balls.h"], "arb_t x; arb_init(x); arb_clear(x);", defines + libraries):
            return libraries, defines
    raise Unbuilt("FLINT's headers are missing")


def arb_version(cc="cc"):
    """The version of the Arb that the kernels are built with."""
    (PLACE / "kernels").mkdir(parents=True, exist_ok=True)
    text = '#include "balls.h"\nint main(void) { puts(flint_version);' + "\n#ifdef ARB_ALONE\nputs(arb_version);\n#endif\n}"
    for _, libraries, defines in ARB:
        program = PLACE / "kernels" / "version"
        if attempt(cc, [], text, defines + libraries, program):
            words = subprocess.run([program], stdout=subprocess.PIPE, text=True).stdout.split()
            return f"FLINT {words[0]}" + (f" and Arb {words[1]}" if words[1:] else "")
    return None


def attempt(cc, headers, body, options, program="/dev/null"):
    text = body if not headers else "".join(f'#include "{h}"\n' for h in headers) + f"int main(void) {{ {body} }}\n"
    command = [cc, f"-I{KERNELS}", "-w", "-x", "c", "-", "-o", program, *options, "-lmpfr", "-lgmp", "-lm"]
    return subprocess.run(command, input=text, text=True, capture_output=True).returncode == 0


def compiled(command):
    result = subprocess.run(command, capture_output=True, text=True)
    if result.returncode:
        reason = next((line for line in result.stderr.splitlines() if "error" in line), f"status {result.returncode}")
        raise Unbuilt(f"the compiler says: {reason}")


def instructions():
    """The vector instructions that the kernels are compiled for."""
    try:
        cc = compiler(pathlib.Path("x.c"))
    except Unbuilt:
        return "none"
    macros = subprocess.run([cc, "-march=native", "-dM", "-E", "-x", "c", "/dev/null"], capture_output=True, text=True).stdout
    names = [("__AVX512F__", "AVX-512"), ("__AVX2__", "AVX2"), ("__AVX__", "AVX"), ("__SSE2__", "SSE2"), ("__ARM_NEON", "NEON")]
    found = [name for macro, name in names if f" {macro} " in macros]
    version = subprocess.run([cc, "--version"], capture_output=True, text=True).stdout.splitlines()[0]
    return f"{found[0] if found else 'no vector instructions'} ({version})"


def processor():
    try:
        lines = pathlib.Path("/proc/cpuinfo").read_text().splitlines()
        return next(line.partition(":")[2].strip() for line in lines if line.startswith("model name"))
    except (OSError, StopIteration):
        return platform.processor() or platform.machine()
