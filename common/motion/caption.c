/* caption.c - see caption.h. */
#include "motion/caption.h"

#include <stdio.h>

void caption_of(const struct live *live, const struct live_report *report,
                double seconds, char text[CAPTION])
{
    static const char *const start[] = {"elastic", "rows", "last state"};
    const struct live_setting *set = &live->set;
    snprintf(text, CAPTION, "%s: %s, %d systems in %.1f ms\n"
             "[l] law: %s   [i] time step: %s   [g] grab: %s\n"
             "[s] start: %s   [p] if it fails: %s\n[e] element: %s   "
             "[+ -] squares: %d   [r] reset\n"
             "[space] stop   [q] close", report->rung,
             status_name(report->status), report->systems, 1e3 * seconds,
             material_law(set->law), method_name(set->method),
             set->grab == SIDE ? "side" : "patch", start[set->start],
             set->fallback ? "downhill" : "nothing",
             set->element == LINEAR_TRIANGLE ? "linear" : "quadratic", set->n);
}
