// A ring segment of rectangular section around the local z axis: a duct bend. Angles from +x
// through arc, |z| <= height / 2.
struct RectangularTorus {
    real inner_radius;  // >= 0, < outer_radius
    real outer_radius;
    real height;  // >= 0
    real arc;     // (0, 2 pi]
};

Bounds bounds(RectangularTorus torus) {
    vec4 xy = sector_box(torus.inner_radius, torus.outer_radius, torus.arc);
    Bounds box;
    box.low = vec3(xy.x, xy.y, real(-0.5) * torus.height);
    box.high = vec3(xy.z, xy.w, real(0.5) * torus.height);
    return box;
}

// Faces: 0 outer wall, 1 and 2 the ends, 3 inner wall, 4 bottom, 5 top; a ring has no ends, they
// are left empty.
int face_count(RectangularTorus torus) {
    return 6;
}

int end_count(RectangularTorus torus) {
    return 0;
}

End end(RectangularTorus torus, int index) {
    return no_end();
}

vec3 point(RectangularTorus torus, int face, vec2 uv) {
    real half_height = real(0.5) * torus.height;
    real z = mix(-half_height, half_height, uv.y);
    real rho = mix(torus.inner_radius, torus.outer_radius, uv.x);
    if (face == 1 || face == 2) {
        bool ring = torus.arc >= real(2) * pi();
        return face == 1 ? polar(rho, real(0), ring ? real(0) : z)
                         : polar(torus.inner_radius + torus.outer_radius - rho, torus.arc,
                                 ring ? real(0) : z);
    }
    real angle = torus.arc * uv.x;
    if (face == 0) {
        return polar(torus.outer_radius, angle, z);
    }
    if (face == 3) {
        return polar(torus.inner_radius, angle, -z);
    }
    return face == 4 ? polar(mix(torus.inner_radius, torus.outer_radius, uv.y), angle, -half_height)
                     : polar(mix(torus.outer_radius, torus.inner_radius, uv.y), angle, half_height);
}

vec3 farthest(RectangularTorus torus, vec3 n) {
    return farthest_of_box(bounds(torus), n);
}

bool suits_outline(RectangularTorus torus) {
    return false;
}

int hull_rings(RectangularTorus torus) {
    return arc_rings(torus.arc);
}

vec3 hull_point(RectangularTorus torus, int ring, int corner, real margin) {
    int rings = hull_rings(torus);
    vec2 half_size = vec2(real(0.5) * (torus.outer_radius - torus.inner_radius) + margin,
                          real(0.5) * torus.height + margin);
    vec2 across = rectangle_corner(half_size, corner);
    across.x = across.x + real(0.5) * (torus.outer_radius + torus.inner_radius);
    if (across.x < torus.outer_radius) {
        across.x = across.x * cos(real(0.5) * torus.arc / real(rings - 1));
    }
    return arc_hull_point(across, torus.arc, rings, ring, margin);
}

vec3 rectangular_torus_normal(int face, vec3 p, vec4 planes) {
    if (face >= 4) {
        return vec3(0, 0, face == 4 ? -1 : 1);
    }
    if (face == 1) {
        return vec3(-planes.x, -planes.y, 0);
    }
    if (face == 2) {
        return vec3(-planes.z, -planes.w, 0);
    }
    return face == 3 ? vec3(-p.x, -p.y, 0) : vec3(p.x, p.y, 0);
}

// The part of body on one side of the bore, which is left by or entered through face 3.
Span beside(Span body, Span bore, bool after) {
    return after ? between(body, bore.exit, huge, 3) : between(body, -huge, bore.enter, 3);
}

// What hit() needs of the shape alone: the GPU calculates it once for each vertex.
ArcEnds prepare(RectangularTorus torus, int open_ends) {
    return arc_ends(torus.arc, real(0), real(0), open_ends);
}

Hit hit_prepared(RectangularTorus torus, ArcEnds ends, Ray ray, int solver) {
    vec3 o = ray.origin;
    vec3 d = ray.direction;
    vec3 across = vec3(d.x, d.y, 0);
    Span body = in_cone(vec3(o.x, o.y, torus.outer_radius), across);
    body = below_plane(body, o.z + real(0.5) * torus.height, d.z, 4);
    body = below_plane(body, real(0.5) * torus.height - o.z, -d.z, 5);
    if (body.enter > body.exit) {
        return miss();
    }
    Span bore = in_cone(vec3(o.x, o.y, torus.inner_radius), across);
    bool bored = bore.enter < bore.exit;
    Sector sector = in_sector(o, d, ends);

    // In order along the line: each part of the sector, before and after the bore.
    for (int i = 0; i < 4; ++i) {
        Span part = i < 2 ? sector.part_0 : sector.part_1;
        Span piece = between(between(body, part.enter, huge, part.enter_face), -huge, part.exit,
                             part.exit_face);
        if (bored) {
            piece = beside(piece, bore, i % 2 == 1);
        }
        Crossing crossing = first_crossing(piece, ray.first, 0);
        if (crossing.found) {
            vec3 p = at(ray, crossing.t);
            return hit_at(ray, crossing.t, rectangular_torus_normal(crossing.face, p, ends.planes));
        }
    }
    return miss();
}

Hit hit(RectangularTorus torus, Ray ray, int open_ends, int solver) {
    return hit_prepared(torus, prepare(torus, open_ends), ray, solver);
}
