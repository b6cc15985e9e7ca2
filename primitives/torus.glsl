// An elbow: a tube around a circle in the local xy plane, from +x through arc; end 0 faces -y, end
// 1 is at the arc.
//
// A ring (arc of a full turn) has no ends. The tube may touch the axis (bend_radius = radius) but
// not cross it: spindle tori are refused by find_fault() in shape.h.
struct Torus {
    real bend_radius;  // >= radius
    real radius;       // > 0, of the tube
    real arc;          // (0, 2 pi]
    real unused_0;
};

Bounds bounds(Torus torus) {
    vec4 xy =
        sector_box(torus.bend_radius - torus.radius, torus.bend_radius + torus.radius, torus.arc);
    Bounds box;
    box.low = vec3(xy.x, xy.y, -torus.radius);
    box.high = vec3(xy.z, xy.w, torus.radius);
    return box;
}

bool is_ring(Torus torus) {
    return torus.arc >= real(2) * pi();
}

int face_count(Torus torus) {
    return is_ring(torus) ? 1 : 3;
}

int end_count(Torus torus) {
    return is_ring(torus) ? 0 : 2;
}

End end(Torus torus, int index) {
    real angle = index == 0 ? real(0) : torus.arc;
    real side = index == 0 ? real(-1) : real(1);
    End disc;
    disc.centre = polar(torus.bend_radius, angle, real(0));
    disc.normal = side * vec3(-sin(angle), cos(angle), 0);
    disc.radius = torus.radius;
    disc.flare = real(0);
    return disc;
}

vec3 point(Torus torus, int face, vec2 uv) {
    if (face == 0) {
        real around = real(2) * pi() * uv.y;
        return polar(torus.bend_radius + torus.radius * cos(around), torus.arc * uv.x,
                     torus.radius * sin(around));
    }
    return disc_point(end(torus, face - 1), uv);
}

// On the spine: where it runs across n, or one of its ends.
vec3 farthest(Torus torus, vec3 n) {
    vec3 spine = farthest_of_disc(real(0), torus.bend_radius, n);
    if (!is_ring(torus)) {
        vec3 first = vec3(torus.bend_radius, 0, 0);
        vec3 last = polar(torus.bend_radius, torus.arc, real(0));
        real after_first = spine.y;
        real before_last = last.y * spine.x - last.x * spine.y;
        bool within = torus.arc > pi() ? after_first >= real(0) || before_last >= real(0)
                                       : after_first >= real(0) && before_last >= real(0);
        if (!within) {
            bool is_first = dot(first, n) >= dot(last, n);
            spine = is_first ? first : last;
            vec3 along = is_first ? vec3(0, 1, 0) : vec3(-last.y, last.x, 0) / torus.bend_radius;
            vec3 across_end = n - dot(n, along) * along;
            real size = length(across_end);
            return spine + (size > real(0) ? torus.radius / size : real(0)) * across_end;
        }
    }
    return spine + torus.radius * normalize(n);
}

// A ring whose bore is small: a thin one's would be most of the polygon.
bool suits_outline(Torus torus) {
    return is_ring(torus) && torus.bend_radius < real(2.5) * torus.radius;
}

int hull_rings(Torus torus) {
    return arc_rings(torus.arc);
}

vec3 hull_point(Torus torus, int ring, int corner, real margin) {
    vec3 tube = octagon_corner(torus.radius + margin, corner, real(0));
    vec2 across_tube = vec2(torus.bend_radius + tube.x, tube.y);
    if (tube.x < real(0)) {
        // The inner side need not be widened: its chords pass inside.
        across_tube.x = across_tube.x * cos(real(0.5) * torus.arc / real(hull_rings(torus) - 1));
    }
    return arc_hull_point(across_tube, torus.arc, hull_rings(torus), ring, margin);
}

// Outwards from the circle in the middle of the tube; its length is the distance from it.
vec3 from_spine(Torus torus, vec3 p) {
    real rho = length(vec2(p));
    if (rho == real(0)) {
        return vec3(-torus.bend_radius, 0, p.z);  // on the axis all directions are alike
    }
    real scale = real(1) - torus.bend_radius / rho;
    return vec3(p.x * scale, p.y * scale, p.z);
}
