// A flat disk or annulus in the local xy plane, seen from both sides; its normal is +z.
struct Disk {
    real radius;        // > 0
    real inner_radius;  // >= 0, < radius
    real unused_0;
    real unused_1;
};

Bounds bounds(Disk disk) {
    Bounds box;
    box.low = vec3(-disk.radius, -disk.radius, 0);
    box.high = vec3(disk.radius, disk.radius, 0);
    return box;
}

int face_count(Disk disk) {
    return 1;
}

int end_count(Disk disk) {
    return 0;
}

End end(Disk disk, int index) {
    return no_end();
}

vec3 point(Disk disk, int face, vec2 uv) {
    return polar(mix(disk.radius, disk.inner_radius, uv.y), real(2) * pi() * uv.x, real(0));
}

vec3 farthest(Disk disk, vec3 n) {
    return farthest_of_disc(real(0), disk.radius, n);
}

bool suits_outline(Disk disk) {
    return true;
}

int hull_rings(Disk disk) {
    return 2;
}

vec3 hull_point(Disk disk, int ring, int corner, real margin) {
    return octagon_corner(disk.radius + margin, corner, ring == 0 ? -margin : margin);
}

Hit hit(Disk disk, Ray ray, int open_ends, int solver) {
    if (ray.direction.z == real(0)) {
        return miss();
    }
    real t = -ray.origin.z / ray.direction.z;
    real rho = length(vec2(at(ray, t)));
    if (t < ray.first || rho > disk.radius || rho < disk.inner_radius) {
        return miss();
    }
    return hit_at(ray, t, vec3(0, 0, 1));
}
