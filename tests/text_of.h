#pragma once

#include <filesystem>
#include <string>

/// All bytes of a file; "" where there is none.
std::string text_of(const std::filesystem::path& path);
/// The same of a file of the sources, by its path from their top folder.
std::string text_of_source(const std::string& path);
