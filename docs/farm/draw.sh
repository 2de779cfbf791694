#!/bin/sh
# SPDX-License-Identifier: MIT
# draw.sh FRAMES PATTERN COMMAND...: draws a part of a sequence, as one task of a job array that begins with 0.
#SBATCH --cpus-per-task=1
#SBATCH --requeue
set -eu
frames=$1 pattern=$2
shift 2
first=$((frames * SLURM_ARRAY_TASK_ID / SLURM_ARRAY_TASK_COUNT))
end=$((frames * (SLURM_ARRAY_TASK_ID + 1) / SLURM_ARRAY_TASK_COUNT))
exec "$@" --threads "$SLURM_CPUS_PER_TASK" --resume --output "$pattern" --frames "$first:$end"
