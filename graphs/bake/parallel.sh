#!/bin/sh
# Bakes in N shards with GNU parallel, as many at a time as this machine has cores, and merges them:
#     parallel.sh N OUT GRAPH --mesh MESH [options of wrinkle bake]
# The shards stay in OUT.parts until they are merged. Where one was killed the merge says which, and
# the same call again bakes what is missing alone.
set -eu
shards=$1 out=$2
shift 2
seq "$shards" | parallel --will-cite --quote \
    wrinkle bake "$@" -o "$out.parts/{}" --shard "{}/$shards" --resume -j 1 || :
set --
for shard in $(seq "$shards"); do set -- "$@" "$out.parts/$shard"; done
wrinkle bake --merge "$@" -o "$out"
rm -r "$out.parts"
