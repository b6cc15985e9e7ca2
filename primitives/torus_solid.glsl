// Where a ray meets a torus segment: its wall within the arc, and the caps of its ends.

// A crossing and what it cost.
struct TorusCrossing {
    Crossing at;
    int steps;
};

// The first crossing with what lies between two cuts, the end planes where they cut: cap, wall,
// cap.
TorusCrossing first_crossing(Torus torus, Ray line, Span cut, int open_ends, int solver) {
    TorusCrossing crossing;
    crossing.at.found = false;
    crossing.at.t = cut.enter;
    crossing.at.face = cut.enter_face;
    crossing.steps = 0;
    if (cut.enter >= cut.exit) {
        return crossing;
    }
    if (cut.enter_face > 0 && is_drawn(cut.enter_face, open_ends) &&
        is_inside(torus, at(line, cut.enter))) {
        crossing.at.found = true;
        return crossing;
    }
    Root root = first_wall_root(torus, line, cut.enter, cut.exit, solver);
    crossing.steps = root.steps;
    crossing.at.found = root.found;
    crossing.at.t = root.t;
    crossing.at.face = 0;
    if (!root.found && cut.exit_face > 0 && is_drawn(cut.exit_face, open_ends)) {
        crossing.at.found = is_inside(torus, at(line, cut.exit));
        crossing.at.t = cut.exit;
        crossing.at.face = cut.exit_face;
    }
    return crossing;
}

Hit hit(Torus torus, Ray ray, int open_ends, int solver) {
    // The same line with a unit direction, measured from its point closest to the centre.
    real speed = length(ray.direction);
    Ray line = ray;
    line.direction = ray.direction / speed;
    real shift = dot(ray.origin, line.direction);
    line.origin = ray.origin - shift * line.direction;
    line.first = ray.first * speed + shift;

    real outer = torus.bend_radius + torus.radius;
    real room = outer * outer - dot(line.origin, line.origin);
    if (room < real(0)) {
        return miss();
    }
    real reach = real(1.00001) * sqrt(room);
    real turn = joint_overlap(torus.radius, real(0)) / torus.bend_radius;
    Sector sector =
        in_sector(line.origin, line.direction, torus.arc, is_open(open_ends, 0) ? turn : real(0),
                  is_open(open_ends, 1) ? turn : real(0));
    real low = max(-reach, line.first);
    TorusCrossing crossing;
    int steps = 0;
    bool again = true;
    for (int part = 0; part < 2 && again; ++part) {
        Span cut = part == 0 ? sector.part_0 : sector.part_1;
        crossing = first_crossing(torus, line, between(cut, low, reach, 0), open_ends, solver);
        steps = steps + crossing.steps;
        again = !crossing.at.found && sector.part_1.enter < sector.part_1.exit;
    }
    Hit result = miss();
    if (crossing.at.found) {
        vec3 normal = from_spine(torus, at(line, crossing.at.t));
        if (crossing.at.face > 0) {
            normal = end(torus, crossing.at.face - 1).normal;
        }
        result = hit_at(line, crossing.at.t, normal);
        result.t = (crossing.at.t - shift) / speed;
    }
    result.steps = steps;
    return result;
}
