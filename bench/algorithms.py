"""Runs stdlib/algorithms and all rivals (other implementations) alternately, and joins the results into groups of figures
(figures.py)."""
import os
import shutil
import subprocess
import sys

import figures

HERE = os.path.dirname(os.path.abspath(__file__))
CPU_SIZES, GPU_SIZES = "16,18,20,22,24", "20,22,24,26,28"
CPU_SYSTEMS, GPU_SYSTEMS = "256,1024", "256,512,1024,2048,4096"


def add_options(parser):
    parser.add_argument("--log2", help=f"sizes on the Vulkan device ({CPU_SIZES}; on a GPU {GPU_SIZES})")
    parser.add_argument("--host-log2", default=CPU_SIZES, help="sizes on the host device (%(default)s)")
    parser.add_argument("--systems", help=f"sizes of tridiagonal systems ({CPU_SYSTEMS}; on a GPU {GPU_SYSTEMS})")
    parser.add_argument("--rounds", type=int, default=3, help="in each, our side and the rivals run once (%(default)s)")
    parser.add_argument("--algorithm-runs", type=int, default=7, help="of which a round takes the median (%(default)s)")


def nvcc():
    """The path of nvcc, as bench/cuda/build finds it."""
    return os.environ.get("NVCC") or shutil.which("nvcc") or shutil.which("/usr/local/cuda/bin/nvcc")


def build_cuda(folder):
    """Builds the CUDA rivals and returns the path of their program; None where there is no nvcc."""
    if not nvcc():
        print("No nvcc: no CUDA rivals.\n")
        return None
    subprocess.run([os.path.join(HERE, "cuda", "build"), folder], check=True, stdout=sys.stderr)
    return os.path.join(folder, "rivals")


def run(command, folder):
    """The groups of figures that a program writes."""
    file = os.path.join(folder, "figures.json")
    subprocess.run(command + ["--json", file], check=True)
    return figures.load(file)


def is_gpu(program, folder):
    """Whether the Vulkan device, which GLIFT_DEVICE may name, is a GPU. Lavapipe calls itself llvmpipe."""
    group, = run([program, "--log2", "10", "--only", "copy", "--runs", "1"], folder)
    return "llvmpipe" not in group["device"]


def measure(bench, options, folder):
    ours, rivals = os.path.join(bench, "bench_algorithms"), os.path.join(bench, "bench_rivals")
    gpu = is_gpu(ours, folder)
    sizes = options.log2 or (GPU_SIZES if gpu else CPU_SIZES)
    systems = options.systems or (GPU_SYSTEMS if gpu else CPU_SYSTEMS)
    runs = ["--runs", str(options.algorithm_runs)]
    cuda = build_cuda(os.path.join(folder, "cuda")) if gpu else None
    groups = []
    for turn in range(options.rounds):
        groups += run([ours, "--log2", sizes, "--systems", systems] + runs, folder)
        groups += run([rivals, "--log2", sizes, "--host-log2", options.host_log2] + runs + ["--unchecked"] * (turn > 0), folder)
        groups += run([ours, "--device", "host", "--log2", options.host_log2, "--systems", CPU_SYSTEMS] + runs, folder)
        if cuda:
            groups += run([cuda, "--log2", sizes] + runs, folder)
    return figures.joined(groups)
