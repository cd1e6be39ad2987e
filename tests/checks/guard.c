/* guard.c - the guarded arrays of judge.h. */
#include "judge.h"

#include "output.h" /* quit */

#include <limits.h>
#ifdef __GLIBC__
#if __GLIBC_PREREQ(2, 33)
#include <malloc.h>
#define HEAP_IS_COUNTED
#endif
#endif
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

enum { BESIDE = 16, MOST = 4096 };

/* A NaN that an operation makes another NaN: what has been computed with it in
 * its place has changed. */
static const uint64_t GUARD = 0x7ff4000000002385u;

/* What stands beside the arrays that the running check has handed over. */
static struct {
    int n_array;
    struct {
        double *first;
        int n;
    } array[MOST];
} guarded;

static void put_guard(double *at)
{
    memcpy(at, &GUARD, sizeof GUARD);
}

double *guarded_alloc(int n)
{
    double *room = malloc((size_t)(n + 2 * BESIDE) * sizeof *room);
    if (!room || guarded.n_array == MOST) quit("no memory for a guarded array");
    for (int i = 0; i < n + 2 * BESIDE; i++) put_guard(&room[i]);
    guarded.array[guarded.n_array].first = room + BESIDE;
    guarded.array[guarded.n_array++].n = n;
    return room + BESIDE;
}

double *guarded_copy(int n, const double values[])
{
    double *array = guarded_alloc(n);
    memcpy(array, values, (size_t)n * sizeof *array);
    return array;
}

int *guarded_indices(int n, const int values[])
{
    int *room = malloc((size_t)(n + 2 * BESIDE) * sizeof *room);
    if (!room) quit("no memory for a guarded array");
    for (int i = 0; i < n + 2 * BESIDE; i++) room[i] = INT_MIN;
    memcpy(room + BESIDE, values, (size_t)n * sizeof *room);
    return room + BESIDE;
}

void guards_hold(void)
{
    for (int k = 0; k < guarded.n_array; k++) {
        const double *first = guarded.array[k].first;
        const int n = guarded.array[k].n;
        for (int i = -BESIDE; i < n + BESIDE; i++) {
            if (i == 0) i = n;
            if (memcmp(&first[i], &GUARD, sizeof GUARD) != 0)
                wrong("writes beyond an array: there are entries 0 to %d, and "
                      "entry %d has been changed", n - 1, i);
        }
    }
    guarded.n_array = 0;
}

/* Bytes on the heap; 0 where nobody counts them. */
static double heap_bytes(void)
{
#ifdef HEAP_IS_COUNTED
    const struct mallinfo2 heap = mallinfo2();
    return (double)heap.uordblks + (double)heap.hblkhd;
#else
    return 0.0;
#endif
}

void expect_no_leak(void (*call)(void), double bytes, const char *what)
{
    enum { CALLS = 8 };
    call();
    call();
    const double before = heap_bytes();
    for (int k = 0; k < CALLS; k++) call();
    if (heap_bytes() - before >= CALLS * bytes)
        wrong("each call of %s keeps memory: free what it has allocated", what);
}
