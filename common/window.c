/* window.c - see window.h. */
#include "window.h"

#include "clock.h"

#include <SDL.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { FRAMES = 240 };
static const double WORLD[2] = {5.6, 4.4}; /* what is seen at least (m) */

struct window {
    SDL_Window *window;
    SDL_Renderer *draw;
    double scale, middle[2]; /* pixels per metre; the pixel of 0 */
    int size[2];
    double next;             /* when the next frame begins (s) */
    int stopped, closed;
    double took[FRAMES];     /* seconds per frame, in a ring */
    int drawn;
};

/* ---- letters: five columns of seven dots, ' ' to 'Z' -------------------- */

static const unsigned long long LETTER[59] = {
    0x0000000000, 0x00005f0000, 0x0007000700, 0x147f147f14, 0x242a7f2a12,
    0x2313086462, 0x3649562050, 0x0000070000, 0x001c224100, 0x0041221c00,
    0x2a1c7f1c2a, 0x08083e0808, 0x0040300000, 0x0808080808, 0x0000606000,
    0x2010080402, 0x3e5149453e, 0x00427f4000, 0x7249494946, 0x2141494d33,
    0x1814127f10, 0x2745454539, 0x3c4a494931, 0x4121110907, 0x3649494936,
    0x464949291e, 0x0000140000, 0x0040340000, 0x0008142241, 0x1414141414,
    0x0041221408, 0x0201590906, 0x3e415d594e, 0x7c1211127c, 0x7f49494936,
    0x3e41414122, 0x7f4141413e, 0x7f49494941, 0x7f09090901, 0x3e41415173,
    0x7f0808087f, 0x00417f4100, 0x2040413f01, 0x7f08142241, 0x7f40404040,
    0x7f021c027f, 0x7f0408107f, 0x3e4141413e, 0x7f09090906, 0x3e4151215e,
    0x7f09192946, 0x2649494932, 0x03017f0103, 0x3f4040403f, 0x1f2040201f,
    0x3f4038403f, 0x6314081463, 0x0304780403, 0x6159494d43};

static void write_text(struct window *w, int x, int y, int dot,
                       const char *text)
{
    for (; *text; text++, x += 6 * dot) {
        const int c = *text >= 'a' && *text <= 'z' ? *text - 'a' + 'A' : *text;
        if (c < ' ' || c > 'Z') continue;
        for (int column = 0; column < 5; column++)
            for (int row = 0; row < 7; row++)
                if (LETTER[c - ' '] >> (8 * (4 - column) + row) & 1)
                    SDL_RenderFillRect(w->draw, &(SDL_Rect){
                        x + column * dot, y + row * dot, dot, dot});
    }
}

/* ---- the window ---------------------------------------------------------- */

struct window *window_open(void)
{
    struct window *w = allocate(1, sizeof *w);
    SDL_SetHint(SDL_HINT_RENDER_SCALE_QUALITY, "1");
    if (SDL_Init(SDL_INIT_VIDEO) != 0 ||
        SDL_CreateWindowAndRenderer(980, 770, SDL_WINDOW_RESIZABLE, &w->window,
                                    &w->draw) != 0)
        die("there is no window: %s", SDL_GetError());
    SDL_SetWindowTitle(w->window, "Elasticity Workbook: lesson 24");
    SDL_SetWindowMinimumSize(w->window, 640, 480);
    w->next = clock_seconds();
    return w;
}

void window_close(struct window *w)
{
    SDL_DestroyRenderer(w->draw);
    SDL_DestroyWindow(w->window);
    SDL_Quit();
    free(w);
}

static void measure(struct window *w)
{
    SDL_GetRendererOutputSize(w->draw, &w->size[0], &w->size[1]);
    w->scale = fmin(w->size[0] / WORLD[0], w->size[1] / WORLD[1]);
    w->middle[0] = 0.5 * w->size[0];
    w->middle[1] = 0.5 * w->size[1];
}

int window_next(struct window *w, struct pointers *input, int k, int mouse)
{
    int x, y, wide, high;
    char key = '.';
    do {
        SDL_Event event;
        while (SDL_PollEvent(&event)) {
            if (event.type == SDL_QUIT) w->closed = 1;
            if (event.type != SDL_KEYDOWN || event.key.repeat) continue;
            const SDL_Keycode code = event.key.keysym.sym;
            if (code == SDLK_SPACE) w->stopped = !w->stopped;
            if (code == SDLK_EQUALS || code == SDLK_KP_PLUS)
                key = '+'; /* on many keyboards + is on the key of = */
            else if (code == SDLK_KP_MINUS)
                key = '-';
            else if (code > ' ' && code < 127 &&
                     strchr(POINTER_KEYS, (char)code))
                key = (char)code;
        }
        const double rest = w->next - clock_seconds();
        if (rest > 0.0) SDL_Delay((Uint32)(1e3 * rest));
        w->next = fmax(w->next, clock_seconds() - 1.0 / 30.0) + 1.0 / 30.0;
    } while (w->stopped && !w->closed);
    const int down = SDL_GetMouseState(&x, &y) & SDL_BUTTON_LMASK ? 1 : 0;
    measure(w);
    SDL_GetWindowSize(w->window, &wide, &high);
    if (mouse)
        pointers_add(input, (struct pointer){
            ((double)x * w->size[0] / wide - w->middle[0]) / w->scale,
            (w->middle[1] - (double)y * w->size[1] / high) / w->scale, down,
            key});
    return !w->closed && k < input->n;
}

/* ---- pictures ------------------------------------------------------------ */

static SDL_FPoint pixel(const struct window *w, const struct live *live, int a)
{
    const double *X = live->mesh->X, *u = live->now.u;
    return (SDL_FPoint){
        (float)(w->middle[0] + w->scale * (X[2 * a] + u[2 * a])),
        (float)(w->middle[1] - w->scale * (X[2 * a + 1] + u[2 * a + 1]))};
}

static SDL_Color colour(double J)
{
    if (!(J > 0.0)) return (SDL_Color){214, 0, 190, 255};
    const double s = fmax(-1.0, fmin(1.0, log2(J)));
    const double end[2][3] = {{33, 102, 196}, {235, 120, 20}};
    Uint8 c[3];
    for (int i = 0; i < 3; i++)
        c[i] = (Uint8)(250.0 + fabs(s) * (end[s > 0.0][i] - 250.0));
    return (SDL_Color){c[0], c[1], c[2], 255};
}

static void draw_body(struct window *w, const struct live *live)
{
    const struct mesh *mesh = live->mesh;
    for (int e = 0; e < mesh->n_triangle; e++) {
        SDL_Vertex corner[3];
        SDL_FPoint line[4];
        for (int k = 0; k < 3; k++)
            line[k] = pixel(w, live, mesh->triangle[3 * e + k]);
        line[3] = line[0];
        /* pixels count downwards, so the area has the other sign */
        const double rest = w->scale * w->scale * 4.0 / mesh->n / mesh->n;
        const double area = (double)(line[2].x - line[0].x) *
                                (double)(line[1].y - line[0].y) -
                            (double)(line[1].x - line[0].x) *
                                (double)(line[2].y - line[0].y);
        for (int k = 0; k < 3; k++)
            corner[k] = (SDL_Vertex){line[k], colour(area / rest), {0, 0}};
        SDL_RenderGeometry(w->draw, NULL, corner, 3, NULL, 0);
        SDL_SetRenderDrawColor(w->draw, 120, 120, 120, 255);
        if (mesh->n <= 32) SDL_RenderDrawLinesF(w->draw, line, 4);
    }
}

static void draw_marks(struct window *w, const struct live *live)
{
    const int n = live->mesh->n_vertex;
    int *knot = allocate((size_t)n, sizeof *knot);
    live_knots(live->mesh, live->now.u, knot);
    for (int a = 0; a < n; a++) {
        const SDL_FPoint at = pixel(w, live, a);
        SDL_SetRenderDrawColor(w->draw, 20, 20, 20, 255);
        if (live->body->equation[2 * a] < 0)
            SDL_RenderFillRectF(w->draw,
                                &(SDL_FRect){at.x - 2, at.y - 2, 5, 5});
        SDL_SetRenderDrawColor(w->draw, 200, 0, 0, 255);
        for (int k = 0; k < 48 && knot[a]; k++) {
            const double z = 6.283185307 * k / 48;
            SDL_RenderFillRectF(w->draw, &(SDL_FRect){
                at.x + (float)(12 * cos(z)) - 1,
                at.y + (float)(12 * sin(z)) - 1, 3, 3});
        }
    }
    free(knot);
}

/* The milliseconds of the last frames, 1 pixel each, and the line of 33. */
static void draw_times(struct window *w, double seconds)
{
    const int left = 12, floor = w->size[1] - 14;
    w->took[w->drawn++ % FRAMES] = seconds;
    for (int k = 0; k < FRAMES && k < w->drawn; k++) {
        const double s = w->took[(w->drawn - 1 - k) % FRAMES];
        const int high = (int)fmin(100.0, 1500.0 * s) + 1;
        SDL_SetRenderDrawColor(w->draw, s > 1.0 / 30.0 ? 200 : 70, 70, 70, 255);
        SDL_RenderDrawLine(w->draw, left + FRAMES - k, floor,
                           left + FRAMES - k, floor - high);
    }
    SDL_SetRenderDrawColor(w->draw, 200, 0, 0, 255);
    SDL_RenderDrawLine(w->draw, left, floor - 50, left + FRAMES, floor - 50);
    write_text(w, left + FRAMES + 6, floor - 56, 2, "33 ms");
}

static void shoot(struct window *w, const char *path)
{
    SDL_Surface *s = SDL_CreateRGBSurfaceWithFormat(
        0, w->size[0], w->size[1], 32, SDL_PIXELFORMAT_ARGB8888);
    if (!s ||
        SDL_RenderReadPixels(w->draw, NULL, s->format->format, s->pixels,
                             s->pitch) != 0 ||
        SDL_SaveBMP(s, path) != 0)
        die("%s cannot be written: %s", path, SDL_GetError());
    SDL_FreeSurface(s);
}

void window_draw(struct window *w, const struct live *live,
                 const struct live_report *report, double seconds,
                 const char *shot)
{
    static const char *const start[] = {"elastic", "rows", "last state"};
    char text[3][160];
    measure(w);
    SDL_SetRenderDrawColor(w->draw, 255, 255, 255, 255);
    SDL_RenderClear(w->draw);
    draw_body(w, live);
    draw_marks(w, live);
    draw_times(w, seconds);
    const int lost = strcmp(report->rung, "lost") == 0;
    snprintf(text[0], sizeof text[0], "%s: %s, %d systems, %.1f ms%s",
             report->rung, status_name(report->status), report->systems,
             1e3 * seconds, live->holding ? ", holding" : "");
    snprintf(text[1], sizeof text[1],
             "n %d (+ -)  law %s (L)  %s (I)  start %s (S)", live->set.n,
             material_law(live->set.law), method_name(live->set.method),
             start[live->set.start]);
    snprintf(text[2], sizeof text[2],
             "ladder %s (P)  grab %s (G)  (R)eset  (space)  min J %.2f",
             live->set.ladder ? "all" : "none",
             live->set.grab == PATCH ? "patch" : "side",
             body_min_J(live->body, live->now.u));
    for (int k = 0; k < 3; k++) {
        const int red = k == 0 && lost ? 200 : 20;
        SDL_SetRenderDrawColor(w->draw, (Uint8)red, 20, 20, 255);
        write_text(w, 12, 12 + 22 * k, w->size[0] >= 800 ? 2 : 1, text[k]);
    }
    if (shot) shoot(w, shot);
    SDL_RenderPresent(w->draw);
}
