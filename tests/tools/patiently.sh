# patiently.sh - for scripts that may be told to end while a command runs: they
# read this file with `.`, and end what runs in their trap.

running=
patiently() { # run a command that end_running ends; its stdin is empty
    "$@" </dev/null &
    running=$!
    wait "$running"
    ended=$?
    running=
    return $ended
}
# within SECONDS: the words before a command that is to end by then, where there
# are such words; its status is 124 then
within() { ! command -v timeout >/dev/null 2>&1 || echo "timeout $1"; }
end_running() {
    [ -z "$running" ] || { kill "$running" && wait "$running"; } 2>/dev/null
}
