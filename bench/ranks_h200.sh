#!/usr/bin/env bash
# Runs the tests and benches of several ranks on a machine with several GPUs that has neither Glift nor MPI installed.
# The folder of this script holds the programs and the libraries:
#
#   mkdir h200; cp build/release/bench/bench_ranks build/release/tests/ranks/ranks_processes bench/ranks_h200.sh h200/
#   cp -L build/release/lib/libglift.so.0.1 /lib/x86_64-linux-gnu/libtbb.so.12 h200/
#   h200/ranks_h200.sh 2 OUT     on the machine: with 2 GPUs; figures as JSON go to the folder OUT
set -uo pipefail
here=$(cd "$(dirname "$0")" && pwd)
ranks=${1:-2}
out=${2:-.}
export LD_LIBRARY_PATH=$here${LD_LIBRARY_PATH:+:$LD_LIBRARY_PATH} GLIFT_RANKS_TIMEOUT=60
bench() {
    local name=$1
    shift
    timeout 100 "$here/bench_ranks" --json "$out/$name.json" "$@" || echo "FAIL: $name"
}
timeout 100 "$here/ranks_processes" "$ranks" bits
timeout 60 "$here/ranks_processes" "$ranks" bytes
timeout 100 "$here/ranks_processes" "$ranks" balance
bench band_1 --what band --ranks 1
bench band_n --what band --ranks "$ranks"
bench band_n_halo_0 --what band --ranks "$ranks" --halo 0
bench band_n_in_turn --what band --ranks "$ranks" --no-overlap
diffusion="--what diffusion --side 512 --steps 128"
bench diffusion_1 $diffusion --ranks 1
bench diffusion_n $diffusion --ranks "$ranks" --halo 0
bench diffusion_n_halo_2 $diffusion --ranks "$ranks" --halo 2
bench diffusion_n_in_turn $diffusion --ranks "$ranks" --halo 0 --no-overlap
bench diffusion_strong_1 $diffusion --strong --ranks 1
bench diffusion_strong_n $diffusion --strong --ranks "$ranks" --halo 0
