// Chooses a solver by its number. In GLSL the number is a compile-time constant, so the branch
// folds away.

// Numbers are stored in files: append, never renumber. solver_table.h holds their names.
const int solver_convexity_split = 1;
const int solver_newton = 2;
const int solver_newton_fine = 3;
const int solver_newton_forward = 4;
const int solver_sturm = 5;
const int solver_double_derivative_bisection = 6;
const int solver_sphere_tracing = 7;          // of a shape's distance: see torus.glsl
const int solver_sphere_tracing_two_ray = 8;  // the same
const int solver_analytic = 9;
const int solver_bracketed = 10;

// The first root of f in [low, high]; the position error of a Newton method is about the square of
// the tolerance, relative to the curve. Solvers that need more than a quartic find none here.
Root first_root(Quartic f, Search search, int solver) {
    Root root;
    root.found = false;
    root.t = search.low;
    if (solver == solver_convexity_split) {
        root = first_root_convexity_split(f, search);
    }
    if (solver == solver_newton || solver == solver_newton_forward) {
        root = first_root_newton(f, search, solver == solver_newton_forward);
    }
    if (solver == solver_newton_fine) {
        // The paper's 0.00003 against its 0.001.
        search.tolerance = real(0.03) * search.tolerance;
        root = first_root_newton(f, search, false);
    }
    if (solver == solver_sturm) {
        root = first_root_sturm(f, search);
    }
    if (solver == solver_double_derivative_bisection) {
        root = first_root_double_derivative_bisection(f, search);
    }
    if (solver == solver_analytic) {
        root = first_root_analytic(f, search);
    }
    if (solver == solver_bracketed) {
        root = first_root_bracketed(f, search);
    }
    return root;
}
