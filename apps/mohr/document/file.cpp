#include "apps/mohr/document/file.h"

#include <algorithm>
#include <optional>

#include "apps/mohr/document/solution.h"
#include "femoop/io/json/json_document.h"
#include "femoop/io/json/json_writer.h"
#include "femoop/methods/mohr/criterion_names.h"
#include "femoop/model/quantity/number_text.h"
#include "ui/text/catalogue.h"

namespace mohr {

using femoop::JsonKind;
using femoop::JsonValue;
using femoop::mohr::Criterion;
using ui::Phrase;
using ui::translatable;

namespace {

constexpr std::array<std::string_view, n_subjects> subject_words{"plane_stress", "plane_strain", "strain", "rosette",
                                                                 "inertia",      "space_stress", "section"};
const auto criterion_words = [] {
    std::array<std::string_view, femoop::mohr::all_criteria.size()> words{};
    std::ranges::transform(femoop::mohr::all_criteria, words.begin(),
                           [](Criterion criterion) { return femoop::mohr::word(criterion); });
    return words;
}();
constexpr std::array<std::string_view, n_strengths> strength_words{"fy", "ft", "fc", "c", "phi", "sci", "m", "s"};

/// What a key's value was and should have been.
struct Refusal {
    Phrase reason;
};

[[noreturn]] void refuse(std::string_view key, JsonValue found, std::string_view wanted)
{
    const std::string what = found.is_present() ? femoop::compact_json(found) : "-";
    throw Refusal{Phrase(translatable("\"{key}\": found {found}, wanted {wanted}"),
                         {{"key", std::string(key)}, {"found", what}, {"wanted", Phrase(wanted)}})};
}

template <std::size_t N>
std::size_t choice(JsonValue value, std::string_view key, const std::array<std::string_view, N>& words)
{
    if (value.is(JsonKind::String))
        if (const auto at = std::ranges::find(words, value.text()); at != words.end())
            return static_cast<std::size_t>(at - words.begin());
    std::string list;
    for (const std::string_view word : words) list += (list.empty() ? "" : ", ") + std::string(word);
    throw Refusal{Phrase(translatable("\"{key}\": found {found}, wanted one of {list}"),
                         {{"key", std::string(key)},
                          {"found", value.is_present() ? femoop::compact_json(value) : "-"},
                          {"list", list}})};
}

std::string number_text_of(JsonValue value, std::string_view key)
{
    if (value.is(JsonKind::Number)) return femoop::number_text(value.number());
    if (value.is(JsonKind::String) && value.text().size() < 64) return std::string(value.text());
    refuse(key, value, translatable("a number, or a text such as \"50 MPa\""));
}

double number_of(JsonValue value, std::string_view key)
{
    if (!value.is(JsonKind::Number)) refuse(key, value, translatable("a number"));
    return value.number();
}

void read_list(JsonValue value, std::string_view key, std::vector<std::string>& texts)
{
    if (!value.is(JsonKind::Array) || value.size() != texts.size())
        refuse(key, value, translatable("a list of as many numbers as the state has"));
    std::size_t i = 0;
    for (const JsonValue number : value) texts[i++] = number_text_of(number, key);
}

void read_normal(JsonValue value, std::array<double, 3>& normal)
{
    if (!value.is(JsonKind::Array) || value.size() != 3)
        refuse("normal", value, translatable("a list of three numbers"));
    std::size_t i = 0;
    for (const JsonValue number : value) normal[i++] = number_of(number, "normal");
}

void read_strengths(JsonValue object, Document& document)
{
    if (!object.is(JsonKind::Object)) refuse("strength", object, translatable("an object"));
    for (const JsonValue value : object) {
        const auto at = std::ranges::find(strength_words, value.key());
        if (at == strength_words.end())
            throw Refusal{Phrase(translatable("there is no key \"{key}\""), {{"key", std::string(value.key())}})};
        document.strengths[static_cast<std::size_t>(at - strength_words.begin())] = number_text_of(value, value.key());
    }
}

void read_path(JsonValue value, Document& document)
{
    if (!value.is(JsonKind::Array) || !has_path(document.subject))
        refuse("path", value, translatable("a list of states, of a plane stress or strain"));
    for (const JsonValue state : value) {
        std::vector<std::string> texts(document.state().size());
        read_list(state, "path", texts);
        document.path().push_back(std::move(texts));
    }
}

JsonValue member(JsonValue object, std::string_view key)
{
    for (const JsonValue value : object)
        if (value.key() == key) return value;
    return {};
}

Document read(JsonValue root)
{
    if (!root.is(JsonKind::Object) || !member(root, "cremona").is(JsonKind::Number))
        throw Refusal{Phrase(translatable("it is no file of Mohr's circle: {example} is missing"),
                             {{"example", "\"cremona\": 1"}})};
    Document document = textbook_state();
    document.subject = static_cast<Subject>(choice(member(root, "mohr"), "mohr", subject_words));
    for (const JsonValue value : root) {
        const std::string_view key = value.key();
        if (key == "state") read_list(value, key, document.state());
        else if (key == "angle") document.angle = number_of(value, key);
        else if (key == "normal") read_normal(value, document.normal);
        else if (key == "E") document.elasticity[0] = number_text_of(value, key);
        else if (key == "nu") document.elasticity[1] = number_text_of(value, key);
        else if (key == "criterion") document.criterion = static_cast<Criterion>(choice(value, key, criterion_words));
        else if (key == "section") document.section = number_text_of(value, key);
        else if (key == "path") read_path(value, document);
        else if (key == "strength") read_strengths(value, document);
        else if (key != "cremona" && key != "mohr")
            throw Refusal{Phrase(translatable("there is no key \"{key}\""), {{"key", std::string(key)}})};
    }
    return document;
}

void write(femoop::JsonWriter& json, const std::vector<std::string>& texts)
{
    json.begin_array();
    for (const std::string& text : texts) json.value(std::string_view(text));
    json.end();
}

} // namespace

std::string file_text(const Document& document)
{
    femoop::JsonWriter json;
    json.begin_object(femoop::JsonWriter::Layout::Block).member("cremona", 1).member("mohr", word(document.subject));
    json.key("state");
    write(json, document.state());
    json.member("angle", document.angle);
    json.key("normal").begin_array();
    for (const double part : document.normal) json.value(part);
    json.end();
    if (!document.path().empty()) {
        json.key("path").begin_array();
        for (const auto& state : document.path()) write(json, state);
        json.end();
    }
    if (document.subject == Subject::Section) json.member("section", std::string_view(document.section));
    json.member("E", std::string_view(document.elasticity[0])).member("nu", std::string_view(document.elasticity[1]));
    if (document.criterion) json.member("criterion", word(*document.criterion));
    json.key("strength").begin_object();
    for (std::size_t i = 0; i < n_strengths; ++i)
        json.member(strength_words[i], std::string_view(document.strengths[i]));
    json.end().end();
    return json.take();
}

std::variant<Document, Phrase> read_file_text(std::string_view text)
{
    const femoop::JsonReading reading = femoop::parse_json(text);
    if (!reading.document || !reading.faults.empty()) {
        const femoop::Fault& fault = reading.faults.front();
        Phrase reason(femoop::pattern(fault.kind));
        for (std::size_t i = 0; i < fault.arguments.size(); ++i)
            reason.arguments.emplace_back(std::to_string(i), fault.arguments[i]);
        return reason;
    }
    try {
        Document document = read(reading.document->root());
        if (auto fault = why_not(document)) return std::move(fault->reason);
        return document;
    } catch (const Refusal& refusal) {
        return refusal.reason;
    }
}

std::string_view word(Subject subject) { return subject_words[static_cast<std::size_t>(subject)]; }

} // namespace mohr
