#include "render/vertex_marks.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>

#include <fmt/core.h>
#include <glad/gl.h>
#include <glm/gtc/type_ptr.hpp>

#include "render/shader.h"

namespace interleaf {
namespace {

/// Lengths of normals in widths of lines, where they are few and where they are many.
constexpr float longest_normal = 14;
constexpr float shortest_normal = 8;

GlProgram make_marks_program(std::size_t key_count, bool normals) {
    constexpr std::string_view files[] = {"surface.vert", "marks.geom", "marks.frag"};
    const std::string definitions = fmt::format(
        "#define KEY_COUNT {}\n#define FIELD 0\n#define VALUES 0\n#define NORMALS {:d}", key_count, normals);
    return link_program(files, definitions);
}

/// How many vertices there are, from 0 for few to 1 for 20,000 and more.
float crowd_of(std::size_t vertex_count) {
    return std::clamp(static_cast<float>(vertex_count) / 20'000, 0.0F, 1.0F);
}

/// Radius of the dots in widths of lines: smaller where there are more of them.
float dot_radius(std::size_t vertex_count) {
    return 2.0F - 1.2F * crowd_of(vertex_count);
}

float normal_length(std::size_t vertex_count) {
    return std::lerp(longest_normal, shortest_normal, crowd_of(vertex_count));
}

}  // namespace

const GlProgram& VertexMarks::program(const Kind& kind) {
    GlProgram& program = programs_[kind];
    if (!program) program = make_marks_program(kind.first, kind.second);
    return program;
}

void VertexMarks::reload_shaders() {
    std::map<Kind, GlProgram> programs;
    for (const auto& [kind, program] : programs_)
        programs[kind] = make_marks_program(kind.first, kind.second);
    programs_ = std::move(programs);
}

void VertexMarks::draw(const SurfaceBuffers& buffers, const OffscreenTarget& target, const Camera& camera,
                       std::span<const float> weights, const Display& display) {
    if (!display.vertices && !display.normals) return;
    const float aspect = static_cast<float>(target.width()) / static_cast<float>(target.height());
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LEQUAL);
    glDepthMask(GL_FALSE);
    glEnable(GL_BLEND);
    glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    glBindVertexArray(buffers.attributes().name());
    for (const bool normals : {true, false}) {
        if (!(normals ? display.normals : display.vertices)) continue;
        const GlProgram& marks = program({buffers.key_count(), normals});
        const auto place = [&](const char* name) { return glGetUniformLocation(marks.name(), name); };
        const std::size_t step = normals ? (buffers.vertex_count() + max_normals - 1) / max_normals : 1;
        glUseProgram(marks.name());
        glUniformMatrix4fv(place("view"), 1, GL_FALSE, glm::value_ptr(camera.view()));
        glUniformMatrix4fv(place("projection"), 1, GL_FALSE, glm::value_ptr(camera.projection(aspect)));
        glUniform1fv(place("weights"), static_cast<GLsizei>(weights.size()), weights.data());
        glUniform2f(place("size"), static_cast<float>(target.width()), static_cast<float>(target.height()));
        glUniform1f(place("mark_size"),
                    display.line_width * (normals ? 0.5F : dot_radius(buffers.vertex_count())));
        glUniform1f(place("line_length"), normal_length(buffers.vertex_count()) * display.line_width);
        glUniform1i(place("step_size"), static_cast<GLint>(std::max<std::size_t>(step, 1)));
        glDrawArrays(GL_POINTS, 0, static_cast<GLsizei>(buffers.vertex_count()));
    }
    glDepthMask(GL_TRUE);
    glDisable(GL_BLEND);
}

}  // namespace interleaf
