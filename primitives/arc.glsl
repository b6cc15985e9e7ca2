// What parts of rings share: a sector of angles from +x counter-clockwise around the local z axis.

// The part of a line whose points have their angle in [0, arc]: one interval up to half a turn,
// else what the remaining sector leaves, two. The overlaps turn the end planes outwards by angles,
// so that joints are tight.
struct Sector {
    Span part_0;
    Span part_1;  // empty up to half a turn
};

// The end whose plane a point of it belongs to, as a face; at half a turn both ends lie in one
// plane.
int face_of_end(vec2 p, real arc) {
    return dot(p, vec2(real(1) - cos(arc), -sin(arc))) >= real(0) ? 1 : 2;
}

// The span with the faces of the ends that its limits lie on.
Span with_end_faces(Span span, vec3 o, vec3 d, real arc) {
    if (span.enter > -huge) {
        span.enter_face = face_of_end(vec2(o + span.enter * d), arc);
    }
    if (span.exit < huge) {
        span.exit_face = face_of_end(vec2(o + span.exit * d), arc);
    }
    return span;
}

Sector in_sector(vec3 o, vec3 d, real arc, real overlap_0, real overlap_1) {
    Sector sector;
    sector.part_0 = whole_line();
    sector.part_1 = empty_span();
    real widened = arc + overlap_0 + overlap_1;
    if (widened >= real(2) * pi()) {
        return sector;
    }
    // Inward normals of the end planes.
    vec2 n_0 = vec2(sin(overlap_0), cos(overlap_0));
    vec2 n_1 = vec2(sin(arc + overlap_1), -cos(arc + overlap_1));
    real depth_0 = dot(n_0, vec2(o));
    real depth_1 = dot(n_1, vec2(o));
    real rate_0 = dot(n_0, vec2(d));
    real rate_1 = dot(n_1, vec2(d));
    if (widened <= pi()) {
        sector.part_0 = below_plane(sector.part_0, depth_0, rate_0, 1);
        sector.part_0 = below_plane(sector.part_0, depth_1, rate_1, 2);
        sector.part_0 = with_end_faces(sector.part_0, o, d, arc);
        return sector;
    }
    Span gap = below_plane(whole_line(), -depth_0, -rate_0, 1);
    gap = below_plane(gap, -depth_1, -rate_1, 2);
    if (gap.enter < gap.exit) {
        gap = with_end_faces(gap, o, d, arc);
        sector.part_0 = between(whole_line(), -huge, gap.enter, gap.enter_face);
        sector.part_1 = between(whole_line(), gap.exit, huge, gap.exit_face);
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

// Rings of a proxy along an arc: one at each end and one every 30 degrees at the most.
int arc_rings(real arc) {
    return 1 + max(1, int(ceil(arc / (pi() / real(6)) - real(0.01))));
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
