/* Fills constants. senses: of each contact that slides the sigma of R = -sigma*mu*N, 1 where it slides along its tangent, -1 where
   against it, the opposite at a guide that presses to its negative side; 0 of all others. Without friction it is not read. */
void model_constants_of(const model_parameters *p, const double *senses, model_constants *k);

/* Gaps of the rows: of contacts 0 where they are closed, of joints what they keep 0, of slips nothing. */
void model_gaps(const model_constants *k, const double *state, double *out);
/* Kinetic and potential energy. */
void model_energy(const model_constants *k, const double *state, double *out);
/* x and y of each point. */
void model_points(const model_constants *k, const double *state, double *out);

/* The equations of motion: mass*acceleration = force + the sum of jacobian^T*multiplier over the rows that hold, of which each keeps
   jacobian*acceleration + bias = 0. The rate of a gap is jacobian*rates + drift; friction is sigma*mu of a slip. */
typedef struct {
    double mass[MODEL_COORDINATES][MODEL_COORDINATES];
    double force[MODEL_COORDINATES];
    double gap[MODEL_ROWS + 1];
    double jacobian[MODEL_ROWS + 1][MODEL_COORDINATES];
    double bias[MODEL_ROWS + 1];
    double drift[MODEL_ROWS + 1];
    double friction[MODEL_ROWS + 1];
} model_equations;
void model_equations_of(const model_constants *k, const double *state, model_equations *e);

/* The motion in any contact set: accelerations of the coordinates, and the multiplier of each row, which is the reaction of a contact,
   the force of a joint, the friction force of a slip. set: of each contact 0 where it is open, 1 where it is closed, 2 where it is
   closed and slides. Returns 0; 2 where the multipliers are not unique, as of supports more than are needed, of which those that can be
   are 0 then; 1 where there is no motion. */
int model_accelerations(const model_constants *k, const int *set, const double *state, double *acceleration,
    double *multiplier);

/* A contact set in closed form: functions of a state that has fewer entries. */
typedef struct {
    /* The closed contacts by name; NULL behind the last of all. */
    const char *name;
    /* As for model_accelerations. */
    const int *set;
    /* How many entries its state has. */
    int entries;
    /* Its state, of a full one. */
    void (*restriction)(const double *state, double *out);
    /* The time derivative of its state. */
    void (*derivative)(const model_constants *k, const double *state, double *out);
    /* Reactions of all contacts, 0 of open ones, then the friction forces of those with friction. */
    void (*reactions)(const model_constants *k, const double *state, double *out);
    /* The full state. */
    void (*embedding)(const model_constants *k, const double *state, double *out);
} model_phase;

extern const model_phase model_phases[];
extern const char *const model_coordinate_names[];
extern const char *const model_contact_names[];

