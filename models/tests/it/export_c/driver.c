/* Calls the library of a model (its name PREFIX, in capitals CAPITAL) for what is asked on the standard input: parameters, senses and
   set, then `at STATE` for every function there, or `from STATE for TIME in STEPS` for its motion, in closed form where there is one. */
#include HEADER
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define JOINED(a, b) a##_##b
#define NAMED(a, b) JOINED(a, b)
#define MODEL(name) NAMED(PREFIX, name)
#define SIZE(name) NAMED(CAPITAL, name)

enum { N = SIZE(COORDINATES), STATE = SIZE(STATE), CONTACTS = SIZE(CONTACTS), ROWS = SIZE(ROWS) };

typedef void (*field)(const void *context, const double *state, double *slope);

static double number(void)
{
    double x;
    if (scanf("%lf", &x) != 1)
        exit(3);
    return x;
}

static void print(const char *name, const double *x, int count)
{
    int i;
    printf("%s", name);
    for (i = 0; i < count; i++)
        printf(" %.17g", x[i]);
    printf("\n");
}

/* Classical Runge-Kutta, of the order 4. */
static void integrate(field slope, const void *context, double *y, int n, double time, int steps)
{
    double k[4][STATE + 1], at[STATE + 1];
    const double h = time/steps;
    int step, i;
    for (step = 0; step < steps; step++) {
        slope(context, y, k[0]);
        for (i = 0; i < n; i++)
            at[i] = y[i] + h/2*k[0][i];
        slope(context, at, k[1]);
        for (i = 0; i < n; i++)
            at[i] = y[i] + h/2*k[1][i];
        slope(context, at, k[2]);
        for (i = 0; i < n; i++)
            at[i] = y[i] + h*k[2][i];
        slope(context, at, k[3]);
        for (i = 0; i < n; i++)
            y[i] += h/6*(k[0][i] + 2*k[1][i] + 2*k[2][i] + k[3][i]);
    }
}

typedef struct {
    MODEL(constants) k;
    int set[CONTACTS + 1];
    const MODEL(phase) *phase;
} motion;

static void in_closed_form(const void *context, const double *state, double *slope)
{
    const motion *m = context;
    m->phase->derivative(&m->k, state, slope);
}

static void of_all_coordinates(const void *context, const double *state, double *slope)
{
    const motion *m = context;
    double multipliers[ROWS + 1];
    int i;
    for (i = 0; i < N; i++)
        slope[i] = state[N + i];
    if (MODEL(accelerations)(&m->k, m->set, state, slope + N, multipliers) == 1)
        exit(4);
    for (i = 2*N; i < STATE; i++)
        slope[i] = i == 2*N && TIMED;
}

static void at(const motion *m, const double *state)
{
    double out[2*(STATE + ROWS + SIZE(POINTS) + SIZE(REACTIONS)) + 1] = {0}, reduced[STATE + 1];
    double accelerations[N + 1] = {0};
    const double status = MODEL(accelerations)(&m->k, m->set, state, accelerations, out);
    print("status", &status, 1);
    print("accelerations", accelerations, N);
    print("multipliers", out, ROWS);
    MODEL(gaps)(&m->k, state, out);
    print("gaps", out, ROWS);
    MODEL(energy)(&m->k, state, out);
    print("energy", out, 2);
    MODEL(points)(&m->k, state, out);
    print("points", out, 2*SIZE(POINTS));
    if (m->phase) {
        m->phase->restriction(state, reduced);
        print("restriction", reduced, m->phase->entries);
        m->phase->derivative(&m->k, reduced, out);
        print("derivative", out, m->phase->entries);
        m->phase->reactions(&m->k, reduced, out);
        print("reactions", out, SIZE(REACTIONS));
        m->phase->embedding(&m->k, reduced, out);
        print("embedding", out, STATE);
    }
    printf("end\n");
}

static void from(const motion *m, double *state)
{
    const double time = number();
    const int steps = (int)number();
    double reduced[STATE + 1], whole[STATE + 1];
    memcpy(whole, state, sizeof whole);
    integrate(of_all_coordinates, m, whole, STATE, time, steps);
    print("whole", whole, STATE);
    if (m->phase) {
        m->phase->restriction(state, reduced);
        integrate(in_closed_form, m, reduced, m->phase->entries, time, steps);
        m->phase->embedding(&m->k, reduced, state);
        print("closed", state, STATE);
    }
    printf("end\n");
}

int main(void)
{
    char word[16];
    while (scanf("%15s", word) == 1) {
        double parameters[sizeof(MODEL(parameters))/sizeof(double) + 1], senses[CONTACTS + 1], state[STATE + 1];
        MODEL(parameters) p;
        motion m;
        int i;
        for (i = 0; i < PARAMETERS; i++)
            parameters[i] = number();
        memcpy(&p, parameters, sizeof p);
        for (i = 0; i < CONTACTS; i++)
            senses[i] = number();
        for (i = 0; i < CONTACTS; i++)
            m.set[i] = (int)number();
        for (i = 0; i < STATE; i++)
            state[i] = number();
        MODEL(constants_of)(&p, senses, &m.k);
        for (m.phase = MODEL(phases); m.phase->name; m.phase++)
            if (!memcmp(m.phase->set, m.set, CONTACTS*sizeof m.set[0]))
                break;
        if (!m.phase->name)
            m.phase = NULL;
        if (strcmp(word, "at") == 0)
            at(&m, state);
        else
            from(&m, state);
    }
    return 0;
}
