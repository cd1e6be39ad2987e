/* view_sdl.c - view.h by SDL2. */
#include "motion/view.h"

#include "base/clock.h"
#include "base/status.h"

#include <SDL.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { FRAMES = 240, WIDE = 12, HIGH = 22 }; /* a letter's room */
static const double FRAME = 1.0 / 30.0;

struct view {
    SDL_Window *window;
    SDL_Renderer *draw;
    int wide, high;      /* pixels */
    double scale;        /* pixels per metre */
    double next;         /* when the next frame begins (s) */
    int stopped, closed, drawn;
    double took[FRAMES]; /* seconds per frame, in a ring */
};

static void ink(struct view *v, Uint8 red, Uint8 green, Uint8 blue)
{
    SDL_SetRenderDrawColor(v->draw, red, green, blue, 255);
}

static void block(struct view *v, float x, float y, float wide, float high)
{
    SDL_RenderFillRectF(v->draw, &(SDL_FRect){x, y, wide, high});
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

/* Lines of text on a plate, for the body may be behind them.  At most 50
 * letters are inside the smallest window. */
static void write_text(struct view *v, int x, int y, const char *text)
{
    int longest = 0, lines = 1, letters = 0;
    for (const char *c = text; *c; c++) {
        letters = *c == '\n' ? 0 : letters + 1;
        lines += *c == '\n';
        if (letters > longest) longest = letters;
    }
    SDL_Color was;
    SDL_GetRenderDrawColor(v->draw, &was.r, &was.g, &was.b, &was.a);
    ink(v, 255, 255, 255);
    block(v, (float)(x - 4), (float)(y - 4), (float)(longest * WIDE + 8),
          (float)(lines * HIGH));
    ink(v, was.r, was.g, was.b);
    for (int at = x; *text; text++, at += WIDE) {
        const char c = *text;
        if (c == '\n') {
            at = x - WIDE;
            y += HIGH;
        }
        if (c < ' ' || c > 'z') continue;
        for (int column = 0; column < 5; column++) /* from the right */
            for (int row = 0; row < 8; row++)
                if (LETTER[c - ' '] >> (8 * column + row) & 1)
                    block(v, (float)(at + 8 - 2 * column),
                          (float)(y + 2 * row), 2, 2);
    }
}

struct view *view_open(const char *title)
{
    struct view *v = allocate(1, sizeof *v);
    if (SDL_Init(SDL_INIT_VIDEO) != 0 ||
        SDL_CreateWindowAndRenderer(980, 770, SDL_WINDOW_RESIZABLE, &v->window,
                                    &v->draw) != 0)
        die("there is no window: %s", SDL_GetError());
    if (strcmp(SDL_GetCurrentVideoDriver(), "offscreen") == 0)
        die("there is no window, because there is no display");
    SDL_SetWindowTitle(v->window, title);
    SDL_SetWindowMinimumSize(v->window, 640, 480);
    return v;
}

void view_close(struct view *v) { SDL_Quit(), free(v); }

int view_next(struct view *v, const char *keys, struct pointer *pointer)
{
    int x, y;
    pointer->key = '.';
    do {
        SDL_Event event;
        while (SDL_PollEvent(&event)) {
            if (event.type == SDL_QUIT) v->closed = 1;
            if (event.type != SDL_KEYDOWN || event.key.repeat) continue;
            SDL_Keycode code = event.key.keysym.sym;
            if (code == SDLK_SPACE) v->stopped = !v->stopped;
            if (code == SDLK_ESCAPE || code == SDLK_q) v->closed = 1;
            if (code == SDLK_EQUALS || code == SDLK_KP_PLUS) code = '+';
            if (code == SDLK_KP_MINUS) code = '-'; /* + is often on = */
            if (code > ' ' && code < 127 && strchr(keys, code))
                pointer->key = (char)code;
        }
        const double now = clock_seconds();
        if (v->next > now) SDL_Delay((Uint32)(1e3 * (v->next - now)));
        v->next = fmax(v->next, now - FRAME) + FRAME;
    } while (v->stopped && !v->closed);
    pointer->down = (SDL_GetMouseState(&x, &y) & SDL_BUTTON_LMASK) != 0;
    SDL_GetRendererOutputSize(v->draw, &v->wide, &v->high);
    v->scale = fmin(v->wide / 5.6, v->high / 4.4);
    pointer->x = (x - 0.5 * v->wide) / v->scale;
    pointer->y = (0.5 * v->high - y) / v->scale;
    return !v->closed;
}

static SDL_FPoint pixel(const struct view *v, const double x[2])
{
    return (SDL_FPoint){(float)(0.5 * v->wide + v->scale * x[0]),
                        (float)(0.5 * v->high - v->scale * x[1])};
}

static SDL_Color colour(double value)
{
    if (!(value > 0.0)) return (SDL_Color){214, 0, 190, 255};
    const double s = fmax(-1.0, fmin(1.0, log2(value))), t = fabs(s), w = 250.0;
    const double *c = (double[2][3]){{33, 102, 196}, {235, 120, 20}}[s > 0.0];
    return (SDL_Color){(Uint8)(w + t * (c[0] - w)), (Uint8)(w + t * (c[1] - w)),
                       (Uint8)(w + t * (c[2] - w)), 255};
}

static void draw_body(struct view *v, const struct view_picture *p)
{
    for (int k = 0; k < 2 * p->n_triangle; k++) { /* the inverted ones last */
        const int e = k % p->n_triangle;
        if ((p->value[e] > 0.0) != (k < p->n_triangle)) continue;
        SDL_Vertex corner[3];
        SDL_FPoint line[4];
        for (int a = 0; a < 4; a++) {
            line[a] = pixel(v, &p->x[2 * p->triangle[3 * e + a % 3]]);
            corner[a % 3] = (SDL_Vertex){line[a], colour(p->value[e]), {0, 0}};
        }
        SDL_RenderGeometry(v->draw, NULL, corner, 3, NULL, 0);
        ink(v, 120, 120, 120);
        if (p->n_triangle <= 2048) SDL_RenderDrawLinesF(v->draw, line, 4);
    }
    for (int a = 0; a < p->n_point; a++) {
        const SDL_FPoint at = pixel(v, &p->x[2 * a]);
        ink(v, 20, 20, 20);
        if (p->held && p->held[a]) block(v, at.x - 2, at.y - 2, 5, 5);
        ink(v, 200, 0, 0);
        if (!p->ring || !p->ring[a]) continue;
        for (float z = 0; z < 6.28F; z += 0.13F)
            block(v, at.x + 12 * cosf(z) - 1, at.y + 12 * sinf(z) - 1, 3, 3);
    }
}

/* Arrows three pixels wide, with a block as head; the curve has two. */
static void draw_arrows(struct view *v, const struct view_picture *p)
{
    ink(v, 20, 20, 20);
    for (int k = 0; k < p->n_arrow; k++) {
        const SDL_FPoint a = pixel(v, &p->arrow[k][0]);
        const SDL_FPoint b = pixel(v, &p->arrow[k][2]);
        for (float i = -1; i <= 1; i++) {
            SDL_RenderDrawLineF(v->draw, a.x + i, a.y, b.x + i, b.y);
            SDL_RenderDrawLineF(v->draw, a.x, a.y + i, b.x, b.y + i);
        }
        block(v, b.x - 4, b.y - 4, 9, 9);
    }
    for (int k = 0; k + 1 < p->n_curve; k++) {
        const SDL_FPoint a = pixel(v, &p->curve[2 * k]);
        const SDL_FPoint b = pixel(v, &p->curve[2 * k + 2]);
        for (float i = 0; i <= 1; i++)
            SDL_RenderDrawLineF(v->draw, a.x, a.y + i, b.x, b.y + i);
    }
}

/* The milliseconds of the last frames, a pixel each, and the line of 33. */
static void draw_times(struct view *v, double seconds)
{
    const int right = 12 + FRAMES, floor = v->high - 14;
    v->took[v->drawn++ % FRAMES] = seconds;
    for (int k = 0; k < FRAMES && k < v->drawn; k++) {
        const double s = v->took[(v->drawn - 1 - k) % FRAMES];
        ink(v, s > FRAME ? 200 : 70, 70, 70);
        SDL_RenderDrawLine(v->draw, right - k, floor, right - k,
                           floor - 1 - (int)fmin(100.0, 1500.0 * s));
    }
    ink(v, 200, 0, 0);
    SDL_RenderDrawLine(v->draw, 12, floor - 50, right, floor - 50);
    write_text(v, right + 6, floor - 56, "33 ms, without drawing");
}

void view_draw(struct view *v, const struct view_picture *p, double seconds,
               const char *shot)
{
    ink(v, 255, 255, 255);
    SDL_RenderClear(v->draw);
    draw_body(v, p);
    draw_arrows(v, p);
    draw_times(v, seconds);
    ink(v, p->alarm ? 200 : 20, 20, 20);
    write_text(v, 12, 12, p->caption);
    write_text(v, 18 + FRAMES, v->high - 36, p->note);
    SDL_Surface *s = shot ? SDL_CreateRGBSurfaceWithFormat(
        0, v->wide, v->high, 32, SDL_PIXELFORMAT_ARGB8888) : NULL;
    if (shot && (!s || SDL_RenderReadPixels(v->draw, NULL, s->format->format,
                                            s->pixels, s->pitch) != 0 ||
                 SDL_SaveBMP(s, shot) != 0))
        die("%s cannot be written: %s", shot, SDL_GetError());
    SDL_FreeSurface(s);
    SDL_RenderPresent(v->draw);
}
