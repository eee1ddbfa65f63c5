// The one file that knows nlohmann-json: its SAX parser calls JsonBuilder, which writes the flat document.
#include <algorithm>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <unordered_set>
#include <utility>

#include "femoop/io/json/json_document.h"
#include "femoop/io/json/text_place.h"

namespace femoop {

/// Receives the parser's events. An object or array that is still open keeps its entry's index on a stack of our own.
class JsonBuilder {
public:
    explicit JsonBuilder(std::string_view text) : text_(text) {}

    JsonReading result()
    {
        if (is_sound_) return {std::move(document_), std::move(faults_)};
        return {std::nullopt, std::move(faults_)};
    }
    void refuse(Fault fault)
    {
        if (is_sound_) faults_.push_back(std::move(fault));
        is_sound_ = false;
    }

    bool null() { return add(JsonKind::Null, 0.0, {}); }
    bool boolean(bool value) { return add(JsonKind::Boolean, value ? 1.0 : 0.0, {}); }
    bool number_integer(std::int64_t value) { return add(JsonKind::Number, static_cast<double>(value), {}); }
    bool number_unsigned(std::uint64_t value) { return add(JsonKind::Number, static_cast<double>(value), {}); }
    bool number_float(double value, const std::string& /*text*/) { return add(JsonKind::Number, value, {}); }
    bool string(std::string& value) { return add(JsonKind::String, 0.0, document_.keep(value)); }
    bool binary(nlohmann::json::binary_t& /*value*/) { return false; }

    bool start_object(std::size_t /*size*/) { return open(JsonKind::Object); }
    bool start_array(std::size_t /*size*/) { return open(JsonKind::Array); }
    bool end_object() { return close(); }
    bool end_array() { return close(); }

    bool key(std::string& value)
    {
        Open& object = open_.back();
        const auto known = keys_.find(value);
        key_ = known != keys_.end() ? *known : *keys_.insert(document_.keep(value)).first;
        object.n_keys += 1;
        if (is_repeated(object)) faults_.push_back({FaultKind::RepeatedKey, {path()}});
        return true;
    }

    bool parse_error(std::size_t position, const std::string& /*last_token*/, const nlohmann::detail::exception& error)
    {
        constexpr int number_overflow = 406;
        const bool is_after_end = open_.empty() && !document_.entries_.empty();
        const auto nature = error.id == number_overflow ? SyntaxError::NumberOverflow
                            : is_after_end              ? SyntaxError::AfterEnd
                                                        : SyntaxError::Grammar;
        if (nature == SyntaxError::NumberOverflow) overflow_ = position;
        refuse(syntax_fault(text_, position, nature));
        return false;
    }

    /// Just behind a number that is too large, where the parser stopped.
    std::optional<std::size_t> overflow() const { return overflow_; }

private:
    struct Open {
        std::uint32_t entry = 0;
        std::uint32_t n_keys = 0;
        std::uint32_t n_values = 0;
        std::unordered_set<std::string_view> keys; // of an object with many keys
    };
    using Entry = JsonDocument::Entry;

    bool add(JsonKind kind, double number, std::string_view text)
    {
        if (!open_.empty()) open_.back().n_values += 1;
        Entry entry{key_, text, number, 0, kind};
        key_ = {};
        document_.entries_.push_back(entry);
        document_.entries_.back().end = static_cast<std::uint32_t>(document_.entries_.size());
        return true;
    }

    bool open(JsonKind kind)
    {
        if (open_.size() == JsonDocument::deepest) {
            refuse(depth_fault(text_, JsonDocument::deepest));
            return false;
        }
        add(kind, 0.0, {});
        open_.push_back({static_cast<std::uint32_t>(document_.entries_.size() - 1), 0, 0, {}});
        return true;
    }

    bool close()
    {
        document_.entries_[open_.back().entry].end = static_cast<std::uint32_t>(document_.entries_.size());
        open_.pop_back();
        return true;
    }

    // Few keys are compared one by one, many through a set: neither is slow.
    bool is_repeated(Open& object)
    {
        constexpr std::uint32_t few = 24;
        const JsonDocument& document = document_;
        const auto for_each_key = [&](auto&& visit) {
            for (std::uint32_t i = object.entry + 1; i < document.entries_.size(); i = document.entries_[i].end)
                visit(document.entries_[i].key);
        };
        if (object.n_keys <= few) {
            bool is_known = false;
            for_each_key([&](std::string_view other) { is_known = is_known || other == key_; });
            return is_known;
        }
        if (object.keys.empty()) for_each_key([&](std::string_view other) { object.keys.insert(other); });
        return !object.keys.insert(key_).second;
    }

    std::string path() const
    {
        std::string text;
        for (std::size_t i = 0; i + 1 < open_.size(); ++i) append_step(text, open_[i], open_[i + 1].entry);
        if (!open_.empty() && kind(open_.back()) == JsonKind::Object)
            text += (text.empty() ? "" : ".") + std::string(key_);
        return text;
    }
    JsonKind kind(const Open& open) const { return document_.entries_[open.entry].kind; }
    void append_step(std::string& text, const Open& outer, std::uint32_t inner) const
    {
        if (kind(outer) == JsonKind::Object)
            text += (text.empty() ? "" : ".") + std::string(document_.entries_[inner].key);
        else text += '[' + std::to_string(outer.n_values - 1) + ']';
    }

    std::string_view text_;
    JsonDocument document_;
    std::vector<Open> open_;
    std::unordered_set<std::string_view> keys_; // every key once: objects of one kind share their keys' text
    std::string_view key_;
    std::vector<Fault> faults_;
    bool is_sound_ = true;
    std::optional<std::size_t> overflow_;
};

namespace {

/// Writes 1 for the number that ends there, so that the rest of the file can be read.
void replace_number(std::string& text, std::size_t end)
{
    constexpr std::string_view letters = "0123456789+-.eE";
    std::size_t begin = std::min(end, text.size());
    while (begin > 0 && letters.find(text[begin - 1]) != std::string_view::npos) text[--begin] = ' ';
    text[begin] = '1';
}

/// As nlohmann::json::sax_parse, but without its readers of CBOR and the like, which a page would carry along.
void read_json(std::string_view text, JsonBuilder& builder)
{
    auto input = nlohmann::detail::input_adapter(text.begin(), text.end());
    nlohmann::detail::parser<nlohmann::json, decltype(input)>(std::move(input)).sax_parse(&builder);
}

/// A number too large is told like any other fault: reading goes on behind it.
JsonReading parse_on(std::string_view text)
{
    constexpr std::size_t most = 50; // of such numbers: then somebody's export is broken throughout
    std::vector<Fault> faults;
    std::string mended;
    while (true) {
        JsonBuilder builder(text);
        read_json(text, builder);
        const std::optional<std::size_t> overflow = builder.overflow();
        JsonReading reading = builder.result();
        if (!overflow || faults.size() >= most) {
            faults.insert(faults.end(), reading.faults.begin(), reading.faults.end());
            return {std::move(reading.document), std::move(faults)};
        }
        faults.push_back(reading.faults.back()); // those before it are told again
        if (mended.empty()) mended = text;
        replace_number(mended, *overflow);
        text = mended;
    }
}

} // namespace

JsonReading parse_json(std::string_view text)
{
    constexpr std::string_view byte_order_mark = "\xef\xbb\xbf";
    if (text.substr(0, byte_order_mark.size()) == byte_order_mark) text.remove_prefix(byte_order_mark.size());
    if (text.substr(0, byte_order_mark.size()) == byte_order_mark)
        return {std::nullopt, {{FaultKind::FileWithSecondMark, {}}}};
    if (const auto fault = text_fault(text)) return {std::nullopt, {*fault}};
    return parse_on(text);
}

} // namespace femoop
