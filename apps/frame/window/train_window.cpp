#include "apps/frame/window/train_window.h"

#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <variant>

#include "apps/drawing/train_drawing.h"
#include "apps/frame/document/train_command.h"
#include "apps/frame/session/train_commands.h"
#include "apps/frame/window/number_row.h"
#include "femoop/methods/influence/train/train_library.h"
#include "ui/widgets/item_label.h"
#include "ui/widgets/wrapped_text.h"

namespace frame {

using femoop::ConcentratedForce;
using femoop::Quantity;
using femoop::Train;
using femoop::UniformExtent;
using ui::Measure;
using ui::translatable;

namespace {

std::optional<ui::Message> why_no_distance(double length)
{
    if (std::isfinite(length) && length >= 0.0) return std::nullopt;
    return ui::Message(translatable("a distance is 0 or more"));
}

std::optional<ui::Message> why_no_factor(double factor)
{
    if (std::isfinite(factor) && factor >= 0.0) return std::nullopt;
    return ui::Message(translatable("the factor of the axles is 0 or more"));
}

/// The axles of the chosen train, one a row: its place, its force, the distance behind it and how far that may vary.
class AxleTable {
public:
    AxleTable(Workspace& workspace, ui::NumberFields& fields, std::optional<std::size_t>& begun)
        : workspace_(workspace),
          fields_(fields),
          draft_(workspace.trains),
          units_(workspace.session.units()),
          begun_(begun)
    {}

    void show()
    {
        const ui::Catalogue tr = workspace_.session.tr();
        const std::size_t n = draft_.train().axles.size();
        if (n > 0) show_table(n);
        if (erased_) change([this](Train& train) { erase_axle(train, *erased_); });
        if (ImGui::Button((tr("Add an axle") + "###add axle").c_str())) add_one();
        fields_.stops().add();
    }

private:
    struct Column {
        std::string heading;
        float width;
    };

    using Columns = std::array<Column, 4>;

    /// In which the table is written: narrower for narrow windows.
    struct Look {
        float type = 1.0F;     ///< of the window's
        float padding = 1.0F;  ///< of the theme's, in and between the cells
        bool is_split = false; ///< the unit stands below the name
    };

    // As wide as their numbers. A narrower window, as on the projector, has narrower cells and then a smaller type, so
    // that all columns are seen; only where even so they have no room the table is scrolled.
    void show_table(std::size_t n)
    {
        constexpr std::array looks{Look{}, Look{1.0F, 0.5F, true}, Look{0.85F, 0.5F, true}, Look{0.75F, 0.4F, true}};
        const ImVec2 cell = ImGui::GetStyle().CellPadding, frame = ImGui::GetStyle().FramePadding;
        const float room = ImGui::GetContentRegionAvail().x;
        for (const Look& look : looks) {
            ImGui::SetWindowFontScale(look.type);
            ImGui::PushStyleVar(ImGuiStyleVar_CellPadding, {look.padding * cell.x, cell.y});
            ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {look.padding * frame.x, frame.y});
            const Columns columns = columns_of(look);
            const bool has_room = needed_width(columns) <= room;
            const bool is_last = &look == &looks.back();
            if (has_room || is_last) show_columns(n, columns, !has_room);
            ImGui::PopStyleVar(2);
            if (has_room) break;
        }
        ImGui::SetWindowFontScale(1.0F);
    }

    Columns columns_of(const Look& look) const
    {
        return {column("s", Measure::Length, look), column("P", Measure::Force, look),
                column("d", Measure::Length, look), column("d max", Measure::Length, look)};
    }

    static float narrow_width() { return 1.2F * ImGui::GetFontSize(); } // of a number, and of the cross

    static float needed_width(const Columns& columns)
    {
        float needed = 2.0F * narrow_width() + 2.0F * 6.0F * ImGui::GetStyle().CellPadding.x;
        for (const Column& one : columns) needed += one.width;
        return needed;
    }

    void show_columns(std::size_t n, const Columns& columns, bool is_scrolled)
    {
        const ImGuiStyle& style = ImGui::GetStyle();
        const float narrow = narrow_width();
        const float row = ImGui::GetFrameHeight() + 2.0F * style.CellPadding.y;
        const float height = is_scrolled ? static_cast<float>(n + 2) * row + style.ScrollbarSize : 0.0F;
        ImGuiTableFlags flags = ImGuiTableFlags_RowBg | ImGuiTableFlags_BordersInnerH;
        if (is_scrolled) flags |= ImGuiTableFlags_ScrollX | ImGuiTableFlags_SizingFixedFit;
        else flags |= ImGuiTableFlags_SizingStretchProp;
        if (!ImGui::BeginTable("###axles", 6, flags, {0.0F, height})) return;
        if (is_scrolled) ImGui::TableSetupScrollFreeze(1, 0);
        ImGui::TableSetupColumn("#", ImGuiTableColumnFlags_WidthFixed, narrow);
        for (const Column& one : columns)
            ImGui::TableSetupColumn(one.heading.c_str(),
                                    is_scrolled ? ImGuiTableColumnFlags_WidthFixed : ImGuiTableColumnFlags_WidthStretch,
                                    one.width);
        ImGui::TableSetupColumn("###delete", ImGuiTableColumnFlags_WidthFixed, narrow);
        ImGui::TableHeadersRow();
        for (std::size_t i = 0; i < n; ++i) {
            ImGui::PushID(static_cast<int>(i));
            show_row(i);
            ImGui::PopID();
        }
        ImGui::EndTable();
    }

    // The widest number of all columns of its kind, and its heading.
    Column column(const std::string& name, Measure measure, const Look& look) const
    {
        const Train& train = draft_.train();
        const auto width_of = [](const std::string& text) { return ImGui::CalcTextSize(text.c_str()).x; };
        Column column{units_.label(name, measure), 0.0F};
        if (const auto unit = column.heading.find(" ["); look.is_split && unit != std::string::npos)
            column.heading[unit] = '\n';
        float widest = width_of("0000");
        const auto include = [&](double value) { widest = std::max(widest, width_of(units_.number(value, measure))); };
        for (std::size_t i = 0; i < train.axles.size(); ++i)
            include(measure == Measure::Force ? train.axles[i].value() : place_of_axle(train, i));
        if (measure == Measure::Length) {
            for (const Quantity& spacing : train.spacings) include(spacing.value());
            for (const femoop::SpacingRange& range : train.spacing_ranges) include(range.max.value());
        }
        const float field = widest + 2.0F * ImGui::GetStyle().FramePadding.x + 0.3F * ImGui::GetFontSize();
        column.width = std::max(width_of(column.heading), field);
        return column;
    }

    void show_row(std::size_t i)
    {
        const Train& train = draft_.train();
        ImGui::TableNextRow();
        ImGui::TableNextColumn();
        ImGui::AlignTextToFramePadding();
        ImGui::TextUnformatted(std::to_string(i + 1).c_str());
        ImGui::TableNextColumn();
        ImGui::TextUnformatted(units_.number(place_of_axle(train, i), Measure::Length).c_str());
        ImGui::TableNextColumn();
        show_force(i);
        ImGui::TableNextColumn();
        if (i < train.spacings.size()) show_distance(i);
        ImGui::TableNextColumn();
        if (i < draft_.train().spacings.size()) show_longest(i);
        ImGui::TableNextColumn();
        const bool is_needed = train.axles.size() == 1 && !train.uniform;
        ImGui::BeginDisabled(is_needed);
        if (ImGui::SmallButton("×###delete")) erased_ = i;
        fields_.stops().add();
        ImGui::EndDisabled();
    }

    // Enter behind the last one goes on with a new one.
    void show_force(std::size_t i)
    {
        const std::string id = "force" + std::to_string(i);
        Quantity force = draft_.train().axles[i];
        const bool begins = begun_ == i;
        if (begins) begun_.reset();
        if (edit_quantity(workspace_, fields_,
                          {.id = id, .measure = Measure::Force, .width = column_width(), .begins = begins}, force))
            change([&](Train& train) { train.axles[i] = force; });
        const std::size_t n = draft_.train().axles.size();
        if (!fields_.is_entered(id) || i + 1 < n) return;
        add_one();
        begun_ = n;
    }

    void add_one()
    {
        change([this](Train& train) { add_axle(train, workspace_.session.model().units); });
    }

    void show_distance(std::size_t i)
    {
        const auto range = spacing_range(draft_.train(), i);
        Quantity spacing = range ? range->min : draft_.train().spacings[i];
        if (edit("distance", i, Measure::Length, spacing, why_no_distance))
            change([&](Train& train) { set_spacing(train, i, spacing); });
    }

    void show_longest(std::size_t i)
    {
        const auto range = spacing_range(draft_.train(), i);
        Quantity longest = range ? range->max : draft_.train().spacings[i];
        const double least = range ? range->min.value() : draft_.train().spacings[i].value();
        const auto why_not = [&](double length) -> std::optional<ui::Message> {
            if (auto reason = why_no_distance(length)) return reason;
            if (length >= least) return std::nullopt;
            return ui::Message(translatable("d max is no less than d = {distance}"),
                               {{"distance", units_.text(least, Measure::Length)}});
        };
        if (edit("longest", i, Measure::Length, longest, why_not))
            change([&](Train& train) { set_longest_spacing(train, i, longest); });
    }

    bool edit(const std::string& what, std::size_t i, Measure measure, Quantity& value,
              const std::function<std::optional<ui::Message>(double)>& why_not)
    {
        const std::string id = what + std::to_string(i);
        return edit_quantity(workspace_, fields_, {id, measure, column_width(), why_not}, value);
    }

    // Of a field as wide as its column: as in a row, a reason stands in a window of its own.
    static float column_width() { return ImGui::GetContentRegionAvail().x; }

    void change(const std::function<void(Train&)>& how) { draft_.change(workspace_.session, how); }

    Workspace& workspace_;
    ui::NumberFields& fields_;
    TrainDraft& draft_;
    ui::DisplayUnits units_;
    std::optional<std::size_t>& begun_;
    std::optional<std::size_t> erased_;
};

struct ExtentEntry {
    UniformExtent extent;
    std::string_view label;
};
constexpr std::array extents{
    ExtentEntry{UniformExtent::Adverse, translatable("where it adds")},
    ExtentEntry{UniformExtent::WholeSpans, translatable("on whole spans where it adds")},
    ExtentEntry{UniformExtent::Everywhere, translatable("everywhere, always")},
    ExtentEntry{UniformExtent::Outside, translatable("where it adds, but not beside the axles")},
};

/// What a train has beside its axles.
class TrainRows {
public:
    TrainRows(Workspace& workspace, ui::NumberFields& fields)
        : workspace_(workspace),
          fields_(fields),
          stops_(fields.stops()),
          draft_(workspace.trains),
          units_(workspace.session.units()),
          tr_(workspace.session.tr())
    {}

    void show()
    {
        const Rows rows("train rows");
        if (!rows.is_open()) return;
        rows.name(tr_("Factor of the axles"));
        Quantity impact = draft_.train().impact;
        if (edit("impact", Measure::Plain, impact, why_no_factor))
            change([&](Train& train) { train.impact = impact.value(); });
        show_uniform(rows);
        if (draft_.train().uniform) show_extent(rows);
        show_forces(rows);
        rows.name(tr_("Path"));
        show_path();
        stops_.add();
        rows.name(tr_("Both directions"));
        bool is_both = draft_.train().both_directions;
        if (ImGui::Checkbox("###both", &is_both)) change([&](Train& train) { train.both_directions = is_both; });
        stops_.add();
    }

private:
    void show_uniform(const Rows& rows)
    {
        rows.name(units_.label(tr_("Uniform load"), Measure::ForcePerLength));
        bool has_load = draft_.train().uniform.has_value();
        ImGui::BeginDisabled(has_load && draft_.train().axles.empty());
        const bool is_clicked = ImGui::Checkbox("###has uniform", &has_load);
        stops_.add();
        ImGui::EndDisabled();
        if (is_clicked)
            change([&](Train& train) { train.uniform = has_load ? std::optional<Quantity>(1.0) : std::nullopt; });
        if (!draft_.train().uniform) return;
        ImGui::SameLine();
        Quantity load = *draft_.train().uniform;
        if (edit("uniform", Measure::ForcePerLength, load)) change([&](Train& train) { train.uniform = load; });
    }

    void show_extent(const Rows& rows)
    {
        rows.name(tr_("It lies"));
        const auto now = std::ranges::find(extents, draft_.train().uniform_extent, &ExtentEntry::extent);
        ImGui::SetNextItemWidth(-1.0F);
        if (ImGui::BeginCombo("###extent", tr_(now->label).c_str())) {
            for (const ExtentEntry& entry : extents)
                if (ImGui::Selectable(tr_(entry.label).c_str(), entry.extent == now->extent))
                    change([&](Train& train) { train.uniform_extent = entry.extent; });
            ImGui::EndCombo();
        }
        stops_.add();
        const float room = ImGui::GetItemRectSize().x - ImGui::GetFrameHeight() -
                           2.0F * ImGui::GetStyle().FramePadding.x;
        const std::string shown = tr_(
            std::ranges::find(extents, draft_.train().uniform_extent, &ExtentEntry::extent)->label);
        if (ImGui::CalcTextSize(shown.c_str()).x > room) ui::wrapped_text(shown); // which the box cuts
        if (draft_.train().uniform_extent != UniformExtent::Outside) return;
        rows.name(units_.label(tr_("Free beside the axles"), Measure::Length));
        Quantity gap = draft_.train().gap.value_or(Quantity(0.0));
        if (edit("gap", Measure::Length, gap, why_no_distance)) change([&](Train& train) { train.gap = gap; });
    }

    // The size for moments, and that for all else; a click on + adds one.
    void show_forces(const Rows& rows)
    {
        for (std::size_t i = 0; i < draft_.train().concentrated.size(); ++i) {
            const ConcentratedForce force = draft_.train().concentrated[i];
            Quantity for_moments = force.for_moments, for_others = force.for_others.value_or(force.for_moments);
            rows.name(units_.label(tr_("Single force, for moments"), Measure::Force));
            if (edit("moments" + std::to_string(i), Measure::Force, for_moments))
                change([&](Train& train) { train.concentrated[i].for_moments = for_moments; });
            rows.name(units_.label(tr_("for all else"), Measure::Force));
            if (edit("others" + std::to_string(i), Measure::Force, for_others))
                change([&](Train& train) { train.concentrated[i].for_others = for_others; });
        }
        rows.name(tr_("Single forces"));
        if (ImGui::SmallButton("+###add force"))
            change([](Train& train) {
                const Quantity usual = train.axles.empty() ? Quantity(1.0) : train.axles.front();
                train.concentrated.push_back({.for_moments = usual, .for_others = {}});
            });
        stops_.add();
        if (draft_.train().concentrated.empty()) return;
        ImGui::SameLine();
        if (ImGui::SmallButton("×###delete force")) change([](Train& train) { train.concentrated.pop_back(); });
        stops_.add();
    }

    std::string name_of(const femoop::LoadPathReference& path) const
    {
        const femoop::Model& model = workspace_.session.model();
        if (const auto* const id = std::get_if<femoop::PathId>(&path)) return model.moving_loads.paths[id->index].id;
        std::string names;
        for (const femoop::MemberId member : std::get<std::vector<femoop::MemberId>>(path))
            names += (names.empty() ? "" : ", ") + model[member].id;
        return names;
    }

    void show_path()
    {
        ImGui::SetNextItemWidth(-1.0F);
        if (!ImGui::BeginCombo("###path", name_of(draft_.train().path).c_str())) return;
        const std::vector<femoop::LoadPath>& paths = workspace_.session.model().moving_loads.paths;
        for (std::size_t i = 0; i < paths.size(); ++i) {
            const femoop::LoadPathReference path = femoop::PathId(i);
            if (ImGui::Selectable(ui::item_label(paths[i].id, "path " + std::to_string(i)).c_str(),
                                  path == draft_.train().path))
                change([&](Train& train) { train.path = path; });
        }
        ImGui::EndCombo();
    }

    bool edit(const std::string& id, Measure measure, Quantity& value,
              const std::function<std::optional<ui::Message>(double)>& why_not = {})
    {
        return edit_quantity(workspace_, fields_, {id, measure, 0.0F, why_not}, value);
    }

    void change(const std::function<void(Train&)>& how) { draft_.change(workspace_.session, how); }

    Workspace& workspace_;
    ui::NumberFields& fields_;
    ui::TabStops& stops_;
    TrainDraft& draft_;
    ui::DisplayUnits units_;
    ui::Catalogue tr_;
};

void accept_or_cancel(Workspace& workspace, ui::NumberFields& fields)
{
    const ui::FootAnswer answer = ui::foot_buttons({.is_typing = fields.is_typing()}, workspace.session.tr(),
                                                   fields.stops());
    if (answer == ui::FootAnswer::Accept) workspace.trains.accept(workspace.session);
    else if (answer == ui::FootAnswer::Cancel) workspace.trains.cancel(workspace.session);
}

} // namespace

namespace {

/// Where a train of the library is from, and what its standard has besides.
void show_origin(const Workspace& workspace)
{
    const Session& session = workspace.session;
    const auto* const entry = femoop::influence::library_entry(workspace.trains.train(), session.model().units);
    if (entry == nullptr) return;
    ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetColorU32(ImGuiCol_TextDisabled));
    ui::wrapped_text(session.tr()(entry->source) + ". " + session.tr()(entry->left_out));
    ImGui::PopStyleColor();
}

} // namespace

void TrainWindow::show(Workspace& workspace, ui::ImGuiSession& gui, ui::NumberFields& fields)
{
    const TrainDraft& draft = workspace.trains;
    if (!draft.is_open()) {
        is_naming_ = false;
        reason_.reset();
    }
    if (!window_.begin(draft.is_open(), "###trains", workspace.session.tr()("Trains"), fields.stops())) return;
    ui::SideWindow::begin_content();
    show_content(workspace, gui, fields);
    ui::SideWindow::end_content();
    accept_or_cancel(workspace, fields);
    window_.end(draft.is_open(), fields.stops());
}

void TrainWindow::show_content(Workspace& workspace, ui::ImGuiSession& gui, ui::NumberFields& fields)
{
    ui::TabStops& stops = fields.stops();
    show_trains(workspace);
    if (!workspace.trains.trains().empty()) stops.add();
    show_new(workspace, stops);
    stops.add();
    if (workspace.trains.trains().empty()) return;
    ImGui::PushID(static_cast<int>(workspace.trains.chosen()));
    show_name(workspace, stops);
    show_picture(workspace, gui);
    show_origin(workspace);
    AxleTable(workspace, fields, begun_).show();
    TrainRows(workspace, fields).show();
    ImGui::PopID();
}

void TrainWindow::show_trains(Workspace& workspace) const
{
    TrainDraft& draft = workspace.trains;
    const std::vector<Train>& all = draft.trains();
    if (all.empty()) return ui::wrapped_text(workspace.session.tr()("The model has no train."));
    ImGui::SetNextItemWidth(-1.0F);
    if (!ImGui::BeginCombo("###chosen", draft.train().id.c_str())) return;
    for (std::size_t i = 0; i < all.size(); ++i)
        if (ImGui::Selectable(ui::item_label(all[i].id, "train " + std::to_string(i)).c_str(), i == draft.chosen()))
            draft.choose(workspace.session, i);
    ImGui::EndCombo();
}

// One's own, a copy of what is shown, or one of the library.
void TrainWindow::show_new(Workspace& workspace, ui::TabStops& stops) const
{
    TrainDraft& draft = workspace.trains;
    Session& session = workspace.session;
    const ui::Catalogue tr = session.tr();
    if (ImGui::Button((tr("New") + "###new").c_str())) draft.add_usual(session);
    stops.add();
    ImGui::SameLine();
    ImGui::BeginDisabled(draft.trains().empty());
    if (ImGui::Button((tr("Copy") + "###copy").c_str())) draft.add_copy(session);
    stops.add();
    ImGui::SameLine();
    if (ImGui::Button((tr("Delete") + "###delete train").c_str())) draft.erase(session);
    stops.add();
    ImGui::EndDisabled();
    ImGui::SameLine();
    const std::string library = tr("Take from the library");
    const float width = ImGui::CalcTextSize(library.c_str()).x + ImGui::GetFrameHeight() +
                        2.0F * ImGui::GetStyle().FramePadding.x;
    if (ImGui::GetContentRegionAvail().x < width) ImGui::NewLine();
    ImGui::SetNextItemWidth(-1.0F);
    if (!ImGui::BeginCombo("###library", library.c_str(), ImGuiComboFlags_HeightLargest)) return;
    for (const LibraryCommand& entry : library_commands()) {
        if (ImGui::Selectable((tr(entry.label) + "###" + std::string(entry.id)).c_str()))
            draft.add(session, *entry.train);
        ImGui::Indent();
        ImGui::TextDisabled("%s", tr(entry.train->source).c_str());
        ImGui::Unindent();
    }
    ImGui::EndCombo();
}

void TrainWindow::show_name(Workspace& workspace, ui::TabStops& stops)
{
    TrainDraft& draft = workspace.trains;
    const ui::Catalogue tr = workspace.session.tr();
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(tr("Name").c_str());
    ImGui::SameLine();
    ImGui::SetNextItemWidth(-1.0F);
    const bool was_naming = is_naming_;
    if (std::exchange(named_, draft.chosen()) != draft.chosen()) reason_.reset();
    if (!is_naming_) old_name_ = name_ = draft.train().id; // another's was typed before
    if (ImGui::InputText("###name", &name_)) reason_ = draft.set_name(workspace.session, name_);
    stops.add(ui::TabStops::Kind::Text);
    is_naming_ = ImGui::IsItemActive();
    const bool is_refused = was_naming && !is_naming_ && reason_; // what was typed of it is no name: it is said on
    if (is_refused) draft.set_name(workspace.session, old_name_);
    if (reason_) ui::wrapped_text(tr(*reason_));
}

void TrainWindow::show_picture(const Workspace& workspace, ui::ImGuiSession& gui) const
{
    const float width = ImGui::GetContentRegionAvail().x, height = 10.0F * ImGui::GetFontSize();
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    ImGui::Dummy({width, height});
    ui::Painter painter({static_cast<double>(width) / gui.scale(), static_cast<double>(height) / gui.scale()}, fonts_);
    draw_train(painter, workspace.trains.train(),
               {.theme = ui::Theme(workspace.session.view.theme),
                .units = workspace.session.units(),
                .tr = workspace.session.view.tr});
    gui.show(painter.picture(), *ImGui::GetWindowDrawList(),
             {static_cast<double>(corner.x), static_cast<double>(corner.y)});
}

} // namespace frame
