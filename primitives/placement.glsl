// How a record holds a rotation: three components of a unit quaternion in full float, the largest
// one left out.
//
// The largest component is made positive and is at least 1/2, so that its root loses nothing: an
// end 100 m away moves by less than 20 micrometres.

// The quaternion (x, y, z, w) from the other three components in order; largest is the index of the
// one left out.
vec4 rotation_of(real a, real b, real c, int largest) {
    real d = sqrt(max(real(0), real(1) - a * a - b * b - c * c));
    if (largest == 0) {
        return vec4(d, a, b, c);
    }
    if (largest == 1) {
        return vec4(a, d, b, c);
    }
    return largest == 2 ? vec4(a, b, d, c) : vec4(a, b, c, d);
}

vec3 turn(vec4 rotation, vec3 v) {
    vec3 axis = vec3(rotation.x, rotation.y, rotation.z);
    vec3 twice = real(2) * cross(axis, v);
    return v + rotation.w * twice + cross(axis, twice);
}

vec3 turn_back(vec4 rotation, vec3 v) {
    return turn(vec4(-rotation.x, -rotation.y, -rotation.z, rotation.w), v);
}
