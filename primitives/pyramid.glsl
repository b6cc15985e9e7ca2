// A frustum between a rectangle at z = -height / 2 and a parallel one at z = height / 2, leaning by
// an offset.
//
// The lower rectangle is centred on (-offset / 2), the upper one on (offset / 2). Any width may be
// 0: a wedge, a tip.
struct Pyramid {
    real bottom_x;  // full widths, >= 0
    real bottom_y;
    real top_x;
    real top_y;
    real offset_x;  // of the upper rectangle against the lower one
    real offset_y;
    real height;  // > 0
    real unused_0;
};

// Centre (xy) and half widths (zw) of the section at v = 0 (bottom) to 1 (top).
vec4 section(Pyramid pyramid, real v) {
    return vec4((v - real(0.5)) * pyramid.offset_x, (v - real(0.5)) * pyramid.offset_y,
                real(0.5) * mix(pyramid.bottom_x, pyramid.top_x, v),
                real(0.5) * mix(pyramid.bottom_y, pyramid.top_y, v));
}

Bounds bounds(Pyramid pyramid) {
    vec4 bottom = section(pyramid, real(0));
    vec4 top = section(pyramid, real(1));
    Bounds box;
    box.low = vec3(min(bottom.x - bottom.z, top.x - top.z), min(bottom.y - bottom.w, top.y - top.w),
                   real(-0.5) * pyramid.height);
    box.high = vec3(max(bottom.x + bottom.z, top.x + top.z),
                    max(bottom.y + bottom.w, top.y + top.w), real(0.5) * pyramid.height);
    return box;
}

int face_count(Pyramid pyramid) {
    return 6;
}

int end_count(Pyramid pyramid) {
    return 0;
}

End end(Pyramid pyramid, int index) {
    return no_end();
}

// Corner 0-3 (counter-clockwise from above, first at +x +y) of the section at v.
vec3 pyramid_corner(Pyramid pyramid, int corner, real v) {
    vec4 here = section(pyramid, v);
    real x = corner == 0 || corner == 3 ? here.z : -here.z;
    real y = corner < 2 ? here.w : -here.w;
    return vec3(here.x + x, here.y + y, (v - real(0.5)) * pyramid.height);
}

// Faces 0-3 are the sides +y, -x, -y, +x; 4 is the bottom, 5 the top.
vec3 point(Pyramid pyramid, int face, vec2 uv) {
    if (face < 4) {
        vec3 a = pyramid_corner(pyramid, face, uv.y);
        vec3 b = pyramid_corner(pyramid, (face + 1) % 4, uv.y);
        return mix(a, b, uv.x);
    }
    real v = face == 4 ? real(0) : real(1);
    vec4 here = section(pyramid, v);
    real x = (real(2) * uv.x - real(1)) * (face == 4 ? -here.z : here.z);
    return vec3(here.x + x, here.y + (real(2) * uv.y - real(1)) * here.w,
                (v - real(0.5)) * pyramid.height);
}

// The inward-facing plane of side 0-3 as (gradient, value at the local origin).
vec4 side_plane(Pyramid pyramid, int face) {
    bool along_x = face % 2 == 1;
    real sign_out = face == 0 || face == 3 ? real(1) : real(-1);
    real growth = along_x ? pyramid.top_x - pyramid.bottom_x : pyramid.top_y - pyramid.bottom_y;
    real offset = along_x ? pyramid.offset_x : pyramid.offset_y;
    real middle = real(0.25) *
                  (along_x ? pyramid.bottom_x + pyramid.top_x : pyramid.bottom_y + pyramid.top_y);
    real rise = (real(0.5) * growth + sign_out * offset) / pyramid.height;
    return along_x ? vec4(-sign_out, 0, rise, middle) : vec4(0, -sign_out, rise, middle);
}

// The normal of a facet in the order of a box's: -x, +x, -y, +y, -z, +z.
vec3 facet_normal(Pyramid pyramid, int facet) {
    if (facet >= 4) {
        return vec3(0, 0, facet == 4 ? -1 : 1);
    }
    int side = facet == 0 ? 1 : (facet == 1 ? 3 : (facet == 2 ? 2 : 0));
    return normalize(-vec3(side_plane(pyramid, side)));
}

vec3 farthest(Pyramid pyramid, vec3 n) {
    return farthest_of_box(bounds(pyramid), n);
}

bool suits_outline(Pyramid pyramid) {
    return false;
}

int hull_rings(Pyramid pyramid) {
    return 2;
}

vec3 hull_point(Pyramid pyramid, int ring, int corner, real margin) {
    // The margin also lengthens the frustum, where it may go on widening or leaning.
    real growth = abs(pyramid.top_x - pyramid.bottom_x) + abs(pyramid.top_y - pyramid.bottom_y) +
                  abs(pyramid.offset_x) + abs(pyramid.offset_y);
    real widening = margin * (real(1) + growth / pyramid.height);
    vec4 here = section(pyramid, ring == 0 ? real(0) : real(1));
    vec2 xy = rectangle_corner(vec2(here.z + widening, here.w + widening), corner);
    real z = real(0.5) * pyramid.height + margin;
    return vec3(here.x + xy.x, here.y + xy.y, ring == 0 ? -z : z);
}

Hit hit(Pyramid pyramid, Ray ray, int open_ends, int solver) {
    vec3 o = ray.origin;
    vec3 d = ray.direction;
    real half_height = real(0.5) * pyramid.height;
    Span span = whole_line();
    for (int face = 0; face < 4; ++face) {
        vec4 plane = side_plane(pyramid, face);
        vec3 inward = vec3(plane);
        span = below_plane(span, dot(inward, o) + plane.w, dot(inward, d), face);
    }
    span = below_plane(span, o.z + half_height, d.z, 4);
    span = below_plane(span, half_height - o.z, -d.z, 5);
    Crossing crossing = first_crossing(span, ray.first, 0);
    if (!crossing.found) {
        return miss();
    }
    vec3 normal = vec3(0, 0, crossing.face == 4 ? -1 : 1);
    if (crossing.face < 4) {
        normal = -vec3(side_plane(pyramid, crossing.face));
    }
    return hit_at(ray, crossing.t, normal);
}
