// Progress reports of long work, for the files of this layer.
#pragma once

#include "hierarchy/progress.h"  // IWYU pragma: export
