// Tests of loading and compiling shaders.
#include "render/shader.h"

#include <algorithm>
#include <string>

#include <doctest/doctest.h>

#include "hierarchy/error.h"
#include "render/context.h"
#include "render/embedded_shaders.h"

using namespace interleaf;

namespace {

std::string failure(std::string_view definitions) {
    constexpr std::string_view files[] = {"surface.vert", "surface.frag"};
    try {
        link_program(files, definitions);
    } catch (const InputError& error) {
        return error.what();
    }
    return {};
}

}  // namespace

TEST_CASE("every embedded shader equals the file on disk") {
    CHECK(embedded_shaders().size() == 13);
    for (const EmbeddedShader& shader : embedded_shaders()) {
        CAPTURE(shader.file);
        CHECK(shader.source.starts_with("#version 330 core\n"));
        CHECK(shader_source(shader.file) == shader.source);
    }
    CHECK_THROWS_AS(shader_source("no such file"), InputError);
}

TEST_CASE("the error of a shader that does not compile names file and line") {
    const EglContext context;
    CHECK(failure("#define KEY_COUNT 2\n#define EDGES 0").empty());
    const std::string message = failure("#define KEY_COUNT wrong\n#define EDGES 0");
    const std::string source = shader_source("surface.vert");
    const auto first_use = source.find("[KEY_COUNT]");
    const auto line =
        1 + std::count(source.begin(), source.begin() + static_cast<std::ptrdiff_t>(first_use), '\n');
    CAPTURE(message);
    CHECK(message.starts_with("surface.vert:" + std::to_string(line) + ":"));
}

TEST_CASE("the error names stages that do not match") {
    const EglContext context;
    const std::string message =
        failure("#define KEY_COUNT 2\n#define EDGES 1");  // needs the output of surface.geom
    CAPTURE(message);
    CHECK(message.find("surface.frag") != std::string::npos);
}

TEST_CASE("lines are recognized in the messages of every driver") {
    CHECK(name_lines("0:12(5): error: x\n0:13(1): error: y", "a.frag") ==
          "a.frag:12: error: x\na.frag:13: error: y");
    CHECK(name_lines("0(12) : error C0000: x", "a.frag") == "a.frag:12: error C0000: x");
    CHECK(name_lines("ERROR: 0:12: 'x' : y", "a.frag") == "a.frag:12: 'x' : y");
    CHECK(name_lines("12 shaders failed\nat once", "a.frag") == "12 shaders failed\nat once");
    CHECK(name_lines("", "a.frag").empty());
}
