#!/bin/sh
# hostile.sh - what `make check-03` makes of programs that mean no good.
#
# Each is the solution with one line more.  It is judged as a student's file is,
# in a copy of the workbook; it must get its verdict, and after it there must be
# no process, no file, and no change in the copy.  Prints "ok ..." or "FAIL ...".
set -u
LC_ALL=C
export LC_ALL
: "${BUILD:=build}" "${MAKE:=make}"
export ANY_FLAGS=1 # the judged programs are compiled quickly, the rest stays
slug=03_dirichlet_correction nn=03
. tests/tools/patiently.sh
within=$(within 1800)
result() { # result STATUS WHAT WHY
    if [ "$1" = 0 ]; then echo "ok cli: $2"; else echo "FAIL cli: $2: $3"; fi
}

# NAME | WHERE | LINE | VERDICT.  WHERE is slot (the first one), main, or file
# (its head), of the starter where it begins with empty; what stands before ## in LINE
# goes to the head as well, and @@ ends a line.  ROOT is the folder of the workbook.
# Linux is to have Landlock, or a program reads and executes what is not its own.  A
# verdict with | depends on the system: where Linux allows namespaces a program
# signals its own processes only; or on the compiler: clang takes /dev/zero for an
# empty file.
programs() {
    cat <<'END'
segmentation fault | slot | int *volatile nowhere = (int *)-4096L; *nowhere = 1; | CRASHED
freed twice | slot | char *p = malloc(8); char *volatile q = p; free(p); free(q); | CRASHED
a gigabyte on the stack | slot | volatile char all[1 << 30]; for (long k = 0; k < 1 << 30; k += 4096) all[k] = 1; | CRASHED
one number too many | slot | double three[3]; for (volatile int k = 0; k <= 3; k++) three[k] = k; | CRASHED
trap | main | raise(SIGFPE); | CRASHED
handler that ends with 0 | slot | static void leave(int s) { _exit(s - s); } ## signal(SIGSEGV, leave); raise(SIGSEGV); | CRASHED
endless loop | slot | for (volatile int spin = 0;; spin = 1) {} | TIMEOUT
endless loop, signals ignored | main | for (int s = 1; s < 32; s++) signal(s, SIG_IGN); for (volatile int spin = 0;; spin = 1) {} | TIMEOUT
endless sleep | slot | for (;;) sleep(1000); | TIMEOUT
endless sleep, signals blocked | main | sigset_t all; sigfillset(&all); sigprocmask(SIG_SETMASK, &all, NULL); for (;;) pause(); | TIMEOUT
stops itself | slot | raise(SIGSTOP); | CRASHED
stops itself in main | main | raise(SIGSTOP); | CRASHED
endless stdout | slot | for (;;) puts("and on and on"); | CRASHED
endless stderr | main | for (;;) fputs("and on and on", stderr); | CRASHED
endless stdout, SIGXFSZ ignored | main | signal(SIGXFSZ, SIG_IGN); for (;;) puts("and on and on"); | TIMEOUT
endless files | slot | for (int k = 0;; k++) { char name[20]; sprintf(name, "f%d", k); close(creat(name, 0600)); } | CRASHED
leak up to the limit | slot | for (;;) { volatile char *p = malloc(1 << 26); for (long k = 0; k < 1 << 26; k += 1 << 16) p[k] = 1; } | CRASHED
all memory, then on | main | static char *volatile hog; ## while ((hog = malloc(1 << 20))) *hog = 1; | OK|WRONG
fifty sleepers | slot | static int born; ## if (!born++) for (int k = 0; k < 50; k++) if (fork() == 0) { sleep(1000); _exit(0); } | OK
three hundred sleepers | slot | for (int k = 0; k < 300; k++) if (fork() == 0) { sleep(1000); _exit(0); } sleep(2); | CRASHED
three hundred threads | slot | static void *nap(void *none) { sleep(1000); return none; } ## pthread_attr_t small; pthread_attr_init(&small); pthread_attr_setstacksize(&small, 1 << 16); for (int k = 0; k < 300; k++) { pthread_t one; pthread_create(&one, &small, nap, NULL); } sleep(2); | CRASHED
sleeping daemon | main | if (fork() == 0) { setsid(); if (fork() == 0) { sleep(1000); } _exit(0); } | OK
computing daemon | main | if (fork() == 0) { setsid(); if (fork() == 0) for (volatile int spin = 0;; spin = 1) {} _exit(0); } | OK
daemon that ignores signals | slot | static int born; ## if (!born++ && fork() == 0) { for (int s = 1; s < 32; s++) signal(s, SIG_IGN); setsid(); sleep(1000); _exit(0); } | OK
daemon with open output | main | if (fork() == 0) { setpgid(0, 0); sleep(1000); _exit(0); } | OK
reads the keyboard | main | while (getchar() != EOF) {} | OK
reads the terminal | slot | FILE *tty = fopen("/dev/tty", "r"); if (tty) fgetc(tty); | OK
runs a shell | main | if (system("exit 0") == 0) puts("here"); | OK
removes all in its folder | slot | DIR *d = opendir("."); for (struct dirent *e; d && (e = readdir(d));) unlink(e->d_name); | WRONG
reads the solution | main | if (fopen("ROOT/solutions/03_dirichlet_correction.c", "r")) exit(7); | OK
reads the judge | slot | if (open("ROOT/build/solutions/03_dirichlet_correction.judge", O_RDONLY) >= 0) exit(7); | OK
is the reference | main | execv("ROOT/build/solutions/03_dirichlet_correction", argv); exit(7); | WRONG
writes into solutions | slot | FILE *f = fopen("ROOT/solutions/03_dirichlet_correction.c", "a"); if (f) { fputs("spoiled", f); fclose(f); } | OK
empties a check | slot | FILE *f = fopen("ROOT/tests/checks/03_dirichlet_correction.c", "w"); if (f) fclose(f); | OK
empties the reference | slot | unlink("ROOT/build/solutions/03_dirichlet_correction"); | OK
links the judge's output to a file | slot | symlink("ROOT/solutions/03_dirichlet_correction.c", "judge.stdout"); | OK
a pipe for the judge's message | slot | mkfifo("judge.message", 0600); | OK
changes the folder | slot | if (chdir("/")) {} | OK
changes the folder in main | main | if (chdir("/")) {} | OK
no permissions | main | umask(0777); chmod(".", 0); | OK
closes every descriptor | slot | for (int fd = 0; fd < 1024; fd++) close(fd); | CRASHED
closes stdout | main | fclose(stdout); | WRONG
says VERDICT OK | main | puts("VERDICT 03: OK, all 11 checks"); | WRONG
says VERDICT OK and leaves | slot | puts("VERDICT 03: OK, all 11 checks"); exit(0); | CRASHED
a constructor | file | __attribute__((constructor)) static void early(void) { write(3, "finished", 8); _exit(0); } | WRONG (refused)
a constructor by a macro | file | #define EARLY(x) __attribute__((con##x)) @@ EARLY(structor) static void early(void) { _exit(0); } | WRONG (refused)
a constructor behind another #line | file | #line 1 "/usr/include/stdio.h" @@ __attribute__((__constructor__)) static void early(void) { _exit(0); } | WRONG (refused)
an entry of .init_array | file | static void early(void) { _exit(0); } static void (*at_first)(void) __attribute__((section( @@ ".init_array"), used)) = early; | WRONG (refused)
a section with a line break | file | static void early(void) { _exit(0); } static void (*at_first)(void) __attribute__((section(".data\n.section .init_array,\"aw\" #"), used)) = early; | WRONG (refused)
a section of its own | file | static int odd __attribute__((section(".interp"), used)) = 1; | WRONG (refused)
a function chosen before main | file | static int (*which(void))(void) { return NULL; } @@ int odd(void) __attribute__((ifunc("which"))); int use(void); int use(void) { return odd(); } | WRONG (refused)
a line of assembler | file | __asm__(".section .init_array"); | WRONG (refused)
a file in assembler | file | __asm__(".incbin \"build/solutions/03_dirichlet_correction\""); | WRONG (refused)
assembler in a slot | slot | __asm__ volatile ("nop"); | WRONG (refused)
no assembler | slot | __asm__ volatile ("" ::: "memory"); | OK
a string with a constructor | file | static const char *const what = "constructor .section .init_array \" .incbin"; const char *const *use = &what; | OK
words of the object file as names | file | static struct { int constructor, section, ifunc; } of; double asm; void section(const char *s); void section(const char *alias) { asm = of.section + !alias; } /* section(".init_array") */ | OK
another _exit, weak | file | void my_exit(int s); void my_exit(int s) { for (;;) s++; } @@ %:pragma weak _exit = my_exit | OK
another _exit, by alias | file | void my_exit(int s); void my_exit(int s) { for (;;) s++; } @@ void _exit(int) __attribute__((alias("my_exit"))); | OK
a macro for the judge | empty file | %:define judge_judge(l, c, v) 0 @@ ??=define judge(l, c, v) 0 @@ /**/ #define wrong \ @@ exit | UNFINISHED
a name of the judge's | file | extern int judging; int *peek = &judging; | WRONG (refused)
a name of the judge's, by another | file | extern int mine __asm__("judging"); int *peek = &mine; | WRONG (refused)
the first number on the stack | empty slot | volatile unsigned long long here = 0, *at = &here, w; do w = *at++; while (!(w >> 48) || w >> 48 == 0x7fff || w >> 48 == 0xffff); if (write(3, (const void *)&w, 8)) {} _exit(0); | CRASHED
the solution, included by another path | file | #include "..//solutions/.//../solutions/03_dirichlet_correction.c" | WRONG (refused)
the solution, included by way of /proc | file | #include "/proc/self/cwd/solutions/./03_dirichlet_correction.c" | WRONG (refused)
the solution, included by a macro | file | #define ALL <../solutions/03_dirichlet_correction.c> @@ #include ALL | WRONG (refused)|WRONG (does not compile)
the solution, included by a link | file | #include "../linked.h" | WRONG (refused)
a known mistake, included | file | #include "../build/mistakes/03_dirichlet_correction/all.c" | WRONG (refused)
includes itself twice | file | #include __FILE__ @@ #include __FILE__ | WRONG (refused)|WRONG (does not compile)
macros of ten to the ten | file | #define A(x) x x x x x x x x x x @@ #define B(x) A(A(A(A(A(A(A(A(A(A(x)))))))))) @@ static const int many = B(+1); | WRONG (refused)
_Exit(0) in a slot | slot | fclose(fopen("judge.finished", "w")); _Exit(0); | CRASHED
the end of a check, said by the program | slot | for (int fd = 3; fd < 9; fd++) if (write(fd, "finished", 8)) {} _exit(0); | CRASHED
a malloc() of its own | file | void *malloc(size_t size) { return size ? NULL : NULL; } | OK
an _exit() of its own | file | extern char **environ; @@ _Noreturn void _exit(int status) { *environ = NULL; for (;;) status++; } | OK
a function of the library's | file | enum status matrix_factor(struct matrix *A) { return A ? OK : NOT_SPD; } | WRONG (refused)
shared memory | slot | shmget(IPC_PRIVATE, 1 << 20, 0600); | OK
says that the judge is in trouble | slot | fprintf(stderr, "judge: usage"); _exit(2); | CRASHED
the program as the judge | slot | execve("/proc/self/exe", (char *[]){"judge", NULL}, (char *[]){NULL}); _exit(2); | CRASHED
neither files nor a right slot | empty slot | setrlimit(RLIMIT_NOFILE, &(struct rlimit){0, 0}); return; | CRASHED
exit(0) in main | main | exit(0); | WRONG
another program | slot | execl("/bin/true", "true", (char *)NULL); | OK
loop at exit | main | static void again(void) { for (volatile int spin = 0;; spin = 1) {} } ## atexit(again); | TIMEOUT
kills its group | slot | kill(0, SIGKILL); | CRASHED
kills its parent | slot | kill(getppid(), SIGKILL); | OK|CRASHED
kills its parent in main | main | kill(getppid(), SIGKILL); | CRASHED
stops its parent | slot | kill(getppid(), SIGSTOP); | OK|CRASHED
jumps to nowhere | slot | jmp_buf nowhere; memset(nowhere, 0, sizeof nowhere); longjmp(nowhere, 1); | CRASHED
no output allowed | main | struct rlimit none = {0, 0}; setrlimit(RLIMIT_FSIZE, &none); | CRASHED
no files allowed | slot | struct rlimit none = {0, 0}; setrlimit(RLIMIT_NOFILE, &none); | OK
a table with a NUL in it | main | fwrite("# nul\nx\n1\0\n\n\n", 1, 13, stdout); | OK
a header that never ends | file | #include "/dev/zero" | WRONG|OK
a header that is not there | file | #include "no such file.h" | WRONG (does not compile)
END
}

# The solution with a line more.
hostile() { # hostile WHERE LINE
    case $1 in empty*) awk -f tests/tools/starter.awk "solutions/$slug.c" ;;
    *) cat "solutions/$slug.c" ;; esac | awk -v where="${1#empty }" -v all="$2" '
        BEGIN {
            n = index(all, " ## ")
            head = n ? substr(all, 1, n - 1) : ""
            line = n ? substr(all, n + 4) : all
            gsub(/ @@ /, "\n", line)
            split("dirent fcntl pthread setjmp signal stdio stdlib string sys/resource sys/shm " \
                  "sys/stat unistd", header, " ")
            print "#if defined(__linux__)\n#define _DEFAULT_SOURCE\n#endif"
            for (h = 1; h in header; h++) print "#include <" header[h] ".h>"
        }
        /^static / && !headed++ { print head; if (where == "file") print line }
        { print }
        where == "main" && /options_parse\(/ { ahead = 1 }
        ahead && /;$/ { print line; ahead = 0 }
        where == "slot" && /\/\* SLOT / && !inside++ { comment = 1 }
        comment && /\*\// { print line; comment = 0 }'
}

# What there is, but for the log and the progress of the lesson.
state() {
    find . -type f -o -type l -o -type p | grep -v -e '^./build/mine/.*\.log$' \
        -e '^./build/progress/' -e "^./lessons/$slug.c\$" | sort
    find solutions common tests Makefile build/solutions build/mistakes \
        -type f -exec cksum {} + | sort
}
# Processes of this copy, by their environment or, without /proc, by their path.
left_over() {
    if [ -r /proc/self/environ ]; then
        grep -l "HOSTILE=$PWD:$1:" /proc/[0-9]*/environ 2>/dev/null |
            while read -r at; do tr '\0' ' ' <"${at%environ}cmdline"; echo; done
    else
        ps -A -o args | grep -F "$PWD" | grep -v grep
    fi
}
nothing_left() { # nothing_left NUMBER: or say what
    for round in 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16 17 18 19 20; do
        found=$(left_over "$1")
        [ -n "$found" ] || break
        sleep 0.5
    done
    [ -z "$found" ] || { echo "left: $found"; return 1; }
    state | diff ../state."$(basename "$PWD")" -
}
judged() { # judged NUMBER WHAT VERDICT [TEXT]: lessons/$slug.c is
    said=$(HOSTILE="$PWD:$1:" $within "$MAKE" "check-$nn" BUILD=build \
        CFLAGS=-O0 2>&1 </dev/null)
    last=$(echo "$said" | grep -v -e '^make' -e '^next: ' | tail -n 1)
    echo "$last" | grep -Eq "^VERDICT $nn: ($(echo "$3" | sed 's/[()]/\\&/g'))"
    result $? "$2 is $3" "$said"
    if [ "${4:-}" ]; then
        echo "$said" | tr -s '\n ' ' ' | grep -qF -e "$4"
        result $? "$2: the message says $4" "$said"
    fi
    left=$(nothing_left "$1")
    result $? "$2 leaves nothing" "$left"
}

prepare() { # prepare COPY
    BUILD="$BUILD" sh tests/tools/copy.sh "$1" "$slug" || exit 1
    cd "$1" || exit 1
    "$MAKE" status BUILD=build >/dev/null
    ln -s "solutions/$slug.c" linked.h
    state >../state."$(basename "$1")"
}
# Ended by a judge that is remade for a second of computing, not five (child.h).
hurried='^endless loop|^endless stdout, SIGXFSZ |^loop at exit '
each() { # each NUMBER: judge the programs of stdin
    number=$1
    while IFS= read -r entry; do
        number=$((number + 1))
        name=${entry%% | *} rest=${entry#* | }
        where=${rest%% | *} rest=${rest#* | }
        hostile "$where" "$(printf '%s\n' "${rest% | *}" | sed "s|ROOT|$PWD|g; s|\\\\|&&|g")" \
            >"lessons/$slug.c"
        judged $number "$name" "${rest##* | }"
    done
}
# Every second program; the two halves are judged at the same time.
table() { # table COPY REMAINDER
    prepare "$1"
    programs | grep -Ev "$hurried" | awk "NR % 2 == $2" | each 0
}
remade() { # remade FLAG: the judge, of which the parts that it concerns have it
    set -- "$1" build/tests/checks/child.o build/tests/checks/confine.o build/tests/checks/verdict.o
    rm "$2" "$3" "$4"
    "$MAKE" "$2" "$3" "$4" "build/solutions/$slug.judge" BUILD=build \
        CFLAGS="-O0 $1" >/dev/null 2>&1
    state >../state."$(basename "$PWD")"
}

# ---- other judges: in a hurry, and without Landlock, as on other systems --------
# exit status 2, nothing that counts as a verdict, and TEXT says why
none() { # none NUMBER WHAT TEXT
    said=$(HOSTILE="$PWD:$1:" $within "$MAKE" "check-$nn" BUILD=build \
        CFLAGS=-O0 ${COMPILER:+CC="$COMPILER"} 2>&1 </dev/null)
    status=$?
    [ $status = 2 ] && [ ! -f build/progress/$nn.result ] &&
        echo "$said" | tr -s '\n ' ' ' | grep -qF -e "$3"
    result $? "$2 gives no verdict, and says $3" "status $status: $said"
}
# Two programs that compute for 0.45 s in each of their five runs are both kept to
# their ends: the limit, 4 s here, is that of one program.
kept_programs() {
    mkdir -p build/two/kept
    echo '#include <time.h>
        int main(void) { while (clock() < 45 * (CLOCKS_PER_SEC / 100)) {} }' >build/two/a.c
    ${CC:-cc} build/two/a.c -o build/two/a
    cp build/two/a build/two/b
    "build/solutions/$slug.judge" --keep build/two/kept build/two/[ab]
    ended=$(cat build/two/kept/*/*.ending)
    [ "$(echo "$ended" | grep -c '^0 0 ')" = 10 ]
    result $? 'each program is kept as if it were alone' "$ended"
    rm -r build/two
}
others() {
    prepare "$1"
    remade -DJUDGE_SECONDS=1
    programs | grep -E "$hurried" | each 200
    kept_programs
    remade '-DJUDGE_SECONDS=1 -DWITHOUT_LANDLOCK'
    number=100
    programs | grep -e '^kills its parent' -e '^stops its parent' \
        -e '^links ' -e '^a pipe ' -e 'daemon that' | while IFS= read -r entry; do
        number=$((number + 1))
        name=${entry%% | *} rest=${entry#* | }
        line=${rest#* | }
        hostile "${rest%% | *}" "$(echo "${line% | *}" | sed "s|ROOT|$PWD|g")" \
            >"lessons/$slug.c"
        judged $number "unguarded: $name" "${rest##* | }"
    done
    if bwrap --bind / / --dev-bind /dev /dev --tmpfs /proc true 2>/dev/null; then
        echo "#!/bin/sh
            export MAKE='$MAKE'
            exec bwrap --bind / / --dev-bind /dev /dev --tmpfs /proc \"\$MAKE\" \"\$@\"" \
            >"$1.make" && chmod +x "$1.make"
        programs | grep -e '^sleeping daemon' -e '^endless sleep |' \
            >"$1.programs"
        MAKE=$1.make each 300 <"$1.programs"
        rm "$1.make" "$1.programs"
    else
        echo 'skip cli: no bubblewrap, and so no empty /proc' >&2
    fi
}

# ---- what is not the student's fault, and what is -----------------------------
tools() {
    prepare "$1"
    cp "solutions/$slug.c" "lessons/$slug.c"
    sed 's/^int main(int argc, char \*argv\[\])/int main(void)/
         s/argc,$/0,/; s/^ *argv);/NULL);/' "solutions/$slug.c" >"lessons/$slug.c"
    judged 120 'main(void)' 'WRONG (does not compile)' \
        'int main(int argc, char *argv[])'
    sed '/^int main(/,$d' "solutions/$slug.c" >"lessons/$slug.c"
    judged 121 'no main()' 'WRONG (does not compile)' \
        'int main(int argc, char *argv[])'
    sed 's/reactions(int N/react(int N/; s/    reactions(/    react(/' \
        "solutions/$slug.c" >"lessons/$slug.c"
    judged 122 'another function' 'WRONG (does not compile)' \
        'no longer has: reactions. New in it: react. Keep the names'
    sed 's/reactions(int N/reactions(int x, int N/; s/    reactions(/&0, /' \
        "solutions/$slug.c" >"lessons/$slug.c"
    judged 138 'another parameter' 'WRONG (does not compile)' \
        'other parameters, or another type: reactions.'
    rm "lessons/$slug.c"
    judged 123 'no file' 'UNFINISHED (no file)'
    echo '  ' >"lessons/$slug.c"
    judged 124 'nothing but blanks' 'UNFINISHED (empty file)'
    hostile slot 'puts("here 3");' >"lessons/$slug.c"
    judged 125 'a debugging line' WRONG \
        '`here 3`. stdout is for tables, so print anything else to stderr'
    hostile file 'static double abs(double x) { return x < 0 ? -x : x; }' \
        >"lessons/$slug.c"
    judged 134 'a function named as one that stdlib.h declares' \
        'WRONG (does not compile)' "abs is a name of the C library's"
    hostile file 'int matrix_factor(double x) { return x < 0; }' >"lessons/$slug.c"
    judged 135 "a function named as one of matrix.h's" \
        'WRONG (does not compile)' "matrix_factor is a name of the workbook's"

    # without nm
    mkdir -p none && printf '#!/bin/sh\nexit 127\n' >none/nm && chmod +x none/nm
    rm build/checks/$slug.words
    way=$PATH PATH=$PWD/none:$PATH
    "$MAKE" "build/checks/$slug.words" "build/solutions/$slug.judge" BUILD=build \
        CFLAGS=-O0 >/dev/null
    state >../state."$(basename "$1")"
    hostile file 'int shared; static void of(void) { _exit(0); }
        static void (*at)(void) __attribute__((section(".init_array"), used)) = of;' \
        >"lessons/$slug.c"
    judged 139 'without nm: an entry of .init_array' 'WRONG (refused)'
    state >../state."$(basename "$1")"
    hostile file 'int judging, quit(void); int quit(void) { return judging; }' \
        >"lessons/$slug.c"
    judged 142 'without nm: names of the judge' OK
    PATH=$way
    rm -r none build/checks/$slug.words
    "$MAKE" "build/checks/$slug.words" "build/solutions/$slug.judge" BUILD=build \
        CFLAGS=-O0 >/dev/null
    state >../state."$(basename "$1")"

    rm "lessons/$slug.c" && mkfifo "lessons/$slug.c"
    judged 131 'a pipe in the place of the file' 'UNFINISHED (no file)' \
        'is not a plain file'
    rm "lessons/$slug.c"
    state >../state."$(basename "$1")"

    cp "solutions/$slug.c" "lessons/$slug.c"
    said=$("$MAKE" "check-$nn" BUILD=asan NATIVE= CFLAGS='-O0 -fsanitize=address' 2>&1)
    echo "$said" | grep -q -e "^VERDICT $nn: OK" -e 'cannot find.*asan'
    result $? 'a program with the address sanitizer is OK' "$said"
    rm -rf asan

    cp "solutions/$slug.c" "lessons/$slug.c"
    COMPILER=no-such-compiler none 126 'a missing compiler' 'make deps'
    # of the student's file alone
    printf '#!/bin/sh\ncase $* in *cpp-output*) %s ;; esac\nexec %s "$@"\n' \
        "\$NEVER" "${CC:-cc}" >never && chmod +x never
    state >../state."$(basename "$1")"
    NEVER='sleep 1000' SECONDS_COMPILING=3 COMPILER=$PWD/never none 136 \
        'a compiler that is not done' 'compiler was not done after 3 s. Is the machine busy?'
    NEVER='eval kill -9 $$' COMPILER=$PWD/never none 137 \
        'a compiler that is killed' 'compiler was ended by a signal.'
    rm never
    mv common/linear/matrix.h common/linear/moved.h
    none 127 'a missing header' 'make deps'
    mv common/linear/moved.h common/linear/matrix.h
    echo 'this is not C' >>"tests/checks/$slug.c"
    none 128 'an error in a check' 'your file is not the reason'
    sed '$d' "tests/checks/$slug.c" >whole && mv whole "tests/checks/$slug.c"
    LDFLAGS=-lno-such-library none 129 'a missing library' 'make deps'
    said=$("$MAKE" "check-$nn" BUILD=build CFLAGS='-O3 -ffast-math' 2>&1)
    [ $? = 2 ] && [ "$(echo "$said" | wc -l)" = 1 ]
    result $? 'make refuses -ffast-math in one line' "$said"

    # two at once, and one that is stopped
    for k in 1 2 3; do
        "$MAKE" "check-$nn" BUILD=build >first 2>&1 &
        "$MAKE" "check-$nn" BUILD=build >second 2>&1
        wait
        grep -h "^VERDICT" first second >last
        [ "$(grep -c "^VERDICT $nn: OK" last)" = 2 ] || break
    done
    [ "$(grep -c "^VERDICT $nn: OK" last)" = 2 ]
    result $? 'two checks at once are both judged' "$(cat first second)"
    rm -f first second last
    said=$("$MAKE" status BUILD=build)
    echo "$said" | grep -q "^  $slug  *passed"
    result $? 'two checks at once leave a pass' ''
    state >../state."$(basename "$1")"
    hostile slot 'if (fork() == 0) setsid(); for (;;) sleep(1000);' \
        >"lessons/$slug.c"
    for wait in 0.2 0.6 1 2; do
        HOSTILE="$PWD:130:" "$MAKE" "check-$nn" BUILD=build >/dev/null 2>&1 &
        check=$!
        sleep $wait
        kill $check
        wait $check 2>/dev/null
        left=$(nothing_left 130)
        result $? "a check that is stopped after $wait s leaves nothing" "$left"
    done
}

# ---- what forks without end, where it can be contained --------------------------
# pen COPY: COPY.make, which is make with at most 400 processes more, or not there
pen() {
    most=$(($(ps -A -o pid= | wc -l) + 400))
    for at in /sys/fs/cgroup/pids /sys/fs/cgroup; do
        group=$at/workbook.$$
        mkdir "$group" 2>/dev/null || continue
        echo 400 2>/dev/null >"$group/pids.max" && enter="echo \$\$ >$group/cgroup.procs" &&
            break
        rmdir "$group"
    done
    if [ ! -d "$group" ]; then
        [ "$(id -u)" != 0 ] || return # no limit holds for root
        enter="ulimit -u $most || ulimit -p $most"
    fi
    printf '#!/bin/sh\n{ %s; } 2>/dev/null || exit 9\nexec "%s" "$@"\n' \
        "$enter" "$MAKE" >"$1.make" && chmod +x "$1.make"
}
bombs() {
    prepare "$1"
    pen "$1"
    if ! "$1.make" -v >/dev/null 2>&1; then
        echo "skip cli: forks without end: they cannot be contained here" >&2
    else
        MAKE=$1.make
        hostile slot 'for (;;) if (fork() == 0) setsid();' >"lessons/$slug.c"
        judged 140 'a tree of sessions without end' CRASHED 'more than 128 processes'
        hostile slot 'for (;;) fork();' >"lessons/$slug.c"
        judged 141 'forks without end' CRASHED
    fi
    rm -f "$1.make"
    [ ! -d "$group" ] || {
        echo 0 >"$group/pids.max"
        xargs kill -9 <"$group/cgroup.procs"
        sleep 0.5
        rmdir "$group"
    } 2>/dev/null
}

here=$PWD
mkdir -p "$BUILD/test"
part() { # part NAME COMMAND...: in a copy of its own
    part=$1
    shift
    ("$1" "$here/$BUILD/test/copy.hostile.$part" "${2:-}") \
        >"$BUILD/test/hostile.$part" 2>&1
    cat "$BUILD/test/hostile.$part"
    chmod -R u+rwx "$BUILD/test/copy.hostile.$part"
    rm -rf "$BUILD/test/copy.hostile.$part" "$BUILD/test/hostile.$part" \
        "$BUILD/test/state.copy.hostile.$part"
}
{ part odd table 1; part others others; } >"$BUILD/test/hostile.lines" &
part even table 0
part tools tools
part bombs bombs
wait
cat "$BUILD/test/hostile.lines"
rm -f "$BUILD/test/hostile.lines"
