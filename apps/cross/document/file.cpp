#include "apps/cross/document/file.h"

#include <algorithm>
#include <utility>

#include "apps/cross/document/compiled_examples.h"
#include "apps/cross/document/pupil_file.h"
#include "apps/cross/document/worked_file.h"
#include "femoop/io/cross/cross_block.h"
#include "femoop/io/json/json_document.h"
#include "femoop/io/model_file.h"
#include "femoop/model/quantity/number_text.h"

namespace cross {

namespace fc = femoop::cross;
using fc::FarEnds;
using fc::Order;

namespace {

constexpr std::string_view key = "cross";

std::vector<std::string> names_in(const std::string& list)
{
    std::vector<std::string> names;
    std::string rest = list;
    while (!rest.empty()) {
        const std::size_t comma = rest.find(',');
        std::string name = rest.substr(0, comma);
        rest = comma == std::string::npos ? "" : rest.substr(comma + 1);
        std::erase(name, ' ');
        if (!name.empty()) names.push_back(std::move(name));
    }
    return names;
}

void set_order(Method& method, const std::string& order)
{
    if (order == "largest") method.order = Order::Largest;
    else if (order == "left-to-right") method.order = Order::LeftToRight;
    else if (order == "all-at-once") method.order = Order::AllAtOnce;
    else {
        method.order = Order::Listed;
        method.joints = names_in(order);
    }
}

/// A structure that the method cannot work on is said so when it is solved.
FarEnds far_ends(const femoop::Model& model, femoop::CaseId load_case, const fc::Block& block)
{
    try {
        return fc::far_ends_of(model, load_case, block);
    } catch (const femoop::ModelError&) {
        return block.is_modified ? FarEnds::Modified : FarEnds::Plain;
    }
}

Method method_of(const femoop::Model& model)
{
    const std::optional<fc::Block> block = fc::block_of(model);
    Method method{.load_case = fc::case_of(model, block)};
    if (!block) return method;
    if (block->order) set_order(method, *block->order);
    method.tolerance = block->tolerance;
    method.digits = block->digits;
    method.far_ends = far_ends(model, method.load_case, *block);
    method.extent = fc::extent_of(block);
    return method;
}

/// Takes the exercise out of the model's block: the document holds it.
std::optional<Pupil> take_pupil(std::string& block_json)
{
    std::optional<Pupil> pupil = pupil_in(block_json);
    if (pupil) block_json = with_pupil(block_json, std::nullopt);
    return pupil;
}

Document document_of(femoop::Model model)
{
    Document document{.model = std::move(model)};
    const auto block = std::ranges::find(document.model.extra, key, &femoop::ExtraBlock::key);
    if (block == document.model.extra.end()) {
        document.method = method_of(document.model);
        return document;
    }
    document.pupil = take_pupil(block->json);
    document.method = method_of(document.model);
    read_worked(block->json, document);
    return document;
}

std::string order_json(const Method& method)
{
    switch (method.order) {
    case Order::Largest: return "\"largest\"";
    case Order::LeftToRight: return "\"left-to-right\"";
    case Order::AllAtOnce: return "\"all-at-once\"";
    case Order::Listed: break;
    }
    std::string list;
    for (const std::string& joint : method.joints) list += (list.empty() ? "" : ", ") + femoop::quoted_json(joint);
    return "[" + list + "]";
}

/// By its fixed-end moments a reader knows a sheet on which pinned ends are released.
std::string fixed_end_json(const femoop::Model& model, const Method& method)
{
    try {
        const fc::Problem problem = fc::problem_of(model, method.load_case, method.far_ends);
        std::string values;
        for (std::size_t e = 0; e < problem.ends.size(); ++e)
            values += (e == 0 ? "" : ", ") + femoop::quoted_json(problem.ends[e].label) + ": " +
                      femoop::number_text(problem.loading.fixed_end[e] + 0.0);
        return ", \"fixed_end_moments\": {" + values + "}";
    } catch (const femoop::ModelError&) {
        return ""; // then there is no sheet
    }
}

std::string block_json(const femoop::Model& model, const Method& method)
{
    std::string text = "{\"order\": " + order_json(method);
    if (method.load_case.index < model.n_cases())
        text += ", \"case\": " + femoop::quoted_json(model.case_name(method.load_case));
    if (method.tolerance) text += ", \"tolerance\": " + femoop::number_text(*method.tolerance);
    if (method.digits > 0) text += ", \"digits\": " + std::to_string(method.digits);
    const bool is_modified = method.far_ends != FarEnds::Plain;
    if (method.extent == fc::Extent::Half) text += ", \"symmetry\": true";
    if (method.far_ends == FarEnds::ReleasedOnSheet) text += fixed_end_json(model, method);
    return text + ", \"modified_stiffness\": " + (is_modified ? "true" : "false") + "}";
}

} // namespace

Document starting_document() { return read_document(std::string(compiled_examples().front())); }

Document read_document(const std::string& text) { return document_of(femoop::read_model(text)); }

Document read_document_file(const std::filesystem::path& path) { return document_of(femoop::read_model_file(path)); }

std::string write_document(const Document& document)
{
    femoop::Model model = document.model;
    const auto is_block = [](const femoop::ExtraBlock& block) { return block.key == key; };
    const bool has_block = std::ranges::any_of(model.extra, is_block);
    const bool needs_block = document.pupil || !document.plays.empty();
    if (document.method != method_of(model) || (needs_block && !has_block)) {
        std::erase_if(model.extra, is_block);
        model.extra.push_back({std::string(key), block_json(model, document.method)});
    }
    if (needs_block) {
        const auto block = std::ranges::find_if(model.extra, is_block);
        block->json = with_worked(with_pupil(block->json, document.pupil), document);
    }
    return femoop::write_model(model);
}

} // namespace cross
