#include "scene/run/depends.h"

#include <fmt/format.h>

#include <string>
#include <utility>
#include <vector>

namespace glibra::scene {
namespace {

/// What Once writes stays, so it cannot follow a variable of time. Variables that the block sets are its own.
void checkOnce(Interpreter& in, std::string_view name, expression::Depends depends, const Place& place) {
    const OpenBlock* block = in.around.block;
    if (block == nullptr || block->isStep || !any(depends & expression::Depends::variable) ||
        !changesWithTime(depends) || in.names().isOfBlock(name))
        return;
    const auto declared = in.modern.names.find(name);
    const std::string where =
        declared != in.modern.names.end() ? fmt::format(" (line {})", declared->second.place.line) : "";
    in.report(diagnose("memory-E11",
                       fmt::format("Once reads '{}'{}, which changes with time, but what Once writes stays; "
                                   "read it in Step",
                                   name, where),
                       place));
}

/// What the scene, or the block that is open, depends on.
expression::Depends& currentDepends(Interpreter& in) {
    return in.around.block != nullptr ? in.around.block->depends : in.shared->depends;
}

}  // namespace

void noteRead(Interpreter& in, std::string_view name, Environment::Slot slot, const Place& place) {
    checkOnce(in, name, in.names().dependsOf(slot), place);
    if (in.around.readSlots != nullptr) in.around.readSlots->push_back(slot);
    if (in.around.block == nullptr || !in.around.block->readSlots.insert(slot).second) return;
    const std::vector<double> values = in.names().valuesOf(slot);
    in.around.block->reads.insert(in.around.block->reads.end(), values.begin(), values.end());
}

void addDepends(Interpreter& in, expression::Depends depends) {
    currentDepends(in) = currentDepends(in) | depends;
}

DependsOnly::DependsOnly(Interpreter& in)
    : all_(currentDepends(in)), before_(std::exchange(all_, expression::Depends::nothing)) {}

}  // namespace glibra::scene
