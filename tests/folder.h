#pragma once

#include <filesystem>
#include <string>

/// A new folder for one test, gone when the test ends.
class Folder {
public:
    Folder();
    ~Folder();
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;

    const std::filesystem::path& path() const { return path_; }
    std::string path(const std::string& name) const { return (path_ / name).string(); }
    std::string write(const std::string& name, const std::string& text) const; ///< gives its path
    std::string read(const std::string& name) const;                           ///< "" where there is none
    bool has(const std::string& name) const { return std::filesystem::exists(path_ / name); }
    long n_entries() const;

private:
    std::filesystem::path path_;
};
