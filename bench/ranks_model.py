#!/usr/bin/env python3
"""Draws the efficiency of weak scaling by the number of ranks: what bench_ranks measured, and a model of two machines.

    bench/ranks_model.py FILE.json... -o FILE.png

The files are those of `bench_ranks --json`, of one kind of run (--what, without --strong) on 1, 2 and perhaps more ranks.

The model of a step on n ranks, in seconds:

    T(n) = compute + whole * n + exchanges * (host + 2 * latency + neighbours * bytes / bandwidth)

compute, whole  of the measured runs: a step on one rank is compute + whole; `whole` is what every rank computes for all
                ranks (topology; 0 for diffusion). It is given by --whole, the share of a step on one rank.
host            what an exchange costs beside the network (staging, waiting for the device), from the measured run on two
                ranks: (T(2) - compute - 2 * whole) / exchanges.
bytes           that a rank sends to one neighbour in an exchange; a rank between two others sends twice as many.
latency, bandwidth  of the machine, for one rank: see MACHINES.

It leaves out: contention in the network beyond a switch, imbalance, slabs that become too thin, and that a rank holds the
whole structure. So it says nothing beyond some tens of ranks.
"""
import argparse
import json
import sys

# Bandwidth of a node's injection over the ranks (GPUs) that share it, and the latency of a small message between nodes.
MACHINES = {
    "Summit: 6 GPUs a node, dual-rail EDR InfiniBand": {"bandwidth": 25e9 / 6, "latency": 1.5e-6},
    "Aurora: 12 GPU tiles a node, 8 x Slingshot 200 Gbit/s": {"bandwidth": 200e9 / 12, "latency": 2.5e-6},
}
MOST_RANKS = 64


def read(files):
    runs = {}
    for name in files:
        with open(name, encoding="utf-8") as file:
            run = json.load(file)
        if run["strong"]:
            sys.exit(f"ranks_model: {name} is of strong scaling")
        runs[run["ranks"]] = run
    if 1 not in runs or 2 not in runs:
        sys.exit("ranks_model: files of 1 and of 2 ranks are needed")
    return runs


def step(runs, whole_share, machine, ranks):
    """The seconds of a step; without a machine, of exchanges as on the measured host."""
    one, two = runs[1]["step_seconds"], runs[2]
    whole, compute = one * whole_share, one * (1 - whole_share)
    if ranks == 1:
        return one
    host = (two["step_seconds"] - compute - 2 * whole) / max(1, two["exchanges"])
    neighbours = 1 if ranks == 2 else 2
    network = 2 * machine["latency"] + neighbours * two["bytes"] / max(1, two["exchanges"]) / machine["bandwidth"] if machine else 0
    return compute + whole * ranks + two["exchanges"] * (host + network)


def draw(runs, whole_share, target):
    import matplotlib
    matplotlib.use("Agg")
    import matplotlib.pyplot as pyplot
    figure, axes = pyplot.subplots(figsize=(7, 4.5))
    numbers = [1, 2, 3, 4, 6, 8, 12, 16, 24, 32, 48, MOST_RANKS]
    one = runs[1]["step_seconds"]
    axes.plot(numbers, [one / step(runs, whole_share, None, n) for n in numbers], "k:", label="model, the measured host")
    for name, machine in MACHINES.items():
        axes.plot(numbers, [one / step(runs, whole_share, machine, n) for n in numbers], label="model, " + name)
    measured = sorted(runs)
    axes.plot(measured, [one / runs[n]["step_seconds"] for n in measured], "o", color="#d55e00",
              label="measured: " + runs[1]["device"])
    axes.set_xscale("log", base=2)
    axes.set_ylim(0, 1.05)
    axes.set_xlabel("ranks")
    axes.set_ylabel("efficiency of weak scaling")
    axes.set_title(f"{runs[1]['what']}, {runs[1]['elements'] / 1e6:.1f} M elements a rank")
    axes.grid(True, linewidth=0.4, alpha=0.6)
    axes.legend(fontsize=8)
    figure.tight_layout()
    figure.savefig(target)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("files", nargs="+")
    parser.add_argument("-o", required=True, dest="target")
    parser.add_argument("--whole", type=float, default=0.0, help="share of a step on one rank that every rank computes")
    arguments = parser.parse_args()
    runs = read(arguments.files)
    for ranks, run in sorted(runs.items()):
        model = step(runs, arguments.whole, None, ranks)
        print(f"{ranks} ranks: measured {1e6 * run['step_seconds']:.1f} us, model {1e6 * model:.1f} us")
    draw(runs, arguments.whole, arguments.target)


if __name__ == "__main__":
    main()
