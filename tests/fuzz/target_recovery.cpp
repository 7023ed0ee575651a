// The note beside a document that was kept for recovery.
#include <string>

#include "fuzz/target.h"

#include "app/storage/recovery.h"
#include "io/family/family_format.h"
#include "text/characters.h"

namespace interleaf::fuzz {

namespace {

constexpr std::string_view name = "recovery.json";

std::string inspected(const RecoveryNote& note) {
    if (!is_printable(note.name)) return "unsound: name";
    if (!note.document_folder.empty() && !note.document_folder.is_absolute()) return "unsound: folder";
    if (note.time < 0) return "unsound: time";
    return parse_recovery_note(recovery_note_text(note), name) == note ? ""
                                                                       : "changed by writing and reading it";
}

Inspection read(ByteSpan bytes) {
    const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    return [note = parse_recovery_note(text, name)] { return inspected(note); };
}

}  // namespace

const Target target{"recovery", read, whole_as_part, first_part, own_size};

}  // namespace interleaf::fuzz
