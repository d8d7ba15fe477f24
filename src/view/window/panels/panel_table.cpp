#include "view/window/panels/panel_table.h"

#include <array>

namespace glibra::view {

std::span<const PanelRow* const> panelRows() {
    static constexpr std::array kRows{
        &kToolsRow,          &kMessagesRow,   &kValuesRow,   &kSceneKeysRow,  &kViewRow,
        &kTimeRow,           &kHardcopyRow,   &kSuiteRow,    &kTabBarRow,     &kSourceRow,
        &kBannerRow,         &kDebugViewRow,  &kFrameRow,    &kInspectorRow,  &kCompareRow,
        &kCostRow,           &kProbeRow,      &kNoiseRow,    &kExamplesRow,   &kVerboseRow,
        &kFileDialogRow,     &kMessageBoxRow, &kQuestionRow, &kWindowKeysRow, &kHelpRow,
        &kCommandPaletteRow, &kNoticeRow,     &kWelcomeRow,  &kPictureRow,    &kRecoveryRow,
        &kBeforeAfterRow,
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
