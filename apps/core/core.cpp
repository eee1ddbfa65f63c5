// What cremona.js calls: text in, text out.
#include <emscripten.h>

#include <functional>
#include <string>

#include "femoop/analysis/linear_static.h"
#include "femoop/io/json/json_writer.h"
#include "femoop/io/model_file.h"
#include "femoop/io/results/results_csv.h"
#include "femoop/io/results/results_json.h"
#include "femoop/io/verify.h"

namespace {

using femoop::JsonWriter;

void write_faults(JsonWriter& json, const std::vector<femoop::Fault>& faults)
{
    json.key("faults").begin_array();
    for (const femoop::Fault& fault : faults) {
        json.begin_object().member("severity", is_error(fault) ? "error" : "warning");
        json.member("message", femoop::message(fault)).end();
    }
    json.end();
}

std::string faults_alone(const std::vector<femoop::Fault>& faults)
{
    JsonWriter json;
    json.begin_object();
    write_faults(json, faults);
    json.end();
    return json.take();
}

std::vector<femoop::CaseId> all_cases(const femoop::Model& model)
{
    std::vector<femoop::CaseId> cases;
    for (std::size_t i = 0; i < model.n_cases(); ++i) cases.emplace_back(i);
    return cases;
}

std::string solved(const femoop::Model& model)
{
    return femoop::results_json(model, femoop::analyse(model), all_cases(model), femoop::usual_n_stations);
}

std::string_view word(femoop::Verdict verdict)
{
    using enum femoop::Verdict;
    return verdict == Passed ? "passed" : verdict == Failed ? "failed" : "skipped";
}

std::string verified(const femoop::Model& model)
{
    std::optional<femoop::Results> results;
    if (femoop::needs_linear_analysis(model)) results = femoop::analyse(model);
    const auto checks = femoop::verify(model, results);
    const femoop::CheckCounts counts = femoop::count(checks);
    JsonWriter json;
    json.begin_object().member("cremona", 1).key("checks").begin_array();
    for (const femoop::CheckOutcome& check : checks) {
        json.begin_object().member("what", check.what).member("verdict", word(check.verdict));
        json.member("expected", check.expected);
        if (check.result) json.member("result", *check.result).member("tolerance", check.tolerance);
        json.end();
    }
    json.end().member("passed", counts.passed).member("failed", counts.failed).member("skipped", counts.skipped).end();
    return json.take();
}

/// Of a sound model; else its faults, as of one that cannot be solved.
std::string of_model(const char* text, const std::function<std::string(const femoop::Model&)>& answer)
try {
    const femoop::ModelReading reading = femoop::examine_model(std::string_view(text));
    return reading.is_sound() ? answer(reading.model) : faults_alone(reading.faults);
} catch (const femoop::ModelError& error) {
    return faults_alone(error.faults());
}

/// Until the next call.
const char* kept(std::string text)
{
    static std::string last;
    last = std::move(text);
    return last.c_str();
}

} // namespace

extern "C" {

EMSCRIPTEN_KEEPALIVE const char* core_solve(const char* model) { return kept(of_model(model, solved)); }
EMSCRIPTEN_KEEPALIVE const char* core_verify(const char* model) { return kept(of_model(model, verified)); }
EMSCRIPTEN_KEEPALIVE const char* core_check(const char* model)
{
    return kept(faults_alone(femoop::examine_model(std::string_view(model)).faults));
}

} // extern "C"
