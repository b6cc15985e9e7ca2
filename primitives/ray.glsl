// Rays, hits and the other values that every shape deals in, in the local frame of the shape.

// A line; what lies before t = first (behind the eye, or nearer than the near plane) is not seen.
// The direction may have any length. For float accuracy the origin should lie near the shape, not
// at a distant eye.
struct Ray {
    vec3 origin;
    vec3 direction;
    real first;
    real pixel;  // a pixel's width where the shape is; 0 where it does not matter
};

// Where a ray first meets a surface. The normal is a unit vector out of the solid, also when the
// hit is from inside.
struct Hit {
    bool found;
    real t;
    vec3 point;
    vec3 normal;
    int steps;  // of the solver's loops, also of a miss
};

// The tight box of a shape.
struct Bounds {
    vec3 low;
    vec3 high;
};

// A round end where a neighbour may be joined: its disc, and how fast the wall's radius grows
// outwards there.
struct End {
    vec3 centre;
    vec3 normal;  // unit, out of the solid
    real radius;
    real flare;  // d radius / d (distance along the normal); 0 where the wall is parallel to the
                 // normal
};

// How far a wall goes on beyond an open end: joined parts must overlap by more than a float step of
// their positions (8 micrometres in a chunk) and of the file's (31 micrometres at 300 m), or light
// would shine through the joint.
const real joint_overlap_max = real(5e-5);

// A wall that widens by flare per metre goes on for less, so that it does not stand out of the
// joint.
real joint_overlap(real radius, real flare) {
    return min(joint_overlap_max, real(0.01) * radius) / (real(1) + abs(flare));
}

bool is_open(int open_ends, int end_index) {
    return (open_ends & (1 << end_index)) != 0;
}

// Where a wall ends, from the middle of its height: at the end's disc, or, open, beyond it.
real wall_reach(int open_ends, int end_index, real half_height, real overlap) {
    return half_height + (is_open(open_ends, end_index) ? overlap : real(0));
}

Hit miss() {
    Hit hit;
    hit.found = false;
    hit.steps = 0;
    hit.t = real(0);
    hit.point = vec3(0);
    hit.normal = vec3(0);
    return hit;
}

vec3 at(Ray ray, real t) {
    return ray.origin + t * ray.direction;
}

Hit hit_at(Ray ray, real t, vec3 normal) {
    Hit hit;
    hit.found = true;
    hit.steps = 0;
    hit.t = t;
    hit.point = at(ray, t);
    hit.normal = normalize(normal);
    return hit;
}

vec3 polar(real radius, real angle, real z) {
    return vec3(radius * cos(angle), radius * sin(angle), z);
}

// A corner of the regular octagon around the circle of this radius, as the proxies of round shapes
// use it.
vec3 octagon_corner(real radius, int corner, real z) {
    return polar(real(1.0823922) * radius, (real(corner) + real(0.5)) * pi() / real(4), z);
}

// The number, for rectangle_corner(), of the corner at low or high x and y.
int corner_at(bool high_x, bool high_y) {
    return high_y ? (high_x ? 0 : 2) : (high_x ? 6 : 4);
}

// The corner of a rectangle of these half widths that octagon corner 0-7 falls on (each twice), for
// four-sided proxies.
vec2 rectangle_corner(vec2 half_widths, int corner) {
    int quarter = (corner / 2) % 4;
    real x = quarter == 0 || quarter == 3 ? half_widths.x : -half_widths.x;
    real y = quarter < 2 ? half_widths.y : -half_widths.y;
    return vec2(x, y);
}

// The farthest points of a box and of a level disc in a direction, and the farther of two.
vec3 farthest_of_box(Bounds box, vec3 n) {
    return vec3(n.x < real(0) ? box.low.x : box.high.x, n.y < real(0) ? box.low.y : box.high.y,
                n.z < real(0) ? box.low.z : box.high.z);
}

vec3 farthest_of_disc(real z, real radius, vec3 n) {
    real length_xy = length(vec2(n));
    real scale = length_xy > real(0) ? radius / length_xy : real(0);
    return vec3(scale * n.x, scale * n.y, z);
}

vec3 farther(vec3 a, vec3 b, vec3 n) {
    return dot(a, n) < dot(b, n) ? b : a;
}

End no_end() {
    End disc;
    disc.centre = vec3(0);
    disc.normal = vec3(0, 0, 1);
    disc.radius = real(0);
    disc.flare = real(0);
    return disc;
}

// The lower (0) or upper (1) disc of a solid of this height around the local z axis, whose radius
// grows upwards by this slope.
End upright_end(int index, real height, real radius, real slope) {
    real side = index == 0 ? real(-1) : real(1);
    End disc;
    disc.centre = vec3(0, 0, side * real(0.5) * height);
    disc.normal = vec3(0, 0, side);
    disc.radius = radius;
    disc.flare = side * slope;
    return disc;
}

// A unit vector across n, without a preferred direction.
vec3 across(vec3 n) {
    vec3 axis = abs(n.x) < real(0.6) ? vec3(1, 0, 0) : vec3(0, 1, 0);
    return normalize(cross(n, axis));
}

// A point of a disc, uv.x around it; the patch faces along the normal.
vec3 disc_point(End disc, vec2 uv) {
    vec3 first_axis = across(disc.normal);
    vec3 second_axis = cross(disc.normal, first_axis);
    real angle = real(2) * pi() * uv.x;
    real radius = disc.radius * (real(1) - uv.y);
    return disc.centre + radius * (cos(angle) * first_axis + sin(angle) * second_axis);
}
