// A vessel end: the cap above z = 0 of an ellipsoid (half of it) or of a sphere, closed by its base
// disc, end 0.
struct Dish {
    real radius;     // > 0, of the base circle
    real height;     // > 0, of the top over the base
    real spherical;  // 1: a cap of the sphere through base circle and top (height > radius: more
                     // than a hemisphere); 0: half an ellipsoid
    real unused_0;
};

bool is_spherical(Dish dish) {
    return dish.spherical > real(0.5);
}

// Radius around z: of the sphere, or of the base.
real equator_radius(Dish dish) {
    return is_spherical(dish)
               ? (dish.radius * dish.radius + dish.height * dish.height) / (real(2) * dish.height)
               : dish.radius;
}

real centre_height(Dish dish) {
    return is_spherical(dish) ? dish.height - equator_radius(dish) : real(0);
}

Bounds bounds(Dish dish) {
    real widest = centre_height(dish) > real(0) ? equator_radius(dish) : dish.radius;
    Bounds box;
    box.low = vec3(-widest, -widest, 0);
    box.high = vec3(widest, widest, dish.height);
    return box;
}

int face_count(Dish dish) {
    return 2;
}

int end_count(Dish dish) {
    return 1;
}

End end(Dish dish, int index) {
    End disc;
    disc.centre = vec3(0);
    disc.normal = vec3(0, 0, -1);
    disc.radius = dish.radius;
    disc.flare = -centre_height(dish) / dish.radius;
    return disc;
}

vec3 point(Dish dish, int face, vec2 uv) {
    if (face == 1) {
        return disc_point(end(dish, 0), uv);
    }
    real a = equator_radius(dish);
    real b = is_spherical(dish) ? a : dish.height;
    real base_angle = atan(dish.radius, -centre_height(dish));
    real polar_angle = base_angle * (real(1) - uv.y);
    return polar(a * sin(polar_angle), real(2) * pi() * uv.x,
                 centre_height(dish) + b * cos(polar_angle));
}

vec3 farthest(Dish dish, vec3 n) {
    vec3 base = farthest_of_disc(real(0), dish.radius, n);
    real a = equator_radius(dish);
    real b = is_spherical(dish) ? a : dish.height;
    vec3 scaled_n = vec3(a * n.x, a * n.y, b * n.z);
    vec3 top = vec3(a, a, b) * normalize(scaled_n) + vec3(0, 0, centre_height(dish));
    return top.z > real(0) ? farther(top, base, n) : base;
}

bool suits_outline(Dish dish) {
    return true;
}

int hull_rings(Dish dish) {
    return 3;
}

// An octagonal prism with a chamfered top.
vec3 hull_point(Dish dish, int ring, int corner, real margin) {
    real radius = bounds(dish).high.x + margin;
    real top = dish.height + margin;
    if (ring == 0) {
        return octagon_corner(radius, corner, -margin);
    }
    // The tangent at 45 degrees of the ellipsoid seen as a sphere meets the side and the top here.
    real a = equator_radius(dish) + margin;
    real b = (is_spherical(dish) ? equator_radius(dish) : dish.height) + margin;
    real z = centre_height(dish) + real(0.41421356) * b;
    if (z < real(0)) {
        return octagon_corner(radius, corner, top);
    }
    // Where the widest circle lies below the base, the tangent starts outside the base circle.
    return ring == 1 ? octagon_corner(max(radius, a), corner, z)
                     : octagon_corner(real(0.41421356) * a, corner, top);
}

Hit hit(Dish dish, Ray ray, int open_ends, int solver) {
    // Stretched along z, the ellipsoid is a sphere; a line's parameter stays the same.
    real a = equator_radius(dish);
    real stretch = is_spherical(dish) ? real(1) : dish.radius / dish.height;
    real centre = centre_height(dish);
    vec3 o = ray.origin;
    vec3 d = ray.direction;

    real overlap = is_open(open_ends, 0) ? joint_overlap(dish.radius, end(dish, 0).flare) : real(0);
    Span span =
        in_sphere(vec3(o.x, o.y, (o.z - centre) * stretch), vec3(d.x, d.y, d.z * stretch), a);
    span = below_plane(span, o.z + overlap, d.z, 1);
    Crossing crossing = first_crossing(span, ray.first, open_ends);
    if (!crossing.found) {
        return miss();
    }
    vec3 p = at(ray, crossing.t);
    vec3 normal = vec3(p.x, p.y, (p.z - centre) * stretch * stretch);
    if (crossing.face == 1) {
        normal = vec3(0, 0, -1);
    }
    return hit_at(ray, crossing.t, normal);
}
