/* sight.c - the processes below this one; see confine.h. */
#include "confine.h"

#include <dirent.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#if defined(__linux__)
struct process {
    int id, parent, threads;
    char state;
    unsigned long ticks;
};

/* All processes of the system, or the first ones of very many; their number,
 * or -1 where they cannot be seen. */
static int all_processes(int most, struct process process[])
{
    int n = 0;
    DIR *all = opendir("/proc");
    if (!all) return -1;
    for (const struct dirent *d; n < most && (d = readdir(all));) {
        char path[300], line[512];
        unsigned long t[4];
        struct process *p = &process[n];
        if (d->d_name[0] < '0' || d->d_name[0] > '9') continue;
        snprintf(path, sizeof path, "/proc/%s/stat", d->d_name);
        FILE *file = fopen(path, "r");
        if (!file) continue;
        const char *read = fgets(line, sizeof line, file);
        fclose(file);
        const char *name_end = read ? strrchr(line, ')') : NULL;
        if (!name_end ||
            sscanf(name_end + 1, " %c %d %*d %*d %*d %*d %*u %*u %*u %*u %*u "
                                 "%lu %lu %lu %lu %*d %*d %d", &p->state,
                   &p->parent, &t[0], &t[1], &t[2], &t[3], &p->threads) != 7)
            continue;
        p->id = atoi(d->d_name);
        p->ticks = t[0] + t[1] + t[2] + t[3];
        n++;
    }
    closedir(all);
    return n > 0 ? n : -1; /* not even this one */
}
#endif

int child_look_around(struct sight *sight)
{
    const struct sight nothing = {0, 0, 0.0};
    *sight = nothing;
#if defined(__linux__)
    enum { MOST = 1 << 15, MOST_ID = 1 << 22 };
    static struct process process[MOST];
    static char ours[MOST_ID];
    const int me = (int)getpid(), n = all_processes(MOST, process);
    unsigned long ticks = 0;
    if (n < 0) return 0;
    ours[me] = 1;
    for (int more = 1; more;) { /* most parents have the smaller number */
        more = 0;
        for (int k = 0; k < n; k++)
            if (!ours[process[k].id] && ours[process[k].parent])
                more = ours[process[k].id] = 1;
    }
    for (int k = 0; k < n; k++) {
        const struct process *p = &process[k];
        if (p->id == me || !ours[p->id]) continue;
        ours[p->id] = 0;
        ticks += p->ticks;
        if (p->state == 'Z') continue; /* ended */
        sight->threads += p->threads;
        sight->computing += p->state == 'R' || p->state == 'D';
    }
    ours[me] = 0;
    sight->seconds = (double)ticks / (double)sysconf(_SC_CLK_TCK);
    return 1;
#else
    return 0;
#endif
}
