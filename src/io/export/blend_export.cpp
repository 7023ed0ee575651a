#include "io/export/blend_export.h"

#include "hierarchy/morph.h"
#include "io/mesh/mesh_writer.h"

namespace interleaf {

void export_obj(const Export& exported, const OutputTarget& target) {
    const Blend blend = blend_of(exported);
    write_output(target,
                 obj_text(blend.mesh.triangles, blend.positions, blend.fields, exported.family.origin));
}

void export_ply(const Export& exported, const OutputTarget& target) {
    const Blend blend = blend_of(exported);
    write_output(target, ply_bytes(blend.mesh.triangles, blend.positions, blend.fields,
                                   exported.family.origin, exported.family.field_scales));
}

void export_key(const Export& exported, const OutputTarget& target) {
    const Blend blend = blend_of(exported);
    write_output(target, serialize_hierarchy(morphed_hierarchy(blend.mesh, blend.weights), exported.form));
}

}  // namespace interleaf
