// A polygon before a part whose edges all touch the part's outline in the picture: for small parts
// a quad, which has the fewest vertices, for compact large ones an dodecagon.
//
// An edge is a plane through the eye that touches the shape. Its slope is the greatest ratio, over
// the shape's points, of distance along the edge's normal in the picture to depth: Dinkelbach's
// iteration (1967) with the point that is farthest across the last plane, which converges
// quadratically.

const int polygon_steps = 3;

// How the part is seen, in its own frame.
struct PartView {
    vec3 centre;    // of the shape's box
    vec3 forward;   // unit, from the eye to the centre, or along all rays
    float depth;    // of the centre from the eye
    bool parallel;  // rays
};

// The longest axis of the box, or, of a flat one, the shortest.
vec3 main_axis(vec3 extent) {
    float longest = max(extent.x, max(extent.y, extent.z));
    float shortest = min(extent.x, min(extent.y, extent.z));
    float middle = extent.x + extent.y + extent.z - longest - shortest;
    float sought = longest - middle < middle - shortest ? shortest : longest;
    return extent.x == sought ? vec3(1, 0, 0)
                              : (extent.y == sought ? vec3(0, 1, 0) : vec3(0, 0, 1));
}

// How far the shape reaches along an axis across the view, at depth 1 (parallel: at any).
float reach_of(THIS_SHAPE shape, PartView view, vec3 axis) {
    float slope = 0.0;
    for (int i = 0; i < polygon_steps; ++i) {
        vec3 p = farthest(shape, view.parallel ? axis : axis - slope * view.forward) - view.centre;
        slope = dot(p, axis) / (view.parallel ? 1.0 : view.depth + dot(p, view.forward));
    }
    return slope;
}

// A corner of the polygon of this many edges, counter-clockwise, in the shape's frame.
vec3 polygon_corner(THIS_SHAPE shape, PartView view, ivec2 corner_of, float margin) {
    Bounds box = bounds(shape);
    vec3 along = main_axis(box.high - box.low);
    vec3 right = along - dot(along, view.forward) * view.forward;
    right = dot(right, right) > 1e-6 ? normalize(right) : across(view.forward);
    vec3 up = cross(right, view.forward);
    float turn_angle = 2.0 * pi() / float(corner_of.y);
    float angle = turn_angle * float(corner_of.x);
    vec3 edge = cos(angle) * right + sin(angle) * up;
    vec3 beside = cos(angle) * up - sin(angle) * right;
    float nearest =
        view.depth + dot(farthest(shape, -view.forward) - view.centre, view.forward) - margin;
    float scale = view.parallel ? 1.0 : nearest;
    float widening = margin / (view.parallel ? 1.0 : max(nearest, margin));
    float reach = reach_of(shape, view, edge) + widening;
    float next_reach =
        reach_of(shape, view, cos(turn_angle) * edge + sin(turn_angle) * beside) + widening;
    vec3 offset = reach * edge + (next_reach - reach * cos(turn_angle)) / sin(turn_angle) * beside;
    return view.centre + (nearest - view.depth) * view.forward + scale * offset;
}
