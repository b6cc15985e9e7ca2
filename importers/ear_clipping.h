// Cuts a plane polygon with holes into triangles: holes are bridged to the outline, then ears are
// clipped.
#pragma once

#include <glm/glm.hpp>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace quartic {

// Reusable, so that small polygons allocate nothing. Follows Eberly, "Triangulation by Ear
// Clipping" (Geometric Tools, 2002); corners are also linked along a Z-order curve, so that an ear
// is tested only against corners near it. The work is counted: at most work_per_corner steps a
// corner, whatever the polygon looks like.
class EarClipping {
public:
    struct Report {
        double area = 0.0;  // of the triangles
        bool out_of_work = false;
        int lost_holes = 0;  // they lie outside the outline
    };

    // Starts a polygon of which at most this many corners will come.
    void start(std::size_t corner_count);

    // Corners in order; the outline must wind counter-clockwise, holes clockwise. The index names
    // the first corner; step is 1, or -1 where the points are to be taken backwards.
    void add_outline(std::span<const glm::dvec2> points, std::uint32_t first, int step);
    void add_hole(std::span<const glm::dvec2> points, std::uint32_t first, int step);

    // Appends triples of corner indices, counter-clockwise.
    Report cut(std::vector<std::uint32_t>& triangles);

private:
    struct Corner {
        glm::dvec2 at{0.0};
        std::uint32_t name = 0;
        std::uint32_t previous = 0;
        std::uint32_t next = 0;
        std::uint32_t curve = 0;   // position on the Z-order curve
        std::uint32_t before = 0;  // neighbours along it
        std::uint32_t after = 0;
    };

    std::uint32_t add_ring(std::span<const glm::dvec2> points, std::uint32_t first, int step);
    std::uint32_t find_bridge(std::uint32_t hole);
    std::uint32_t nearest_edge_left_of(glm::dvec2 point, double& crossing_x);
    void bridge(std::uint32_t outline, std::uint32_t hole);
    void link_curve();
    bool is_ear(std::uint32_t corner);
    bool blocks(std::uint32_t corner, std::uint32_t a, std::uint32_t b, std::uint32_t c) const;
    bool is_blocked_nearby(std::uint32_t a, std::uint32_t b, std::uint32_t c);
    void clip(std::uint32_t corner, std::vector<std::uint32_t>& triangles);
    void remove(std::uint32_t corner);
    bool drop_flat_corners();
    bool untie_crossings(std::vector<std::uint32_t>& triangles);
    bool looks_inside(std::uint32_t from, std::uint32_t to) const;
    double turn(std::uint32_t a, std::uint32_t b, std::uint32_t c) const;
    std::uint32_t curve_position(glm::dvec2 point) const;

    std::vector<Corner> corners_;
    std::vector<std::uint32_t> holes_;  // the leftmost corner of each
    std::vector<std::uint32_t> order_;
    std::uint32_t outline_ = 0;
    glm::dvec2 low_{0.0};
    double curve_scale_ = 0.0;
    bool has_curve_ = false;
    std::uint64_t work_left_ = 0;
    Report report_;
};

}  // namespace quartic
