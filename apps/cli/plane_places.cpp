#include "apps/cli/plane_places.h"

#include <charconv>
#include <cmath>

#include "apps/cli/argument.h"
#include "femoop/plane/mesh/mesh_geometry.h"

namespace cli {

namespace fp = femoop::plane;

namespace {

constexpr double longest_cut = 1e6; // times the body: its places have ten digits then

} // namespace

std::vector<double> numbers_of(const std::string& option, const std::string& text, std::size_t n,
                               const ui::Catalogue& tr)
{
    std::vector<double> numbers;
    for (const std::string& part : comma_list(text)) {
        double number = 0.0;
        const auto [end, error] = std::from_chars(part.data(), part.data() + part.size(), number);
        if (error == std::errc() && end == part.data() + part.size() && std::isfinite(number))
            numbers.push_back(number);
    }
    if (numbers.size() == n && comma_list(text).size() == n) return numbers;
    throw UsageError(tr("{option}: found {found}; wanted {n} numbers with commas between them",
                        {{"option", option}, {"found", "\"" + text + "\""}, {"n", std::to_string(n)}}));
}

std::vector<Eigen::Vector2d> places_in(const fp::Locator& locator, const std::vector<std::string>& texts,
                                       const ui::Catalogue& tr)
{
    std::vector<Eigen::Vector2d> places;
    for (const std::string& text : texts) {
        const std::vector<double> at = numbers_of("--at", text, 2, tr);
        places.emplace_back(at[0], at[1]);
        if (locator.find(places.back()).empty())
            throw UsageError(tr("--at: no element is at {place}; give a place in the material", {{"place", text}}));
    }
    return places;
}

std::vector<fp::Cut> cuts_through(const fp::PlaneModel& mesh, const fp::Locator& locator,
                                  const std::vector<std::string>& texts, const ui::Catalogue& tr)
{
    std::vector<fp::Cut> cuts;
    for (const std::string& text : texts) {
        const std::vector<double> at = numbers_of("--cut", text, 4, tr);
        const fp::Cut cut{{at[0], at[1]}, {at[2], at[3]}};
        if (cut.length() == 0.0)
            throw UsageError(tr("--cut: {cut} ends where it begins; give two places", {{"cut", text}}));
        if (cut.length() > longest_cut * fp::extent(fp::positions(mesh)))
            throw UsageError(
                tr("--cut: {cut} is so long beside the body that rounding would move what it meets; let it "
                   "end near the body",
                   {{"cut", text}}));
        if (fp::pieces_along(mesh, locator, cut).empty())
            throw UsageError(tr("--cut: {cut} meets no material; move it", {{"cut", text}}));
        cuts.push_back(cut);
    }
    if (!cuts.empty() && mesh.analysis == femoop::StressState::Axisymmetric)
        throw UsageError(tr("--cut: a cut through an axisymmetric body has no N, V and M; read stresses with --at"));
    return cuts;
}

} // namespace cli
