#include "view/window/before_leaving.h"

#include <utility>
#include <vector>

#include "view/edit/example_folders.h"
#include "view/edit/save_values.h"

namespace glibra::view {
namespace {

void addValues(std::vector<UnsavedValues>& values, const Session& session) {
    if (session.hasScene() && hasChangedValues(session.knobs()))
        values.push_back({session.path(), session.knobs(), session.chosenFiles()});
}

std::optional<Question> asked(Question question) {
    if (question.files.empty() && question.values.empty()) return std::nullopt;
    return question;
}

}  // namespace

std::optional<Question> beforeOpening(const Tabs& tabs, const std::filesystem::path& scene) {
    Question question{Question::About::openScene, scene, 0, tabs.unsaved(tabs.shownIndex()), {}, {}};
    addValues(question.values, tabs.shown().session);
    return asked(std::move(question));
}

std::optional<Question> beforeClosing(const Tabs& tabs, std::size_t tab) {
    Question question{Question::About::closeTab, {}, tab, tabs.unsaved(tab), {}, {}};
    if (tab < tabs.count() && !isExample(tabs.at(tab).session.path()))
        addValues(question.values, tabs.at(tab).session);
    return asked(std::move(question));
}

std::optional<Question> beforeQuitting(const Tabs& tabs) {
    return asked({Question::About::quit, {}, 0, tabs.unsaved(), {}, {}});
}

}  // namespace glibra::view
