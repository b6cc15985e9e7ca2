// Where a ray meets a torus segment: its wall within the arc, and the caps of its ends.

// A crossing and what it cost.
struct TorusCrossing {
    Crossing at;
    int steps;
};

// The first crossing with what lies between two cuts, the end planes where they cut: cap, wall,
// cap.
TorusCrossing first_crossing(Torus torus, Ray line, Span cut, ArcEnds ends, int solver) {
    TorusCrossing crossing;
    crossing.at.found = false;
    crossing.at.t = cut.enter;
    crossing.at.face = cut.enter_face;
    crossing.steps = 0;
    if (cut.enter >= cut.exit) {
        return crossing;
    }
    if (cut.enter_face > 0 && is_drawn(cut.enter_face, ends.open) &&
        is_inside(torus, at(line, cut.enter))) {
        crossing.at.found = true;
        return crossing;
    }
    Root root = first_wall_root(torus, line, cut, ends, solver);
    crossing.steps = root.steps;
    crossing.at.found = root.found;
    crossing.at.t = root.t;
    crossing.at.face = 0;
    if (!root.found && cut.exit_face > 0 && is_drawn(cut.exit_face, ends.open)) {
        crossing.at.found = is_inside(torus, at(line, cut.exit));
        crossing.at.t = cut.exit;
        crossing.at.face = cut.exit_face;
    }
    return crossing;
}

// By which angle an open end's wall goes on.
real end_overlap(Torus torus, int open_ends, int index) {
    return is_open(open_ends, index) ? joint_overlap(torus.radius, real(0)) / torus.bend_radius
                                     : real(0);
}

// What hit() needs of the shape alone: the GPU calculates it once for each vertex.
ArcEnds prepare(Torus torus, int open_ends) {
    ArcEnds ends = arc_ends(torus.arc, end_overlap(torus, open_ends, 0),
                            end_overlap(torus, open_ends, 1), open_ends);
    ends.nears_axis = torus.bend_radius < real(1.3) * torus.radius;
    return ends;
}

Hit hit_prepared(Torus torus, ArcEnds ends, Ray ray, int solver) {
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
    Sector sector = in_sector(line.origin, line.direction, ends);
    real low = max(-reach, line.first);
    TorusCrossing crossing;
    crossing.at.found = false;
    int steps = 0;
    int parts = ends.form == arc_wide ? 2 : 1;
    for (int part = 0; part < parts; ++part) {
        if (!crossing.at.found) {
            Span cut = part == 0 ? sector.part_0 : sector.part_1;
            crossing = first_crossing(torus, line, between(cut, low, reach, 0), ends, solver);
            steps = steps + crossing.steps;
        }
    }
    Hit result = miss();
    if (crossing.at.found) {
        vec3 normal = from_spine(torus, at(line, crossing.at.t));
        if (crossing.at.face > 0) {
            normal = crossing.at.face == 1 ? vec3(-ends.planes.x, -ends.planes.y, 0)
                                           : vec3(-ends.planes.z, -ends.planes.w, 0);
        }
        result = hit_at(line, crossing.at.t, normal);
        result.t = (crossing.at.t - shift) / speed;
    }
    result.steps = steps;
    return result;
}

Hit hit(Torus torus, Ray ray, int open_ends, int solver) {
    return hit_prepared(torus, prepare(torus, open_ends), ray, solver);
}
