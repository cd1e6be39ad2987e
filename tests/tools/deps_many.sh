#!/bin/sh
# deps_many.sh - install what only figures/many/ needs: PETSc and Open MPI.
#
# Says first what and how much it is.  Exit status 1 when it cannot be had.
set -u
LC_ALL=C
export LC_ALL
there() {
    pkg-config --exists petsc 2>/dev/null && command -v mpicc >/dev/null 2>&1 &&
        command -v mpirun >/dev/null 2>&1
}
if there; then
    echo "  deps     all there: PETSc, MPI"
    exit 0
fi
if command -v apt-get >/dev/null 2>&1; then
    names='petsc-dev openmpi-bin pkg-config'
    install="apt-get install -y --no-install-recommends $names"
    if [ "$(id -u)" != 0 ]; then
        echo "deps-many: no PETSc; run:  sudo apt-get update && sudo $install" >&2
        exit 1
    fi
    log=$(mktemp) || exit 1
    export DEBIAN_FRONTEND=noninteractive
    apt-get update >"$log" 2>&1
    size=$(apt-get install --assume-no --no-install-recommends $names 2>/dev/null |
        sed -n -e 's/^Need to get \(.*\/\)*\(.*\) of archives.*/\2 to fetch,/p' \
            -e 's/^After this operation, \(.*\) of additional.*/\1 on the disk/p' |
        tr '\n' ' ')
    echo "  deps     installing $names: $size"
    if ! $install >"$log" 2>&1; then
        tail -n 3 "$log" >&2
        echo "deps-many: apt-get failed; the whole log is $log" >&2
        exit 1
    fi
    rm -f "$log"
elif command -v brew >/dev/null 2>&1; then
    echo "  deps     installing petsc (with open-mpi), about 500 MB on the disk"
    brew install petsc pkg-config || exit 1
else
    echo "deps-many: install PETSc 3.18 or newer with headers, and an MPI." >&2
    exit 1
fi
there || { echo "deps-many: PETSc is installed, and pkg-config does not find it." >&2; exit 1; }
echo "  deps     installed: PETSc, MPI"
