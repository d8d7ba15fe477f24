#include "view/window/before_leaving.h"

#include <utility>
#include <vector>

#include "view/browse/example_scenes.h"
#include "view/edit/save_values.h"

namespace glibra::view {
namespace {

void addValues(std::vector<UnsavedValues>& values, const Session& session) {
    if (session.hasScene() && hasChangedValues(session.knobs()))
        values.push_back({session.path(), session.knobs(), session.chosenFiles()});
}

void addOwnValues(std::vector<UnsavedValues>& values, const Session& session) {
    if (!isExample(session.path())) addValues(values, session);
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
    if (tab < tabs.count()) addOwnValues(question.values, tabs.at(tab).session);
    return asked(std::move(question));
}

std::optional<Question> beforeQuitting(const Tabs& tabs) {
    // The tabs come back with their values.
    return asked({Question::About::quit, {}, 0, tabs.unsaved(), {}, {}});
}

}  // namespace glibra::view
