// Textures that the renderer presents its samples into.
#include "viewer/picture.h"

#include <epoxy/gl.h>

#include <chrono>

namespace quartic::viewer {
namespace {

// A rotated grid, whose first point is the pixel's centre; picking relies on that.
constexpr std::array<glm::dvec2, sample_count> offsets{
    glm::dvec2(0.0), {0.375, -0.125}, {-0.125, -0.375}, {-0.375, 0.25}};

}  // namespace

struct Picture::Layers {
    std::array<GLuint, sample_count> textures{};
    std::array<GLuint, sample_count> framebuffers{};

    Layers() { glCreateFramebuffers(sample_count, framebuffers.data()); }
    ~Layers() {
        glDeleteFramebuffers(sample_count, framebuffers.data());
        glDeleteTextures(sample_count, textures.data());
    }
    Layers(const Layers&) = delete;
    Layers& operator=(const Layers&) = delete;

    void resize(PixelSize size) {
        glDeleteTextures(sample_count, textures.data());
        glCreateTextures(GL_TEXTURE_2D, sample_count, textures.data());
        for (std::size_t i = 0; i < textures.size(); ++i) {
            glTextureStorage2D(textures[i], 1, GL_RGBA8, size.width, size.height);
            glTextureParameteri(textures[i], GL_TEXTURE_MIN_FILTER, GL_LINEAR);
            glTextureParameteri(textures[i], GL_TEXTURE_MAG_FILTER, GL_LINEAR);
            glTextureParameteri(textures[i], GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
            glTextureParameteri(textures[i], GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
            glNamedFramebufferTexture(framebuffers[i], GL_COLOR_ATTACHMENT0, textures[i], 0);
        }
    }
};

Picture::Picture() : layers_(std::make_unique<Layers>()) {}
Picture::~Picture() = default;

unsigned Picture::texture(int sample) const {
    return layers_->textures[static_cast<std::size_t>(sample)];
}

Status Picture::draw(Renderer& renderer, const Camera& camera, PixelSize size,
                     RenderOptions options, int reduction) {
    const PixelSize wanted{std::max(1, size.width / reduction),
                           std::max(1, size.height / reduction)};
    if (wanted.width != size_.width || wanted.height != size_.height) {
        layers_->resize(wanted);
        size_ = wanted;
        samples_ = 0;
    }
    reduction_ = reduction;
    const auto sample = static_cast<std::size_t>(samples_ % sample_count);
    options.jitter_px = offsets[sample];
    const auto start = std::chrono::steady_clock::now();
    const Status drawn = renderer.draw(camera, wanted, options);
    if (!drawn) {
        return drawn;
    }
    renderer.finish();
    const std::chrono::duration<double, std::milli> elapsed =
        std::chrono::steady_clock::now() - start;
    draw_ms_ = sample == 0 ? elapsed.count() : draw_ms_;
    renderer.present(layers_->framebuffers[sample], wanted);
    samples_ = static_cast<int>(sample) + 1;
    return Done{};
}

std::vector<std::uint8_t> Picture::read() const {
    const auto bytes =
        static_cast<std::size_t>(size_.width) * static_cast<std::size_t>(size_.height) * 4;
    std::vector<unsigned> sums(bytes, 0);
    std::vector<std::uint8_t> one(bytes);
    for (int i = 0; i < samples_; ++i) {
        glGetTextureImage(texture(i), 0, GL_RGBA, GL_UNSIGNED_BYTE, static_cast<GLsizei>(bytes),
                          one.data());
        for (std::size_t k = 0; k < bytes; ++k) {
            sums[k] += one[k];
        }
    }
    const unsigned count = static_cast<unsigned>(std::max(samples_, 1));
    for (std::size_t k = 0; k < bytes; ++k) {
        one[k] = static_cast<std::uint8_t>((sums[k] + count / 2) / count);
    }
    return one;
}

}  // namespace quartic::viewer
