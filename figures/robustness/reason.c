/* reason.c - see reason.h. */
#include "reason.h"

const char *reason_of(const struct step_control *control, enum status status)
{
    const int blown_up = status == NOT_SPD || status == NONFINITE ||
                         status == STALLED || status == MAX_ITERATIONS;
    return blown_up && !control->line_search ? "fails" : status_name(status);
}
