#pragma once
// All panels of the window.

#include <memory>
#include <span>
#include <vector>

#include "view/window/panels/panel.h"

namespace glibra::view {

#define GLIBRA_PANEL(row) extern const PanelRow row;
#include "view/window/panels/panels.def"
#undef GLIBRA_PANEL

/// All rows, in the order of panels.def.
std::span<const PanelRow* const> panelRows();

/// One entry per row; null for the rows that are not of that kind.
using PanelSet = std::vector<std::unique_ptr<Panel>>;
/// Makes the panels of one tab, or those that all tabs share.
PanelSet makePanels(bool areShared);

/// A panel of a tab with its row.
struct PanelUse {
    const PanelRow* row = nullptr;
    Panel* panel = nullptr;
};
/// All panels that a tab shows, in the order of the rows.
std::vector<PanelUse> panelsOf(const PanelSet& shared, const PanelSet& own);

}  // namespace glibra::view
