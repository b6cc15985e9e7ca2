// Index patterns of proxies: quads, boxes of 8 vertices and hulls of rings of 8, for many parts at
// once.
#pragma once

#include "render/gl_objects.h"

#include <cstdint>
#include <map>

namespace quartic {

struct IndexRange {
    std::uint32_t first = 0;
    std::uint32_t count = 0;
};

// One index buffer with the patterns of a quad, a box, and hulls with 2, 3, 4, 5, 9, 13 and 17
// rings, each repeated for gpu::parts_per_instance parts: vertex v of part p is number p * vertices
// + v. Front faces wind counter-clockwise seen from outside.
struct Proxies {
    GlBuffer indices;
    IndexRange quad;
    IndexRange box;
    std::map<int, IndexRange> hulls;  // by their number of rings, or outline_rings
};

Proxies make_proxies();

}  // namespace quartic
