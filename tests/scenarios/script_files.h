#pragma once

#include "tests/folder.h"
#include "tests/text_of.h"

#include <filesystem>
#include <string>
#include <vector>

/// Where this repository's files are.
std::filesystem::path repository();
/// The scenarios of a folder of it, in the order of their names; in a build for browsers without those that write
/// PDF and those in which rounding decides.
std::vector<std::filesystem::path> scenarios_in(const std::filesystem::path& folder);
/// The blocks of a page that are marked as scenarios, one after the other.
std::string scenario_on(const std::string& page);

/// A scenario finds the files of the repository under their own paths, and what it writes is gone when it ends.
class Workplace {
public:
    Workplace();
    /// One that has nothing but a copy of this file of the repository: whatever is saved, the repository stays as it is.
    explicit Workplace(const std::filesystem::path& file);
    ~Workplace() { std::filesystem::current_path(home_); }
    Workplace(const Workplace&) = delete;
    Workplace& operator=(const Workplace&) = delete;

private:
    std::filesystem::path go_to_desk() const;

    std::filesystem::path home_ = std::filesystem::current_path();
    Folder folder_;
};
