# debug.sh - `make debug-NN`; student.sh reads this file with `.`.
#
# The student's program and the library below it are built without optimization
# and with the sanitizers that the compiler has, in a folder of their own, and
# run once, within the limits of student.sh.

sanitizers() { # the first of these with which a program is built and runs
    for kinds in address,undefined undefined address; do
        echo 'int main(void) { return 0; }' >"$folder/try.c"
        ${CC:-cc} -fsanitize=$kinds "$folder/try.c" -o "$folder/try" \
            2>/dev/null && "$folder/try" 2>/dev/null && return
    done
    kinds=
    echo 'This compiler has no sanitizers here.' >&2
}

# A debugger's command, to stop where a sanitizer does or, with any word, in main.
debugger() { # debugger [WORD]
    if ! command -v gdb >/dev/null && command -v lldb >/dev/null; then
        how="lldb${1:+ -o 'b main'} -o run --"
    else
        how="gdb${1:+ -ex 'break main'} -ex run --args"
    fi
    echo "$how $program${ARGS:+ $ARGS}"
}

debug() {
    folder=$(mktemp -d "$BUILD/mine/$slug.XXXXXX") || return 2
    sanitizers
    program=$BUILD/debug/mine/$slug
    flags="-O0 -g -fno-omit-frame-pointer"
    [ -z "$kinds" ] || flags="$flags -fsanitize=$kinds -fno-sanitize-recover=all"
    # -s: no word of what is up to date
    patiently "$MAKE" -s "$program" BUILD="$BUILD/debug" NATIVE= FAST_LD= \
        CFLAGS="$flags" || return 2
    built=$built/debug out=$program.tsv report=$program.report
    export ASAN_OPTIONS="${ASAN_OPTIONS:-detect_leaks=0}" \
        UBSAN_OPTIONS="${UBSAN_OPTIONS:-print_stacktrace=1}"
    run_mine 2>"$report"
    status=$?
    if ! awk -f tests/tools/debug.awk -v mine="$mine" "$report"; then
        echo "The whole report is in $report"
        echo 'To stop there, and see all variables (`up` goes to your line):'
        echo "  ASAN_OPTIONS=abort_on_error=1 $(debugger '')"
        return 1
    fi
    case $status in
    0) ended='It ends well' ;;
    3) ended='It comes to a slot that is not written' ;;
    *) ended="It ends with status $status" ;;
    esac
    echo "$ended${kinds:+; the sanitizers ($kinds) found nothing}."
    echo "To go through it: $(debugger main)"
    return $status
}
