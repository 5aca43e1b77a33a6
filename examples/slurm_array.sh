#!/usr/bin/env bash
# A data set built by many machines, one piece an array task, without Ray:
#
#   N=1000 PIECE=100 OUT=/shared/homes sbatch --array=0-9 examples/slurm_array.sh
#   N=1000 PIECE=100 OUT=/shared/homes sbatch --dependency=afterany:JOBID examples/slurm_array.sh merge
#
# Task k makes scenes k * PIECE to (k + 1) * PIECE - 1 in a folder of its own; "merge" joins them to
# the bytes of one build. A task that was cut off (time limit, preemption) goes on when it is
# submitted again; until then "merge" refuses its piece. More options of "sdgen build" go into
# OPTIONS. ("afterany": a task ends with exit code 3 when one of its scenes could not be made, and
# "afterok" would never start the merge.)
#SBATCH --job-name=sdgen
#SBATCH --cpus-per-task=4
#SBATCH --mem-per-cpu=2G
#SBATCH --time=02:00:00
# B: to this script's own process, which becomes the build; else SLURM signals job steps alone.
#SBATCH --signal=B:TERM@60
set -euo pipefail
: "${N:?scenes in all}" "${PIECE:?scenes a task}" "${OUT:?folder of the data set}"
SEED=${SEED:-7}
SDGEN=${SDGEN:-sdgen}
read -ra options <<< "${OPTIONS:-}"

if [ "${1:-}" = merge ]; then
    exec $SDGEN merge "$OUT".piece-* --out "$OUT"
fi

first=$((SLURM_ARRAY_TASK_ID * PIECE))
end=$((first + PIECE < N ? first + PIECE : N))
[ "$first" -lt "$N" ] || exit 0
# Equal widths, so that the pieces are listed in their order.
piece=$(printf '%s.piece-%06d' "$OUT" "$SLURM_ARRAY_TASK_ID")
exec $SDGEN build --n "$N" --seed "$SEED" --range "$first:$end" --out "$piece" \
    --workers "${SLURM_CPUS_PER_TASK:-4}" "${options[@]}"
