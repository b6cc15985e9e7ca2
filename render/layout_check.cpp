// Sizes and offsets that C++ and the shaders must agree on; a test asks the GPU for its own.
#include "scene/gpu_layout.h"
#include "scene/pack.h"
#include "shaders/variants.h"

#include <cstddef>

namespace quartic {

static_assert(sizeof(gpu::Placement) == 32);
static_assert(sizeof(gpu::ChunkBlock) == 32);
static_assert(sizeof(gpu::BoundsBlock) == sizeof(PackedBounds));
static_assert(offsetof(gpu::BoundsBlock, locator) == offsetof(PackedBounds, locator));
static_assert(offsetof(gpu::BoundsBlock, layer) == offsetof(PackedBounds, layer));
static_assert(sizeof(gpu::Command) == 32);
static_assert(offsetof(gpu::CameraBlock, step) == 128);
static_assert(offsetof(gpu::CameraBlock, orthographic) == 192);
static_assert(static_cast<int>(Pass::small) == gpu::command_small);
static_assert(static_cast<int>(Pass::large) == gpu::command_hull);
static_assert(static_cast<int>(Pass::near) == gpu::command_near);
static_assert(sizeof(gpu::CameraBlock) == 240);

// A record is a placement and a shape, whose own alignment std430 rounds its size to: 64 bytes at
// the most, but for surfaces that carry a polynomial.
#define SHAPE(id, Type, name)                                         \
    static_assert(sizeof(gpu::Placement) + sizeof(f32::Type) <= 64 || \
                  (Implicit<f64::Type> && sizeof(f32::Type) % 16 == 0));
#include "primitives/catalog.h"
#undef SHAPE

}  // namespace quartic
