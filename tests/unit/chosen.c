/* chosen.c - laws of lessons/choose/chosen.h: the words are the state's. */
#include "lessons/choose/chosen.h"

#include "unit.h"

#include <math.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

/* What is said, and of what. */
static struct scene_file file;
static struct ladder_scene *const scene = &file.scene;
static struct ladder_state *s;
static struct climb_rung tried[3];
static int n_tried;
static const struct cells *others;

static void numbers(void) { chosen_say_numbers(&file, s); }
static void climb(void) { chosen_say_climb(tried, n_tried); }
static void model(void) { chosen_say_model(&file, s, others); }
static void answer(void) { chosen_say_answer(s, &tried[0], 0.073, others); }
static void errors(void)
{
    const enum ladder_quantity quantity = scene->quantity;
    chosen_say_error(s, &tried[0], others);
    ck_assert(s->scene == scene && scene->quantity == quantity);
}

/* What is printed, without a process of its own, for there is much of it. */
static const char *printed(void (*call)(void))
{
    static char text[8192];
    FILE *out = tmpfile();
    fflush(stdout);
    const int kept = dup(STDOUT_FILENO);
    ck_assert(out && kept >= 0 && dup2(fileno(out), STDOUT_FILENO) >= 0);
    call();
    fflush(stdout);
    dup2(kept, STDOUT_FILENO);
    close(kept);
    rewind(out);
    text[fread(text, 1, sizeof text - 1, out)] = '\0';
    fclose(out);
    return text;
}
static void says(void (*call)(void), const char *words)
{
    const char *text = printed(call);
    ck_assert_msg(strstr(text, words), "no \"%s\" in:\n%s", words, text);
}
static void is_silent_on(void (*call)(void), const char *words)
{
    const char *text = printed(call);
    ck_assert_msg(!strstr(text, words), "\"%s\" in:\n%s", words, text);
}

/* A body of 3 m whose second has half a second, not solved. */
static void begin(struct ladder_scene of, struct ladder_model m)
{
    file = (struct scene_file){of, 1.5, 2.0, 0.5, "some"};
    s = ladder_alloc(scene, m);
}

/* Stretched along its axis by the factor, and turned by the angle. */
static void deform(double stretch, double angle)
{
    const mat2 Q = mat2_rotation(angle);
    for (int a = 0; a < s->mesh->n_vertex; a++) {
        const double *X = &s->mesh->X[2 * a];
        for (int i = 0; i < 2; i++)
            s->u[2 * a + i] =
                Q.m[i][0] * stretch * X[0] + Q.m[i][1] * X[1] - X[i];
    }
}

static const struct ladder_scene still = {"some", 4, 0.3,
    .weight = {0.0, -1.0}, .finest = 2};

/* Stretched by 1.2: G11 = 0.22.  A pull t on the end of 0.5 m is 0.5 t / P_cr
 * of the load that buckles, and below 0.005 of that hardly one. */
static void numbers_are_those_of_the_body(void)
{
    begin(still, (struct ladder_model){CUBIC_PLANE, 0, 0});
    deform(1.2, -0.31);
    says(numbers, "Scene some, 3 m long, ");
    says(numbers, "  largest strain 0.22: at 0.1 the linear stress is 10 % ");
    says(numbers, "  largest turn 0.31 rad: at 0.2 the linear displacement");
    says(numbers, "length over height 4, Poisson's ratio 0.3 (lesson 12)\n");
    says(numbers, "  hardly loaded along its axis (lesson 23)\n");
    is_silent_on(numbers, "omega T");
    is_silent_on(numbers, "speed of sound");
    ladder_free(s);
    static const double share[] = {-0.51, 0.51, -0.0051, 0.0049};
    static const char *const words[] = {
        "pressed along its axis by 0.51 times", "pulled along its axis by 0.51",
        "pressed along its axis by 0.0051", "hardly loaded"};
    for (int k = 0; k < 4; k++) {
        struct ladder_scene axial = still;
        axial.nu = k ? 0.4499 : 0.4501;
        axial.pull[0] = share[k] < 0.0 ? -1.0 : 1.0;
        axial.pull[0] *= fabs(share[k] / ladder_pressed(&axial));
        begin(axial, (struct ladder_model){LINEAR_PLANE, 0, 0});
        says(numbers, words[k]);
        (k ? is_silent_on : says)(numbers, "linear triangles lock");
        ladder_free(s);
        axial.held = LADDER_ENDS;
        begin(axial, (struct ladder_model){LINEAR_PLANE, 0, 0});
        is_silent_on(numbers, "along its axis");
        ladder_free(s);
    }
}

/* Turned by the angle that is printed a body moves by Q X - X, but linearly by
 * the angle times X across: 10 % off, as geometry says of it as well. */
static void linear_geometry_errs_as_is_printed(void)
{
    double angle = 0.0;
    begin(still, (struct ladder_model){LINEAR_PLANE, 0, 0});
    const char *line = strstr(printed(numbers), "largest turn ");
    ck_assert(line &&
              sscanf(line, "largest turn %*g rad: at %lf", &angle) == 1);
    close_to(hypot(1.0 - cos(angle), angle - sin(angle)) /
             (2.0 * sin(0.5 * angle)), 0.1, 5e-4);
    deform(1.0, angle);
    close_to(estimate_geometry(s), 0.1, 5e-4);
    ladder_free(s);
}

/* Shifted by c: omega^2 = f.u / u.M u = 10 / c, of 2 kg pulled by 20 N. */
static void a_motion_has_its_numbers(void)
{
    struct ladder_scene pulled = {"some", 2, 0.0, .pull = {20.0, 0.0},
        .time = RISES, .T = 0.5, .dt = 0.1, .end = 1.0, .finest = 2};
    begin(pulled, (struct ladder_model){LINEAR_PLANE, 1, 1});
    for (int a = 0; a < s->mesh->n_vertex; a++) s->u[2 * a] = 0.1;
    s->fastest = sqrt(1000.0) / 4.0;
    says(numbers, "1 / (omega T) 0.2: inertia counts");
    says(numbers, "over speed of sound 0.25, ");
    says(numbers, "over a cell 6.3:"); /* 0.79 m of 1/8 m */
    says(model, "implicit midpoint rule, 10 steps of 0.05 s, omega dt 1 (");
    says(model, "in motion: the load is too fast");
    ladder_free(s);
    begin(pulled, (struct ladder_model){LINEAR_PLANE, 0, 1});
    says(numbers, "1 / (omega T)");
    is_silent_on(numbers, "speed of sound");
    is_silent_on(model, "implicit midpoint");
    says(model, "at rest: the load is slow");
    ladder_free(s);
}

static void a_climb_is_told_step_by_step(void)
{
    tried[0] = (struct climb_rung){{BAR, 0, 0}, {0.0}, 0.9994, DIMENSION, 0};
    tried[1] = (struct climb_rung){{CUBIC_PLANE, 1, 2}, {0.0}, 1.0, LAW, 0};
    tried[2] = (struct climb_rung){{LOG_PLANE, 0, 1}, {0.0}, 0.034, MESH, 0};
    n_tried = 3;
    ck_assert_str_eq(printed(climb),
        "Tried, from the least model on (lesson 23)\n"
        "  bar at rest, mesh 0: expected error 1e+02 %,\n"
        "    most of all since a bar neither bends nor is held wide\n"
        "  cubic in motion, mesh 2: expected error 100 % or more,\n"
        "    most of all since the cubic law stands in place of the logarithm\n"
        "  log at rest, mesh 1: expected error 3.4 %\n");
    tried[1].part[LAW] = 1.0;
    says(climb, "most of all since J is so far from 1 that the cubic law says");
    tried[0].estimate = 0.5;
    tried[1].doubt = GIVES_WAY;
    n_tried = 2;
    ck_assert_str_eq(printed(climb),
        "Tried, from the least model on (lesson 23)\n"
        "  bar at rest, mesh 0: expected error 50 %,\n"
        "    most of all since a bar neither bends nor is held wide\n"
        "  cubic in motion, mesh 2: not known, for at the peak K is not "
        "positive definite\n");
}

/* The answer is in the first two lines, and what is in doubt below them. */
static void an_answer_comes_first(void)
{
    static const struct cells quadratic = {.element = QUADRATIC_TRIANGLE,
                                           .grade = 2.0, .level = 2};
    begin(still, (struct ladder_model){CUBIC_PLANE, 0, 1});
    tried[0] = (struct climb_rung){s->model, {[MESH] = 0.07}, 0.07, MESH,
                                     NO_DOUBT};
    ck_assert_str_eq(printed(answer),
        "Enough for 7.3 %: linear triangles, cubic law, at rest, mesh 1 of "
        "32 x 8 cells.\nExpected error 7 % of the largest displacement.\n\n");
    others = &quadratic;
    says(answer, "Enough for 7.3 %: quadratic triangles graded to the corners, "
                 "cubic law, at rest, mesh 2 of 32 x 8 cells.\n");
    others = NULL;
    tried[0].estimate = 0.08;
    says(answer, "NOT SURE: nothing here is known to be enough for 7.3 %.\n"
                 "Last tried: linear triangles, cubic law, at rest, mesh 1 of "
                 "32 x 8 cells; expected error 8 % of the largest displacement."
                 "\n  most of all since the cells have a size (lesson 23)\n");
    is_silent_on(answer, "Enough");
    tried[0].estimate = 0.01;
    static const char *const words[] = {
        [TORN] = "the strain is so large that no body of this E",
        [LONG_STEPS] = "the steps are too long",
        [GIVES_WAY] = "the body gives way under this load",
        [BUCKLES] = "taken to stay straight beyond the load at which it ",
        [TOO_STIFF] = "these are too stiff to buckle so"};
    for (int k = TORN; k <= TOO_STIFF; k++) {
        tried[0].doubt = (enum doubt)k;
        says(answer, "NOT SURE");
        says(answer, words[k]);
        (k < GIVES_WAY ? says : is_silent_on)(answer, "expected error 1 %");
        (k < GIVES_WAY ? is_silent_on : says)(answer, "; its error is not ");
    }
    tried[0].doubt = GIVES_WAY;
    tried[0].model.moving = 1;
    says(answer, "at the peak K is not positive definite");
    ladder_free(s);
    begin(still, (struct ladder_model){BAR, 0, 0});
    tried[0] = (struct climb_rung){s->model, {0.0}, 0.01, MESH, NO_DOUBT};
    says(answer, "Enough for 7.3 %: a bar at rest.\nExpected error 1 % of");
    ladder_free(s);
}

/* Each rung has its own words, and those of a plane their factors' flops. */
static void a_model_is_told_with_its_solver(void)
{
    static const char *const rung[] = {
        "a bar: it hardly bends (lesson 9)\n", "the linear law: turn, strain",
        "cubic Neo-Hookean law: it turns or strains too much",
        "logarithmic Neo-Hookean law: J is far from 1"};
    for (int k = BAR; k <= LOG_PLANE; k++) {
        char words[200];
        begin(still, (struct ladder_model){(enum rung)k, 0, 1});
        says(model, rung[k]);
        says(model, "at rest: the load stands (lesson 12)\n");
        (k > LINEAR_PLANE ? says : is_silent_on)(model, "cures to switch on");
        if (k == BAR) says(model, "a sum along the bar, 32 unknowns");
        if (k == BAR) is_silent_on(model, "flops");
        if (k != BAR) {
            const int n = 2 * 32 * 9, p = s->body->K->p;
            snprintf(words, sizeof words, "Cholesky factors of a band, %d "
                     "unknowns (lesson 21):\n    a factorisation has %.2g "
                     "flops in a band, ", n, matrix_cost(BANDED, n, p).flops);
            says(model, words);
            snprintf(words, sizeof words, "by dissection, %.2g dense;\n    the "
                     "band is the faster one below 24 cells across\n",
                     matrix_cost(DENSE, n, 0).flops);
            says(model, words);
        }
        ladder_free(s);
    }
    begin((struct ladder_scene){"some", 0.5, 0.3, .weight = {0.0, -1.0}},
          (struct ladder_model){LINEAR_PLANE, 0, 2});
    says(model, "Cholesky factors of a band, "); /* 16 cells across */
    ladder_free(s);
    begin((struct ladder_scene){"some", 0.5, 0.3, .weight = {0.0, -1.0}},
          (struct ladder_model){LINEAR_PLANE, 0, 3});
    says(model, "Cholesky factors by dissection, ");
    ladder_free(s);
    static const struct cells quadratic = {.element = QUADRATIC_TRIANGLE,
                                           .grade = 1.0, .level = 2};
    begin(still, (struct ladder_model){LINEAR_PLANE, 0, 0});
    others = &quadratic; /* 32 of 64 x 16 cells are held */
    says(model, "factors by dissection, 2176 unknowns");
    says(model, "the band is the faster one below 16 cells across\n");
    others = NULL;
    ladder_free(s);
}

/* Parts are told if they are not 0; of a body that gives way nothing is known;
 * the other quantities are those that can be asked for. */
static void an_error_is_told_in_parts(void)
{
    begin(still, (struct ladder_model){LINEAR_PLANE, 0, 0});
    s->status = OK;
    deform(1.1, 0.0);
    tried[0] = (struct climb_rung){s->model, {[MESH] = 0.03, [STRESS] = 0.04},
                                     0.05, STRESS, NO_DOUBT};
    says(errors, "(lesson 23)\n  mesh             3 %  the cells have a size\n"
                 "  stress           4 %  in the linear law stress");
    says(errors, " % of the displacement in the root mean square\nNot sure");
    is_silent_on(errors, "contact");
    is_silent_on(errors, "linear triangles lock");
    is_silent_on(errors, "the force in the hand");
    is_silent_on(errors, "the moment");
    is_silent_on(errors, "which in motion is asked at the peak");
    others = &(struct cells){.element = QUADRATIC_TRIANGLE};
    says(errors, "the cells have a size");
    is_silent_on(errors, "in the root mean square"); /* that of linear ones */
    others = NULL;
    tried[0].doubt = GIVES_WAY;
    ck_assert_str_eq(printed(errors), "");
    tried[0].doubt = NO_DOUBT;
    deform(1.0, 1.58);
    says(errors, "contact: the body turns by more than a right angle");
    deform(1.0, 1.56);
    is_silent_on(errors, "contact");
    scene->nu = 0.45;
    says(errors, "linear triangles lock where nu is near 1/2");
    scene->quantity = LADDER_RMS;
    says(errors, " % of the largest displacement\nNot sure");
    scene->pull[0] = 1.0;
    says(errors, " % of the force in the hand\nNot sure");
    is_silent_on(errors, "that of a hand which moves its side");
    scene->quantity = LADDER_HAND;
    says(errors, "that of a hand which moves its side");
    ladder_free(s);
}

/* What the estimate says of another quantity is what it would say of a scene
 * that asks for it. */
static void other_quantities_are_estimated_as_if_asked_for(void)
{
    struct ladder_scene both = still;
    double estimate[2];
    char words[80];
    both.weight[1] = 0.0;
    both.pull[0] = -0.3;
    both.nu = 0.49;
    both.slender = 1.0;
    begin(both, (struct ladder_model){LINEAR_PLANE, 0, 0});
    ladder_free(s);
    s = ladder_solve(scene, (struct ladder_model){LINEAR_PLANE, 0, 0});
    for (int k = LADDER_LARGEST; k <= LADDER_RMS; k++) {
        scene->quantity = (enum ladder_quantity)k;
        climb_judge(s, 1.0, &tried[0]);
        estimate[k] = tried[0].estimate;
    }
    ck_assert_double_gt(fabs(log(estimate[1] / estimate[0])), 0.1); /* seen */
    scene->quantity = LADDER_LARGEST;
    snprintf(words, sizeof words, "  and %.2g %% of the displacement in the "
             "root", 100.0 * estimate[1]);
    tried[0] = (struct climb_rung){s->model, {0.0}, 0.05, MESH, NO_DOUBT};
    says(errors, words);
    ladder_free(s);
}

/* A rival counts from nine tenths on; how far it is apart is a part of u. */
static void a_motion_has_its_doubts(void)
{
    struct ladder_scene moves = still;
    moves.time = RISES;
    moves.T = moves.end = 1.0;
    moves.dt = 0.1;
    begin(moves, (struct ladder_model){LINEAR_PLANE, 1, 0});
    ladder_free(s);
    s = ladder_solve(scene, (struct ladder_model){LINEAR_PLANE, 1, 0});
    tried[0] = (struct climb_rung){s->model, {0.0}, 0.05, MESH, NO_DOUBT};
    s->apart = 0.3 * ladder_size(s, s->u);
    s->rival = 0.91;
    says(errors, "another peak of the load's work is 91 % as high, and there "
                 "u\n  differs by 30 %\n");
    says(errors, "which in motion is asked at the peak");
    s->rival = 0.89;
    is_silent_on(errors, "another peak");
    ladder_free(s);
}

UNIT_MAIN("chosen",
    LAW(numbers_are_those_of_the_body),
    LAW(linear_geometry_errs_as_is_printed),
    LAW(a_motion_has_its_numbers),
    LAW(a_climb_is_told_step_by_step),
    LAW(an_answer_comes_first),
    LAW(a_model_is_told_with_its_solver),
    LAW(an_error_is_told_in_parts),
    LAW(other_quantities_are_estimated_as_if_asked_for),
    LAW(a_motion_has_its_doubts))
