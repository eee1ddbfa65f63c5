#include "tests/source_folder.h"

std::string source_folder() { return CREMONA_SOURCE_DIR; }
