// Buffers and binding numbers that C++ (in namespace quartic::gpu) and the shaders share.
//
// Only scalars and 32-byte vectors of doubles, so that std140, std430 and C++ agree;
// render/layout_check.cpp and a test on the GPU compare sizes and offsets.

// A part's place in its chunk: followed in its record by the float shape.
struct Placement {
    float x;  // metres from the chunk's origin
    float y;
    float z;
    float turn_a;  // rotation, as primitives/placement.glsl says
    float turn_b;
    float turn_c;
    uint part;  // its id in the scene
    uint bits;  // see the masks below
};
const uint open_ends_mask = 3u;          // bit i: end i has no cap
const uint smooth_ends_shift = 2u;       // two bits: the wall goes on smoothly at end i
const uint rotation_largest_shift = 4u;  // two bits: which component of the quaternion is left out
const uint chunk_shift = 6u;             // the rest: the chunk's index

// What a frame is drawn from. Doubles where the plant's coordinates are subtracted.
struct CameraBlock {
    dvec4 eye;    // world
    dvec4 right;  // unit axes in the world
    dvec4 up;
    dvec4 back;
    double step;  // of a pixel: tangent, or metres in orthographic projection
    double near_depth;
    double far_depth;    // orthographic only
    double focus_depth;  // depths are counted from here in orthographic views; 0 in perspective
    double half_width;   // of the picture in pixels
    double half_height;
    double jitter_x;  // of all rays, in pixels
    double jitter_y;
    int orthographic;
    float size_min_px;  // smaller parts are culled; 0: none
    uint layer_mask;    // bit i: layer i is visible
    uint cull_frustum;
    uint proxy;     // one of proxy_...
    uint selected;  // part drawn highlighted, or all ones
    uint edges;
    uint occlusion;
    float height;           // of the picture: at depth 1, or in metres in orthographic projection
    float near_from_focus;  // the near plane's depth as pixels need it
    float near_from_eye;
    uint unused_0;
};

const uint proxy_automatic = 0u;
const uint proxy_box = 1u;
const uint proxy_quad = 2u;
const uint proxy_hull = 3u;

struct ChunkBlock {
    double x;  // origin in the world
    double y;
    double z;
    uint first;  // in the bounds
    uint count;
};

struct BoundsBlock {
    float centre_x;  // from the chunk's origin
    float centre_y;
    float centre_z;
    uint locator;  // batch << 24 | index in the batch
    float half_x;
    float half_y;
    float half_z;
    uint layer;
};
const uint locator_shift = 24u;

// One indirect draw, in the order that OpenGL reads, and how many parts it draws.
struct Command {
    uint index_count;
    uint instance_count;
    uint first_index;
    int base_vertex;
    uint base_instance;
    uint part_count;
    uint unused_0;
    uint unused_1;
};
// The commands of a batch: small parts by quads (polyhedra, or all if asked for, by their boxes),
// large ones by their hulls, those at the near plane by their boxes from inside.
const int command_small = 0;
const int command_hull = 1;
const int command_near = 2;
const int commands_per_batch = 3;

// Corners of such a polygon.
const int outline_corners = 12;

// Instances of an indirect draw hold this many parts each: single parts would each cost a driver a
// draw.
const uint parts_per_instance = 64u;

struct BatchBlock {
    uint first;  // in the lists of visible parts
    uint count;
    uint first_command;
    uint drawn_as;  // one of the three below
};

const uint drawn_as_rays = 0u;        // small parts from quads, large ones from hulls
const uint drawn_as_mesh = 1u;        // one command a part instead of three a batch
const uint drawn_as_outline = 3u;     // rays; large parts from polygons around their outlines
const uint drawn_as_polyhedron = 2u;  // by its own facets, wherever the near plane does not cut it

struct CountsBlock {
    uint drawn;
    uint culled_by_frustum;
    uint culled_by_size;
    uint unused_0;
};

const int binding_camera = 0;  // uniform block
const int binding_chunks = 0;  // storage blocks from here
const int binding_records = 1;
const int binding_visible = 2;
const int binding_near = 3;
const int binding_commands = 4;
const int binding_bounds = 5;
const int binding_batches = 6;
const int binding_counts = 7;
const int binding_part_materials = 8;
const int binding_materials = 9;
const int binding_decisions = 10;
const int binding_table = 11;

// What a frame that is inspected writes besides, in images of these units.
const int image_counts = 0;  // r32ui: rays << ray_shift | steps of all rays of the pixel
const int image_ray_origins = 1;
const int image_ray_directions = 2;
const int image_ray_pixels = 3;
const uint ray_shift = 20u;

const uint no_part = 0xffffffffu;
