// Chooses a solver by its number. In GLSL the number is a compile-time constant, so the branch
// folds away.

// Numbers are stored in files: append, never renumber. solver_table.h holds their names.
const int solver_none = -1;  // takes the start for a root: what all but the solving costs
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
const int solver_sturm_adaptive = 11;

// The first root of f in [low, high]; the position error of a Newton method is about the square of
// the tolerance, relative to the curve. Solvers that need more than a polynomial find none here.
Root first_root(Polynomial f, Search search, int solver) {
    if (solver == solver_none) {
        return search.low < search.high ? root_at(search.low, 0) : no_root(search.low, 0);
    }
    if (solver == solver_convexity_split) {
        return first_root_convexity_split(f, search);
    }
    if (solver == solver_newton || solver == solver_newton_forward) {
        return first_root_newton(f, search, solver == solver_newton_forward);
    }
    if (solver == solver_newton_fine) {
        // The paper's 0.00003 against its 0.001.
        search.tolerance = real(0.03) * search.tolerance;
        return first_root_newton(f, search, false);
    }
    if (solver == solver_sturm || solver == solver_sturm_adaptive) {
        return first_root_sturm(f, search, solver == solver_sturm_adaptive);
    }
    if (solver == solver_double_derivative_bisection) {
        return first_root_double_derivative_bisection(f, search);
    }
    if (solver == solver_analytic) {
        return first_root_analytic(f, search);
    }
    if (solver == solver_bracketed) {
        return first_root_bracketed(f, search);
    }
    return no_root(search.low, 0);
}
