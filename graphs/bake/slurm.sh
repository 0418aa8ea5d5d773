#!/bin/sh
# One of N shards as a task of a Slurm job array:
#     slurm.sh N OUT GRAPH --mesh MESH [options of wrinkle bake]
# The shards are in OUT.parts, in a folder that all machines see; a second job merges them:
#     job=$(sbatch --parsable --array=1-64 slurm.sh 64 maps rock.json --mesh rock.glb --size 16384)
#     sbatch --dependency=afterany:$job --wrap "wrinkle bake --merge maps.parts/* -o maps"
# Where a shard was killed the merge says which. It is done again alone, with --array=7 for the
# seventh and all else as before, and goes on where it was; so does one that Slurm requeues.
#SBATCH --cpus-per-task=1
#SBATCH --requeue
#SBATCH --open-mode=append
set -eu
shards=$1 out=$2 shard=$SLURM_ARRAY_TASK_ID
shift 2
exec wrinkle bake "$@" -o "$out.parts/$shard" --shard "$shard/$shards" --resume \
    -j "${SLURM_CPUS_PER_TASK:-1}"
