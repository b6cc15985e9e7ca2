// Sphere tracing of a torus: it needs the distance from the wall, not the quartic.

// Steps of marching; along a silhouette they become ever shorter.
const int marching_steps_max = 128;

// Marches by the distance from the wall: Hart 1996, "Sphere tracing", as in de Toledo, Levy, Paul
// 2007, section 4.3. With two starts the march goes on from the place nearest to the centre once
// the distance grows. It stops beside the wall, so that a silhouette is fatter by the tolerance.
Root march(Torus torus, Ray line, Search search, bool two_starts) {
    Root root = no_root(search.low, 0);
    real before = huge;
    for (int i = 0; i < marching_steps_max; ++i) {
        root.steps = i + 1;
        real distance = abs(length(from_spine(torus, at(line, root.t))) - torus.radius);
        if (distance < search.tolerance) {
            root.found = root.t <= search.high;
            return root;
        }
        bool restarts = two_starts && distance > before && root.t < real(0);
        before = restarts ? huge : distance;
        root.t = restarts ? real(0) : root.t + distance;
        if (root.t > search.high) {
            return root;
        }
    }
    return root;
}
