// A sphere centred on the local origin.
struct Sphere {
    real radius;  // > 0
    real unused_0;
    real unused_1;
    real unused_2;
};

Bounds bounds(Sphere sphere) {
    Bounds box;
    box.low = vec3(-sphere.radius);
    box.high = vec3(sphere.radius);
    return box;
}

int face_count(Sphere sphere) {
    return 1;
}

vec3 point(Sphere sphere, int face, vec2 uv) {
    real polar_angle = pi() * (real(1) - uv.y);
    return polar(sphere.radius * sin(polar_angle), real(2) * pi() * uv.x,
                 sphere.radius * cos(polar_angle));
}

int end_count(Sphere sphere) {
    return 0;
}

End end(Sphere sphere, int index) {
    return no_end();
}

vec3 farthest(Sphere sphere, vec3 n) {
    return sphere.radius * normalize(n);
}

bool suits_outline(Sphere sphere) {
    return true;
}

int hull_rings(Sphere sphere) {
    return 4;
}

// Octagons touching the sphere at 0 and +-45 degrees of latitude, and its poles.
vec3 hull_point(Sphere sphere, int ring, int corner, real margin) {
    real radius = sphere.radius + margin;
    real shoulder = real(0.41421356) * radius;
    bool pole = ring == 0 || ring == 3;
    real z = pole ? radius : shoulder;
    return octagon_corner(pole ? shoulder : radius, corner, ring < 2 ? -z : z);
}

Hit hit(Sphere sphere, Ray ray, int open_ends, int solver) {
    Crossing crossing =
        first_crossing(in_sphere(ray.origin, ray.direction, sphere.radius), ray.first, open_ends);
    if (!crossing.found) {
        return miss();
    }
    return hit_at(ray, crossing.t, at(ray, crossing.t));
}
