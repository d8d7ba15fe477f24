#include "view/session/history.h"

#include <algorithm>
#include <utility>

namespace glibra::view {

History::State History::stateOf(const Session& session) {
    State state;
    for (std::size_t i = 0; i < session.knobs().size(); ++i)
        state.values.push_back({session.knobs()[i].program, session.knobs()[i].tag, session.restingValue(i)});
    state.view = session.view();
    return state;
}

bool History::isCurrent(const Session& session) const {
    if (states_.empty() || states_[at_].view != session.view()) return false;
    const std::vector<Value>& values = states_[at_].values;
    if (values.size() != session.knobs().size()) return false;
    for (std::size_t i = 0; i < values.size(); ++i) {
        const render::Knob& knob = session.knobs()[i];
        if (values[i].program != knob.program || values[i].tag != knob.tag ||
            values[i].values != session.restingValue(i))
            return false;
    }
    return true;
}

void History::record(const Session& session) {
    if (isCurrent(session)) return;
    State state = stateOf(session);
    if (!states_.empty()) states_.resize(at_ + 1);
    states_.push_back(std::move(state));
    if (states_.size() > kMost) states_.erase(states_.begin());
    at_ = states_.size() - 1;
}

void History::restore(Session& session) const {
    const State& state = states_[at_];
    for (const Value& each : state.values)
        for (std::size_t i = 0; i < session.knobs().size(); ++i)
            if (session.knobs()[i].program == each.program && session.knobs()[i].tag == each.tag)
                session.setValue(i, each.values);
    session.setView(state.view);
}

bool History::undo(Session& session) {
    record(session);
    if (session.undoAnimations()) return true;
    if (at_ == 0) return false;
    --at_;
    restore(session);
    return true;
}

bool History::redo(Session& session) {
    session.undoAnimations();
    if (at_ + 1 >= states_.size()) return false;
    ++at_;
    restore(session);
    return true;
}

void History::takeBack(const Session& session) {
    if (at_ == 0) return;
    --at_;
    if (isCurrent(session))
        states_.resize(at_ + 1);
    else
        ++at_;
}

void History::clear() {
    states_.clear();
    at_ = 0;
}

}  // namespace glibra::view
