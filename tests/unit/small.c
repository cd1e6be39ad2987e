/* small.c - laws of the small files of common/, and values that the laws of
 * the large ones leave open: norms, clocks, energies, the notes' scenes. */
#include "bar/bar_scene.h"
#include "base/clock.h"
#include "motion/window.h"
#include "unit.h"

#include <math.h>
#include <stdio.h>
#include <string.h>
#include <time.h>

/* Between two looks at the system's clock, and the part below a second too. */
static void seconds_are_those_of_the_system(void)
{
    const struct timespec pause = {0, 20000000};
    struct timespec first, last;
    for (int k = 0; k < 5; k++) {
        clock_gettime(CLOCK_MONOTONIC, &first);
        const double start = clock_seconds();
        nanosleep(&pause, NULL);
        const double end = clock_seconds();
        clock_gettime(CLOCK_MONOTONIC, &last);
        const double most = (double)(last.tv_sec - first.tv_sec) +
                            1e-9 * (double)(last.tv_nsec - first.tv_nsec);
        ck_assert_msg(end - start >= 0.02 - 1e-6 && end - start <= most + 1e-6,
                      "%g s in a time of %g s", end - start, most);
    }
}

static void a_machine_has_its_processors_name(void)
{
    char text[512], line[256], name[256] = "";
    FILE *file = fopen("/proc/cpuinfo", "r"); /* where there is one */
    while (file && !*name && fgets(line, sizeof line, file))
        if (strncmp(line, "model name\t: ", 13) == 0)
            sscanf(line + 13, "%100[^\n]", name);
    if (file) fclose(file);
    clock_machine(sizeof text, text);
    ck_assert_msg(strncmp(text, name, strlen(name)) == 0, "%s: %s", name, text);
    ck_assert_ptr_nonnull(strstr(text, ", "));
    ck_assert(strstr(text, "gcc ") || strstr(text, "clang "));
}

/* Not only its slope: 0 at rest, h sum psi - b.u elsewhere. */
static void energies_count_from_rest(void)
{
    const double b[] = {1.0, -2.0, 4.0, 8.0}, rest[4] = {0.0};
    const double u[] = {0.0, 0.05, 0.1, 0.15};
    for (int law = LINEAR; law <= CUBIC; law++) {
        const struct bar bar = {3, 0.25, {1, 0}, b,
                                material_notes((enum law)law)};
        double energy;
        ck_assert(bar_energy(&bar, rest, &energy) == OK);
        close_to(energy, 0.0, 1e-12);
        ck_assert(bar_energy(&bar, u, &energy) == OK);
        close_to(energy, 0.75 * material1_psi(&bar.material, 1.2) - 1.5, 1e-12);
    }
}

/* 1e-12 of the size: 1 m, what the loads stretch, what the ends move; full
 * steps, at most 100 of them. */
static void a_tolerance_has_the_size_of_the_answer(void)
{
    struct bar_scene scene = bar_scene_notes(LOG, 4);
    const double modulus = material_modulus(&scene.material);
    scene.c = -2.0 * modulus;
    scene.pull[0] = 3.0 * modulus;
    scene.pull[1] = -4.0 * modulus;
    scene.g[0] = 5.0;
    scene.g[1] = -6.0;
    const struct newton_control control = bar_scene_control(&scene);
    close_to(control.tolerance, 21e-12, 1e-24);
    ck_assert_int_eq(control.max_iterations, 100);
    ck_assert(!control.line_search && !control.definite);
    scene.n = 2000;
    close_to(bar_scene_control(&scene).tolerance,
             21.0 * 8.0 * 2000.0 * 0x1p-52, 1e-22);
}

/* Roots of Williams' equation by another program; none is singular at nu = 0.
 */
static void corners_are_williams(void)
{
    static const double nu[] = {0.0, 0.2385, 0.3, 0.49};
    static const double p[] = {1.0, 0.75283083950742284, 0.71117293297146607,
                               0.59989510759463660};
    for (int k = 0; k < COUNT(nu); k++) {
        const struct material m = material_make(LOG, 2385.0, nu[k]);
        close_to(material_corner(&m), p[k], 1e-14);
    }
}

/* Without SDL there is no window, and the input has its frames and no more. */
static void without_a_window_the_input_is_followed(void)
{
    struct pointers hard = pointers_hard();
    ck_assert(!window_open());
    for (int k = 0; k <= hard.n; k++)
        ck_assert_int_eq(window_next(NULL, &hard, k, 0), k < hard.n);
    pointers_free(&hard);
}

UNIT_MAIN("small",
    LAW(seconds_are_those_of_the_system),
    LAW(a_machine_has_its_processors_name),
    LAW(energies_count_from_rest),
    LAW(corners_are_williams),
    LAW(a_tolerance_has_the_size_of_the_answer),
    LAW(without_a_window_the_input_is_followed))
