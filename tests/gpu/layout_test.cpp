// The GPU's own idea of the buffers' offsets against that of C++.
#include "scene/gpu_layout.h"
#include "shaders/variants.h"
#include "tests/gpu/gpu_fixture.h"

#include <epoxy/gl.h>

#include <cstddef>

namespace quartic {
namespace {

struct Member {
    const char* name;
    std::size_t offset;
};

GLuint compile(GLenum type, const std::string& text) {
    const char* const pointer = text.c_str();
    return glCreateShaderProgramv(type, 1, &pointer);
}

GLint offset_of(GLuint program, GLenum interface, const char* name) {
    const GLuint index = glGetProgramResourceIndex(program, interface, name);
    if (index == GL_INVALID_INDEX) {
        return -1;
    }
    const GLenum property = GL_OFFSET;
    GLint offset = -1;
    glGetProgramResourceiv(program, interface, index, 1, &property, 1, nullptr, &offset);
    return offset;
}

#define MEMBER(prefix, Type, member)                \
    Member {                                        \
        prefix #member, offsetof(gpu::Type, member) \
    }

void expect_offsets(GLuint program, GLenum interface, std::initializer_list<Member> members) {
    for (const Member& member : members) {
        const GLint found = offset_of(program, interface, member.name);
        EXPECT_EQ(found, static_cast<GLint>(member.offset)) << member.name;
    }
}

using LayoutTest = GpuTest;

TEST_F(LayoutTest, camera_block_has_the_same_offsets_in_the_culling_shader) {
    const GLuint program = compile(GL_COMPUTE_SHADER, cull_texts()[0].text);
    expect_offsets(
        program, GL_UNIFORM,
        {MEMBER("camera.", CameraBlock, eye), MEMBER("camera.", CameraBlock, back),
         MEMBER("camera.", CameraBlock, step), MEMBER("camera.", CameraBlock, near_depth),
         MEMBER("camera.", CameraBlock, half_height), MEMBER("camera.", CameraBlock, orthographic),
         MEMBER("camera.", CameraBlock, size_min_px), MEMBER("camera.", CameraBlock, layer_mask),
         MEMBER("camera.", CameraBlock, cull_frustum)});
    glDeleteProgram(program);
}

TEST_F(LayoutTest, storage_blocks_have_the_same_offsets_in_the_culling_shader) {
    const GLuint program = compile(GL_COMPUTE_SHADER, cull_texts()[0].text);
    expect_offsets(
        program, GL_BUFFER_VARIABLE,
        {MEMBER("chunks[0].", ChunkBlock, z), MEMBER("chunks[0].", ChunkBlock, count),
         MEMBER("bounds[0].", BoundsBlock, locator), MEMBER("bounds[0].", BoundsBlock, layer),
         MEMBER("commands[0].", Command, instance_count),
         MEMBER("commands[0].", Command, part_count), MEMBER("batches[0].", BatchBlock, drawn_as),
         MEMBER("counts.", CountsBlock, culled_by_size)});
    glDeleteProgram(program);
}

TEST_F(LayoutTest, records_of_every_shape_are_as_long_as_in_cpp) {
    for (const ShapeRow& shape : shape_table()) {
        const ProgramText text =
            program_text({.type = shape.type, .solver = 1, .pass = Pass::near});
        const GLuint program = compile(GL_VERTEX_SHADER, text.vertex);
        const GLuint index =
            glGetProgramResourceIndex(program, GL_BUFFER_VARIABLE, "records[0].placement.bits");
        ASSERT_NE(index, GL_INVALID_INDEX) << shape.name;
        const GLenum properties[] = {GL_OFFSET, GL_TOP_LEVEL_ARRAY_STRIDE};
        GLint values[2] = {};
        glGetProgramResourceiv(program, GL_BUFFER_VARIABLE, index, 2, properties, 2, nullptr,
                               values);
        EXPECT_EQ(values[0], static_cast<GLint>(offsetof(gpu::Placement, bits))) << shape.name;
        EXPECT_EQ(values[1], static_cast<GLint>(sizeof(gpu::Placement) + shape.record_bytes))
            << shape.name;
        EXPECT_LE(values[1], shape.implicit ? 176 : 64) << shape.name;
        glDeleteProgram(program);
    }
}

}  // namespace
}  // namespace quartic
