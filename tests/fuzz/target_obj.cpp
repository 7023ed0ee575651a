// Wavefront OBJ files.
#include <algorithm>
#include <string>

#include "fuzz/scratch_file.h"
#include "fuzz/target.h"

#include "hierarchy/checker.h"
#include "io/mesh/mesh_writer.h"
#include "io/mesh/obj_keys.h"

namespace interleaf::fuzz {

namespace {

Hierarchy read_bytes(ByteSpan bytes) {
    static const ScratchFile file("mesh.obj");
    file.set_content(bytes);
    return read_obj(file.path());
}

Inspection read(ByteSpan bytes) {
    return [mesh = read_bytes(bytes)]() -> std::string {
        if (!check(mesh).empty()) return "unsound: " + check(mesh).front();
        const std::string text = obj_text(mesh.roots.triangles(), mesh.positions);
        const Hierarchy again = read_bytes(std::as_bytes(std::span(text)));
        const bool is_same = again.roots == mesh.roots && std::ranges::equal(again.positions, mesh.positions);
        return is_same ? "" : "changed by writing and reading it";
    };
}

}  // namespace

const Target target{"obj", read, whole_as_part, first_part, own_size};

}  // namespace interleaf::fuzz
