// The look: a key light over the viewer's left shoulder, sky and ground, a soft highlight.
const vec3 sky_light = vec3(0.46, 0.50, 0.56);
const vec3 ground_light = vec3(0.24, 0.22, 0.20);

// Linear colour of a surface facing the viewer. openness darkens what ambient light does not reach.
vec3 lit(vec3 colour, vec3 normal, vec3 towards, float openness) {
    vec3 right = vec3(camera.right.xyz);
    vec3 up = vec3(camera.up.xyz);
    vec3 key = normalize(towards + 0.75 * up - 0.55 * right);
    vec3 ambient = mix(ground_light, sky_light, 0.5 + 0.5 * normal.z) * openness;
    float diffuse = max(dot(normal, key), 0.0);
    float rim = pow(1.0 - max(dot(normal, towards), 0.0), 3.0);
    float highlight = pow(max(dot(normal, normalize(key + towards)), 0.0), 48.0);
    return colour * (ambient + 0.72 * diffuse) + 0.10 * highlight * openness +
           0.04 * rim * openness * sky_light;
}

vec3 srgb(vec3 linear) {
    vec3 c = clamp(linear, 0.0, 1.0);
    return mix(1.055 * pow(c, vec3(1.0 / 2.4)) - 0.055, 12.92 * c, lessThan(c, vec3(0.0031308)));
}
