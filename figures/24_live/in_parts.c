/* in_parts.c - see in_parts.h. */
#include "in_parts.h"

#include <string.h>

struct live_report live_frame_in_parts(struct live *live, const double to[2])
{
    const struct frame frame = integrate_frame(live->body, live->dt, live->g,
                                               &live->now);
    const int lost = frame.status != OK;
    if (!lost) memcpy(live->hand, to, sizeof live->hand);
    return (struct live_report){status_name(frame.status), frame.status,
                                lost ? "lost" : "parts", frame.iterations,
                                lost ? 0.0 : 1.0};
}
