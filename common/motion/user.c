/* user.c - see user.h. */
#include "motion/user.h"
#include "base/table.h"

#include <gsl/gsl_math.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

const struct user_motion USER_SCRIPT[USER_MOTIONS] = {
    {"grab", 0.2, {0.0, 0.0}, 0.0, 1},   {"pull", 0.7, {0.9, 0.0}, 0.0, 1},
    {"hold", 1.0, {0.9, 0.0}, 0.0, 1},   {"shake", 1.8, {0.9, 0.0}, 0.4, 1},
    {"slam", 1.9, {-0.9, 0.0}, 0.0, 1},  {"push", 2.4, {-1.1, 0.2}, 0.0, 1},
    {"hold", 2.7, {-1.1, 0.2}, 0.0, 1},  {"let go", 3.4, {0.0, 0.0}, 0.0, 0},
};

struct user *user_alloc(int n, enum law law, double reach)
{
    struct user *user = allocate(1, sizeof *user);
    for (int held = 0; held <= 1; held++) {
        struct scene_setting set = scene_notes(held ? STRETCH : GRAVITY, law,
                                               n);
        set.force = 0.0;
        user->scene[held] = scene_alloc(&set);
    }
    user->reach = reach;
    user->dt = 1.0 / 30.0;
    user->n_dof = user->scene[0]->n_dof;
    user->side = 2 * (n / 2 * (n + 1) + n);
    user->frames = (int)lround(USER_SCRIPT[USER_MOTIONS - 1].until / user->dt);
    user->g = allocate((size_t)user->n_dof, sizeof *user->g);
    user->kept = allocate((size_t)(USER_MOTIONS * user->n_dof),
                          sizeof *user->kept);
    return user;
}

void user_free(struct user *user)
{
    if (!user) return;
    for (int held = 0; held <= 1; held++) scene_free(user->scene[held]);
    free(user->g);
    free(user->kept);
    free(user);
}

/* Return the motion that holds at time t, 0 < t <= the end of the last, and the
 * place of the right side. */
static const struct user_motion *script_at(double t, double reach,
                                           double place[2])
{
    int m = 0;
    while (t > USER_SCRIPT[m].until + 1e-9) m++;
    const struct user_motion *now = &USER_SCRIPT[m];
    const double begin = m ? now[-1].until : 0.0;
    const double s = fmin((t - begin) / (now->until - begin), 1.0);
    for (int i = 0; i < 2; i++) {
        const double start = m ? now[-1].to[i] : 0.0;
        place[i] = start + s * s * (3.0 - 2.0 * s) * (now->to[i] - start);
    }
    place[1] += now->tremble * sin(6.0 * M_PI * (t - begin));
    for (int i = 0; i < 2; i++) place[i] *= reach;
    return now;
}

int user_next(struct user *user)
{
    const struct mesh *mesh = user->scene[0]->mesh;
    double place[2];
    if (user->k == user->frames) return 0;
    user->t = ++user->k * user->dt;
    const struct user_motion *now = script_at(user->t, user->reach, place);
    user->motion = now->word;
    user->body = user->scene[now->held]->body;
    for (int a = mesh->n; a < mesh->n_vertex; a += mesh->n + 1)
        for (int i = 0; i < 2; i++) user->g[2 * a + i] = place[i];
    return 1;
}

void user_keep(struct user *user, const double u[])
{
    if (user->n_kept == USER_MOTIONS ||
        user->t < USER_SCRIPT[user->n_kept].until - 1e-9)
        return;
    memcpy(&user->kept[user->n_kept++ * user->n_dof], u,
           (size_t)user->n_dof * sizeof *u);
}

void user_table(const struct user *user)
{
    const double *X = user->scene[0]->mesh->X;
    table_begin("square", "k motion X Y u_x u_y");
    for (int m = 0; m < user->n_kept; m++) {
        const double *u = &user->kept[m * user->n_dof];
        for (int r = 0; r < user->n_dof; r += 2)
            table_row(m, USER_SCRIPT[m].word, X[r], X[r + 1], u[r], u[r + 1]);
    }
    table_end();
}
