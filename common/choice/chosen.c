/* chosen.c - see chosen.h. */
#include "choice/chosen.h"

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

/* Why nobody may rely on what the parts say. */
static const char *const doubts[] = {
    [TORN] = "the load is more than a body of this E can bear",
    [LONG_STEPS] = "the steps are too long for a body that swings so fast: "
                   "make 'end' shorter",
    [GIVES_WAY] = "the body gives way under this load: K is not positive "
                  "definite (lesson 15)",
    [BUCKLES] = "it is taken to stay straight beyond the load at which it "
                "buckles (lesson 23):\n    load it a little sideways, too",
    [TOO_STIFF] = "quadratic triangles go elsewhere: these are too stiff to "
                  "buckle so (lesson 25)"};

/* What a part of the error comes from. */
static const char *const says[N_PART] = {
    [GEOMETRY] = "the linear law knows no turn and no square of the strain",
    [LAW] = "the cubic law stands in place of the logarithm",
    [DIMENSION] = "a bar neither bends nor is held wide",
    [INERTIA] = "at rest nothing swings",
    [MESH] = "the cells have a size",
    [STRESS] = "in the linear law stress does not turn with the body"};

void chosen_say_climb(const struct chosen_tried tried[], int n)
{
    printf("Tried, from the least model on (lesson 23)\n");
    for (int k = 0; k < n; k++) {
        const char *end = k < n - 1 ? "," : "";
        printf("  %s %s, mesh %d: ", ladder_rung(tried[k].model.rung),
               tried[k].model.moving ? "in motion" : "at rest",
               tried[k].model.level);
        if (tried[k].doubt >= GIVES_WAY) {
            printf("%s\n", tried[k].doubt == BUCKLES
                   ? "stays straight where a column buckles"
                   : tried[k].doubt == TOO_STIFF
                   ? "is too stiff to buckle as quadratic triangles do"
                   : tried[k].model.moving
                   ? "not known, for at the peak K is not positive definite"
                   : "gives way, for K is not positive definite");
            continue;
        }
        if (tried[k].estimate < 1.0)
            printf("expected error %.2g %%%s\n", 100.0 * tried[k].estimate,
                   end);
        else
            printf("expected error 100 %% or more%s\n", end);
        if (k < n - 1) printf("    most of all since %s\n", says[tried[k].add]);
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

/* What one factorisation costs by each solver, and which one to take. */
static void say_solver(const struct ladder_state *s)
{
    if (s->model.rung == BAR) {
        printf("  solver: a sum along the bar, %d unknowns (lesson 9)\n",
               s->mesh->n);
        return;
    }
    struct ladder_state *other = ladder_alloc(s->scene, s->model);
    const int n = other->body->n_equation, p = other->body->K->p;
    const int by_dissection = s->mesh->rows >= BODY_SPARSE_FROM;
    body_store(other->body, SPARSE);
    printf("  solver: Cholesky factors %s, %d unknowns (lesson 21):\n    a "
           "factorisation has %.2g flops in a band, %.2g by dissection, %.2g "
           "dense;\n    the band is the faster one below %d cells across\n",
           by_dissection ? "by dissection" : "of a band", n,
           matrix_cost(BANDED, n, p).flops, other->body->pattern->flops,
           matrix_cost(DENSE, n, 0).flops, BODY_SPARSE_FROM);
    ladder_free(other);
}

void chosen_say_model(const struct scene_file *file,
                      const struct ladder_state *s, double tolerance,
                      enum chosen_how how)
{
    static const char *const model[] = {
        "a bar (lesson 9)", "linear triangles, linear law (lesson 12)",
        "linear triangles, cubic Neo-Hookean law (lesson 12)",
        "linear triangles, logarithmic Neo-Hookean law (lesson 12)"};
    static const char *const why[] = {
        "it hardly bends", "turn, strain and stress are small enough",
        ("it turns or strains too much for the linear law, or is under stress "
         "that turns"),
        "J is far from 1, where the cubic law departs from it"};
    const struct ladder_scene *scene = s->scene;
    if (how != CHOSEN_NOTHING)
        printf("The least model for an error of %g %%\n", 100.0 * tolerance);
    else
        printf("NOT SURE: no model here is known to be enough for an error of "
               "%g %%.\nThe last one tried is\n", 100.0 * tolerance);
    printf("  %s:\n    %s\n", model[s->model.rung], why[s->model.rung]);
    printf("  %s\n", s->model.moving ?
           "in motion: the load is too fast for an answer at rest (lesson 14)" :
           scene->time == STANDS ? "at rest: the load stands (lesson 12)"
                                 : "at rest: the load is slow (lesson 14)");
    printf("  mesh %d, of %d x %d cells (lesson 12)%s\n", s->model.level,
           s->mesh->n, s->mesh->rows, how == CHOSEN_WITH_OTHERS ?
           ", which is not fine enough;\n  but other triangles are (below)"
           : "");
    if (s->model.moving)
        printf("  implicit midpoint rule, %.0f steps of %.3g s, omega dt %.2g "
               "(lesson 14)\n", scene->end / scene->dt,
               scene->dt * file->second, estimate_frequency(s) * scene->dt);
    say_solver(s);
    if (s->model.rung > LINEAR_PLANE)
        printf("  cures to switch on: line search (lesson 11), projection on "
               "demand (lesson 15)\n");
}

const char *chosen_quantity(enum ladder_quantity quantity)
{
    static const char *const of[] = {
        [LADDER_LARGEST] = "of the largest displacement",
        [LADDER_RMS] = "of the displacement in the root mean square",
        [LADDER_HAND] = "of the force in the hand"};
    return of[quantity];
}

/* What is expected of every quantity that can be asked for. */
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

/* The parts of the error, and what no part sees. */
void chosen_say_error(struct ladder_state *s, const struct chosen_tried *t)
{
    if (t->doubt < GIVES_WAY) {
        printf("Expected error %.2g %% %s:\nthe root of the sum of the squares "
               "of its parts (lesson 23)\n", 100.0 * t->estimate,
               chosen_quantity(s->scene->quantity));
        for (int k = 0; k < N_PART; k++)
            if (t->part[k] > 0.0)
                printf("  %-9s %8.2g %%  %s\n", ladder_part((enum part)k),
                       100.0 * t->part[k], says[k]);
        say_quantities(s);
    } else
        printf("Expected error: not known, for the body %s (lesson 23)\n",
               t->doubt != GIVES_WAY ? "buckles" : s->model.moving
               ? "swings far" : "gives way");
    printf("Not sure of\n");
    if (t->doubt == TORN)
        printf("  the answer as a whole:\n    the strain is beyond %g: %s\n",
               ESTIMATE_STRAIN, doubts[TORN]);
    else if (t->doubt != NO_DOUBT)
        printf("  the answer as a whole:\n    %s\n",
               t->doubt == GIVES_WAY && s->model.moving
               ? "at the peak K is not positive definite, so that no part of "
                 "the error is known (lesson 15)" : doubts[t->doubt]);
    printf("  the estimate: the error was up to 1.9 times as large in "
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
