#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <memory_resource>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "femoop/model/fault/fault.h"

namespace femoop {

enum class JsonKind : std::uint8_t { Absent, Null, Boolean, Number, String, Array, Object };

std::string_view name(JsonKind kind); ///< "text", "list", "object", ... for messages

class JsonDocument;

/// A value inside a JsonDocument, or the absence of one: a cursor that is copied freely and dies with the document.
class JsonValue {
public:
    class Iterator;

    JsonValue() = default;
    JsonKind kind() const;
    bool is_present() const { return document_ != nullptr; }
    bool is(JsonKind wanted) const { return kind() == wanted; }

    std::string_view key() const;  ///< of a member of an object
    std::string_view text() const; ///< of a string
    double number() const;         ///< of a number
    bool boolean() const;

    /// The values inside an array or an object, in file order; none in anything else.
    Iterator begin() const;
    Iterator end() const;
    std::size_t size() const; ///< how many: walks over them

private:
    friend class JsonDocument;
    JsonValue(const JsonDocument* document, std::uint32_t index) : document_(document), index_(index) {}

    const JsonDocument* document_ = nullptr;
    std::uint32_t index_ = 0;
};

/// A JSON text, parsed: one flat list of values in file order, so that a file of a million values costs a handful
/// of allocations and freeing it takes no recursion.
class JsonDocument {
public:
    JsonDocument();

    JsonValue root() const;

    static constexpr int deepest = 64; ///< nesting of arrays and objects that is still read

private:
    friend class JsonValue;
    friend class JsonBuilder;
    struct Entry {
        std::string_view key;
        std::string_view text;
        double number = 0.0;
        std::uint32_t end = 0; ///< index just past this value and all that it holds
        JsonKind kind = JsonKind::Null;
    };
    std::string_view keep(std::string_view text);

    std::unique_ptr<std::pmr::monotonic_buffer_resource> texts_;
    std::vector<Entry> entries_;
};

class JsonValue::Iterator {
public:
    Iterator() = default;
    explicit Iterator(JsonValue value) : value_(value) {}
    JsonValue operator*() const { return value_; }
    Iterator& operator++();
    bool operator==(const Iterator& other) const { return value_.index_ == other.value_.index_; }

private:
    JsonValue value_;
};

/// What came of reading a JSON text: a document, unless the text breaks JSON's grammar. A repeated key leaves a
/// document with a fault.
struct JsonReading {
    std::optional<JsonDocument> document;
    std::vector<Fault> faults;
};

/// Reads strict JSON (RFC 8259): no comments, no trailing comma, UTF-8 with or without a byte-order mark, numbers
/// within the range of double, nesting up to JsonDocument::deepest. Faults name line and column (in characters). A
/// number too large is a fault too, but reading goes on behind it.
JsonReading parse_json(std::string_view text);

std::string quoted_json(std::string_view text); ///< a JSON string with its quotation marks

/// The value on one line, as the project writes JSON: {"a": [1, 2]}.
std::string compact_json(JsonValue value);

/// The value with line breaks where it would be wider than `width`, rows of plain values aside; lines after the first
/// are indented by `indent`.
std::string pretty_json(JsonValue value, std::size_t indent, std::size_t width);

} // namespace femoop
