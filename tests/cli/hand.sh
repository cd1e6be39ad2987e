#!/bin/sh
# hand.sh - what is held in the hand (make live-NN), without a window: replayed it is
# the same, 2000 random frames end well, also with a known mistake, and a slot that is
# not written, that crashes, leaks, does not end, leaves the program or returns no number
# is told as such; and in a window that nobody sees (view.c) late frames are counted.
#
# Called with SCENES, and what tests/tools/hand.sh needs.  Prints ok and FAIL lines.
set -u
LC_ALL=C
export LC_ALL
: "${BUILD:=build}"
MINE=$BUILD/test/hand WINDOW=no
export MINE WINDOW
rm -rf "$MINE" && mkdir -p "$MINE" || exit 1
result() { # result STATUS WHAT WHY
    if [ "$1" = 0 ]; then echo "ok hand: $2"; else echo "FAIL hand: $2: $3"; fi
}
play() { # play FILE ARGS: the scene of $slug with the slots of FILE
    said=$(ARGS=$2 sh tests/tools/hand.sh "$slug" "$1" 2>&1)
    status=$?
}
random() { # random SEED: 2000 random frames with the same program
    said=$("$MINE/$slug.hand" --input mad --frames 2000 --seed "$1" 2>&1 \
        >"$MINE/$slug.hand.tsv")
    status=$?
}
frames() { grep -c '^[0-9]' "$MINE/$slug.hand.tsv"; }
# balanced: a frame that is lost has a reason, and no row has a number that is none; a
# scene that keeps books says that they balance (figures/26_cut/hand.c): a step may gain
# energy only where a triangle has lost much of its area
balanced() {
    awk -F '\t' '$1 == "frame" { for (k = 1; k <= NF; k++) at[$k] = k; next }
        !/^[0-9]/ { next }
        /nan|inf/ || (("lost" in at) && $at["lost"] > lost && $at["status"] == "OK") {
            print; exit 1 }
        { lost = "lost" in at ? $at["lost"] : 0 }
        !("gained" in at) { next }
        { J = $at["min_J"]
          if ($at["mass_off"] > 1e-12 || $at["jumped"] > 1e-12 || (J > 0.6 &&
              before > 0.6 && $at["gained"] > 1e-4)) { print; exit 1 }
          before = J }' "$MINE/$slug.hand.tsv"
}
# with_line SLOT LINE: the solution with LINE where SLOT begins
with_line() {
    line=$2 awk -v slot="$1" '{ print }
        index($0, "/* SLOT " slot "(") { inside = 1 }
        inside && /\*\// { print ENVIRON["line"]; inside = 0 }' \
        "solutions/$slug.c" >"$MINE/lined.c"
}
# what a slot may do and not return: a loop that sleeps costs nothing, and brings the
# alarm forward that is set
bad='extern char *getenv(const char *); extern void exit(int), abort(void);
    extern int pause(void); volatile int *volatile nowhere = 0;
    extern unsigned alarm(unsigned); extern void *malloc(unsigned long);
    volatile char *leaked; int page = 256;
    switch (*getenv("HOW")) { case 99: *nowhere = 1; break; case 101: exit(0); break;
        case 97: abort(); break; case 115: leaked = malloc(1 << 20);
        while (page--) leaked[4096 * page] = 1;
        break; default: if (alarm(1) > 1) for (;;) pause(); }'
$COMPILE -DHAND_MEMORY=9000 -c common/motion/hand.c -o "$MINE/hand.o" &&
    $COMPILE -DHAND_MEMORY=9000 -Dclock_seconds=frame_clock -c common/motion/hand.c \
        -o "$MINE/late.o" &&
    $COMPILE -c tests/cli/view.c -o "$MINE/view.o" || exit 1
objects=$OBJECTS
for slug in $SCENES; do
    play "solutions/$slug.c" '--input hard'
    cp "$MINE/$slug.hand.tsv" "$MINE/first"
    [ $status = 0 ] && [ "$(frames)" = 300 ]
    result $? "$slug, 300 frames" "$said"
    "$MINE/$slug.hand" --input hard --picture "$MINE/last.svg" >/dev/null
    grep -q '^<polygon' "$MINE/last.svg" && grep -q "the reference's slots\|yours: " "$MINE/last.svg" &&
        tail -n 1 "$MINE/last.svg" | grep -q '^</svg>$' && ! grep -q nan "$MINE/last.svg"
    result $? "$slug, the last picture as SVG" "$(head -n 5 "$MINE/last.svg")"
    # whose slots they are is found out from the file, and changes no number
    awk -f tests/tools/starter.awk "solutions/$slug.c" >"$MINE/starter.c"
    play "$MINE/starter.c" '--input hard'
    cmp -s "$MINE/first" "$MINE/$slug.hand.tsv" &&
        grep -q '^yours: none; reference: ' "$MINE/$slug.hand.whose"
    result $? "$slug, a starter runs with the reference's slots, the same to the last digit" \
        "$said"
    for seed in 1 2 3; do
        random $seed
        [ $status = 0 ] && [ "$(frames)" = 2120 ] && said=$(balanced)
        result $? "$slug, random frames, seed $seed" "$said"
    done
    mistake=$(awk -f tests/tools/variant.awk -v list=mistake "tests/mistakes/$slug.txt" |
        head -n 1)
    awk -f tests/tools/variant.awk -v name="$mistake" "tests/mistakes/$slug.txt" \
        "solutions/$slug.c" >"$MINE/mistake.c"
    play "$MINE/mistake.c" '--input hard'
    for seed in none 1; do
        [ $seed = none ] || random $seed
        [ $status = 0 ] || [ "$(echo "$said" | grep -c "^live-${slug%%_*}: ")" = 1 ]
        result $? "$slug, with $mistake, seed $seed" "$said"
    done
    slot=$(sed -n 's/.*hand_slot("\([0-9a-z]*\)").*/\1/p' "figures/$slug/hand.c" | head -n 1)
    with_line "$slot" "$bad"
    OBJECTS="$MINE/hand.o $objects" HOW=crash
    export OBJECTS HOW
    play "$MINE/lined.c" '--input pull'
    OBJECTS=$objects
    for HOW in crash exit abort spill loop; do
        # where a leak meets the end of memory first, it is a leak nevertheless
        [ $HOW = spill ] && input=hard || input=pull
        said=$(ulimit -v 100000 && "$MINE/$slug.hand" --input $input 2>&1 >/dev/null)
        status=$?
        case $HOW in
        spill) words="CRASHED (slot $slot): it leaks" ;;
        crash) words="CRASHED (slot $slot): .*make debug-${slug%%_*}$" ;;
        loop) words="TIMEOUT (slot $slot): " ;;
        *) words="CRASHED (slot $slot): " ;;
        esac
        [ $status = 1 ] && echo "$said" | grep -q "^live-${slug%%_*}: $words"
        result $? "$slug, a slot with $HOW" "$status: $said"
    done
done
slug=01_deformation
OBJECTS="$MINE/late.o $MINE/view.o $objects" MS=34
export MS
play "solutions/$slug.c" ''
[ $status = 0 ] && echo "$said" | grep -q '^30 of 30 frames late$' && awk '/^[0-9]/ { k++
    if ($2 != (k - 1) / 16 || $3 != (1 - k) / 32 || $4 != (k - 1) % 2) exit 1 }
    END { exit k != 30 }' "$MINE/$slug.hand.tsv"
result $? "$slug, late frames are counted, and have their pointer" "$(echo "$said" | tail -n 4)"
said=$(MS=33 "$MINE/$slug.hand" 2>&1 >/dev/null)
echo "$said" | grep -q '^.r. reset' && ! echo "$said" | grep -q late
result $? "$slug, frames of 33 ms are in time" "$(echo "$said" | tail -n 4)"
with_line 1b "$bad"
HOW=spill play "$MINE/lined.c" ''
[ $status = 1 ] && [ "$(echo "$said" | grep '^live-')" = \
    'live-01: CRASHED (slot 1b): it leaks, more than a gigabyte by now' ]
result $? "$slug, a leak in a window is told before memory ends" \
    "$status: $(echo "$said" | tail -n 4)"
OBJECTS=$objects
sed 's|/\* END 1b \*/|J = 0.0 / (F->m[0][0] - F->m[0][0]);&|' "solutions/$slug.c" >"$MINE/lined.c"
play "$MINE/lined.c" '--input pull'
[ $status = 1 ] && echo "$said" | grep -q ': NONFINITE (slot 1c): '
result $? "$slug, no number" "$status: $said"
sed 's/J = F->m/J = F.m/' "solutions/$slug.c" >"$MINE/lined.c"
play "$MINE/lined.c" '--input pull'
[ $status = 1 ] && echo "$said" | grep -q "lined.c:[0-9]*:.*error" &&
    echo "$said" | grep -q '^live-01: WRONG (does not compile)'
result $? "$slug, an error of the compiler has its line" "$status: $said"
echo '1 2 3' >"$MINE/broken"
play "solutions/$slug.c" "--input $MINE/broken"
[ $status = 2 ] && echo "$said" | grep -q "broken.*line 1"
result $? 'a broken recording is named, with its line' "$status: $said"
