#pragma once

#include <string_view>

namespace outline {

/// Reads numbers and letters as SVG packs them: "M10-5.5.5L3,4".
class SvgScanner {
public:
    explicit SvgScanner(std::string_view text) : rest_(text) {}

    bool is_at_end();                             ///< but for blanks and commas
    bool is_at_number();                          ///< what comes next can begin one
    char letter();                                ///< takes what comes next. \pre not at the end
    double number();                              ///< \throws topology::LineError where none comes next
    bool flag();                                  ///< 0 or 1, which need not be separated from what follows
    std::string_view word(std::string_view ends); ///< up to one of these letters, which stays

private:
    void skip_blanks();
    std::string_view rest_;
};

} // namespace outline
