#include "view/window/panels/panel_table.h"

#include <array>

namespace glibra::view {

std::span<const PanelRow* const> panelRows() {
    static constexpr std::array kRows{
#define GLIBRA_PANEL(row) &(row),
#include "view/window/panels/panels.def"
#undef GLIBRA_PANEL
    };
    return kRows;
}

PanelSet makePanels(bool areShared) {
    PanelSet panels;
    for (const PanelRow* row : panelRows())
        panels.push_back(row->isShared == areShared ? row->make() : nullptr);
    return panels;
}

std::vector<PanelUse> panelsOf(const PanelSet& shared, const PanelSet& own) {
    std::vector<PanelUse> panels;
    for (std::size_t i = 0; i < panelRows().size(); ++i)
        panels.push_back({panelRows()[i], shared[i] ? shared[i].get() : own[i].get()});
    return panels;
}

}  // namespace glibra::view
