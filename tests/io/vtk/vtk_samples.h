// A small mesh as VTK files, in each of the encodings that the format has.
#pragma once

#include <string>
#include <vector>

#include "hierarchy/field_mesh.h"

namespace interleaf {

enum class VtkEncoding { words, inline_base64, appended_raw, appended_base64 };

struct XmlStyle {
    VtkEncoding encoding = VtkEncoding::words;
    bool has_wide_headers = false;
    bool is_big_endian = false;
    bool is_compressed = false;
};

/// Each style that a writer may choose.
std::vector<XmlStyle> all_xml_styles();

/// For messages of tests.
std::string name_of(const XmlStyle& style);

/// A .vtu file of seven cells: a triangle, a quadrilateral, a vertex, a line, a pixel, a strip and a polygon.
std::string sample_grid(const XmlStyle& style);

/// The same mesh in the legacy format, of version 4 (cells in one list) or 5 (offsets and points).
std::string sample_legacy(bool is_binary, bool is_version_5);

/// What a reader makes of sample_grid().
FieldMesh sample_mesh();

/// What a reader makes of sample_legacy(), which has a time, too.
FieldMesh legacy_sample_mesh();

}  // namespace interleaf
