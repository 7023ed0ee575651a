#include "app/cli/family_command.h"

#include <string>

#include "app/cli/error_message.h"
#include "app/document/opening.h"
#include "io/family/family_file.h"

namespace interleaf {

void run_family(const FamilyOptions& options) {
    std::vector<std::string> changes;
    const Family family = open_family(options.keys, &changes);
    write_family(family, options.output, options.form);
    for (const std::string& change : changes) print_error(change);
}

}  // namespace interleaf
