// Ear clipping on linked rings of corners.
#include "importers/ear_clipping.h"

#include <algorithm>
#include <cmath>

namespace quartic {
namespace {

constexpr std::uint32_t none = 0xffffffff;
constexpr std::uint64_t work_per_corner =
    2000;  // plates with a thousand bolt holes need some hundreds
constexpr std::uint64_t work_at_least = 100000;
constexpr std::size_t curve_from = 64;  // below, testing all corners is faster than sorting them

double cross(glm::dvec2 a, glm::dvec2 b, glm::dvec2 c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

// Borders count as inside.
bool is_inside(glm::dvec2 a, glm::dvec2 b, glm::dvec2 c, glm::dvec2 p) {
    return cross(a, b, p) >= 0.0 && cross(b, c, p) >= 0.0 && cross(c, a, p) >= 0.0;
}

bool do_cross(glm::dvec2 a, glm::dvec2 b, glm::dvec2 c, glm::dvec2 d) {
    return cross(a, b, c) * cross(a, b, d) < 0.0 && cross(c, d, a) * cross(c, d, b) < 0.0;
}

// Puts a zero bit above each of the lower 16 bits.
std::uint32_t spread(std::uint32_t bits) {
    bits = (bits | (bits << 8)) & 0x00ff00ff;
    bits = (bits | (bits << 4)) & 0x0f0f0f0f;
    bits = (bits | (bits << 2)) & 0x33333333;
    return (bits | (bits << 1)) & 0x55555555;
}

}  // namespace

void EarClipping::start(std::size_t corner_count) {
    corners_.clear();
    corners_.reserve(corner_count + 64);
    holes_.clear();
    outline_ = none;
    has_curve_ = false;
    work_left_ = work_at_least + work_per_corner * corner_count;
    report_ = {};
}

std::uint32_t EarClipping::add_ring(std::span<const glm::dvec2> points, std::uint32_t first,
                                    int step) {
    const auto start = static_cast<std::uint32_t>(corners_.size());
    const std::size_t count = points.size();
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t index = step > 0 ? i : count - 1 - i;
        const bool repeats = corners_.size() > start && corners_.back().at == points[index];
        const bool closes =
            i + 1 == count && corners_.size() > start && corners_[start].at == points[index];
        if (!repeats && !closes) {
            const auto self = static_cast<std::uint32_t>(corners_.size());
            corners_.push_back(
                {points[index], first + static_cast<std::uint32_t>(index), self - 1, self + 1});
        }
    }
    const auto end = static_cast<std::uint32_t>(corners_.size());
    if (end - start < 3) {
        corners_.resize(start);
        return none;
    }
    corners_[start].previous = end - 1;
    corners_[end - 1].next = start;
    return start;
}

void EarClipping::add_outline(std::span<const glm::dvec2> points, std::uint32_t first, int step) {
    outline_ = add_ring(points, first, step);
}

void EarClipping::add_hole(std::span<const glm::dvec2> points, std::uint32_t first, int step) {
    const std::uint32_t start = add_ring(points, first, step);
    if (start == none) {
        return;
    }
    std::uint32_t leftmost = start;
    for (std::uint32_t i = start; i < corners_.size(); ++i) {
        const glm::dvec2 at = corners_[i].at;
        const glm::dvec2 best = corners_[leftmost].at;
        leftmost = at.x < best.x || (at.x == best.x && at.y < best.y) ? i : leftmost;
    }
    holes_.push_back(leftmost);
}

double EarClipping::turn(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
    return cross(corners_[a].at, corners_[b].at, corners_[c].at);
}

// Whether the way from a corner to a point starts into the polygon.
bool EarClipping::looks_inside(std::uint32_t from, std::uint32_t to) const {
    const Corner& corner = corners_[from];
    const bool left_of_next = turn(from, corner.next, to) >= 0.0;
    const bool left_of_previous = turn(corner.previous, from, to) >= 0.0;
    const bool convex = turn(corner.previous, from, corner.next) > 0.0;
    return convex ? left_of_next && left_of_previous : left_of_next || left_of_previous;
}

// The outline's edge that a ray to the left meets first; returns its left end.
std::uint32_t EarClipping::nearest_edge_left_of(glm::dvec2 point, double& crossing_x) {
    std::uint32_t nearest = none;
    crossing_x = -HUGE_VAL;
    std::uint32_t at = outline_;
    do {
        const Corner& corner = corners_[at];
        const glm::dvec2 p = corner.at;
        const glm::dvec2 q = corners_[corner.next].at;
        if (p.y >= point.y && point.y >= q.y && p.y != q.y) {
            const double x = p.x + (point.y - p.y) * (q.x - p.x) / (q.y - p.y);
            if (x <= point.x && x > crossing_x) {
                crossing_x = x;
                nearest = p.x < q.x ? at : corner.next;
            }
        }
        at = corner.next;
        work_left_ -= work_left_ > 0 ? 1 : 0;
    } while (at != outline_);
    return nearest;
}

// The corner of the outline that sees the hole's leftmost corner (Eberly, section 3), or none.
std::uint32_t EarClipping::find_bridge(std::uint32_t hole) {
    const glm::dvec2 h = corners_[hole].at;
    double crossing_x = 0.0;
    std::uint32_t best = nearest_edge_left_of(h, crossing_x);
    if (best == none) {
        return none;
    }
    // A corner within the triangle between hole, crossing and edge end would be in the way: take
    // the one with the flattest way to the hole.
    const glm::dvec2 end = corners_[best].at;
    const glm::dvec2 crossing(crossing_x, h.y);
    const glm::dvec2 a = h.y < end.y ? h : crossing;
    const glm::dvec2 c = h.y < end.y ? crossing : h;
    double flattest = HUGE_VAL;
    std::uint32_t at = outline_;
    do {
        const glm::dvec2 p = corners_[at].at;
        if (p.x >= end.x && p.x < h.x && is_inside(a, end, c, p)) {
            const double slope = std::abs(h.y - p.y) / (h.x - p.x);
            const bool better =
                slope < flattest || (slope == flattest && p.x > corners_[best].at.x);
            if (better && looks_inside(at, hole)) {
                best = at;
                flattest = slope;
            }
        }
        at = corners_[at].next;
        work_left_ -= work_left_ > 0 ? 1 : 0;
    } while (at != outline_);
    return best;
}

// Joins a hole to the outline by a pair of opposite edges; both corners are doubled.
void EarClipping::bridge(std::uint32_t outline, std::uint32_t hole) {
    const auto outline_copy = static_cast<std::uint32_t>(corners_.size());
    const std::uint32_t hole_copy = outline_copy + 1;
    corners_.push_back(Corner(corners_[outline]));
    corners_.push_back(Corner(corners_[hole]));
    const std::uint32_t after_outline = corners_[outline].next;
    const std::uint32_t before_hole = corners_[hole].previous;
    corners_[outline].next = hole;
    corners_[hole].previous = outline;
    corners_[outline_copy].next = after_outline;
    corners_[after_outline].previous = outline_copy;
    corners_[hole_copy].next = outline_copy;
    corners_[outline_copy].previous = hole_copy;
    corners_[before_hole].next = hole_copy;
    corners_[hole_copy].previous = before_hole;
}

std::uint32_t EarClipping::curve_position(glm::dvec2 point) const {
    const glm::dvec2 grid =
        glm::clamp((point - low_) * curve_scale_, glm::dvec2(0.0), glm::dvec2(65535.0));
    return spread(static_cast<std::uint32_t>(grid.x)) |
           (spread(static_cast<std::uint32_t>(grid.y)) << 1);
}

void EarClipping::link_curve() {
    glm::dvec2 high = corners_[0].at;
    low_ = high;
    for (const Corner& corner : corners_) {
        low_ = glm::min(low_, corner.at);
        high = glm::max(high, corner.at);
    }
    const double extent = std::max(high.x - low_.x, high.y - low_.y);
    curve_scale_ = extent > 0.0 ? 65535.0 / extent : 0.0;
    order_.resize(corners_.size());
    for (std::uint32_t i = 0; i < order_.size(); ++i) {
        order_[i] = i;
        corners_[i].curve = curve_position(corners_[i].at);
    }
    std::sort(order_.begin(), order_.end(), [&](std::uint32_t a, std::uint32_t b) {
        return corners_[a].curve != corners_[b].curve ? corners_[a].curve < corners_[b].curve
                                                      : a < b;
    });
    for (std::size_t i = 0; i < order_.size(); ++i) {
        corners_[order_[i]].before = i > 0 ? order_[i - 1] : none;
        corners_[order_[i]].after = i + 1 < order_.size() ? order_[i + 1] : none;
    }
    has_curve_ = true;
}

// Whether a corner lies in the triangle so that clipping it would cut into the polygon. Bridges
// double corners: one that coincides with a or c is no obstacle.
bool EarClipping::blocks(std::uint32_t corner, std::uint32_t a, std::uint32_t b,
                         std::uint32_t c) const {
    const Corner& other = corners_[corner];
    if (corner == a || corner == b || corner == c || other.at == corners_[a].at ||
        other.at == corners_[c].at) {
        return false;
    }
    return is_inside(corners_[a].at, corners_[b].at, corners_[c].at, other.at) &&
           turn(other.previous, corner, other.next) <= 0.0;
}

bool EarClipping::is_blocked_nearby(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    const glm::dvec2 pa = corners_[a].at;
    const glm::dvec2 pb = corners_[b].at;
    const glm::dvec2 pc = corners_[c].at;
    const std::uint32_t first = curve_position(glm::min(pa, glm::min(pb, pc)));
    const std::uint32_t last = curve_position(glm::max(pa, glm::max(pb, pc)));
    for (std::uint32_t at = corners_[b].before; at != none && corners_[at].curve >= first;
         at = corners_[at].before) {
        work_left_ -= work_left_ > 0 ? 1 : 0;
        if (work_left_ == 0 || blocks(at, a, b, c)) {
            return true;
        }
    }
    for (std::uint32_t at = corners_[b].after; at != none && corners_[at].curve <= last;
         at = corners_[at].after) {
        work_left_ -= work_left_ > 0 ? 1 : 0;
        if (work_left_ == 0 || blocks(at, a, b, c)) {
            return true;
        }
    }
    return false;
}

bool EarClipping::is_ear(std::uint32_t corner) {
    const std::uint32_t a = corners_[corner].previous;
    const std::uint32_t c = corners_[corner].next;
    if (turn(a, corner, c) <= 0.0) {
        return false;
    }
    if (has_curve_) {
        return !is_blocked_nearby(a, corner, c);
    }
    for (std::uint32_t at = corners_[c].next; at != a; at = corners_[at].next) {
        work_left_ -= work_left_ > 0 ? 1 : 0;
        if (work_left_ == 0 || blocks(at, a, corner, c)) {
            return false;
        }
    }
    return true;
}

void EarClipping::remove(std::uint32_t corner) {
    const Corner& gone = corners_[corner];
    corners_[gone.previous].next = gone.next;
    corners_[gone.next].previous = gone.previous;
    if (has_curve_) {
        if (gone.before != none) {
            corners_[gone.before].after = gone.after;
        }
        if (gone.after != none) {
            corners_[gone.after].before = gone.before;
        }
    }
    outline_ = gone.next;
}

void EarClipping::clip(std::uint32_t corner, std::vector<std::uint32_t>& triangles) {
    const std::uint32_t a = corners_[corner].previous;
    const std::uint32_t c = corners_[corner].next;
    const double twice_area = turn(a, corner, c);
    if (twice_area > 0.0) {
        report_.area += 0.5 * twice_area;
        triangles.insert(triangles.end(),
                         {corners_[a].name, corners_[corner].name, corners_[c].name});
    }
    remove(corner);
}

// Takes out corners on a straight line or on their neighbour; true where there were any.
bool EarClipping::drop_flat_corners() {
    bool dropped = false;
    std::uint32_t last = outline_;
    std::uint32_t at = outline_;
    do {
        const Corner& corner = corners_[at];
        const std::uint32_t next = corner.next;
        if (corner.previous == next) {
            break;
        }
        if (corner.at == corners_[next].at || turn(corner.previous, at, next) == 0.0) {
            const std::uint32_t previous = corner.previous;
            remove(at);
            dropped = true;
            at = previous;
            last = previous;
        }
        at = corners_[at].next;
    } while (at != last);
    outline_ = at;
    return dropped;
}

// Cuts off the small triangle where an edge crosses the edge after the next.
bool EarClipping::untie_crossings(std::vector<std::uint32_t>& triangles) {
    std::uint32_t at = outline_;
    const std::uint32_t last = outline_;
    do {
        const std::uint32_t a = corners_[at].previous;
        const std::uint32_t q = corners_[at].next;
        const std::uint32_t b = corners_[q].next;
        const bool crosses =
            a != b && do_cross(corners_[a].at, corners_[at].at, corners_[q].at, corners_[b].at);
        if (crosses && looks_inside(a, b) && looks_inside(b, a)) {
            clip(at, triangles);
            remove(q);
            return true;
        }
        at = q;
    } while (at != last);
    return false;
}

EarClipping::Report EarClipping::cut(std::vector<std::uint32_t>& triangles) {
    if (outline_ == none) {
        return report_;
    }
    // From left to right, so that a bridge meets only what is part of the outline already.
    std::sort(holes_.begin(), holes_.end(), [&](std::uint32_t a, std::uint32_t b) {
        const glm::dvec2 p = corners_[a].at;
        const glm::dvec2 q = corners_[b].at;
        return p.x != q.x ? p.x < q.x : (p.y != q.y ? p.y < q.y : a < b);
    });
    for (const std::uint32_t hole : holes_) {
        const std::uint32_t corner = work_left_ > 0 ? find_bridge(hole) : none;
        if (corner == none) {
            ++report_.lost_holes;
        } else {
            bridge(corner, hole);
        }
    }
    if (corners_.size() > curve_from) {
        link_curve();
    }
    std::uint32_t at = outline_;
    std::uint32_t stop = at;
    int stage = 0;
    while (corners_[at].previous != corners_[at].next && work_left_ > 0) {
        --work_left_;
        if (is_ear(at)) {
            const std::uint32_t next = corners_[at].next;
            clip(at, triangles);
            at = corners_[next].next;  // not the neighbour: fewer slivers
            stop = at;
            continue;
        }
        at = corners_[at].next;
        if (at != stop) {
            continue;
        }
        // Once around without an ear: the polygon touches or crosses itself.
        outline_ = at;
        bool changed = drop_flat_corners();
        if (!changed && stage == 0) {
            stage = 1;
            changed = untie_crossings(triangles);
        }
        if (!changed) {
            clip(outline_, triangles);  // whatever it is: the area tells the caller
            stage = 0;
        }
        at = outline_;
        stop = at;
    }
    report_.out_of_work = work_left_ == 0;
    return report_;
}

}  // namespace quartic
