// Chooses a solver by its number. In GLSL the number is a compile-time constant, so the branch
// folds away.

// Numbers are stored in files: append, never renumber. solver_table.h holds their names.
const int solver_convexity_split = 1;

// The first root of f in [low, high]; the position error is about the square of the tolerance,
// relative to the curve.
Root first_root(Quartic f, real low, real high, real tolerance, int solver) {
    Root root;
    root.found = false;
    root.t = low;
    if (solver == solver_convexity_split) {
        root = first_root_convexity_split(f, low, high, tolerance);
    }
    return root;
}
