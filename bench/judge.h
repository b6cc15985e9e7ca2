// Judges the rays of a picture that was drawn with RenderOptions::inspect: the solver's answer to
// each ray against the truth of that very ray.
#pragma once

#include "bench/truth.h"
#include "render/renderer.h"
#include "scene/compare.h"

namespace quartic {

// Of a set of pictures of one surface. A pixel is a tie where a ray tie_distance_px beside it would
// make the solver's answer true.
struct Judgement {
    std::uint64_t covered = 0;  // pixels that the proxy covers: rays were cast
    std::uint64_t hits = 0;     // pixels whose rays truly hit
    HardAndTie missed;          // the solver finds nothing where there is a hit, or no ray was cast
    HardAndTie false_hits;      // the solver finds what is not there
    HardAndTie elsewhere;       // both hit, but far apart: another lobe, another sheet
    std::vector<float> errors;  // along the ray, where both hit the same place

    std::uint64_t rays = 0;
    std::uint64_t steps = 0;  // of the solver, over all rays
    std::uint64_t steps_max = 0;
    // What a GPU pays that works on 8x4 pixels at a time: the most steps in each block with rays.
    std::uint64_t blocks = 0;
    std::uint64_t steps_of_blocks = 0;

    double steps_mean() const;
    double steps_mean_of_blocks() const;
    double waste() const;  // the part of the covered pixels without a true hit
};

void add(const Judgement& from, Judgement& into);

// What needs no truth: covered pixels, rays and steps.
Judgement count_rays(const GBuffer& picture);

// The truth of one view, remembered, since all solvers of a view are given the same rays. The
// surface must be placed at the origin without rotation.
class Judge {
public:
    // Errors are divided by length; places farther apart than far_apart, in metres, are not the
    // same.
    Judge(Crossings crossings, const View& view, double length, double far_apart);

    Judgement judge(const GBuffer& picture);

private:
    struct Pixel {
        glm::vec4 origin{0.0f};
        glm::vec4 direction{0.0f};
        bool known = false;
        bool hits = false;
        Long t = 0.0L;
        // First hits of the rays beside it, infinite where they miss; empty until somebody errs.
        std::vector<double> beside;
    };
    struct Answer {
        LongRay ray;
        bool found;
        Long t;
    };

    void judge_row(const GBuffer& picture, int y, Judgement& into);
    LongRay ray_of(const GBuffer& picture, int x, int y) const;
    LongRay moved(const LongRay& ray, double dx, double dy) const;
    void look_beside(const LongRay& ray, Pixel& pixel) const;
    bool is_tie(const Answer& answer, const Pixel& pixel) const;

    Crossings crossings_;
    View view_;
    Long length_;
    Long far_apart_;
    std::vector<Pixel> pixels_;
};

}  // namespace quartic
