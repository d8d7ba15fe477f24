#include "view/edit/text_history.h"

#include <algorithm>

namespace glibra::view {
namespace {

bool isContinuation(char c) {
    return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U;
}

bool isBlank(char c) {
    return c == ' ' || c == '\t' || c == '\n';
}

}  // namespace

/// Typing joins the last step until a new word or line begins; deleting joins until another kind of change.
bool TextHistory::join(const Step& step) {
    if (!mayJoin_ || at_ == 0 || at_ < steps_.size()) return false;
    Step& last = steps_[at_ - 1];
    if (step.removed.empty() && last.removed.empty() && step.begin == last.begin + last.added.size()) {
        const bool beginsWord = isBlank(last.added.back()) && !isBlank(step.added.front());
        const bool isLine = step.added.find('\n') != std::string::npos;
        if (beginsWord || isLine) return false;
        last.added += step.added;
        return true;
    }
    if (!step.added.empty() || !last.added.empty()) return false;
    if (step.begin == last.begin) {
        last.removed += step.removed;
        return true;
    }
    if (step.begin + step.removed.size() != last.begin) return false;
    last.removed = step.removed + last.removed;
    last.begin = step.begin;
    return true;
}

void TextHistory::record(std::string_view text) {
    if (text == present_) return;
    const std::size_t shorter = std::min(text.size(), present_.size());
    auto same = static_cast<std::size_t>(std::ranges::mismatch(text, present_).in1 - text.begin());
    // The common parts end at whole characters, so that every state is UTF-8.
    const auto cuts = [](std::string_view of, std::size_t at) {
        return at < of.size() && isContinuation(of[at]);
    };
    while (same > 0 && (cuts(text, same) || cuts(present_, same))) --same;
    std::size_t behind = 0;
    while (behind < shorter - same &&
           text[text.size() - 1 - behind] == present_[present_.size() - 1 - behind])
        ++behind;
    while (behind > 0 && (cuts(text, text.size() - behind) || cuts(present_, present_.size() - behind)))
        --behind;
    Step step{same, present_.substr(same, present_.size() - behind - same),
              std::string(text.substr(same, text.size() - behind - same))};
    present_ = text;
    if (join(step)) return;
    steps_.resize(at_);
    steps_.push_back(std::move(step));
    if (steps_.size() > kMostSteps) steps_.erase(steps_.begin());
    at_ = steps_.size();
    mayJoin_ = true;
}

TextHistory::State TextHistory::undo() {
    mayJoin_ = false;
    if (at_ == 0) return {present_, 0};
    const Step& step = steps_[--at_];
    present_.replace(step.begin, step.added.size(), step.removed);
    return {present_, step.begin + step.removed.size()};
}

TextHistory::State TextHistory::redo() {
    mayJoin_ = false;
    if (at_ == steps_.size()) return {present_, 0};
    const Step& step = steps_[at_++];
    present_.replace(step.begin, step.removed.size(), step.added);
    return {present_, step.begin + step.added.size()};
}

}  // namespace glibra::view
