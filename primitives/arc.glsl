// What parts of rings share: a sector of angles from +x counter-clockwise around the local z axis.

// The part of a line whose points have their angle in [0, arc]: one interval up to half a turn,
// else what the remaining sector leaves, two.
struct Sector {
    Span part_0;
    Span part_1;  // empty up to half a turn
};

// The forms of a sector: up to half a turn, more, and all of it, without ends; the last also for
// rays that are known to start outside the solid. The GPU has a program for each.
const int arc_narrow = 0;
const int arc_wide = 1;
const int arc_whole = 2;
const int arc_whole_from_outside = 3;

// The ends of a sector: all that a ray needs to know of it.
struct ArcEnds {
    vec4 planes;  // their inward normals, (n_0.x, n_0.y, n_1.x, n_1.y)
    int form;
    int open;         // as hit()'s open_ends
    bool nears_axis;  // the solid's inner side is near the z axis
};

// The overlaps turn the planes outwards by angles, so that joints are tight.
ArcEnds arc_ends(real arc, real overlap_0, real overlap_1, int open_ends) {
    real last = arc + overlap_1;
    real widened = last + overlap_0;
    ArcEnds ends;
    ends.open = open_ends;
    ends.nears_axis = false;
    ends.planes = vec4(sin(overlap_0), cos(overlap_0), sin(last), -cos(last));
    ends.form = widened <= pi() ? arc_narrow : (widened < real(2) * pi() ? arc_wide : arc_whole);
    return ends;
}

// The end whose plane a point of it belongs to, as a face; at half a turn both ends lie in one
// plane.
int face_of_end(vec2 p, vec4 planes) {
    return dot(p, vec2(planes.y + planes.w, -planes.x - planes.z)) >= real(0) ? 1 : 2;
}

// The span with the faces of the ends that its limits lie on.
Span with_end_faces(Span span, vec3 o, vec3 d, vec4 planes) {
    if (span.enter > -huge) {
        span.enter_face = face_of_end(vec2(o + span.enter * d), planes);
    }
    if (span.exit < huge) {
        span.exit_face = face_of_end(vec2(o + span.exit * d), planes);
    }
    return span;
}

Sector in_sector(vec3 o, vec3 d, ArcEnds ends) {
    Sector sector;
    sector.part_0 = whole_line();
    sector.part_1 = empty_span();
    if (ends.form >= arc_whole) {
        return sector;
    }
    vec4 planes = ends.planes;
    vec2 depths = vec2(planes.x * o.x + planes.y * o.y, planes.z * o.x + planes.w * o.y);
    vec2 rates = vec2(planes.x * d.x + planes.y * d.y, planes.z * d.x + planes.w * d.y);
    // Beyond half a turn the gap is the smaller sector, with the same planes seen from behind.
    real side = ends.form == arc_narrow ? real(1) : real(-1);
    Span part = below_plane(whole_line(), side * depths.x, side * rates.x, 1);
    part = below_plane(part, side * depths.y, side * rates.y, 2);
    if (ends.form == arc_narrow) {
        sector.part_0 = with_end_faces(part, o, d, planes);
    } else if (part.enter < part.exit) {
        part = with_end_faces(part, o, d, planes);
        sector.part_0 = between(whole_line(), -huge, part.enter, part.enter_face);
        sector.part_1 = between(whole_line(), part.exit, huge, part.exit_face);
    }
    return sector;
}

// The tight box, in the plane, of the sector between two radii: (low.x, low.y, high.x, high.y).
vec4 sector_box(real inner, real outer, real arc) {
    vec2 last = vec2(cos(arc), sin(arc));
    vec2 low = min(vec2(inner, 0), min(inner * last, outer * last));
    vec2 high = max(vec2(outer, 0), max(inner * last, outer * last));
    if (arc > real(0.5) * pi()) {
        high.y = outer;
    }
    if (arc > pi()) {
        low.x = -outer;
    }
    if (arc > real(1.5) * pi()) {
        low.y = -outer;
    }
    return vec4(low.x, low.y, high.x, high.y);
}

// Rings of a proxy along an arc: one at each end and one every 22.5 degrees at the most.
int arc_rings(real arc) {
    return 1 + max(1, int(ceil(arc / (pi() / real(8)) - real(0.01))));
}

// Maps a corner of a ring's section, (distance from the z axis, height), to a proxy's ring around
// the arc. The end rings step outwards by the margin; the others lie on the outer radius divided by
// the cosine of half a step.
vec3 arc_hull_point(vec2 corner, real arc, int rings, int ring, real margin) {
    real step_angle = arc / real(rings - 1);
    real angle = step_angle * real(ring);
    real widening = real(1) / cos(real(0.5) * step_angle);
    real rho = max(real(0), corner.x) * widening;
    vec3 p =
        polar(rho, angle,
              -corner.y);  // turned over: seen from ring 0 the corners run as in straight shapes
    real step_out = arc >= real(2) * pi()
                        ? real(0)
                        : (ring == 0 ? -margin : (ring == rings - 1 ? margin : real(0)));
    return p + step_out * vec3(-sin(angle), cos(angle), 0);
}
