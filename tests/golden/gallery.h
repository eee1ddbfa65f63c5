#pragma once

#include "ui/context/pixels.h"

#include <filesystem>
#include <optional>
#include <string>

namespace golden {

/// A picture of a test and the strings in it.
struct Exhibit {
    std::string name; ///< of its files: letters, digits, - and _
    std::string text;
    std::optional<ui::Pixels> pixels; ///< nothing where there is no renderer: the text alone is judged
};

struct Verdict {
    bool is_good = false;
    std::string words; ///< what differs, and where the pictures of it are
};

/// The reference pictures, NAME.webp and NAME.txt, and a folder for what differs from them.
class Gallery {
public:
    Gallery(std::filesystem::path references, std::filesystem::path failures)
        : references_(std::move(references)), failures_(std::move(failures))
    {}

    /// Compares with the reference. What fails is written to the failures' folder: NAME.new.png and .webp,
    /// NAME.reference.png, NAME.difference.png, NAME.new.txt, NAME.html, and an index.html of all; what is good is removed.
    Verdict judge(const Exhibit& exhibit) const;

private:
    std::filesystem::path reference(const std::string& name, const char* ending) const;
    std::filesystem::path failure(const std::string& name, const char* ending) const;
    std::string fault_of_text(const Exhibit& exhibit) const;
    std::string fault_of_pixels(const Exhibit& exhibit) const;
    void keep(const Exhibit& exhibit, const std::string& words) const;
    void forget(const std::string& name) const;
    void write_page(const std::string& name, const std::string& words) const;
    void write_index() const;

    std::filesystem::path references_;
    std::filesystem::path failures_;
};

} // namespace golden
