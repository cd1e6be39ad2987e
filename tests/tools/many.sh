#!/bin/sh
# many.sh many|test|peer - the study on many processes, figures/many/.
#
# many runs it all, writes figures/many/many.tsv (counts, no seconds), says
# which goals hold, and, from runs on a machine that was free, compares seconds.
# test makes the smallest runs and wrong programs, and prints "ok WHAT", "FAIL
# WHAT: why" or "skip WHAT: why".  peer measures what a step takes
# beside PETSc.  Called by the Makefile with BUILD, OMPI_CC, FLAGS and LINK.
set -u
LC_ALL=C
export LC_ALL
: "${BUILD:=build}"
export OMPI_CC
programs=$BUILD/figures/many
program=$programs/many
kept=figures/many/many.tsv
out=$(mktemp -d) || exit 2
part=$kept.$$.part
trap 'rm -rf "$out" "$part"' EXIT
trap 'exit 130' HUP INT TERM

# cells, steps, method, processes, compare with step.c
small='16 10 geometric 1 yes
16 10 geometric 2 yes
16 10 geometric 4 yes
16 10 cholesky 1 yes
16 10 cholesky 2 yes
16 10 cholesky 4 yes'
all="$small
32 30 geometric 1 yes
32 30 geometric 2 yes
32 30 geometric 4 yes
32 30 cholesky 1 yes
32 30 cholesky 2 yes
32 30 cholesky 4 yes
64 30 geometric 1 yes
64 30 rigid_modes 1 no
64 30 algebraic 1 no
64 30 cholesky 1 no
128 30 geometric 1 yes
128 30 rigid_modes 1 no
128 30 algebraic 1 no
128 30 cholesky 1 no
64 6 geometric 1 no
64 6 geometric 2 no
64 6 geometric 4 no
64 6 rigid_modes 1 no
64 6 algebraic 1 no
128 6 geometric 1 no
128 6 geometric 2 no
128 6 geometric 4 no
128 6 rigid_modes 1 no
128 6 algebraic 1 no
192 6 geometric 1 yes
256 6 geometric 1 yes
256 6 geometric 2 no
256 6 geometric 4 no
256 6 rigid_modes 1 no
256 6 algebraic 1 no
512 6 geometric 1 no
512 6 geometric 2 no
512 6 geometric 4 no"

# In three rounds, whose medians are compared: one run is too noisy.
timed='64 6 geometric 1 no
128 6 geometric 1 no
256 6 geometric 1 no
256 6 geometric 2 no
512 6 geometric 1 no'

# run PROGRAM N STEPS METHOD PROCESSES SERIAL: tables to $out/one, log to .log
run() {
    sh tests/tools/mpirun.sh "$5" "$1" --n "$2" --steps "$3" --method "$4" \
        --serial "$6" </dev/null >"$out/one" 2>"$out/one.log"
    status=$?
    return $status
}

# The rows of $out/one under those that are there: $out/$1TABLE.
keep() {
    for table in runs messages seconds; do
        file=$out/$1$table
        head=1
        [ ! -f "$file" ] || head=0
        awk -v table="$table" -v head="$head" '
            /^#/ { on = $2 == table; rows = 0; next }
            on && NF && (rows++ || head)' "$out/one" >>"$file"
        [ -s "$file" ] || rm -f "$file"
    done
}

# each RUNS NAME: all of them, and their tables in $out/NAMETABLE
each() {
    echo "$1" | while read -r n steps method processes serial; do
        echo "  run      n = $n, $steps steps, $method, processes: $processes"
        run "$program" "$n" "$steps" "$method" "$processes" "$serial" || {
            echo "many: n = $n, $method on $processes: status $status" >&2
            cat "$out/one.log" >&2
            exit 1
        }
        keep "$2"
    done || exit 1
}

# Are the counts of $out/one those that are kept?
compare() {
    awk -F '\t' -v what="$1" '
        /^#/ { table = $1; next }
        table == "# runs" && $1 == "n" { for (c = 1; c <= NF; c++) at[$c] = c }
        table == "# runs" && NF {
            key = $1 " " $2 " " $3 " " $4
            if (FNR == NR) { systems[key] = $at["systems"]
                             iterations[key] = $at["iterations"]; next }
            if ($1 == "n") next
            found = 1
            if (!(key in systems)) why = "no such run is kept"
            else {
                d = $at["systems"] - systems[key]
                e = $at["iterations"] - iterations[key]
                if (d > 2 || d < -2)
                    why = $at["systems"] " systems, kept " systems[key]
                if (e > 1 || e < -1)
                    why = $at["iterations"] " iterations, kept " iterations[key]
            }
        }
        END { if (!found) why = "it printed no counts"
              print (why == "" ? "ok " : "FAIL ") what (why == "" ? "" : ": " why) }
    ' "$kept" "$out/one"
}

test_all() {
    echo "$small" | while read -r n steps method processes serial; do
        what="many: n = $n, $method on $processes"
        if run "$program" "$n" "$steps" "$method" "$processes" "$serial"; then
            compare "$what"
        elif grep -q 'has no MUMPS' "$out/one.log"; then
            echo "skip $what: this PETSc has no MUMPS"
        else
            echo "FAIL $what: status $status: $(tail -n 3 "$out/one.log")"
        fi
    done
    # Wrong programs: by 1e-3 of a step at least, or by the counts.
    what='many: neighbours_left_out is caught by the displacements'
    if run "$programs/neighbours_left_out/many" 16 10 geometric 2 yes; then
        echo "FAIL $what: nobody notices"
    else
        awk -v what="$what" '/^Largest difference/ { d = $(NF - 1) }
            END { if (d > 1e-3 * 0.5 / 30) print "ok " what
                  else print "FAIL " what ": it differs by " d }' "$out/one.log"
    fi
    what='many: lift_left_out is caught by the counts'
    run "$programs/lift_left_out/many" 16 10 geometric 2 yes
    case $(compare x) in
    *systems*) echo "ok $what" ;;
    *) echo "FAIL $what: status $status" ;;
    esac
    what='many: operations that grow like n^3 miss their goals'
    missed=$(awk -F '\t' -v OFS='\t' '$1 == "n" { at = 0
            for (c = 1; c <= NF; c++) if ($c == "flops") at = c }
        at && $1 + 0 > 0 { $at *= $1 } { print }' "$kept" |
        awk -F '\t' -f tests/tools/many.awk | grep -c 'MISSED  exponent')
    if [ "$missed" = 2 ]; then echo "ok $what"; else echo "FAIL $what"; fi
}

measure() {
    each "$all" ''
    for table in runs messages; do
        printf '# %s\n' "$table"
        cat "$out/$table"
        printf '\n\n'
    done >"$part"
    if [ -s "$out/seconds" ]; then
        for round in 1 2 3; do each "$timed" round_; done
        : >>"$out/round_seconds"
        echo 'Seconds per step, of runs that had their processors to themselves:'
        cat "$out/seconds"
        for table in seconds round_seconds; do
            printf '# %s\n' "$table"
            cat "$out/$table"
        done >"$out/all_seconds"
    fi
    : >>"$out/all_seconds"
    awk -F '\t' -f tests/tools/many.awk "$part" "$out/all_seconds" || exit 1
    mv "$part" "$kept"
    echo "  wrote    $kept"
    [ -s "$out/seconds" ] || echo 'The machine was busy: no seconds.'
}

# there: PETSc with MPI is here; without it say so
there() {
    pkg-config --exists petsc 2>/dev/null && command -v mpicc >/dev/null &&
        command -v mpirun >/dev/null && return
    echo "$1: no PETSc with MPI here; make deps-many installs it"
    return 1
}
# compile FILE PROGRAM: FILE may be a copy elsewhere.  The headers of PETSc are not ours
# to warn about; with -rdynamic a library that starts threads finds our own start of
# them (peer.c).
compile() {
    mkdir -p "${2%/*}"
    mpicc $FLAGS -Ifigures/many $(pkg-config --cflags petsc | sed 's/-I */-isystem /g') "$1" -o "$2" \
        $LINK -rdynamic $(pkg-config --libs petsc)
}
# the program, and those with a known mistake
compile_all() {
    compile figures/many/many.c "$program" || return
    for name in $(awk -f tests/tools/variant.awk -v list=mistake tests/many/mistakes.txt); do
        to=$programs/$name
        mkdir -p "$to" && cp figures/many/*.[ch] "$to"
        file=$(awk -f tests/tools/variant.awk -v name="$name" -v get=file \
            tests/many/mistakes.txt)
        awk -f tests/tools/variant.awk -v name="$name" tests/many/mistakes.txt \
            "figures/many/$file" >"$to/$file" && compile "$to/many.c" "$to/many" || return
    done
}

case $1 in
test)
    there 'skip many' || exit 0
    if compile_all >"$out/log" 2>&1; then test_all; else
        echo 'FAIL many:'
        cat "$out/log"
    fi ;;
many)
    there many || exit 0
    compile figures/many/many.c "$program" && measure ;;
peer)
    peer=$BUILD/data/many/peer.tsv
    mkdir -p "$BUILD/data/many"
    if there peer >/dev/null; then
        compile figures/many/peer.c "$programs/peer" || exit
        printf '  %-8s %s\n' bench many/peer >&2
        OPENBLAS_NUM_THREADS=1 OMP_NUM_THREADS=1 OMP_THREAD_LIMIT=1 "$programs/peer" \
            >"$out/peer" && cp "$out/peer" "$peer" && cp "$out/peer" figures/many/peer.tsv || exit
    else
        cp figures/many/peer.tsv "$peer"
    fi ;;
esac
