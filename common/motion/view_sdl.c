/* view_sdl.c - view.h by SDL2. */
#include "motion/view.h"

#include "base/clock.h"
#include "base/status.h"

#include <SDL.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { FRAMES = 240, WIDE = 10, HIGH = 20 }; /* a letter */
static const double FRAME = 1.0 / 30.0;

struct view {
    SDL_Window *window;
    SDL_Renderer *draw;
    SDL_Texture *letters;
    int wide, high;      /* pixels */
    double scale;        /* pixels per metre */
    double next;         /* when the next frame begins (s) */
    int stopped, closed, drawn;
    char key;            /* the last one, told of until frame `told` */
    int told;
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

/* ' ' to '~' beside each other, white on black: DejaVu Sans Mono. */
static SDL_Texture *letters_load(SDL_Renderer *draw)
{
    SDL_Surface *file = SDL_LoadBMP("common/motion/letters.bmp"), *s = NULL;
    if (file) s = SDL_ConvertSurfaceFormat(file, SDL_PIXELFORMAT_ARGB8888, 0);
    if (!s) die("common/motion/letters.bmp cannot be read: %s", SDL_GetError());
    for (int y = 0; y < s->h; y++) { /* white becomes alpha */
        Uint32 *row = (Uint32 *)(void *)((Uint8 *)s->pixels + y * s->pitch);
        for (int x = 0; x < s->w; x++) row[x] = row[x] << 24 | 0xffffff;
    }
    SDL_Texture *letters = SDL_CreateTextureFromSurface(draw, s);
    SDL_SetTextureBlendMode(letters, SDL_BLENDMODE_BLEND);
    SDL_FreeSurface(file);
    SDL_FreeSurface(s);
    return letters;
}

/* Write lines of text on a plate, for the body may be behind them.  At most 60
 * letters are inside the smallest window.  What the last key has changed,
 * `[key] what it is now`, has a plate of another colour for a second. */
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
    SDL_SetTextureColorMod(v->letters, was.r, was.g, was.b);
    int changed = 0;
    for (int left = x; *text; text++, left += WIDE) {
        const int place = *text - ' ';
        const size_t keys = strcspn(text, "]"); /* [+ -] has two */
        if (*text == '[')
            changed = v->drawn < v->told && keys < 5 &&
                      memchr(text + 1, v->key, keys - 1);
        if (*text == '\n' || strncmp(text, "   ", 3) == 0) changed = 0;
        if (changed) ink(v, 255, 226, 120);
        if (changed) block(v, (float)left, (float)(y - 2), WIDE, HIGH);
        if (*text == '\n') {
            left = x - WIDE;
            y += HIGH;
        }
        if (place > 0 && place < 95)
            SDL_RenderCopy(v->draw, v->letters,
                           &(SDL_Rect){place * WIDE, 0, WIDE, HIGH},
                           &(SDL_Rect){left, y, WIDE, HIGH});
    }
}

struct view *view_open(const char *title, int must)
{
    struct view *v = allocate(1, sizeof *v);
    SDL_setenv("XDG_RUNTIME_DIR", "/", 0); /* else libwayland says something */
    const int open = SDL_Init(SDL_INIT_VIDEO) == 0 &&
                     SDL_CreateWindowAndRenderer(980, 770, SDL_WINDOW_RESIZABLE,
                                                 &v->window, &v->draw) == 0;
    const int seen = open && strcmp(SDL_GetCurrentVideoDriver(), "offscreen");
    if (must && !open) die("there is no window: %s", SDL_GetError());
    if (must && !seen) die("there is no window, because there is no display");
    if (!seen) return SDL_Quit(), free(v), NULL;
    v->letters = letters_load(v->draw);
    SDL_SetWindowTitle(v->window, title);
    SDL_SetWindowMinimumSize(v->window, 640, 480);
    return v;
}

void view_close(struct view *v) { SDL_Quit(), free(v); }

int view_next(struct view *v, const char *keys, struct pointer *pointer)
{
    int x, y, pressed = 0; /* also if only while a late frame was computed */
    pointer->key = '.';
    do {
        SDL_Event event; /* a second key waits for the next frame */
        while ((v->stopped || pointer->key == '.') &&
               SDL_PollEvent(&event)) {
            if (event.type == SDL_QUIT) v->closed = 1;
            pressed |= event.type == SDL_MOUSEBUTTONDOWN &&
                       event.button.button == SDL_BUTTON_LEFT;
            if (event.type != SDL_KEYDOWN || event.key.repeat) continue;
            SDL_Keycode code = event.key.keysym.sym;
            if (code == SDLK_SPACE) v->stopped = !v->stopped;
            if (code == SDLK_ESCAPE || code == SDLK_q) v->closed = 1;
            if (code == SDLK_EQUALS || code == SDLK_KP_PLUS) code = '+';
            if (code == SDLK_KP_MINUS) code = '-'; /* + is often on = */
            if (code > ' ' && code < 127 && strchr(keys, code)) {
                pointer->key = v->key = (char)code;
                v->told = v->drawn + 30;
            }
        }
        const double now = clock_seconds();
        if (v->next > now) SDL_Delay((Uint32)(1e3 * (v->next - now)));
        v->next = fmax(v->next, now - FRAME) + FRAME;
    } while (v->stopped && !v->closed);
    pointer->down = (SDL_GetMouseState(&x, &y) & SDL_BUTTON_LMASK) || pressed;
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

/* Draw arrows three pixels wide, with a block as head; the curve has two. */
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
    ink(v, 20, 20, 20);
    write_text(v, 18 + FRAMES, v->high - 46, p->note);
    ink(v, p->alarm ? 200 : 20, 20, 20);
    write_text(v, 12, 12, p->caption);
    SDL_Surface *s = shot ? SDL_CreateRGBSurfaceWithFormat(
        0, v->wide, v->high, 32, SDL_PIXELFORMAT_ARGB8888) : NULL;
    if (shot && (!s || SDL_RenderReadPixels(v->draw, NULL, s->format->format,
                                            s->pixels, s->pitch) != 0 ||
                 SDL_SaveBMP(s, shot) != 0))
        die("%s cannot be written: %s", shot, SDL_GetError());
    SDL_FreeSurface(s);
    SDL_RenderPresent(v->draw);
}
