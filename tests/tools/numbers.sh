# numbers.sh - for student.sh, which reads it with `.`: a program run with the
# options ARGS, and its numbers beside the reference's, as a list (make diff-NN)
# and as a picture (make plot-NN).

# limit OPTION MOST: `ulimit`, which in dash sets one limit at a time.  One that
# is there already may be lower.
limit() {
    ulimit "$1" "$2" 2>/dev/null ||
        case $(ulimit "$1" 2>/dev/null) in
        *[0-9]*) ;;
        *) echo "ulimit knows no $1 here: what never ends is yours to stop." >&2 ;;
        esac
}
# run_limited PROGRAM FILE: what it prints goes to FILE.  ARGS is split at blanks,
# and nothing else is done to it.  An endless loop or endless output ends.
run_limited() {
    (
        limit -t 21
        ulimit -S -t 20 2>/dev/null # a signal that has a name
        limit -f 65536
        set -f
        exec "$1" $ARGS >"$2"
    )
    ended=$?
    case $ended in
    152) echo 'The program was ended: it computes for too long.' ;;
    153) echo "The program was ended: it prints too much; see $2" ;;
    esac >&2
    return $ended
}
out=$BUILD/mine/$slug.tsv
run_mine() { run_limited "$built/mine/$slug" "$out"; }
asked_for_help() {
    case " $ARGS " in *' -h '* | *' --help '*) return 0 ;; esac
    return 1
}

# The cells of both, mine and the reference with the same options; 2 when the
# reference refuses them.
cells=$BUILD/mine/$slug.cells
compare() {
    ! asked_for_help || exec "$built/solutions/$slug" -h
    theirs=$BUILD/data/$slug.tsv
    if [ -n "$ARGS" ]; then
        theirs=$BUILD/mine/$slug.reference.tsv
        run_limited "$built/solutions/$slug" "$theirs" 2>"$cells"
        status=$?
        sed "s/^/the reference: /" "$cells" >&2
        [ $status -le 1 ] || return 2
        [ $status = 0 ] ||
            echo "The reference ends with status 1: it is compared until then."
    fi
    run_mine
    case $ended in
    0) ;;
    3) echo 'Yours is unfinished: it is compared until there.' ;;
    *) [ $ended -lt 128 ] || ended="$ended (signal $(kill -l $((ended - 128))))"
       echo "Yours ends with status $ended: it is compared until then." ;;
    esac
    "$built/solutions/$slug.judge" --cells "$out" "$theirs" >"$cells"
}

make_diff() {
    compare || return 2
    awk -v nn="$nn" -v only="$TABLE" -f tests/tools/diff.awk "$cells"
}

# The table and the two columns that the solution's header says to plot; then
# may follow logx, logy, key=COLUMN.
plot_spec() { sed -n 's/^ \* Plot: *//p' "solutions/$slug.c" | head -n 1; }

draw() { # in the C locale gnuplot has no degree sign of its own, and says so
    said=$(gnuplot -e "$1" figures/overlay.gp 2>&1 1>&3)
    drawn=$?
    echo "$said" | grep -v -e '^$' -e 'iconv failed to convert degree sign' >&2
    return $drawn
} 3>&1

curves=$BUILD/mine/$slug.curves
make_curves() { # ENVIRON, because -v takes a backslash for the beginning of something
    said=$(SPEC=$(plot_spec) curves=$curves nn=$nn awk -f tests/tools/plot.awk "$cells") || {
        echo "$said" >&2
        return 2
    }
    echo "$said" >"$curves.gp"
}
make_plot() {
    compare || return 2
    make_curves || return 2
    # where nothing of mine is in the lesson's own picture, what is worst of mine
    instead=$(echo "$said" | sed -n "s/^instead = '\(.*\)'/\1/p")
    if [ -z "$TABLE$X$Y$KEY" ] && [ -n "$instead" ] &&
        echo "$said" | grep -q '^# Nothing of yours'; then
        echo "Of table \`$(plot_spec | cut -d ' ' -f 1)\` yours has nothing;" \
            "what is worst is drawn."
        TABLE=${instead% *} Y=${instead#* } make_curves || return 2
    fi
    picture=$BUILD/mine/$slug.svg part=$BUILD/mine/$slug.$$.part
    rm -f "$picture"
    given="data='$curves'"
    draw "$given; out=''" && draw "$given; out='$part'" && mv "$part" "$picture" &&
        echo && sed -n 's/^# //p' "$curves.gp" | fold -s -w 79 |
            sed 's/ *$//' && echo "The picture is $picture" || return 1
    course_figures
    ! grep -q '^# Nothing of yours' "$curves.gp"
}
