#include "apps/frame/funicular/asked_funicular.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <variant>

#include "apps/drawing/sketch/counted_units.h"
#include "femoop/io/funicular/funicular_text.h"

namespace frame {

using namespace femoop::funicular;
using drawing::FunicularHandle;

bool AskedFunicular::is_on(const femoop::Model& model) const
{
    const auto is_there = [&](const std::string& name) { return model.find_member(name).has_value(); };
    return is_on_ && (members_.empty() || std::ranges::any_of(members_, is_there));
}

void AskedFunicular::clear()
{
    const std::size_t next = number_ + 1;
    *this = {};
    number_ = next;
}

void AskedFunicular::ask(const femoop::Model& model, const std::vector<femoop::MemberId>& members)
{
    std::vector<std::string> names;
    for (const femoop::MemberId member : members) names.push_back(model[member].id);
    if (is_on(model) && (names.empty() || names == members_)) return;
    clear();
    is_on_ = true;
    members_ = std::move(names);
}

void AskedFunicular::pick(const femoop::Model& model, femoop::MemberId member, bool adds)
{
    const std::string& name = model[member].id;
    std::vector<std::string> names = adds ? members_ : std::vector<std::string>();
    if (std::erase(names, name) == 0) names.push_back(name);
    clear();
    is_on_ = true;
    members_ = std::move(names);
}

void AskedFunicular::drag(FunicularHandle handle, double height)
{
    constexpr double least_share = 0.002; // of the span: of no rise at all H would be infinite
    const Funicular now = funicular();
    rise_ = now.rise();
    is_stale_ = true;
    if (handle == FunicularHandle::LeftEnd) over_ends_.left = height - basis_->chain.left().y();
    if (handle == FunicularHandle::RightEnd) over_ends_.right = height - basis_->chain.right().y();
    if (handle != FunicularHandle::Rise) return;
    const double rise = height - now.closing(now.span.largest_moment().x), least = least_share * now.span.length();
    rise_ = std::abs(rise) < least ? std::copysign(least, rise) : rise;
}

void AskedFunicular::read_at(std::optional<double> x)
{
    is_stale_ = is_stale_ || x != reading_;
    reading_ = x;
}

void AskedFunicular::reach_for(std::optional<FunicularHandle> handle)
{
    is_stale_ = is_stale_ || handle != in_reach_;
    in_reach_ = handle;
}

void AskedFunicular::lead_through_crown()
{
    over_ends_ = {};
    rise_.reset();
    is_stale_ = true;
}

std::vector<femoop::MemberId> AskedFunicular::members(const femoop::Model& model) const
{
    std::vector<femoop::MemberId> found;
    for (const std::string& name : members_)
        if (const auto member = model.find_member(name)) found.push_back(*member);
    return found;
}

Funicular AskedFunicular::funicular() const
{
    const Chain& chain = basis_->chain;
    const ClosingLine line{chain.left().y() + over_ends_.left, chain.right().y() + over_ends_.right};
    const double H = rise_ ? thrust_of_rise(basis_->span, *rise_) : usual_thrust(chain, basis_->span);
    return {basis_->span, line, H};
}

const drawing::FunicularPicture* AskedFunicular::picture(const femoop::Model& model, std::uint64_t generation,
                                                         const drawing::DrawOptions& options) const
{
    const Subject subject{generation, options.load_case, options.tr.language(),
                          drawing::counted_units(model, options).units};
    if (subject_ == subject && !is_stale_) return last();
    if (subject_ != subject) find(model, options);
    subject_ = subject;
    is_stale_ = false;
    picture_.reset();
    if (basis_) draw(model, options);
    return last();
}

void AskedFunicular::find(const femoop::Model& model, const drawing::DrawOptions& options) const
{
    basis_.reset();
    why_none_.clear();
    if (!is_on(model)) return;
    auto found = loaded_chain(model, members(model), options.load_case);
    if (const auto* refusal = std::get_if<Refusal>(&found)) why_none_ = sentence(*refusal, model, options.tr);
    else basis_ = std::get<LoadedChain>(std::move(found));
}

void AskedFunicular::draw(const femoop::Model& model, const drawing::DrawOptions& options) const
{
    picture_ = drawing::FunicularPicture{.chain = basis_->chain, .funicular = funicular()};
    const Funicular& shown = picture_->funicular;
    if (reading_ && *reading_ >= shown.span.from() && *reading_ <= shown.span.to()) picture_->reading = reading_;
    picture_->in_reach = in_reach_;
    picture_->sentences = sentences(model, options);
}

// In the units of the picture, from the same structure counted in these.
std::vector<std::string> AskedFunicular::sentences(const femoop::Model& model,
                                                   const drawing::DrawOptions& options) const
{
    const drawing::CountedUnits units = drawing::counted_units(model, options);
    const femoop::Model counted = counted_in(units, model);
    const auto loaded = loaded_chain(counted, members(model), options.load_case);
    const auto* const basis = std::get_if<LoadedChain>(&loaded);
    if (basis == nullptr) return {};
    const Funicular& drawn = picture_->funicular;
    const ClosingLine line{units.length * drawn.closing_line.left, units.length * drawn.closing_line.right};
    const Funicular shown{basis->span, line, units.force * drawn.H};
    std::vector<std::string> lines = funicular_lines(shown, basis->chain, counted, options.tr);
    lines.push_back(picture_->reading
                        ? reading_line(shown, basis->chain, units.length * *picture_->reading, counted, options.tr)
                        : options.tr("Point at a place of the span: M0 and M are read there."));
    return lines;
}

} // namespace frame
