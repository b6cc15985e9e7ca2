// Where a ray meets a torus segment: its wall within the arc, and the caps of its ends.

// The first crossing with what lies in [low, high] between two cuts, the end planes where they cut:
// cap, wall, cap.
Crossing first_crossing(Torus torus, Ray line, Span cut, int open_ends, int solver) {
    Crossing crossing;
    crossing.found = false;
    crossing.t = cut.enter;
    crossing.face = cut.enter_face;
    if (cut.enter >= cut.exit) {
        return crossing;
    }
    if (cut.enter_face > 0 && is_drawn(cut.enter_face, open_ends) &&
        is_inside(torus, at(line, cut.enter))) {
        crossing.found = true;
        return crossing;
    }
    Root root = first_wall_root(torus, line.origin, line.direction, cut.enter, cut.exit, solver);
    crossing.found = root.found;
    crossing.t = root.t;
    crossing.face = 0;
    if (!root.found && cut.exit_face > 0 && is_drawn(cut.exit_face, open_ends)) {
        crossing.found = is_inside(torus, at(line, cut.exit));
        crossing.t = cut.exit;
        crossing.face = cut.exit_face;
    }
    return crossing;
}

Hit hit(Torus torus, Ray ray, int open_ends, int solver) {
    // The same line with a unit direction, measured from its point closest to the centre.
    real speed = length(ray.direction);
    Ray line;
    line.direction = ray.direction / speed;
    real shift = dot(ray.origin, line.direction);
    line.origin = ray.origin - shift * line.direction;
    line.first = ray.first * speed + shift;

    real outer = torus.bend_radius + torus.radius + quartic_slack(torus);
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
    Crossing crossing =
        first_crossing(torus, line, between(sector.part_0, low, reach, 0), open_ends, solver);
    if (!crossing.found) {
        crossing =
            first_crossing(torus, line, between(sector.part_1, low, reach, 0), open_ends, solver);
    }
    if (!crossing.found) {
        return miss();
    }
    vec3 normal = from_spine(torus, at(line, crossing.t));
    if (crossing.face > 0) {
        normal = end(torus, crossing.face - 1).normal;
    }
    Hit result = hit_at(line, crossing.t, normal);
    result.t = (crossing.t - shift) / speed;
    return result;
}
