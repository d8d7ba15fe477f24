#include "view/window/dropped.h"

#include <fmt/format.h>

#include <fstream>
#include <system_error>

#include "glib/text.h"
#include "view/browse/file_use.h"
#include "view/debug_view/texels.h"

namespace glibra::view {
namespace {

namespace fs = std::filesystem;

std::string showUse(Ui& ui, const FileUse& use, const std::string& name) {
    if (use.kind == FileUse::Kind::texture) {
        ui.wanted.inspected = textureKey(ui.session.live().scene(), use.texture);
        return {};
    }
    showSource(ui, use.place);
    if (use.kind == FileUse::Kind::text) return {};
    return fmt::format("{} is used in line {} of this scene", name, use.place.line);
}

}  // namespace

Dropped takeDroppedFile(Tabs& tabs, const fs::path& file) {
    const std::string name = file.filename().string();
    std::error_code failure;
    if (fs::is_directory(file, failure)) {
        tabs.shown().ui.wanted.file = FileRequest{std::nullopt, true, file};
        return {};
    }
    if (!fs::exists(file, failure)) return {false, {}, fmt::format("{}: no such file", file.string())};
    if (!std::ifstream(file)) return {false, {}, fmt::format("{}: cannot read this file", file.string())};
    if (glib::sameWord(file.extension().string(), ".glib")) {
        if (tabs.find(file) == tabs.shownIndex()) return {false, {}, fmt::format("{} is already open", name)};
        return {true, {}, {}};
    }
    for (std::size_t i = 0; i < tabs.count(); ++i) {
        const std::size_t index = (tabs.shownIndex() + i) % tabs.count();
        Tab& tab = tabs.at(index);
        if (!tab.session.hasScene()) continue;
        const FileUse use = useOf(tab.session.live(), file);
        if (use.kind != FileUse::Kind::none) return {false, index, showUse(tab.ui, use, name)};
    }
    return {false, {}, fmt::format("{} is neither a scene (.glib) nor a file that an open scene uses", name)};
}

}  // namespace glibra::view
