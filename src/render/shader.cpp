// Compiles and links. Errors name the file and the line.
#include "render/shader.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>

#include <fmt/core.h>
#include <glad/gl.h>

#include "hierarchy/error.h"
#include "render/embedded_shaders.h"

namespace interleaf {
namespace {

std::optional<std::string> read_text(const std::filesystem::path& path) {
    std::ifstream stream(path, std::ios::binary);
    if (!stream) return std::nullopt;
    return std::string(std::istreambuf_iterator<char>(stream), {});
}

GLenum stage_of(std::string_view file) {
    if (file.ends_with(".vert")) return GL_VERTEX_SHADER;
    if (file.ends_with(".geom")) return GL_GEOMETRY_SHADER;
    return GL_FRAGMENT_SHADER;
}

/// \p source with \p definitions behind its first line, because GLSL requires #version to come first. Line
/// numbers stay the same.
std::string with_definitions(const std::string& source, std::string_view definitions) {
    const std::size_t end_of_version = source.find('\n') + 1;
    return fmt::format("{}{}\n#line 2\n{}", source.substr(0, end_of_version), definitions,
                       source.substr(end_of_version));
}

/// The compiler's or the linker's message about the object \p name.
std::string log_of(GLuint name, PFNGLGETSHADERIVPROC get, PFNGLGETSHADERINFOLOGPROC get_log) {
    GLint length = 0;
    get(name, GL_INFO_LOG_LENGTH, &length);
    std::string log(static_cast<std::size_t>(length), '\0');
    get_log(name, length, &length, log.data());
    log.resize(static_cast<std::size_t>(length));
    return log;
}

/// A shader object, which lives until its program is linked.
class Stage {
  public:
    Stage(std::string_view file, std::string_view definitions) : name_(glCreateShader(stage_of(file))) {
        const std::string source = with_definitions(shader_source(file), definitions);
        const char* text = source.c_str();
        glShaderSource(name_, 1, &text, nullptr);
        glCompileShader(name_);
    }
    ~Stage() { glDeleteShader(name_); }
    Stage(const Stage&) = delete;
    Stage& operator=(const Stage&) = delete;

    GLuint name() const { return name_; }

    /// The compiler's message; none if the shader compiled.
    std::optional<std::string> failure() const {
        GLint compiled = 0;
        glGetShaderiv(name_, GL_COMPILE_STATUS, &compiled);
        if (compiled != 0) return std::nullopt;
        return log_of(name_, glGetShaderiv, glGetShaderInfoLog);
    }

  private:
    GLuint name_;
};

std::string link_failure(GLuint program) {
    return log_of(program, glGetProgramiv, glGetProgramInfoLog);
}

/// Removes the first \p count characters from \p text and returns them.
std::string_view take(std::string_view& text, std::size_t count) {
    const std::string_view taken = text.substr(0, count);
    text.remove_prefix(taken.size());
    return taken;
}

std::string_view take_digits(std::string_view& text) {
    return take(text, std::min(text.find_first_not_of("0123456789"), text.size()));
}

/// Mesa writes 0:12(5):, NVIDIA 0(12) :, others ERROR: 0:12:, where 0 is the file and 12 the line.
std::string name_line(std::string_view line, std::string_view file) {
    constexpr std::string_view error = "ERROR: ";
    std::string_view rest = line;
    if (rest.starts_with(error)) rest.remove_prefix(error.size());
    const bool has_file = !take_digits(rest).empty();
    const std::string_view separator = take(rest, 1);
    const std::string_view number = take_digits(rest);
    if (!has_file || number.empty() || (separator != ":" && separator != "(")) return std::string(line);
    return fmt::format("{}:{}{}", file, number, rest.substr(std::min(rest.find(':'), rest.size())));
}

}  // namespace

std::string shader_source(std::string_view file) {
    if (auto text = read_text(std::filesystem::path(INTERLEAF_SHADER_FOLDER) / file)) return *std::move(text);
    for (const EmbeddedShader& shader : embedded_shaders())
        if (shader.file == file) return std::string(shader.source);
    throw InputError(fmt::format("shader {}: there is no such file", file));
}

std::string name_lines(std::string_view log, std::string_view file) {
    std::string named;
    while (!log.empty()) {
        const std::string_view line = take(log, std::min(log.find('\n'), log.size() - 1) + 1);
        named += name_line(line, file);
    }
    return named;
}

GlProgram link_program(std::span<const std::string_view> files, std::string_view definitions) {
    GlProgram program = GlProgram::create();
    for (const std::string_view file : files) {
        const Stage stage(file, definitions);
        if (const auto failure = stage.failure()) throw InputError(name_lines(*failure, file));
        glAttachShader(program.name(), stage.name());
    }
    glLinkProgram(program.name());
    GLint linked = 0;
    glGetProgramiv(program.name(), GL_LINK_STATUS, &linked);
    if (linked == 0)
        throw InputError(
            fmt::format("{} with {}: {}", files.front(), files.back(), link_failure(program.name())));
    return program;
}

}  // namespace interleaf
