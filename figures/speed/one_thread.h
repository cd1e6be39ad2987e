/*
 * one_thread.h - on one thread a parallel region is a call.  CHOLMOD has
 * thousands, and where libgomp makes a team of one for each, it takes three
 * times as long.  For programs that run another library on one thread.
 */
#ifndef FIGURES_ONE_THREAD_H
#define FIGURES_ONE_THREAD_H

void GOMP_parallel(void (*work)(void *), void *data, unsigned threads,
                   unsigned flags);
void GOMP_parallel(void (*work)(void *), void *data, unsigned threads,
                   unsigned flags)
{
    (void)threads, (void)flags;
    work(data);
}

#endif
