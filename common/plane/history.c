/* history.c - see history.h. */
#include "plane/history.h"

#include <math.h>
#include <stdio.h>

void history_table(const char *name, const struct history *history)
{
    const int last = history->iterations;
    const double left = history->residual[last];
    table_begin(name, "k residual increment status");
    for (int k = 0; k < last; k++)
        table_row(k, history->residual[k], history->increment[k], MISSING);
    table_row(last,
              cell_if(history->status != OK && history->status != INVERTED &&
                          isfinite(left), left),
              MISSING, status_name(history->status));
    table_end();
}

void history_nodes(const struct scene *scene, const char *name,
                   const double w[])
{
    const double *X = scene->mesh->X, *u = scene->u;
    char columns[80];
    snprintf(columns, sizeof columns, "X Y u_x u_y %s_x %s_y held", name, name);
    table_begin("nodes", columns);
    for (int x = 0, y = 1; x < scene->n_dof; x += 2, y += 2)
        table_row(X[x], X[y], u[x], u[y], w[x], w[y],
                  scene->held[x / 2] ? "held" : "free");
    table_end();
}
