#include "view/window/panels/save_scene.h"

#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "base/text.h"
#include "image/file.h"
#include "system/places.h"
#include "view/edit/example_folders.h"
#include "view/edit/save_values.h"
#include "view/edit/scene_copy.h"
#include "view/session/comparison.h"
#include "view/window/panels/ui.h"

namespace glibra::view {
namespace {

namespace fs = std::filesystem;

/// The text of the session's scene as it would be saved: with unsaved edits, or else with the values.
Result<std::string> textToSave(const Ui& ui) {
    const fs::path& path = ui.session.path();
    if (const EditedFile* edited = knownSource(ui, path); edited && edited->isChanged())
        return edited->text();
    const auto bytes = image::readFile(path, {path.generic_string(), {path.generic_string(), 1, 1}});
    if (!bytes) return bytes.diagnostics;
    return withValues(
        withFiles({reinterpret_cast<const char*>(bytes->data()), bytes->size()}, ui.session.chosenFiles()),
        ui.session.knobs());
}

/// Returns the problem; empty on success.
std::string save(Ui& ui, fs::path target) {
    if (!target.has_extension()) target += ".glib";
    const Session& session = ui.session;
    const Result<std::string> text = textToSave(ui);
    Diagnostics problems = text.diagnostics;
    if (text) problems = writingProblem(target);
    std::vector<CopiedFile> files;
    if (problems.empty()) {
        files = filesOfCopy(session.live(), target, isExample(session.path()),
                            session.renderOptions().libraryRoots);
        problems = writeCopy(*text, target, files);
        if (problems.empty()) problems = copyExercise(session.path(), target);
    }
    if (!problems.empty()) return problems.front().text;
    ui.notice = "saved " + target.generic_string();
    if (!files.empty()) ui.notice.text += " and " + base::counted(files.size(), "file") + " that it reads";
    ui.requests.open = target;
    ui.requests.inNewTab = true;
    return {};
}

}  // namespace

fs::path ownFolder(const Ui& ui) {
    if (ui.session.hasScene() && !isExample(ui.session.path())) return ui.session.path().parent_path();
    std::error_code failure;
    for (const std::string& each : ui.settings.recent)
        if (const fs::path folder = fs::path(each).parent_path();
            !isExample(each) && fs::is_directory(folder, failure))
            return folder;
    if (const fs::path here = fs::current_path(failure);
        !here.empty() && here != "/" && !isExample(here / "x"))
        return here;
    const fs::path home = system::homeFolder();
    return home.empty() ? "." : home;
}

void saveScene(Ui& ui) {
    if (!ui.session.hasScene()) return;
    if (isExample(ui.session.path())) return saveSceneAs(ui);
    const Diagnostics problems = saveValues(ui.session.path(), ui.session.knobs(), ui.session.chosenFiles(),
                                            knownSource(ui, ui.session.path()));
    if (!problems.empty()) {
        ui.notice = problems.front();
        return;
    }
    ui.notice = "saved the values in " + ui.session.path().filename().generic_string();
    ui.session.forgetChosenFiles();
}

void saveSceneAs(Ui& ui) {
    if (!ui.session.hasScene()) return;
    const bool isCopy = isExample(ui.session.path());
    const std::string name = ui.session.path().filename().generic_string();
    askForFile(
        ui,
        {.kind = FileQuestion::Kind::save,
         .title = (isCopy ? "Save a copy of " : "Save as: ") + name,
         .button = "Save",
         .hint = isCopy ? "Examples stay as they are. The copy gets your values, and the shaders and "
                          "other files of the scene are copied into its folder."
                        : "The scene with its values. Files that it would not find there are copied, too.",
         .endings = ".glib",
         .entry = name,
         .chosen = save},
        ownFolder(ui));
}

}  // namespace glibra::view
