// Where a ray meets a torus segment: its wall within the arc, and the caps of its ends.

// A crossing and what it cost.
struct TorusCrossing {
    Crossing at;
    int steps;
};

Search wall_search(Torus torus, Ray line, Span cut, ArcEnds ends, int solver) {
    Search search;
    search.low = cut.enter;
    search.high = cut.exit;
    search.tolerance = last_step() * torus.radius;
    search.scale = torus.bend_radius + torus.radius;
    search.resolution = line.pixel;
    search.starts_above = ends.form == arc_whole_from_outside;
    if (is_exact(solver) && ends.nears_axis) {
        // Where the tube nearly meets the axis it bends far more sharply than its radius says.
        search.tolerance =
            last_step() * clamp(length(line.origin), real(0.001) * torus.radius, torus.radius);
    }
    return search;
}

// Whether the cap that a cut lies on is seen there. The wall's own quartic says so: a rim where cap
// and wall round differently would let rays through.
bool meets_cap(Polynomial f, real t, int face, ArcEnds ends) {
    f.as_squares = true;
    return face > 0 && is_drawn(face, ends.open) && value_at(f, t) < real(0);
}

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
    Polynomial f = torus_quartic(torus, line, ends.nears_axis, solver);
    if (meets_cap(f, cut.enter, cut.enter_face, ends)) {
        crossing.at.found = true;
        return crossing;
    }
    Search search = wall_search(torus, line, cut, ends, solver);
    Root root = first_wall_root(torus, f, line, search, solver);
    crossing.steps = root.steps;
    crossing.at.found = root.found;
    crossing.at.t = root.t;
    crossing.at.face = 0;
    if (!root.found && meets_cap(f, cut.exit, cut.exit_face, ends)) {
        crossing.at.found = true;
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

    // A little more than the sphere around the torus, or a ray that enters both in one place would
    // seem to start inside.
    real outer = real(1.0001) * (torus.bend_radius + torus.radius);
    real room = outer * outer - dot(line.origin, line.origin);
    if (room < real(0)) {
        return miss();
    }
    real reach = sqrt(room);
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
