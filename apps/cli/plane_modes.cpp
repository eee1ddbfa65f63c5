#include "apps/cli/plane_modes.h"

namespace cli {

bool asks_for_modes(const std::optional<std::string>& analysis, const ui::Catalogue& tr)
{
    if (analysis && *analysis != "linear" && *analysis != "modal")
        throw unknown_choice("--analysis", *analysis, {"linear", "modal"}, tr);
    return analysis == "modal";
}

UsageError modes_of_members(const ui::Catalogue& tr)
{
    return UsageError(tr("--analysis modal: natural modes of structures of members are not built yet; those of plane "
                         "models are"));
}

} // namespace cli
