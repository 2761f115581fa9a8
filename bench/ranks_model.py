#!/usr/bin/env python3
"""Draws the efficiency of weak scaling by the number of ranks: what bench_ranks measured, and a model of two machines.

    bench/ranks_model.py FILE.json... -o FILE.png

The files are those of `bench_ranks --json`, of one kind of run (--what, --halo, without --strong) on 1, 2 and perhaps more
ranks. Prints what the model says for the measured numbers of ranks, which it was not told but for 1 and 2.

The model of a step on n ranks, in seconds:

    T(n) = T(1) + (n - 1) * whole + exchanges * (visible + max(0, delay - pass))
    delay = exchange + 2 * latency + neighbours * bytes / bandwidth

whole       what a rank computes for each other one (topology): --whole, microseconds; 0 for dense structures
visible     of an exchange beside the network: packing, unpacking, the elements at the border, submissions. From the
            measured run on two ranks: (T(2) - T(1) - whole) / exchanges
exchange    the measured run's, from when the device has packed its elements until the others' have arrived
pass        the time of a pass, in which the exchange hides: T(1) / passes of a step
bytes       that a rank sends to one neighbour in an exchange; a rank between two others sends twice as many
latency, bandwidth  of the machine, for one rank: see MACHINES. Without a machine: ranks of the measured host, between
            which only `neighbours` changes

It leaves out: contention in the network beyond a node's injection, imbalance, slabs that become too thin, and that each
rank holds the whole structure (128 GB hold some hundred ranks of 1 GB). So it ends at 64 ranks.
"""
import argparse
import json
import sys

# Bandwidth of a node's injection over the ranks (GPUs) that share it: Summit, two EDR InfiniBand rails of 100 Gbit/s and 6
# GPUs a node (Stunkel et al., IBM J. Res. Dev. 64, 2020); Aurora, 8 Slingshot endpoints of 200 Gbit/s and 12 tiles of GPUs
# a node (alcf.anl.gov/support-center/aurora/interconnect). Latencies of small messages are published between 1 and 5 us;
# the curves use both ends, which the plot cannot tell apart.
MACHINES = {
    "Summit: 25 GB/s a node, 6 GPUs": 25e9 / 6,
    "Aurora: 200 GB/s a node, 12 tiles": 200e9 / 12,
}
LATENCIES = (1e-6, 5e-6)
MOST_RANKS = 64


def read(files):
    runs = {}
    for name in files:
        with open(name, encoding="utf-8") as file:
            run = json.load(file)
        if run["strong"]:
            sys.exit(f"ranks_model: {name} is of strong scaling")
        runs.setdefault(run["ranks"], []).append(run)
    if 1 not in runs or 2 not in runs:
        sys.exit("ranks_model: files of 1 and of 2 ranks are needed")
    # Of several runs the one in the middle.
    return {ranks: sorted(all, key=lambda r: r["step_seconds"])[len(all) // 2] for ranks, all in runs.items()}


def step(runs, whole, bandwidth, latency, ranks):
    """The seconds of a step; without a bandwidth, of ranks of the measured host."""
    one, two = runs[1]["step_seconds"], runs[2]
    if ranks == 1:
        return one
    exchanges = two["exchanges"]
    exchange = two["exchange_seconds"] / exchanges
    visible = (two["step_seconds"] - one - whole) / exchanges
    neighbours = 1 if ranks == 2 else 2
    delay = exchange if bandwidth is None else exchange + 2 * latency + neighbours * two["bytes"] / exchanges / bandwidth
    pass_seconds = one / two["distributed"]
    beyond = max(0, delay - pass_seconds) - (max(0, exchange - pass_seconds) if bandwidth is None else 0)
    return one + (ranks - 1) * whole + exchanges * (visible + beyond)


def draw(runs, whole, target):
    import matplotlib
    matplotlib.use("Agg")
    import matplotlib.pyplot as pyplot
    figure, axes = pyplot.subplots(figsize=(7, 4.5))
    numbers = [1, 2, 3, 4, 6, 8, 12, 16, 24, 32, 48, MOST_RANKS]
    one = runs[1]["step_seconds"]
    axes.plot(numbers, [one / step(runs, whole, None, 0, n) for n in numbers], "k:", label="model, ranks of one host")
    for name, bandwidth in MACHINES.items():
        slow, fast = ([one / step(runs, whole, bandwidth, latency, n) for n in numbers] for latency in reversed(LATENCIES))
        line, = axes.plot(numbers, slow, label="model, " + name)
        axes.fill_between(numbers, slow, fast, color=line.get_color(), alpha=0.3)
    measured = sorted(runs)
    axes.plot(measured, [one / runs[n]["step_seconds"] for n in measured], "o", color="#d55e00",
              label="measured: " + runs[1]["device"])
    axes.set_xscale("log", base=2)
    axes.set_xticks([1, 2, 4, 8, 16, 32, 64], labels=[1, 2, 4, 8, 16, 32, 64])
    axes.set_ylim(0, 1.05)
    axes.set_xlabel("ranks")
    axes.set_ylabel("efficiency of weak scaling")
    axes.set_title(f"{runs[1]['what']}, {runs[1]['elements'] / 1e6:.1f} M elements a rank, halo {runs[2]['halo']}")
    axes.grid(True, linewidth=0.4, alpha=0.6)
    axes.legend(fontsize=8, loc="lower left")
    figure.tight_layout()
    figure.savefig(target)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("files", nargs="+")
    parser.add_argument("-o", required=True, dest="target")
    parser.add_argument("--whole", type=float, default=0.0, help="microseconds a step that a rank computes for each other one")
    arguments = parser.parse_args()
    runs = read(arguments.files)
    for ranks, run in sorted(runs.items()):
        model = step(runs, 1e-6 * arguments.whole, None, 0, ranks)
        print(f"{ranks} ranks: measured {1e6 * run['step_seconds']:.1f} us, model {1e6 * model:.1f} us")
    draw(runs, 1e-6 * arguments.whole, arguments.target)


if __name__ == "__main__":
    main()
