// The model's picture on the GPU: a few draws, each jittered, laid over one another once nothing
// moves.
#pragma once

#include "render/renderer.h"

#include <array>
#include <memory>
#include <vector>

namespace quartic::viewer {

constexpr int sample_count = 4;

class Picture {
public:
    Picture();
    ~Picture();

    // The next draw starts anew.
    void discard() { samples_ = 0; }
    bool is_complete() const { return samples_ == sample_count; }

    // Draws one more sample. The size is the view's, the reduction how many of its pixels one pixel
    // stands for.
    Status draw(Renderer& renderer, const Camera& camera, PixelSize size, RenderOptions options,
                int reduction);

    int samples() const { return samples_; }
    int reduction() const { return reduction_; }
    double draw_ms() const { return draw_ms_; }  // of the first sample, by the wall's clock
    unsigned texture(int sample) const;

    // The mean of the samples as it is shown; RGBA, rows from the bottom up.
    std::vector<std::uint8_t> read() const;
    PixelSize size_px() const { return size_; }

private:
    struct Layers;
    std::unique_ptr<Layers> layers_;
    PixelSize size_;  // of the textures
    int samples_ = 0;
    int reduction_ = 1;
    double draw_ms_ = 0.0;
};

}  // namespace quartic::viewer
