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
end_running() {
    [ -z "$running" ] || { kill "$running" && wait "$running"; } 2>/dev/null
}
