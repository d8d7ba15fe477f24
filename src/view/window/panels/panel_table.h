#pragma once
// All panels of the window.

#include <memory>
#include <span>
#include <vector>

#include "view/window/panels/panel.h"

namespace glibra::view {

// Each row stands at the end of its panel's file. A new one is named here and in panelRows().
extern const PanelRow kToolsRow, kMessagesRow, kValuesRow, kSceneKeysRow, kViewRow, kTimeRow, kHardcopyRow,
    kSuiteRow, kTabBarRow, kSourceRow, kBannerRow, kDebugViewRow, kInspectorRow, kCompareRow, kCostRow,
    kProbeRow, kNoiseRow, kExamplesRow, kVerboseRow, kFileDialogRow, kMessageBoxRow, kQuestionRow,
    kWindowKeysRow, kHelpRow, kPictureRow, kRecoveryRow, kCommandPaletteRow, kNoticeRow, kWelcomeRow,
    kFrameRow, kBeforeAfterRow;

/// The panels of each place in the order in which they are drawn, shortcuts of each group in the order in
/// which they are listed.
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
