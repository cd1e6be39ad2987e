#!/bin/sh
# mpirun.sh PROCESSES PROGRAM ARGUMENTS... - run a program on many processes.
#
# For Open MPI on a machine that others use as well: at most ten minutes, one
# thread per process, and a process that waits lets others run.  Without these a
# waiting process spins, and a step of milliseconds takes a second when there
# are more processes than free cores.
set -u
LC_ALL=C OMP_NUM_THREADS=1 OPENBLAS_NUM_THREADS=1 OMP_THREAD_LIMIT=1
OMPI_MCA_mpi_yield_when_idle=1 OMPI_MCA_hwloc_base_binding_policy=none
OMPI_MCA_rmaps_base_oversubscribe=1
export LC_ALL OMP_NUM_THREADS OPENBLAS_NUM_THREADS OMP_THREAD_LIMIT
export OMPI_MCA_mpi_yield_when_idle OMPI_MCA_hwloc_base_binding_policy
export OMPI_MCA_rmaps_base_oversubscribe
# Open MPI refuses to run as root, unless told twice.
if [ "$(id -u)" = 0 ]; then
    OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
    export OMPI_ALLOW_RUN_AS_ROOT OMPI_ALLOW_RUN_AS_ROOT_CONFIRM
fi
processes=$1
shift
mpirun -q --timeout 600 -n "$processes" "$@"
status=$?
case $status in
110 | 124) echo "mpirun: no end after ten minutes" >&2 ;;
esac
exit $status
