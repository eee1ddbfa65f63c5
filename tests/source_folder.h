#pragma once

#include <string>

/// The top folder of the sources, without a stroke at its end.
std::string source_folder();
