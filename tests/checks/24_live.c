/*
 * 24_live.c - what a loop that loses no frame satisfies.
 *
 * Arguments: slot, argument: varied by checks
 *   24a from, pointer: the_hand_is_bounded
 *   24b mesh, u: knots_are_counted
 *   24c body (laws, what is held), u0, w, g: lift_solves_the_linear_problem,
 *       lift_refuses_what_cannot_be (a leap of g alone, in x or y); dt,
 *       tangent: lift_without_a_jump_is_newton
 *   24d live (u0, v0, g, law, dt of 1/30 and 1/40 s), report:
 *       downhill_does_what_it_says; n: no_frame_is_lost
 */
#include "program.h"

#include "judge.h"

#include <stdio.h>
#include <string.h>

/* A few dozen operations on numbers of size 1. */
static const double ROUND_OFF = 1e-12;

static const struct live_setting SQUARE = {8,     LOG,     BACKWARD_EULER,
                                           PATCH, ELASTIC, 1,
                                           LINEAR_TRIANGLE};

/* A frame begins: what is held, live->g and the hand's `to`. */
static void begin_frame(struct live *live, const struct pointer *pointer,
                        double to[2])
{
    live_input(live, pointer);
    live_hand(live->hand, pointer, to);
    live_carry(live, to);
}

static struct live *square(enum law law)
{
    struct live_setting set = SQUARE;
    set.law = law;
    return live_alloc(&set);
}

/* A live square after the frames 0..k-1 of hard, by common/motion/live.h. */
static struct live *after(int k, enum law law)
{
    struct live *live = square(law);
    struct pointers hard = pointers_hard();
    double to[2];
    for (int j = 0; j <= k; j++) {
        begin_frame(live, &hard.frame[j], to);
        if (j < k) live_frame(live, to);
    }
    pointers_free(&hard);
    return live; /* live->g is that of frame k */
}

static void the_hand_is_bounded(void)
{
    const double from[][2] = {{0.3, -0.2}, {9.9, -9.9}, {-2.0, 1.0}};
    const double aim[][2] = {{0.31, -0.17}, {0.3, 0.05},    {3.0, -7.0},
                             {1e9, -0.2},   {-1e300, 1e30}, {10.5, -9.8}};
    for (int i = 0; i < COUNT(from); i++)
        for (int j = 0; j < COUNT(aim); j++) {
            const struct pointer p = {aim[j][0], aim[j][1], 1, '.'};
            double *to = guarded_alloc(2), end[2];
            for (int k = 0; k < 2; k++)
                end[k] = fmax(-LIVE_FAR, fmin(LIVE_FAR, aim[j][k]));
            const double d[2] = {end[0] - from[i][0], end[1] - from[i][1]};
            const double way = hypot(d[0], d[1]);
            const double due = fmin(way, LIVE_REACH);
            hand_next(from[i], &p, to);
            for (int k = 0; k < 2; k++)
                expect_close(to[k], from[i][k] + due * d[k] / way, ROUND_OFF,
                             10.0, "hand at (%g, %g), pointer at (%g, %g): "
                             "its %s after a frame", from[i][0], from[i][1],
                             aim[j][0], aim[j][1], k ? "y" : "x");
        }
    const struct pointer here = {0.3, -0.2, 1, '.'};
    double to[2] = {NAN, NAN};
    hand_next(from[0], &here, to);
    for (int k = 0; k < 2; k++)
        expect_close(to[k], from[0][k], ROUND_OFF, 1.0,
                     "a hand that is where the pointer is: its %s",
                     k ? "y" : "x");
}

/* u of vertex a, so that it comes to stand at (x, y). */
static void place(const struct mesh *mesh, double u[], int a, double x,
                  double y)
{
    u[2 * a] = x - mesh->X[2 * a];
    u[2 * a + 1] = y - mesh->X[2 * a + 1];
}

static void knots_are_counted(void)
{
    struct mesh *mesh = mesh_square(4);
    const double *X = mesh->X;
    double *u = guarded_alloc(2 * mesh->n_vertex);
    for (double turn = 0.0; turn < 7.0; turn += 1.247) {
        for (int a = 0; a < mesh->n_vertex; a++)
            place(mesh, u, a,
                  1.7 * (cos(turn) * X[2 * a] - sin(turn) * X[2 * a + 1]),
                  0.3 * (sin(turn) * X[2 * a] + cos(turn) * X[2 * a + 1]));
        const int knots = count_knots(mesh, u);
        expect(knots == 0, "the square, turned by %g and stretched to 1.7 x "
               "0.3: got %d knots, want 0", turn, knots);
    }
    for (int a = 0; a < mesh->n_vertex; a++)
        place(mesh, u, a, X[2 * a], -X[2 * a + 1]);
    int knots = count_knots(mesh, u);
    expect(knots == 9, "the square seen in a mirror: got %d knots, want 9, for "
           "the angles round each inner vertex add up to -2 pi", knots);

    /* r and the angle z of a vertex become r and f(z), which goes round twice
     * while z goes round once: 4 pi round the middle, 2 pi everywhere else */
    const double z[] = {0.0, 0.25, 0.5, 1.0, 1.25, 1.5, 2.0};
    for (int a = 0; a < mesh->n_vertex; a++) {
        const double r = fmax(fabs(X[2 * a]), fabs(X[2 * a + 1]));
        double angle = atan2(X[2 * a + 1], X[2 * a]) / M_PI;
        if (angle < 0.0) angle += 2.0;
        int k = 0;
        while (angle >= z[k + 1]) k++;
        const double f = 2.0 * M_PI / 3.0 *
                         (k + (angle - z[k]) / (z[k + 1] - z[k]));
        place(mesh, u, a, r * cos(f), r * sin(f));
    }
    knots = count_knots(mesh, u);
    expect(knots == 1, "a square that is wound twice round its middle vertex: "
           "got %d knots, want 1, where the angles add up to 4 pi", knots);
    mesh_free(mesh);
    for (int n = 2; n <= 11; n += 3) {
        mesh = mesh_square(n);
        u = guarded_alloc(2 * mesh->n_vertex);
        for (int r = 0; r < 2 * mesh->n_vertex; r++)
            u[r] = 2.0 / n * sin(2.385 * r * r + n);
        knots = count_knots(mesh, u);
        const int want = live_knots(mesh, u, NULL);
        expect(knots == want, "n = %d, vertices thrown about: got %d knots, "
               "want %d", n, knots, want);
        mesh_free(mesh);
    }
}

/* Phi of the frame that takes `live` from its state, without the constant. */
static double phi(const struct live *live, const double u[])
{
    const int n = live->n_dof;
    double *move = allocate(2 * (size_t)n, sizeof *move), *p = move + n;
    double sum = 0.0, energy = NAN;
    for (int r = 0; r < n; r++)
        move[r] = u[r] - live->now.u[r] - live->dt * live->now.v[r];
    body_mass(live->body, move, p);
    for (int r = 0; r < n; r++) sum += 0.5 * move[r] * p[r];
    if (body_energy(live->body, u, &energy) != OK) energy = INFINITY;
    free(move);
    return sum + live->dt * live->dt * energy;
}

/* max|q| of the free unknowns at u. */
static double residual_at(const struct live *live, const double w[],
                          const double u[])
{
    double *q = allocate((size_t)live->n_dof, sizeof *q);
    const struct incremental Phi = {live->dt, w, NULL};
    expect(body_assemble(live->body, Phi, u, NO_TANGENT, q) == OK,
           "the lifted state is one that the material does not have");
    const double largest = body_max_free(live->body, q);
    free(q);
    return largest;
}

/* From a state with q = 0 the lift by the exact K leaves a q of second order in
 * the jump: a quarter for half of it. */
static void lift_solves_the_linear_problem(void)
{
    struct live *live = after(8, CUBIC); /* the hand holds a patch */
    const int n = live->n_dof;
    double *u0 = guarded_copy(n, live->now.u), *g = guarded_alloc(n);
    double *u = guarded_alloc(n), *w = guarded_alloc(n), q[4];
    double *due = guarded_alloc(n);
    const struct step_control newton = step_method("demand+search");
    const struct incremental Phi = {live->dt, w, NULL};
    memset(w, 0, (size_t)n * sizeof *w);
    expect(step_solve(live->body, &newton, Phi, u0).status == OK,
           "the state to start from was not found");
    for (int k = 0; k < 4; k++) {
        const double jump = 0.04 / (1 << k);
        for (int r = 0; r < n; r++) {
            const int moved = live->body->equation[r] < 0 &&
                              live->mesh->X[r / 2 * 2] > -1.0;
            g[r] = live->body->equation[r] >= 0 ? NAN : u0[r];
            if (moved) g[r] += r % 2 ? -0.3 * jump : jump;
        }
        const enum status status =
            elastic_lift(live->body, Phi, u0, g, EXACT, u);
        expect(status == OK, "elastic_lift() of a jump of %g m: %s", jump,
               status_name(status));
        for (int r = 0; r < n; r++)
            if (live->body->equation[r] < 0)
                expect_close(u[r], g[r], ROUND_OFF, 1.0,
                             "the lifted u[%d], which is prescribed", r);
        q[k] = residual_at(live, w, u) / (jump * jump);
        /* round-off over a micrometre, where one-sided differences leave 1e-7;
         * live_lift() reads g of what is free, too */
        for (int r = 0; r < n; r++)
            if (live->body->equation[r] >= 0) g[r] = u0[r];
        live_lift(live->body, Phi, u0, g, EXACT, due);
        for (int r = 0; r < n; r++)
            expect_close(u[r], due[r], 1e-9, 1.0, "u[%d], lifted by a jump of "
                         "%g m, with the central difference", r, jump);
    }
    expect_close(q[2] / q[3], 1.0, 0.05, 1.0,
                 "max|q| / jump^2 after the lift of 0.01 m over that of 0.005 "
                 "m: the lift is exact to first order");
    live_free(live);
}

/* Where nothing jumps, the lift is a step of Newton's method; K is that which
 * was asked for. */
static void lift_without_a_jump_is_newton(void)
{
    int indefinite = 0;
    for (int k = 3; k <= 48; k += 9) {
        struct live *live = after(k, CUBIC);
        struct body *body = live->body;
        const int n = live->n_dof;
        double *u = guarded_alloc(n), *w = guarded_alloc(n);
        double *q = allocate(2 * (size_t)n, sizeof *q), *du = q + n;
        for (int r = 0; r < n && k > 20; r++) /* until K is indefinite */
            if (body->equation[r] >= 0)
                live->now.u[r] += 0.1 * sin(2.385 * r * r + k);
        for (int kind = EXACT; kind <= PROJECTED; kind++) {
            const double dt = live->dt * (k % 2 ? 1.0 : 0.5);
            const struct incremental Phi = {dt, w, NULL};
            for (int r = 0; r < n; r++)
                w[r] = live->now.u[r] + dt * live->now.v[r];
            body_assemble(body, Phi, live->now.u, (enum tangent)kind, q);
            enum status due = body_increment(body, body->K, q, du);
            for (int r = 0; r < n && due == OK; r++)
                if (fabs(du[r]) > LIVE_LEAP) due = NONFINITE;
            indefinite += due == NOT_SPD;
            const enum status status =
                elastic_lift(body, Phi, live->now.u, live->now.u,
                             (enum tangent)kind, u);
            expect(status == due, "elastic_lift() without a jump, %s K, frame "
                   "%d: got %s, want %s, as a step of Newton's method",
                   kind == EXACT ? "exact" : "projected", k,
                   status_name(status), status_name(due));
            for (int r = 0; r < n && due == OK; r++)
                expect_close(u[r], live->now.u[r] + du[r], 1e-9, 1.0,
                             "elastic_lift() without a jump, u[%d], against a "
                             "step of Newton's method", r);
        }
        free(q);
        live_free(live);
    }
    expect(indefinite > 0, "no K was indefinite: the check sees nothing");
}

/* What cannot be: a leap, and a state that LOG does not have. */
static void lift_refuses_what_cannot_be(void)
{
    struct live *live = after(8, LOG);
    const int n = live->n_dof;
    double *u = guarded_alloc(n), *w = guarded_copy(n, live->now.u);
    for (int r = 0; r < n; r++) w[r] += 5.0;
    struct incremental Phi = {live->dt, w, NULL};
    enum status status =
        elastic_lift(live->body, Phi, live->now.u, live->g, EXACT, u);
    expect(status == NONFINITE, "the body flies with 150 m/s, so that the lift "
           "moves it by more than LIVE_LEAP: got %s, want NONFINITE",
           status_name(status));
    /* the hand goes farther, and draws the free ones along less */
    double *rest = guarded_alloc(n), *g = guarded_alloc(n);
    for (int r = 0; r < n; r++) rest[r] = 0.0;
    Phi.w = rest;
    for (int way = 0; way < 2; way++) {
        double most = 0.0;
        for (int r = 0; r < n; r++)
            g[r] = live->body->equation[r] < 0 && r % 2 == way &&
                           live->mesh->X[r / 2 * 2] > -1.0 ? 1.0 : 0.0;
        g[0] = 0.0613; /* vertex 0 is held on the side */
        status = elastic_lift(live->body, Phi, rest, g, EXACT, u);
        expect(status == OK, "the hand moves by LIVE_LEAP in %c from a body at "
               "rest: got %s, want OK", way ? 'y' : 'x', status_name(status));
        for (int r = 0; r < n; r++)
            if (live->body->equation[r] >= 0)
                most = fmax(most, fabs(u[r]));
            else
                expect_close(u[r], g[r], ROUND_OFF, 1.0, "u[%d], which is "
                             "held, against g", r);
        expect(most < 0.995, "a free vertex moves by %g: the check sees "
               "nothing", most);
        for (int r = 0; r < n; r++) g[r] *= 1.004;
        status = elastic_lift(live->body, Phi, rest, g, EXACT, u);
        expect(status == NONFINITE, "the hand moves by 1.004 LIVE_LEAP in %c, "
               "the free ones by less: got %s, want NONFINITE",
               way ? 'y' : 'x', status_name(status));
    }
    for (int a = 0; a < n / 2; a++) u[2 * a] = -1.5 * live->mesh->X[2 * a];
    for (int a = 0; a < n / 2; a++) u[2 * a + 1] = 0.0;
    double *inverted = guarded_copy(n, u);
    Phi.w = live->now.u;
    status = elastic_lift(live->body, Phi, inverted, live->g, EXACT, u);
    expect(status == INVERTED, "elastic_lift() from a state that LOG does not "
           "have: got %s, want INVERTED", status_name(status));
    live_free(live);
}

/* A triangle with a held vertex and a free one is nearly flat, so that one of
 * the states of the difference is inverted, and u0 is not. */
static void lift_hands_on_each_status(void)
{
    for (int side = 0; side < 2; side++) {
        struct live *live = after(8, LOG);
        const struct mesh *mesh = live->mesh;
        const int n = live->n_dof, *equation = live->body->equation;
        double *u0 = guarded_alloc(n), *g = guarded_alloc(n);
        int corner = 0; /* of a triangle: held by the hand, the next free */
        while (equation[2 * mesh->triangle[corner]] >= 0 ||
               mesh->X[2 * mesh->triangle[corner]] <= -1.0 ||
               equation[2 * mesh->triangle[corner / 3 * 3 +
                                           (corner + 1) % 3]] < 0)
            corner++;
        const int *t = &mesh->triangle[corner / 3 * 3], held = t[corner % 3];
        const double *A = &mesh->X[2 * t[(corner + 1) % 3]];
        const double *B = &mesh->X[2 * t[(corner + 2) % 3]];
        const double *C = &mesh->X[2 * held];
        /* the held vertex comes to stand 1e-8 m from the side opposite */
        const double l = hypot(B[0] - A[0], B[1] - A[1]);
        const double up[2] = {-(B[1] - A[1]) / l, (B[0] - A[0]) / l};
        const double high = (C[0] - A[0]) * up[0] + (C[1] - A[1]) * up[1];
        for (int r = 0; r < n; r++) u0[r] = 0.0;
        for (int i = 0; i < 2; i++)
            u0[2 * held + i] = (1e-8 - high) * up[i];
        memcpy(g, u0, (size_t)n * sizeof *g);
        for (int i = 0; i < 2; i++)
            g[2 * held + i] += (side ? 0.01 : -0.01) * up[i];
        const struct incremental Phi = {live->dt, u0, NULL};
        const enum status status =
            elastic_lift(live->body, Phi, u0, g, EXACT, guarded_alloc(n));
        expect(status == INVERTED, "elastic_lift() from a state in which a "
               "micrometre %s inverts a triangle: got %s, want INVERTED",
               side ? "backward" : "forward", status_name(status));
        live_free(live);
    }
}

/* The state and the hand of another square. */
static void follow(struct live *live, const struct live *other)
{
    const size_t bytes = (size_t)live->n_dof * sizeof(double);
    memcpy(live->now.u, other->now.u, bytes);
    memcpy(live->now.v, other->now.v, bytes);
    memcpy(live->now.u_before, other->now.u_before, bytes);
    memcpy(live->now.v_before, other->now.v_before, bytes);
    live->now.steps = other->now.steps;
    memcpy(live->hand, other->hand, sizeof live->hand);
}

/* downhill() on one of two equal squares, live_downhill() on the other, after
 * 0 to 7 systems of the rung before.  Two right programs differ by less than
 * Newton's method may; a frame that has not converged may have grown what their
 * lifts differ by. */
static struct live_report compare_downhill(struct live *live,
                                           struct live *copy, int k)
{
    const int n = live->n_dof;
    double *u = guarded_alloc(n), *v = guarded_alloc(n);
    double *due_u = allocate(2 * (size_t)n, sizeof *due_u);
    double *due_v = due_u + n;
    const int used = k % FRAME_SYSTEMS;
    struct live_report report = {.rung = "downhill", .systems = used};
    for (int r = 0; r < n && k % 2; r++) /* most are 0 by then */
        if (live->body->equation[r] >= 0)
            copy->now.v[r] = live->now.v[r] += 3.0 * sin(2.385 * r);
    struct live_report due = report;
    report.status = downhill(live, u, v, &report);
    due.status = live_downhill(copy, due_u, due_v, &due);
    const char *name = material_law(live->set.law);
    expect(report.part == due.part && report.systems == due.systems &&
               report.status == due.status,
           "frame %d of hard, %s law, %d systems used before downhill(): got "
           "part %g, %d systems more, %s; want part %g, %d systems more, %s", k,
           name, used, report.part, report.systems - used,
           status_name(report.status), due.part, due.systems - used,
           status_name(due.status));
    const double allowed = due.status == OK ? LIVE_TOLERANCE : 1e-3; /* m */
    for (int r = 0; r < n; r++) {
        expect_close(u[r], due_u[r], allowed, 1.0, "frame %d of hard, "
                     "%s: u[%d] of downhill()", k, name, r);
        expect_close(v[r], due_v[r], allowed, 1.0 / live->dt, "frame %d "
                     "of hard, %s: v[%d] of downhill()", k, name, r);
    }
    if (report.part == 0.0)
        expect(phi(live, u) <= phi(live, live->now.u) * (1.0 + 1e-9),
               "frame %d of hard, %s: Phi has risen from %g to %g", k, name,
               phi(live, live->now.u), phi(live, u));
    free(due_u);
    return report;
}

/* The frames of hard, each from the state of common/motion/live.h. */
static void downhill_does_what_it_says(void)
{
    int unfinished = 0, held_back = 0, stopped = 0;
    struct pointers hard = pointers_hard();
    for (int law = LOG; law <= CUBIC; law++) {
        struct live *all[3];
        for (int i = 0; i < 3; i++) {
            all[i] = square((enum law)law);
            all[i]->dt *= law == LOG ? 1.0 : 0.75;
        }
        for (int k = 0; k < 190; k++) {
            double to[2];
            for (int i = 0; i < 3; i++) {
                if (i > 0) follow(all[i], all[0]);
                begin_frame(all[i], &hard.frame[k], to);
            }
            if (k % 3 == 1) {
                const struct live_report report =
                    compare_downhill(all[1], all[2], k);
                unfinished += report.status == MAX_ITERATIONS;
                held_back += report.part > 0.0 && report.part < 1.0;
                stopped += report.part == 0.0;
            }
            live_frame(all[0], to);
        }
        for (int i = 0; i < 3; i++) live_free(all[i]);
    }
    pointers_free(&hard);
    expect(unfinished > 0 && held_back > 0 && stopped > 0,
           "hard: %d frames unfinished, %d held back, %d stopped; each must "
           "occur", unfinished, held_back, stopped);
}

/* Random input, both laws, with the program's own functions. */
static void no_frame_is_lost(void)
{
    for (int law = LOG; law <= CUBIC; law++) {
        char options[80];
        snprintf(options, sizeof options, "--input mad --n 6 --law %s --seed 3",
                 material_law((enum law)law));
        const struct output *out = run(options);
        expect(cell(out, "summary", "lost", 0) == 0.0, "%s: %g frames lost",
               options, cell(out, "summary", "lost", 0));
        expect(cell(out, "summary", "most_systems", 0) <= FRAME_SYSTEMS,
               "%s: %g systems in a frame, whose budget is %d", options,
               cell(out, "summary", "most_systems", 0), FRAME_SYSTEMS);
    }
}

/* What is not input is named with its line, and leaves no output. */
static void bad_input_is_refused(void)
{
    static const char *const bad[] = {"0 0 1", "0 nan 1 .", "0 0 2 .",
                                      "0 0 1 x", "0 0 1 . 4", "a 0 1 ."};
    for (int k = 0; k < COUNT(bad); k++) {
        FILE *file = fopen("hand.txt", "w");
        expect(file && fprintf(file, "0 0 1 .\n%s\n", bad[k]) > 0 &&
                   fclose(file) == 0, "hand.txt cannot be written");
        expect_refusal("--input hand.txt", 2, "hand.txt: line 2 must be");
    }
    expect_refusal("--input there/is/none", 2, "there/is/none");
    expect_refusal("--n 1", 2, "--n 1");
}

/* What the header asks to PREDICT. */
static void what_was_predicted(void)
{
    struct output *output = run("");
    measured("1a", cell(output, "summary", "lost", 0));
    measured("1b", cell(output, "summary", "downhill", 0));
}

static const struct claim claims[] = {
    {"the_hand_is_bounded", the_hand_is_bounded, "24a"},
    {"knots_are_counted", knots_are_counted, "24b"},
    {"lift_solves_the_linear_problem", lift_solves_the_linear_problem, "24c"},
    {"lift_without_a_jump_is_newton", lift_without_a_jump_is_newton, "24c"},
    {"lift_refuses_what_cannot_be", lift_refuses_what_cannot_be, "24c"},
    {"lift_hands_on_each_status", lift_hands_on_each_status, "24c"},
    {"downhill_does_what_it_says", downhill_does_what_it_says, "24d"},
    {"no_frame_is_lost", no_frame_is_lost, "24d"},
    {"bad_input_is_refused", bad_input_is_refused, NULL},
};

/* Where round-off does not decide: hard and mad are chaos after a while, and
 * with some n a frame may or may not be finished after the last system. */
static const char *const runs[] = {
    "",
    "--speed 3 --n 7",
    "--speed -6 --n 8",
    "--speed -4 --n 6 --law cubic",
    "--speed -3 --n 5 --law cubic --integrator midpoint",
};

#define FRAME "round-off in Newton's method, and the motion after it"

static const struct column_rule rules[] = {
    {"frames", "k", 0.0, "counts frames", 0.0},
    {"frames", "systems", 0.25, "round-off may decide about three systems",
     0.0},
    {"frames", "ms", NOT_COMPARED, "seconds", 0.0},
    {"frames", "knots", 0.0, "counts vertices", 0.0},
    {"frames", "*", 1e-4, FRAME, 0.0},
    {"summary", "most_systems", 0.25, "as systems", 0.0},
    {"summary", "last_max_u", 1e-4, FRAME, 1.0},
    {"summary", "*", 1e-4, FRAME, 0.0},
};

static const struct lesson lesson = {
    .name = "24_live",
    .claims = claims,
    .n_claim = COUNT(claims),
    .runs = runs,
    .n_run = COUNT(runs),
    .rules = rules,
    .n_rule = COUNT(rules),
    .notice = "The table `frames` of --input hard shows how many linear "
              "systems a frame takes, and where `part` is not 1: there the "
              "hand was held back.",
    .break_it = "Run make live, press p, which takes the second rung away, and "
                "pull.",
    what_was_predicted};

int main(int argc, char *argv[]) { return judge(&lesson, argc, argv); }
