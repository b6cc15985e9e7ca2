// One headless context and renderer for all tests of a program; they are skipped aloud where there
// is no OpenGL.
#pragma once

#include "render/context.h"
#include "render/renderer.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <optional>

namespace quartic {

constexpr std::array<bool, layer_count> all_layers{true, true, true, true};

class GpuTest : public testing::Test {
protected:
    static void SetUpTestSuite() {
        if (!context_) {
            Result<HeadlessContext> context = HeadlessContext::create();
            if (!context) {
                std::fprintf(stderr, "SKIPPED: %s\n", context.error().message.c_str());
                return;
            }
            context_.emplace(std::move(context).value());
            Result<Renderer> renderer = Renderer::create();
            ASSERT_TRUE(renderer) << renderer.error().where << ": " << renderer.error().message;
            renderer_.emplace(std::move(renderer).value());
        }
    }
    void SetUp() override {
        if (!renderer_) {
            GTEST_SKIP() << "no usable OpenGL";
        }
    }

    static Renderer& renderer() { return *renderer_; }

    // Everything is drawn, opaque, whatever its size and layer.
    static RenderOptions all_parts() {
        RenderOptions options;
        options.layers = all_layers;
        options.cull_size = false;
        return options;
    }

    static void load(const Scene& scene) {
        PackOptions options;
        options.transparent_as_opaque = true;
        const Status loaded = renderer().load(pack(scene, options));
        ASSERT_TRUE(loaded) << loaded.error().where << ": " << loaded.error().message;
    }

    static GBuffer draw(const Camera& camera, PixelSize size) {
        const Status drawn = renderer().draw(camera, size, all_parts());
        EXPECT_TRUE(drawn) << drawn.error().message;
        return renderer().read();
    }

    static void expect_no_gl_error() {
        for (const std::string& error : renderer().gl_errors()) {
            ADD_FAILURE() << error;
        }
    }

private:
    static inline std::optional<HeadlessContext> context_;
    static inline std::optional<Renderer> renderer_;
};

}  // namespace quartic
