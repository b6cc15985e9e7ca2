// Builds the index patterns of proxies.
#include "render/proxies.h"

#include "scene/gpu_layout.h"
#include "scene/pack.h"

#include <vector>

namespace quartic {
namespace {

using Indices = std::vector<std::uint16_t>;

// Bit 0, 1 and 2 of a box's vertex say whether x, y and z are high.
constexpr std::uint16_t box_indices[] = {0, 2, 1, 1, 2, 3, 4, 5, 6, 5, 7, 6, 0, 1, 4, 1, 5, 4,
                                         2, 6, 3, 3, 6, 7, 0, 4, 2, 2, 4, 6, 1, 3, 5, 3, 7, 5};

// Cuts off every second corner, again and again: a fan's triangles would be long and thin, and
// share long edges, along which pixels are shaded twice.
Indices polygon_indices(int corners) {
    Indices indices;
    for (int stride = 1; stride < corners; stride *= 2) {
        for (int i = 0; i + stride < corners; i += 2 * stride) {
            const int next = i + 2 * stride < corners ? i + 2 * stride : 0;
            if (next != i) {
                for (const int corner : {i, i + stride, next}) {
                    indices.push_back(static_cast<std::uint16_t>(corner));
                }
            }
        }
    }
    return indices;
}

Indices hull_indices(int rings) {
    Indices indices;
    const auto add = [&](int a, int b, int c) {
        for (const int index : {a, b, c}) {
            indices.push_back(static_cast<std::uint16_t>(index));
        }
    };
    for (int ring = 0; ring + 1 < rings; ++ring) {
        for (int corner = 0; corner < 8; ++corner) {
            const int here = ring * 8 + corner;
            const int beside = ring * 8 + (corner + 1) % 8;
            add(here, beside, beside + 8);
            add(here, beside + 8, here + 8);
        }
    }
    const int last = (rings - 1) * 8;
    for (int corner = 1; corner < 7; ++corner) {
        add(0, corner + 1, corner);
        add(last, last + corner, last + corner + 1);
    }
    return indices;
}

IndexRange append(Indices& all, std::span<const std::uint16_t> pattern, unsigned vertices) {
    const IndexRange range{static_cast<std::uint32_t>(all.size()),
                           static_cast<std::uint32_t>(pattern.size() * gpu::parts_per_instance)};
    for (unsigned part = 0; part < gpu::parts_per_instance; ++part) {
        for (const std::uint16_t index : pattern) {
            all.push_back(static_cast<std::uint16_t>(index + part * vertices));
        }
    }
    return range;
}

}  // namespace

Proxies make_proxies() {
    Proxies proxies;
    Indices all;
    proxies.quad = append(all, polygon_indices(4), 4);
    proxies.box = append(all, box_indices, 8);
    proxies.hulls[outline_rings] =
        append(all, polygon_indices(gpu::outline_corners), gpu::outline_corners);
    for (const int rings : {2, 3, 4, 5, 9, 13, 17}) {
        proxies.hulls[rings] = append(all, hull_indices(rings), static_cast<unsigned>(rings) * 8);
    }
    proxies.indices = make_buffer(std::as_bytes(std::span(all)));
    return proxies;
}

}  // namespace quartic
