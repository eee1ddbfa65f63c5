#include "apps/cli/mohr_cases.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <optional>
#include <string_view>
#include <vector>

#include "apps/cli/model_input.h"
#include "apps/cli/mohr_results.h"
#include "apps/cli/solid_file.h"
#include "femoop/io/json/json_document.h"
#include "femoop/io/json/json_writer.h"
#include "femoop/io/verify.h"
#include "femoop/model/check/suggestion.h"
#include "femoop/model/quantity/number_text.h"

namespace cli {

namespace {

using femoop::JsonKind;
using femoop::JsonValue;
using femoop::Verdict;

constexpr double usual_rtol = 1e-6;

JsonValue member(JsonValue object, std::string_view key)
{
    for (const JsonValue value : object)
        if (object.is(JsonKind::Object) && value.key() == key) return value;
    return {};
}

/// One comparison: a key of `expected` and how it came out.
struct StateCheck {
    std::string what, expected, result, tolerance;
    Verdict verdict = Verdict::Passed;
};

UsageError no_list(const std::string& file, const ui::Catalogue& tr)
{
    return UsageError(file + ": " + tr("wanted a list of cases: [{\"id\": ..., ...}]"));
}

class CaseFile {
public:
    CaseFile(std::string name, const ui::Catalogue& tr) : name_(std::move(name)), tr_(tr) {}

    std::vector<StateCheck> run(JsonValue root) const
    {
        if (!root.is(JsonKind::Array)) throw no_list(name_, tr_);
        std::vector<StateCheck> checks;
        std::size_t i = 0;
        for (const JsonValue entry : root) {
            const std::string place = "[" + std::to_string(i++) + "]";
            const JsonValue id = member(entry, "id");
            run_entry(entry, id.is(JsonKind::String) ? std::string(id.text()) : place, checks);
        }
        return checks;
    }

private:
    UsageError refused(const std::string& place, const std::string& reason) const
    {
        return UsageError(name_ + ": " + place + ": " + reason);
    }

    void run_entry(JsonValue entry, const std::string& id, std::vector<StateCheck>& checks) const
    {
        const JsonValue expected = member(entry, "expected");
        if (!member(entry, "input").is(JsonKind::Object) || !expected.is(JsonKind::Object))
            throw refused(id, tr_("wanted an object with \"input\" and \"expected\""));
        const double rtol = tolerance(entry, "rtol", usual_rtol, id), atol = tolerance(entry, "atol", 0.0, id);
        std::vector<MohrResult> results;
        try {
            results = mohr_results(mohr_problem(words(entry, id), tr_));
        } catch (const UsageError& error) {
            throw refused(id, error.what());
        }
        for (const JsonValue value : expected) checks.push_back(compare(id, value, results, rtol, atol));
    }

    double tolerance(JsonValue entry, std::string_view key, double otherwise, const std::string& id) const
    {
        const JsonValue value = member(entry, key);
        if (!value.is_present()) return otherwise;
        if (value.is(JsonKind::Number) && value.number() >= 0.0) return value.number();
        throw refused(id, tr_("{key}: found {found}; wanted a number that is not negative",
                              {{"key", key}, {"found", femoop::compact_json(value)}}));
    }

    /// A number as it stands, or a text such as "200 GPa".
    std::string word(JsonValue value, const std::string& place) const
    {
        if (value.is(JsonKind::Number)) return femoop::number_text(value.number());
        if (value.is(JsonKind::String)) return std::string(value.text());
        if (!value.is_present()) return "";
        throw refused(place, tr_("found {found}; wanted a number", {{"found", femoop::compact_json(value)}}));
    }

    std::vector<std::string> list(JsonValue value, const std::string& place) const
    {
        std::vector<std::string> words;
        if (!value.is_present()) return words;
        if (!value.is(JsonKind::Array) || value.size() == 0)
            throw refused(place,
                          tr_("found {found}; wanted a list of numbers", {{"found", femoop::compact_json(value)}}));
        for (const JsonValue number : value) words.push_back(word(number, place));
        return words;
    }

    /// What the input says, with what may stand in the rosette, in the input or beside it.
    MohrWords words(JsonValue entry, const std::string& id) const
    {
        const JsonValue input = member(entry, "input"), rosette = member(input, "rosette");
        const auto anywhere = [&](std::string_view key) {
            for (const JsonValue place : {rosette, input, member(input, "material"), entry})
                if (const JsonValue found = member(place, key); found.is_present()) return found;
            return JsonValue();
        };
        MohrWords words;
        words.stress = list(member(input, "stress"), id + ".stress");
        words.strain = list(member(input, "strain"), id + ".strain");
        words.inertia = list(member(input, "inertia"), id + ".inertia");
        if (rosette.is_present()) {
            words.rosette_angles = list(member(rosette, "angles"), id + ".rosette.angles");
            words.rosette_readings = list(member(rosette, "readings"), id + ".rosette.readings");
            if (words.rosette_angles.empty()) throw refused(id + ".rosette", tr_("\"angles\" are missing"));
        }
        words.normal = list(anywhere("normal"), id + ".normal");
        words.angle = word(anywhere("angle"), id + ".angle");
        words.E = word(anywhere("E"), id + ".E");
        words.nu = word(anywhere("nu"), id + ".nu");
        if (words.reading_unit = word(anywhere("reading_unit"), id + ".reading_unit");
            words.reading_unit == "microstrain")
            words.reading_unit = "1e-6";
        words.is_plane_strain = anywhere("plane_strain").is(JsonKind::Boolean) && anywhere("plane_strain").boolean();
        return words;
    }

    std::string number(double value, int digits = 10) const
    {
        std::array<char, 32> buffer{};
        static_cast<void>(std::snprintf(buffer.data(), buffer.size(), "%.*g", digits, value));
        return femoop::localized(buffer.data(), tr_);
    }

    std::string text(const MohrResult::Value& value) const
    {
        if (const auto* one = std::get_if<double>(&value)) return number(*one);
        const auto* values = std::get_if<std::vector<double>>(&value);
        if (values == nullptr) return tr_("none");
        std::string joined;
        for (const double v : *values) joined += (joined.empty() ? "" : " ") + number(v);
        return joined;
    }

    MohrResult::Value wanted(JsonValue value, const std::string& place) const
    {
        if (value.is(JsonKind::Null)) return std::monostate{};
        if (value.is(JsonKind::Number)) return value.number();
        std::vector<double> values;
        for (const JsonValue v : value)
            if (v.is(JsonKind::Number)) values.push_back(v.number());
        if (!value.is(JsonKind::Array) || values.size() != value.size())
            throw refused(place, tr_("found {found}; wanted a number, a list of numbers or null",
                                     {{"found", femoop::compact_json(value)}}));
        return values;
    }

    StateCheck compare(const std::string& id, JsonValue expected, const std::vector<MohrResult>& results, double rtol,
                       double atol) const
    {
        StateCheck check;
        check.what = id + ": " + std::string(expected.key());
        const MohrResult::Value target = wanted(expected, check.what);
        check.expected = text(target);
        const MohrResult* result = find_result(results, expected.key());
        if (result == nullptr) {
            check.verdict = Verdict::Skipped;
            return check;
        }
        check.result = text(result->value);
        check.verdict = agrees(result->value, target, rtol, atol, check) ? Verdict::Passed : Verdict::Failed;
        return check;
    }

    /// A list is compared within one tolerance, that of its largest number.
    bool agrees(const MohrResult::Value& result, const MohrResult::Value& target, double rtol, double atol,
                StateCheck& check) const
    {
        const auto numbers = [](const MohrResult::Value& value) {
            if (const auto* one = std::get_if<double>(&value)) return std::vector<double>{*one};
            const auto* list = std::get_if<std::vector<double>>(&value);
            return list != nullptr ? *list : std::vector<double>{};
        };
        const auto found = numbers(result), wanted = numbers(target);
        if (result.index() != target.index() || found.size() != wanted.size()) return false;
        double largest = 0.0;
        for (const double value : wanted) largest = std::max(largest, std::abs(value));
        const double tolerance = std::max(atol, rtol * largest);
        check.tolerance = number(tolerance, 3);
        return std::equal(found.begin(), found.end(), wanted.begin(),
                          [&](double a, double b) { return std::abs(a - b) <= tolerance; });
    }

    std::string name_;
    const ui::Catalogue& tr_;
};

std::string line(const std::string& file, const StateCheck& check, const ui::Catalogue& tr)
{
    const std::string begin = file + ": " + check.what;
    if (check.verdict == Verdict::Skipped)
        return begin + ": " + tr("skipped: {reason}", {{"reason", tr("there is no such result of this input")}}) + "\n";
    const std::string numbers = tr("{result}, expected {expected} within {tolerance}",
                                   {{"result", check.result},
                                    {"expected", check.expected},
                                    {"tolerance", check.tolerance.empty() ? "0" : check.tolerance}});
    return begin + " = " + numbers + ": " + (check.verdict == Verdict::Passed ? tr("passed") : tr("FAILED")) + "\n";
}

std::size_t n_of(const std::vector<StateCheck>& checks, Verdict verdict)
{
    return static_cast<std::size_t>(
        std::count_if(checks.begin(), checks.end(), [&](const StateCheck& check) { return check.verdict == verdict; }));
}

std::string json(const std::string& file, const std::vector<StateCheck>& checks)
{
    constexpr std::array<std::string_view, 3> words{"passed", "failed", "skipped"};
    femoop::JsonWriter json;
    json.begin_object(femoop::JsonWriter::Layout::Block).member("cremona", 1);
    json.key("checks").begin_array(femoop::JsonWriter::Layout::Block);
    for (const StateCheck& check : checks)
        json.begin_object()
            .member("file", file)
            .member("what", check.what)
            .member("verdict", words[static_cast<std::size_t>(check.verdict)])
            .member("expected", check.expected)
            .member("result", check.result)
            .end();
    json.end();
    for (const Verdict verdict : {Verdict::Passed, Verdict::Failed, Verdict::Skipped})
        json.member(words[static_cast<std::size_t>(verdict)], n_of(checks, verdict));
    json.end();
    return json.take();
}

} // namespace

ExitStatus run_mohr_cases(const std::string& file, bool is_json, Console& console)
{
    const ui::Catalogue& tr = console.tr();
    const std::string name = display_name(file, tr);
    const std::string text = text_of(file, tr);
    if (text.find_first_not_of(" \t\r\n") == std::string::npos) throw no_list(name, tr);
    const femoop::JsonReading reading = femoop::parse_json(text);
    if (!reading.document || !reading.faults.empty()) {
        console.report(name, reading.faults);
        return ExitStatus::BadInput;
    }
    const ui::Catalogue english;
    const std::vector<StateCheck> checks = CaseFile(name, is_json ? english : tr).run(reading.document->root());
    if (is_json) console.print(json(name, checks));
    else {
        for (const StateCheck& check : checks) console.print(line(name, check, tr));
        console.print(tr("{passed} passed, {failed} failed, {skipped} skipped",
                         {{"passed", std::to_string(n_of(checks, Verdict::Passed))},
                          {"failed", std::to_string(n_of(checks, Verdict::Failed))},
                          {"skipped", std::to_string(n_of(checks, Verdict::Skipped))}}) +
                      "\n");
    }
    return n_of(checks, Verdict::Failed) > 0 ? ExitStatus::No : ExitStatus::Done;
}

} // namespace cli
