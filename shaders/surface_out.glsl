// What every surface writes: id and normal, or, translucent, its weighted colour. Defines:
// [TRANSPARENT].
#include "shaders/normals.glsl"

#ifdef TRANSPARENT
#include "shaders/shading.glsl"
layout(std430, binding = binding_part_materials) readonly buffer PartMaterials {
    uint part_materials[];
};
layout(std430, binding = binding_materials) readonly buffer Materials {
    vec4 materials[];
};
layout(location = 0) out vec4 out_colour;  // sums of colour * alpha * weight, and of alpha * weight
layout(location = 1) out float out_revealed;  // product of 1 - alpha

// Weighted blended transparency (McGuire and Bavoil 2013): order does not matter. The weight falls
// with depth.
void put_surface(uint part, vec3 normal) {
    vec4 material = materials[part_materials[part]];
    vec3 towards = normalize(vec3(camera.back.xyz));
    vec3 facing = dot(normal, towards) < 0.0 ? -normal : normal;
    float alpha = material.a;
    float weight = alpha * (0.01 + gl_FragCoord.z);
    out_colour = vec4(lit(material.rgb, facing, towards, 1.0) * alpha, alpha) * weight;
    out_revealed = alpha;
}
#else
layout(location = 0) out uint out_part;
layout(location = 1) out uint out_normal;

void put_surface(uint part, vec3 normal) {
    out_part = part;
    out_normal = packed_normal(normal);
}
#endif
