/* chosen.c - see chosen.h. */
#include "chosen.h"

#include "linear/sparse.h"

#include <math.h>
#include <stdio.h>

/* The largest angle (rad) of the rotation in F. */
static double largest_turn(const struct ladder_state *s)
{
    double turn = 0.0;
    for (int e = 0; e < s->mesh->n_triangle; e++) {
        const mat2 F = body_deformation(s->body, s->u, e);
        turn = fmax(turn, fabs(atan2(F.m[1][0] - F.m[0][1],
                                     F.m[0][0] + F.m[1][1])));
    }
    return turn;
}

/* Return why the parts of the error cannot be relied on. */
static const char *doubt_of(const struct climb_rung *t)
{
    static const char *const doubts[] = {
        [TORN] = "the strain is so large that no body of this E bears the "
                 "load",
        [LONG_STEPS] = "the steps are too long for a body that swings so fast: "
                       "make 'end' shorter",
        [GIVES_WAY] = "the body gives way under this load: K is not positive "
                      "definite (lesson 15)",
        [BUCKLES] = "it is taken to stay straight beyond the load at which it "
                    "buckles (lesson 23):\n  load it a little sideways, too",
        [TOO_STIFF] = "quadratic triangles go elsewhere: these are too stiff "
                      "to buckle so (lesson 25)"};
    if (t->doubt == GIVES_WAY && t->model.moving)
        return "at the peak K is not positive definite, so that no part of the "
               "error is known\n  (lesson 15)";
    return doubts[t->doubt];
}

/* The source of a part of the error. */
static const char *const says[N_PART] = {
    [GEOMETRY] = "the linear law knows no turn and no square of the strain",
    [LAW] = "the cubic law stands in place of the logarithm",
    [DIMENSION] = "a bar neither bends nor is held wide",
    [INERTIA] = "at rest nothing swings",
    [MESH] = "the cells have a size",
    [STRESS] = "in the linear law stress does not turn with the body"};

/* Return the largest source of the error. */
static const char *why_of(const struct climb_rung *t)
{
    return t->add == LAW && t->part[LAW] >= 1.0
               ? "J is so far from 1 that the cubic law says nothing of the "
                 "logarithm" : says[t->add];
}

/* Return text, as "7.7 %". */
static const char *percent(double estimate, char text[20])
{
    if (!(estimate < 1.0)) return "100 % or more";
    snprintf(text, 20, "%.2g %%", 100.0 * estimate);
    return text;
}

/* The triangles of the answer. */
static struct cells cells_of(const struct ladder_state *s,
                             const struct cells *others)
{
    return others ? *others : (struct cells){.element = LINEAR_TRIANGLE,
                                             .grade = 1.0,
                                             .level = s->model.level};
}

static void say_what(const struct ladder_state *s, const struct cells *others)
{
    static const char *const law[] = {"", "linear", "cubic", "logarithmic"};
    const char *when = s->model.moving ? "in motion" : "at rest";
    const struct cells c = cells_of(s, others);
    const int per = c.element == QUADRATIC_TRIANGLE ? 2 : 1; /* edge */
    if (s->model.rung == BAR)
        printf("a bar %s", when);
    else
        printf("%s triangles%s, %s law, %s, mesh %d of %d x %d cells",
               cells_name(c.element),
               c.grade > 1.0 ? " graded to the corners" : "",
               law[s->model.rung], when, c.level,
               (s->mesh->n >> s->model.level << c.level) / per,
               (s->mesh->rows >> s->model.level << c.level) / per);
}

int chosen_say_answer(const struct ladder_state *s,
                      const struct climb_rung *t, double tolerance,
                      const struct cells *others)
{
    const char *quantity = chosen_quantity(s->scene->quantity);
    const int enough = t->doubt == NO_DOUBT && t->estimate <= tolerance;
    char text[20];
    printf(enough ? "Enough for %g %%: " :
           "NOT SURE: nothing here is known to be enough for %g %%.\n"
           "Last tried: ", 100.0 * tolerance);
    say_what(s, others);
    if (t->doubt >= GIVES_WAY)
        printf("; its error is not known.\n");
    else
        printf("%s error %s %s.\n", enough ? ".\nExpected" : "; expected",
               percent(t->estimate, text), quantity);
    if (t->doubt != NO_DOUBT)
        printf("  %s\n", doubt_of(t));
    else if (!enough)
        printf("  most of all since %s (lesson 23)\n", why_of(t));
    printf("\n");
    return enough;
}

void chosen_say_climb(const struct climb_rung tried[], int n)
{
    printf("Tried, from the least model on (lesson 23)\n");
    for (int k = 0; k < n; k++) {
        const struct climb_rung *t = &tried[k];
        char text[20];
        printf("  %s %s, mesh %d: ", ladder_rung(t->model.rung),
               t->model.moving ? "in motion" : "at rest", t->model.level);
        if (t->doubt >= GIVES_WAY) {
            printf("%s\n", t->doubt == BUCKLES
                   ? "stays straight where a column buckles"
                   : t->doubt == TOO_STIFF
                   ? "is too stiff to buckle as quadratic triangles do"
                   : t->model.moving
                   ? "not known, for at the peak K is not positive definite"
                   : "gives way, for K is not positive definite");
            continue;
        }
        printf("expected error %s%s\n", percent(t->estimate, text),
               k < n - 1 ? "," : "");
        if (k < n - 1) printf("    most of all since %s\n", why_of(t));
    }
}

void chosen_say_numbers(const struct scene_file *file,
                        const struct ladder_state *s)
{
    const struct ladder_scene *scene = s->scene;
    const double strain = estimate_strain(s), turn = largest_turn(s);
    const double N = ladder_pressed(scene);
    printf("Scene %s, %g m long, in numbers without dimension\n", file->name,
           2.0 * file->metre);
    printf("  largest strain %.2g: at 0.1 the linear stress is 10 %% off "
           "(lesson 9)\n", strain);
    printf("  largest turn %.2g rad: at 0.2 the linear displacement is 10 %% "
           "off (lesson 23)\n", turn);
    printf("  length over height %.3g, Poisson's ratio %g%s (lesson 12)\n",
           scene->slender, scene->nu,
           scene->nu >= 0.45 ? ": linear triangles lock, quadratic ones do not"
                             : "");
    if (scene->held == LADDER_LEFT && fabs(N) < 5e-3)
        printf("  hardly loaded along its axis (lesson 23)\n");
    else if (scene->held == LADDER_LEFT)
        printf("  %s along its axis by %.2g times the load at which it buckles "
               "(lesson 23)\n", N > 0.0 ? "pressed" : "pulled", fabs(N));
    if (scene->time != STANDS)
        printf("  1 / (omega T) %.2g: inertia counts where it is not small "
               "(lesson 23)\n", estimate_inertia(s));
    if (s->model.moving) {
        const double sound = sqrt(material_modulus(&s->body->material));
        printf("  fastest motion over speed of sound %.2g, its jump per step "
               "over a cell %.2g:\n  beyond 1 triangles may turn inside out "
               "(lesson 14)\n", s->fastest / sound,
               s->fastest * scene->dt * s->mesh->n / 2.0);
    }
}

/* Print the cost of one factorisation by each solver, and the solver to
 * take. */
static void say_solver(const struct ladder_state *s, const struct cells *others)
{
    if (s->model.rung == BAR) {
        printf("  solver: a sum along the bar, %d unknowns (lesson 9)\n",
               s->mesh->n);
        return;
    }
    const struct cells c = cells_of(s, others);
    struct ladder_model model = s->model;
    model.level = c.level;
    struct ladder_state *same =
        ladder_alloc_of(c.element, c.grade, s->scene, model);
    const int n = same->body->n_equation, p = same->body->K->p;
    const int first_sparse = c.element == QUADRATIC_TRIANGLE
                         ? BODY_QUADRATIC_SPARSE_FROM : BODY_SPARSE_FROM;
    body_store(same->body, SPARSE);
    printf("  solver: Cholesky factors %s, %d unknowns (lesson 21):\n    a "
           "factorisation has %.2g flops in a band, %.2g by dissection, %.2g "
           "dense;\n    the band is the faster one below %d cells across\n",
           same->mesh->rows >= first_sparse ? "by dissection" : "of a band", n,
           matrix_cost(BANDED, n, p).flops, same->body->pattern->flops,
           matrix_cost(DENSE, n, 0).flops, first_sparse);
    ladder_free(same);
}

void chosen_say_model(const struct scene_file *file,
                      const struct ladder_state *s, const struct cells *others)
{
    static const char *const why[] = {
        "a bar: it hardly bends (lesson 9)",
        "the linear law: turn, strain and stress are small enough (lesson 12)",
        "the cubic Neo-Hookean law: it turns or strains too much for the "
        "linear one, or\n    is under stress that turns (lesson 12)",
        "the logarithmic Neo-Hookean law: J is far from 1, where the cubic one "
        "departs\n    from it (lesson 12)"};
    const struct ladder_scene *scene = s->scene;
    printf("The model, and how to solve it\n  %s\n", why[s->model.rung]);
    printf("  %s\n", s->model.moving ?
           "in motion: the load is too fast for an answer at rest (lesson 14)" :
           scene->time == STANDS ? "at rest: the load stands (lesson 12)"
                                 : "at rest: the load is slow (lesson 14)");
    if (s->model.moving)
        printf("  implicit midpoint rule, %.0f steps of %.3g s, omega dt %.2g "
               "(lesson 14)\n", scene->end / scene->dt,
               scene->dt * file->second, estimate_frequency(s) * scene->dt);
    say_solver(s, others);
    if (s->model.rung > LINEAR_PLANE)
        printf("  cures to switch on: line search (lesson 11), projection on "
               "demand (lesson 15)\n");
}

const char *chosen_quantity(enum ladder_quantity quantity)
{
    static const char *const words[] = {
        [LADDER_LARGEST] = "of the largest displacement",
        [LADDER_RMS] = "of the displacement in the root mean square",
        [LADDER_HAND] = "of the force in the hand"};
    return words[quantity];
}

/* Print the expected error of every quantity. */
static void say_quantities(struct ladder_state *s)
{
    const struct ladder_scene *scene = s->scene;
    struct ladder_scene other = *scene;
    const int n = ladder_has_hand(scene) ? LADDER_HAND : LADDER_RMS;
    s->scene = &other;
    for (int k = 0; k <= n; k++) {
        double part[N_PART], estimate;
        enum part add;
        other.quantity = (enum ladder_quantity)k;
        estimate_parts(s, part);
        estimate_verdict(s->model, scene->time, 1, 1.0, part, &estimate, &add);
        if (other.quantity != scene->quantity)
            printf("  and %.2g %% %s\n", 100.0 * estimate,
                   chosen_quantity(other.quantity));
    }
    s->scene = scene;
}

void chosen_say_error(struct ladder_state *s, const struct climb_rung *t,
                      const struct cells *others)
{
    if (t->doubt >= GIVES_WAY) return;
    printf("Parts of the expected error, the root of the sum of their squares "
           "(lesson 23)\n");
    for (int k = 0; k < N_PART; k++)
        if (t->part[k] > 0.0)
            printf("  %-9s %8.2g %%  %s\n", ladder_part((enum part)k),
                   100.0 * t->part[k], says[k]);
    if (!others) say_quantities(s);
    printf("Not sure of\n"
           "  the estimate: the error was up to 1.9 times as large in "
           "the twelve scenes of\n  lesson 23, and seldom far more in random "
           "ones\n");
    if (s->model.moving && s->rival > 0.9)
        printf("  the moment: another peak of the load's work is %.0f %% as "
               "high, and there u\n  differs by %.2g %%\n", 100.0 * s->rival,
               100.0 * s->apart / ladder_size(s, s->u));
    if (s->model.moving)
        printf("  whether K stays positive definite, which in motion is asked "
               "at the peak alone\n");
    if (s->scene->quantity == LADDER_HAND)
        printf("  the force in the hand where u is: it is that of a hand which "
               "moves its side as\n  far as the model says\n");
    if (largest_turn(s) > 1.57)
        printf("  contact: the body turns by more than a right angle, and may "
               "meet itself\n");
    if (s->scene->nu >= 0.45)
        printf("  the mesh: linear triangles lock where nu is near 1/2\n");
}
