#include "apps/mohr/document/file.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "apps/mohr/document/section_text.h"
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
using ui::Message;
using ui::translatable;

namespace {

constexpr int format = 1;
constexpr std::array<std::string_view, n_subjects> subject_words{"plane_stress", "plane_strain", "strain", "rosette",
                                                                 "inertia",      "space_stress", "section"};
const auto criterion_words = [] {
    std::array<std::string_view, femoop::mohr::all_criteria.size()> words{};
    std::ranges::transform(femoop::mohr::all_criteria, words.begin(),
                           [](Criterion criterion) { return femoop::mohr::word(criterion); });
    return words;
}();
constexpr std::array<std::string_view, n_strengths> strength_words{"fy", "ft", "fc", "c", "phi", "sci", "m", "s"};

JsonValue member(JsonValue object, std::string_view key)
{
    for (const JsonValue value : object)
        if (value.key() == key) return value;
    return {};
}

std::string compact(JsonValue found) { return found.is_present() ? femoop::compact_json(found) : "-"; }

/// Goes on after what it cannot read, and lists it.
class FileReader {
public:
    std::vector<Message> faults;

    std::optional<Document> read(JsonValue root)
    {
        if (!root.is(JsonKind::Object) || !member(root, "cremona").is(JsonKind::Number)) {
            faults.push_back(Message(translatable("it is no file of Mohr's circle: {example} is missing"),
                                     {{"example", "\"cremona\": 1"}}));
            return std::nullopt;
        }
        read_format(member(root, "cremona"));
        document_ = textbook_state();
        const auto subject = choice(member(root, "mohr"), "mohr", subject_words);
        if (subject) document_.subject = static_cast<Subject>(*subject);
        for (const JsonValue value : root)
            if (subject || (value.key() != "state" && value.key() != "path")) read_member(value);
        return subject ? std::optional(document_) : std::nullopt;
    }

private:
    void refuse(std::string_view key, JsonValue found, std::string_view wanted)
    {
        faults.push_back(Message(translatable("\"{key}\": found {found}, wanted {wanted}"),
                                 {{"key", std::string(key)}, {"found", compact(found)}, {"wanted", Message(wanted)}}));
    }

    void refuse_key(std::string_view key)
    {
        faults.push_back(Message(translatable("there is no key \"{key}\""), {{"key", std::string(key)}}));
    }

    void read_format(JsonValue value)
    {
        if (value.number() != format) faults.push_back(sentence({femoop::FaultKind::UnknownFormat, {compact(value)}}));
    }

    template <std::size_t N>
    std::optional<std::size_t> choice(JsonValue value, std::string_view key,
                                      const std::array<std::string_view, N>& words)
    {
        if (value.is(JsonKind::String))
            if (const auto at = std::ranges::find(words, value.text()); at != words.end())
                return static_cast<std::size_t>(at - words.begin());
        std::string list;
        for (const std::string_view word : words) list += (list.empty() ? "" : ", ") + std::string(word);
        faults.push_back(Message(translatable("\"{key}\": found {found}, wanted one of {list}"),
                                 {{"key", std::string(key)}, {"found", compact(value)}, {"list", list}}));
        return std::nullopt;
    }

    void read_text(JsonValue value, std::string_view key, std::string& text)
    {
        if (value.is(JsonKind::Number)) text = femoop::number_text(value.number());
        else if (value.is(JsonKind::String) && value.text().size() < 64) text = std::string(value.text());
        else refuse(key, value, translatable("a number, or a text such as \"50 MPa\""));
    }

    void read_number(JsonValue value, std::string_view key, double& number)
    {
        if (value.is(JsonKind::Number)) number = value.number();
        else refuse(key, value, translatable("a number"));
    }

    void read_list(JsonValue value, std::string_view key, std::vector<std::string>& texts)
    {
        if (!value.is(JsonKind::Array) || value.size() != texts.size())
            return refuse(key, value, translatable("a list of as many numbers as the state has"));
        std::size_t i = 0;
        for (const JsonValue number : value) read_text(number, key, texts[i++]);
    }

    void read_normal(JsonValue value)
    {
        if (!value.is(JsonKind::Array) || value.size() != 3)
            return refuse("normal", value, translatable("a list of three numbers"));
        std::size_t i = 0;
        for (const JsonValue number : value) read_number(number, "normal", document_.normal[i++]);
    }

    void read_strengths(JsonValue object)
    {
        if (!object.is(JsonKind::Object)) return refuse("strength", object, translatable("an object"));
        for (const JsonValue value : object) {
            const auto at = std::ranges::find(strength_words, value.key());
            if (at == strength_words.end()) refuse_key(value.key());
            else
                read_text(value, value.key(),
                          document_.strengths[static_cast<std::size_t>(at - strength_words.begin())]);
        }
    }

    void read_path(JsonValue value)
    {
        if (!value.is(JsonKind::Array) || !has_path(document_.subject))
            return refuse("path", value, translatable("a list of states, of a plane stress or strain"));
        for (const JsonValue state : value) {
            std::vector<std::string> texts(document_.state().size(), "0");
            read_list(state, "path", texts);
            document_.path().push_back(std::move(texts));
        }
    }

    void read_criterion(JsonValue value)
    {
        if (const auto criterion = choice(value, "criterion", criterion_words))
            document_.criterion = static_cast<Criterion>(*criterion);
    }

    void read_member(JsonValue value)
    {
        const std::string_view key = value.key();
        if (key == "state") read_list(value, key, document_.state());
        else if (key == "angle") read_number(value, key, document_.angle);
        else if (key == "normal") read_normal(value);
        else if (key == "E") read_text(value, key, document_.elasticity[0]);
        else if (key == "nu") read_text(value, key, document_.elasticity[1]);
        else if (key == "criterion") read_criterion(value);
        else if (key == "section") read_text(value, key, document_.section);
        else if (key == "path") read_path(value);
        else if (key == "strength") read_strengths(value);
        else if (key != "cremona" && key != "mohr") refuse_key(key);
    }

    Document document_;
};

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
    json.begin_object(femoop::JsonWriter::Layout::Block)
        .member("cremona", format)
        .member("mohr", word(document.subject));
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

std::variant<Document, std::vector<Message>> read_file_text(std::string_view text)
{
    const femoop::JsonReading reading = femoop::parse_json(text);
    FileReader reader;
    for (const femoop::Fault& fault : reading.faults) reader.faults.push_back(sentence(fault));
    const bool is_json = reading.document && reader.faults.empty();
    std::optional<Document> document = is_json ? reader.read(reading.document->root()) : std::nullopt;
    if (document)
        for (Fault& fault : faults(*document)) reader.faults.push_back(std::move(fault.reason));
    if (!document || !reader.faults.empty()) return std::move(reader.faults);
    return *std::move(document);
}

namespace {

/// Written in one way or another.
bool is_same_section(const std::string& a, const std::string& b)
{
    using femoop::mohr::SectionFigure;
    const auto first = section_figure(a), second = section_figure(b);
    const auto *const one = std::get_if<SectionFigure>(&first), *const other = std::get_if<SectionFigure>(&second);
    if (one == nullptr || other == nullptr) return a == b;
    const auto is_near = [](double x, double y) { return std::abs(x - y) <= 1e-9 * std::abs(x); };
    return is_near(one->area(), other->area()) && is_near(one->Iz(), other->Iz()) &&
           is_near(one->top(), other->top()) && is_near(one->bottom(), other->bottom()) &&
           is_near(one->outline().width(), other->outline().width());
}

} // namespace

Document with_section_of(const Document& document, const Document& other)
{
    Document next = document;
    constexpr auto section = static_cast<std::size_t>(Subject::Section);
    const std::string fibre = document.numbers[section].back();
    next.subject = Subject::Section;
    if (!is_same_section(document.section, other.section)) next.section = other.section;
    next.elasticity = other.elasticity;
    next.strengths[static_cast<std::size_t>(StrengthPlace::fy)] =
        other.strengths[static_cast<std::size_t>(StrengthPlace::fy)];
    next.numbers[section] = other.numbers[section];
    Document as_it_was = next;
    as_it_was.state().back() = fibre;
    return why_not(as_it_was) ? next : as_it_was;
}

std::string file_text_of_section(const Document& document)
{
    return file_text(with_section_of(textbook_state(), document));
}

std::string_view word(Subject subject) { return subject_words[static_cast<std::size_t>(subject)]; }

} // namespace mohr
