# pictures.sh - the course's figures with the student's numbers; part of
# student.sh.

# The tables that a script says it reads.
tables_of() {
    awk '/^# Reads/ { on = 1 } on && /^# (Writes|Expected|Yours)/ { exit }
        on { sub(/^# (Reads +data +tables?)? */, ""); said = said " " $0 }
        END { gsub(/\([^)]*\)/, "", said); gsub(/,/, " ", said); print said }' "$1"
}
has_rows() { # has_rows TABLE FILE
    awk -v title="# $1" '$0 == title { on = 1; next } on && !NF { exit }
        on && !/^#/ { n++ } END { exit n < 2 }' "$2" 2>/dev/null
}
print_with() ( # print_with PROGRAM FILE: its tables, the options before ARGS
    ARGS="$options $ARGS"
    run_limited "$1" "$2" 2>/dev/null
)
# course_figures: each script of the lesson's folder that has no study, or says
# with which options the lesson prints its table, draws $out.
course_figures() {
    grey=
    for script in figures/"$slug"/*.gp; do
        grep -q '^# Reads' "$script" || continue
        options=$(sed -n 's/^# Yours *the lesson with //p' "$script")
        [ -n "$options" ] || [ ! -f "${script%.gp}.c" ] || continue
        what=$(basename "$script" .gp)
        kind=svg numbers=$out
        ! grep -q '^set terminal gif' "$script" || kind=gif
        picture=$BUILD/mine/$slug.$what.$kind
        rm -f "$picture"
        behind=$BUILD/data/$slug.tsv
        if [ -n "$options" ]; then
            numbers=$BUILD/mine/$slug.$what.tsv
            behind=$BUILD/mine/$slug.$what.reference.tsv
            print_with "$built/mine/$slug" "$numbers"
            ! grep -q reference "$script" ||
                print_with "$built/solutions/$slug" "$behind"
        elif [ -n "$ARGS" ]; then
            behind=$BUILD/mine/$slug.reference.tsv
        fi
        [ -f "$behind" ] || behind=$numbers
        missing=
        for table in $(tables_of "$script"); do
            has_rows "$table" "$numbers" || missing="$missing $table"
        done
        if [ -n "$missing" ]; then
            echo "${script%.gp}.$kind is not drawn: your program has not" \
                "printed the table$missing."
        elif ( limit -t 10; sh tests/tools/figure.sh "$script" "$numbers" \
            "$picture" "$behind" ) 2>/dev/null; then
            echo "${script%.gp}.$kind with your numbers: $picture"
            ! grep -q -e 'reference index' -e square.gp "$script" || grey=yes
        else
            echo "${script%.gp}.$kind is not drawn: are all numbers of" \
                $(tables_of "$script") "finite and of a sensible size?"
        fi
    done
    [ -z "$grey" ] || echo 'What is grey behind yours is the reference.'
}
