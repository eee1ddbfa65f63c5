#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "femoop/model/fault/fault.h"

namespace femoop {

/// Line and column of a byte in a text, both from 1; columns count characters.
struct TextPlace {
    std::size_t line = 1;
    std::size_t column = 1;
};
TextPlace place_of(std::string_view text, std::size_t offset);

/// Why these bytes are not a text at all: nothing but blanks, not UTF-8, control characters. Nothing if they are.
std::optional<Fault> text_fault(std::string_view text);

enum class SyntaxError : std::uint8_t { Grammar, NumberOverflow, AfterEnd };

/// The bracket that nests deeper than `deepest`. \pre there is one.
Fault depth_fault(std::string_view text, int deepest);

/// What a person should do about a JSON text that a parser refused after reading `position` bytes.
Fault syntax_fault(std::string_view text, std::size_t position, SyntaxError error);

} // namespace femoop
