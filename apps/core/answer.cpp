#include "apps/core/answer.h"

#include <utility>

#include "femoop/analysis/linear_static.h"
#include "femoop/io/results/results_csv.h"
#include "femoop/io/results/results_json.h"

namespace core {

std::string faults_alone(const std::vector<femoop::Fault>& faults)
{
    femoop::JsonWriter json;
    json.begin_object().key("faults").begin_array();
    for (const femoop::Fault& fault : faults) {
        json.begin_object().member("severity", is_error(fault) ? "error" : "warning");
        json.member("message", femoop::message(fault)).end();
    }
    json.end().end();
    return json.take();
}

std::string unless_refused(const std::function<std::string()>& answer)
try {
    return answer();
} catch (const femoop::ModelError& error) {
    return faults_alone(error.faults());
}

std::string solved(const femoop::Model& model)
{
    std::vector<femoop::CaseId> cases;
    for (std::size_t i = 0; i < model.n_cases(); ++i) cases.emplace_back(i);
    return femoop::results_json(model, femoop::analyse(model), cases, femoop::usual_n_stations);
}

const char* kept(std::string text)
{
    static std::string last;
    last = std::move(text);
    return last.c_str();
}

} // namespace core
