/* history.c - laws of common/plane/history.h and common/motion/film.h. */
#include "motion/film.h"
#include "plane/history.h"

#include "unit.h"

#include <math.h>
#include <stdlib.h>

/* Two systems solved, and three ends. */
static void print_histories(void)
{
    struct history h = {NOT_SPD, 2, {4.0, 2.0, 1.0}, {0.5, 0.25}};
    history_table("stopped", &h);
    h.status = OK;
    history_table("solved", &h);
    h.status = NONFINITE;
    h.residual[2] = INFINITY;
    history_table("lost", &h);
    h = (struct history){.status = INVERTED};
    history_table("never", &h);
    exit(table_finish());
}

#define ROWS "k\tresidual\tincrement\tstatus\n0\t4\t0.5\t-\n1\t2\t0.25\t-\n"
static void a_history_ends_with_its_reason(void)
{
    const struct outcome end = outcome_of(print_histories);
    ck_assert_int_eq(end.status, 0);
    ck_assert_str_eq(end.out,
                     "# stopped\n" ROWS "2\t1\t-\tNOT_SPD\n\n\n"
                     "# solved\n" ROWS "2\t-\t-\tOK\n\n\n"
                     "# lost\n" ROWS "2\t-\t-\tNONFINITE\n\n\n"
                     "# never\nk\tresidual\tincrement\tstatus\n"
                     "0\t-\t-\tINVERTED\n\n\n");
}

/* One square, its left side held. */
static void print_vertices(void)
{
    const struct scene_setting set = scene_notes(GRAVITY, CUBIC, 1);
    struct scene *s = scene_alloc(&set);
    for (int r = 0; r < s->n_dof; r++) {
        s->u[r] = 0.25 * r;
        s->v[r] = 10.0 + r;
    }
    history_nodes(s, "v", s->v);
    scene_free(s);
    exit(table_finish());
}

static void vertices_are_printed_with_what_belongs_to_them(void)
{
    const struct outcome end = outcome_of(print_vertices);
    ck_assert_int_eq(end.status, 0);
    ck_assert_str_eq(end.out,
                     "# nodes\nX\tY\tu_x\tu_y\tv_x\tv_y\theld\n"
                     "-1\t-1\t0\t0.25\t10\t11\theld\n"
                     "1\t-1\t0.5\t0.75\t12\t13\tfree\n"
                     "-1\t1\t1\t1.25\t14\t15\theld\n"
                     "1\t1\t1.5\t1.75\t16\t17\tfree\n\n\n");
}

/* One square of which a corner has moved, four frames, every third. */
static void print_film(void)
{
    const struct live_setting set = {1, CUBIC, BACKWARD_EULER, PATCH, ELASTIC,
                                     1, LINEAR_TRIANGLE};
    struct live *live = live_alloc(&set);
    const struct pointer pointer = {0.5, 0.25, 1, '.'};
    live->now.u[7] = 1.0;
    table_begin("motion", FILM);
    for (int k = 0; k < 4; k++) film_frame(live, 3, k, &pointer);
    table_end();
    live_free(live);
    exit(table_finish());
}

static void a_film_shows_the_triangles_of_its_frames(void)
{
    const struct outcome end = outcome_of(print_film);
    ck_assert_int_eq(end.status, 0);
    ck_assert_str_eq(end.out, "# motion\nk\tJ\tx0\ty0\tx1\ty1\tx2\ty2\t"
                              "pointer_x\tpointer_y\tdown\n"
                              "0\t1.5\t-1\t-1\t1\t-1\t1\t2\t0.5\t0.25\t1\n"
                              "0\t1\t-1\t-1\t1\t2\t-1\t1\t0.5\t0.25\t1\n"
                              "3\t1.5\t-1\t-1\t1\t-1\t1\t2\t0.5\t0.25\t1\n"
                              "3\t1\t-1\t-1\t1\t2\t-1\t1\t0.5\t0.25\t1\n"
                              "\n\n");
}

UNIT_MAIN("history",
    LAW(a_history_ends_with_its_reason),
    LAW(vertices_are_printed_with_what_belongs_to_them),
    LAW(a_film_shows_the_triangles_of_its_frames))
