#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace ui {

/// One message of a translation file: the sentence in the source's English, and in the file's language.
struct PoEntry {
    std::string id;
    std::string text;
    std::size_t line = 0; ///< of its `msgid`, from 1

    friend bool operator==(const PoEntry&, const PoEntry&) = default;
};

/// What cannot be read in a translation file: "line 12: ...".
class PoError : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// Reads the part of gettext's PO format that this program writes: comments (`#`), `msgid` and `msgstr`, strings that
/// go on over several lines, the escapes \n \t \" and \\. The header entry (empty msgid) is left out. \throws PoError
/// for anything else, an empty translation or a repeated msgid
std::vector<PoEntry> read_po(std::string_view text);

} // namespace ui
