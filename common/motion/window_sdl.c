/* window_sdl.c - window.h by SDL2. */
#include "motion/window.h"

#include "base/clock.h"
#include "motion/caption.h"

#include <SDL.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { FRAMES = 240 };
static const double FRAME = 1.0 / 30.0;

struct window {
    SDL_Window *window;
    SDL_Renderer *draw;
    int wide, high;      /* pixels */
    double scale;        /* pixels per metre */
    double next;         /* when the next frame begins (s) */
    int mouse, stopped, closed, drawn, knots;
    double took[FRAMES]; /* seconds per frame, in a ring */
};

static void ink(struct window *w, Uint8 red, Uint8 green, Uint8 blue)
{
    SDL_SetRenderDrawColor(w->draw, red, green, blue, 255);
}

static void dot(struct window *w, float x, float y, float size)
{
    SDL_RenderFillRectF(w->draw, &(SDL_FRect){x, y, size, size});
}

/* ' ' to 'z', five columns of seven dots each, 8 bits per column. */
static const unsigned long long LETTER[91] = {
    0x0, 0x5f0000, 0x7000700, 0x147f147f14, 0x242a7f2a12, 0x2313086462,
    0x3649562050, 0x70000, 0x1c224100, 0x41221c00, 0x2a1c7f1c2a,
    0x8083e0808, 0x40300000, 0x808080808, 0x606000, 0x2010080402,
    0x3e5149453e, 0x427f4000, 0x7249494946, 0x2141494d33, 0x1814127f10,
    0x2745454539, 0x3c4a494931, 0x4121110907, 0x3649494936, 0x464949291e,
    0x140000, 0x40340000, 0x8142241, 0x1414141414, 0x41221408, 0x201590906,
    0x3e415d594e, 0x7c1211127c, 0x7f49494936, 0x3e41414122, 0x7f4141413e,
    0x7f49494941, 0x7f09090901, 0x3e41415173, 0x7f0808087f, 0x417f4100,
    0x2040413f01, 0x7f08142241, 0x7f40404040, 0x7f021c027f, 0x7f0408107f,
    0x3e4141413e, 0x7f09090906, 0x3e4151215e, 0x7f09192946, 0x2649494932,
    0x3017f0103, 0x3f4040403f, 0x1f2040201f, 0x3f4038403f, 0x6314081463,
    0x304780403, 0x6159494d43,
    0x7f414100, 0x204081020, 0x41417f00, 0x402010204, 0x4040404040,
    0x102040000, 0x2054545478, 0x7f48444438, 0x3844444420, 0x384444487f,
    0x3854545418, 0x87e090102, 0x18a4a4a47c, 0x7f08040478, 0x447d4000,
    0x2040443d00, 0x7f10284400, 0x417f4000, 0x7c04180478, 0x7c08040478,
    0x3844444438, 0xfc24242418, 0x18242424fc, 0x7c08040408, 0x4854545420,
    0x43f444020, 0x3c4040207c, 0x1c2040201c, 0x3c4030403c, 0x4428102844,
    0x1ca0a0a07c, 0x4464544c44};

/* At most 50 letters are inside the smallest window. */
static void write_text(struct window *w, int x, int y, const char *text)
{
    for (int at = x; *text; text++, at += 12) {
        const char c = *text;
        if (c == '\n') {
            at = x - 12;
            y += 22;
        }
        if (c < ' ' || c > 'z') continue;
        for (int column = 0; column < 5; column++) /* from the right */
            for (int row = 0; row < 8; row++)
                if (LETTER[c - ' '] >> (8 * column + row) & 1)
                    dot(w, (float)(at + 8 - 2 * column), (float)(y + 2 * row),
                        2);
    }
}

struct window *window_open(void)
{
    struct window *w = allocate(1, sizeof *w);
    if (SDL_Init(SDL_INIT_VIDEO) != 0 ||
        SDL_CreateWindowAndRenderer(980, 770, SDL_WINDOW_RESIZABLE, &w->window,
                                    &w->draw) != 0)
        die("there is no window: %s", SDL_GetError());
    if (strcmp(SDL_GetCurrentVideoDriver(), "offscreen") == 0)
        die("there is no window, because there is no display");
    SDL_SetWindowTitle(w->window, "Elasticity Workbook: lesson 24");
    SDL_SetWindowMinimumSize(w->window, 640, 480);
    return w;
}

void window_close(struct window *w) { SDL_Quit(), free(w); }

int window_next(struct window *w, struct pointers *input, int k, int mouse)
{
    struct pointer p = {.key = '.'};
    int x, y;
    w->mouse = mouse;
    do {
        SDL_Event event;
        while (SDL_PollEvent(&event)) {
            if (event.type == SDL_QUIT) w->closed = 1;
            if (event.type != SDL_KEYDOWN || event.key.repeat) continue;
            SDL_Keycode code = event.key.keysym.sym;
            if (code == SDLK_SPACE) w->stopped = !w->stopped;
            if (code == SDLK_ESCAPE || code == SDLK_q) w->closed = 1;
            if (code == SDLK_EQUALS || code == SDLK_KP_PLUS) code = '+';
            if (code == SDLK_KP_MINUS) code = '-'; /* + is often on = */
            if (code > ' ' && code < 127 && strchr(POINTER_KEYS, code))
                p.key = (char)code;
        }
        const double now = clock_seconds();
        if (w->next > now) SDL_Delay((Uint32)(1e3 * (w->next - now)));
        w->next = fmax(w->next, now - FRAME) + FRAME;
    } while (w->stopped && !w->closed);
    p.down = (SDL_GetMouseState(&x, &y) & SDL_BUTTON_LMASK) != 0;
    SDL_GetRendererOutputSize(w->draw, &w->wide, &w->high);
    w->scale = fmin(w->wide / 5.6, w->high / 4.4); /* m seen at least */
    p.x = (x - 0.5 * w->wide) / w->scale;
    p.y = (0.5 * w->high - y) / w->scale;
    if (mouse && !w->closed) pointers_add(input, p);
    return !w->closed && k < input->n;
}

static SDL_FPoint pixel(const struct window *w, const struct live *live, int a)
{
    const double *X = &live->mesh->X[2 * a], *u = &live->now.u[2 * a];
    return (SDL_FPoint){(float)(0.5 * w->wide + w->scale * (X[0] + u[0])),
                        (float)(0.5 * w->high - w->scale * (X[1] + u[1]))};
}

static SDL_Color colour(double J)
{
    if (!(J > 0.0)) return (SDL_Color){214, 0, 190, 255};
    const double s = fmax(-1.0, fmin(1.0, log2(J))), t = fabs(s), w = 250.0;
    const double *c = (double[2][3]){{33, 102, 196}, {235, 120, 20}}[s > 0.0];
    return (SDL_Color){(Uint8)(w + t * (c[0] - w)), (Uint8)(w + t * (c[1] - w)),
                       (Uint8)(w + t * (c[2] - w)), 255};
}

/* Black squares where the body is held, red rings round its knots. */
static void draw_body(struct window *w, const struct live *live)
{
    const struct mesh *mesh = live->mesh;
    int *knot = allocate((size_t)mesh->n_vertex, sizeof *knot);
    w->knots = live_knots(mesh, live->now.u, knot);
    for (int e = 0; e < mesh->n_triangle; e++) {
        const double J = mat2_det(body_deformation(live->body, live->now.u, e));
        SDL_Vertex corner[3];
        SDL_FPoint line[4];
        for (int k = 0; k < 4; k++) {
            line[k] = pixel(w, live, mesh->triangle[3 * e + k % 3]);
            corner[k % 3] = (SDL_Vertex){line[k], colour(J), {0, 0}};
        }
        SDL_RenderGeometry(w->draw, NULL, corner, 3, NULL, 0);
        ink(w, 120, 120, 120);
        if (mesh->n <= 32) SDL_RenderDrawLinesF(w->draw, line, 4);
    }
    for (int a = 0; a < mesh->n_vertex; a++) {
        const SDL_FPoint at = pixel(w, live, a);
        ink(w, 20, 20, 20);
        if (live->body->equation[2 * a] < 0) dot(w, at.x - 2, at.y - 2, 5);
        ink(w, 200, 0, 0);
        if (!knot[a]) continue;
        for (float z = 0; z < 6.28F; z += 0.13F)
            dot(w, at.x + 12 * cosf(z) - 1, at.y + 12 * sinf(z) - 1, 3);
    }
    free(knot);
}

/* The milliseconds of the last frames, a pixel each, and the line of 33. */
static void draw_times(struct window *w, double seconds)
{
    const int right = 12 + FRAMES, floor = w->high - 14;
    w->took[w->drawn++ % FRAMES] = seconds;
    for (int k = 0; k < FRAMES && k < w->drawn; k++) {
        const double s = w->took[(w->drawn - 1 - k) % FRAMES];
        ink(w, s > FRAME ? 200 : 70, 70, 70);
        SDL_RenderDrawLine(w->draw, right - k, floor, right - k,
                           floor - 1 - (int)fmin(100.0, 1500.0 * s));
    }
    ink(w, 200, 0, 0);
    SDL_RenderDrawLine(w->draw, 12, floor - 50, right, floor - 50);
    write_text(w, right + 6, floor - 56, "33 ms, without drawing");
}

void window_draw(struct window *w, const struct live *live,
                 const struct live_report *report, double seconds,
                 const char *shot)
{
    char text[CAPTION];
    ink(w, 255, 255, 255);
    SDL_RenderClear(w->draw);
    draw_body(w, live);
    draw_times(w, seconds);
    ink(w, strcmp(report->rung, "lost") == 0 ? 200 : 20, 20, 20);
    caption_of(live, report, seconds, text);
    write_text(w, 12, 12, text);
    if (w->mouse) write_text(w, 12 + 27 * 12, 122, "drag with the mouse");
    snprintf(text, sizeof text, "min J %.2f, %d knots",
             body_min_J(live->body, live->now.u), w->knots);
    write_text(w, 18 + FRAMES, w->high - 36, text);
    SDL_Surface *s = shot ? SDL_CreateRGBSurfaceWithFormat(
        0, w->wide, w->high, 32, SDL_PIXELFORMAT_ARGB8888) : NULL;
    if (shot && (!s || SDL_RenderReadPixels(w->draw, NULL, s->format->format,
                                            s->pixels, s->pitch) != 0 ||
                 SDL_SaveBMP(s, shot) != 0))
        die("%s cannot be written: %s", shot, SDL_GetError());
    SDL_FreeSurface(s);
    SDL_RenderPresent(w->draw);
}
