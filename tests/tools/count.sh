#!/bin/sh
# count.sh - read "ok ..." and "FAIL ..." lines; print the failures and, last,
# the counts.  What follows a FAIL line belongs to it.
LC_ALL=C
export LC_ALL
awk '/^ok / { ok++; bad = 0; next }
     /^skip / { skipped++; bad = 0; print "  " $0; next }
     /^FAIL / { failed++; bad = 1 }
     bad { print "  " $0 }
     END {
         printf "%d passed, %d failed", ok, failed
         printf skipped ? ", %d skipped\n" : "\n", skipped
         exit failed > 0 || ok == 0
     }'
