/*
 * saddle.c - is an answer of Newton's method the one that is looked for?
 *
 * The last step that the notes' method survives while the ends are pushed
 * together (compress, cubic law, n = 8), and the same step projected on demand,
 * from the same state.  Table: Phi [eq:incremental-potential] of both answers,
 * and whether K there, the curvature of Phi, is positive definite.
 */
#include "plane/scene.h"
#include "base/study.h"
#include "base/table.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { LAST = 22 };

/* Phi of the step from w = u0 + dt v0 to the state of the scene. */
static double potential(const struct scene *s, const double w[])
{
    double *move = allocate((size_t)s->n_dof, sizeof *move);
    double *momentum = allocate((size_t)s->n_dof, sizeof *momentum);
    double phi;
    const enum status status = body_energy(s->body, s->u, &phi);
    if (status != OK) die("no energy: %s", status_name(status));
    phi *= s->set.dt * s->set.dt;
    for (int r = 0; r < s->n_dof; r++) move[r] = s->u[r] - w[r];
    body_mass(s->body, move, momentum);
    for (int r = 0; r < s->n_dof; r++) phi += 0.5 * move[r] * momentum[r];
    free(move);
    free(momentum);
    return phi;
}

struct answer {
    struct step_report report;
    double phi, min_J;
    int definite;
};

/* Steps 1 to LAST, all but the last by the notes' method. */
static struct answer squeeze(const char *method)
{
    const struct scene_setting set = scene_notes(COMPRESS, CUBIC, 8);
    const struct step_control notes = step_method("notes");
    const struct step_control last = step_method(method);
    struct scene *s = scene_alloc(&set);
    double *w = allocate((size_t)s->n_dof, sizeof *w);
    double *q = allocate((size_t)s->n_dof, sizeof *q);
    struct answer a;
    for (int k = 1; k < LAST; k++)
        if (scene_step(s, &notes).status != OK) die("step %d failed", k);
    for (int r = 0; r < s->n_dof; r++) w[r] = s->u[r] + set.dt * s->v[r];
    a.report = scene_step(s, &last);
    a.phi = potential(s, w);
    a.min_J = body_min_J(s->body, s->u);
    const struct incremental Phi = {set.dt, w, NULL};
    body_assemble(s->body, Phi, s->u, EXACT, q);
    a.definite = matrix_factor(s->body->K) == OK;
    free(w);
    free(q);
    scene_free(s);
    return a;
}

int main(void)
{
    const char *const method[] = {"notes", "demand+search"};
    struct answer a[2];
    table_begin_note("two_answers",
                     "method reason iterations indefinite projections phi "
                     "min_J definite",
                     "step %d from the same state; phi in units of dt^2 (J/m)",
                     LAST);
    for (int m = 0; m < 2; m++) {
        a[m] = squeeze(method[m]);
        table_row(m ? "on demand, line search" : method[m],
                  status_name(a[m].report.status),
                  a[m].report.iterations, a[m].report.indefinite,
                  a[m].report.projections, a[m].phi * 30.0 * 30.0, a[m].min_J,
                  a[m].definite ? "yes" : "no");
    }
    table_end();

    claim(a[0].report.status == OK && a[1].report.status == OK,
          "both methods report OK");
    claim(!a[0].definite && a[0].min_J < 0.0 && a[0].report.indefinite > 0,
          "the notes' answer is a saddle, and its report counts indefinite "
          "systems (%d)", a[0].report.indefinite);
    claim(a[1].definite && a[1].min_J > 0.0 && a[1].phi < 0.95 * a[0].phi,
          "the other is a minimum with a smaller Phi (by %.2g of it)",
          1.0 - a[1].phi / a[0].phi);
    return table_finish();
}
