#include "budget/surface_model.h"

#include <cassert>

#include "glib/statement_table.h"

namespace glibra::budget {
namespace {

SurfaceModel modelOf(glib::CommandId command) {
    SurfaceModel model{.command = command, .spec = glib::primitiveOf(command)};
    const auto arguments = model.spec->arguments;
    for (std::size_t i = 0; i < arguments.size(); ++i) {
        const geometry::ShapeArgument& each = arguments[i];
        if (each.kind != geometry::ArgumentKind::count) continue;
        assert(model.countsUsed < model.counts.size());
        model.counts[model.countsUsed++] = {i, static_cast<int>(each.least), each.smooth, each.isFixed,
                                            each.name};
    }
    return model;
}

std::vector<SurfaceModel> allModels() {
    std::vector<SurfaceModel> models;
    for (const glib::StatementRow& row : glib::commandTable())
        if (const geometry::PrimitiveSpec* spec = glib::primitiveOf(row.id); spec && spec->deviation)
            models.push_back(modelOf(row.id));
    return models;
}

}  // namespace

const SurfaceModel* surfaceModel(glib::CommandId command) {
    static const std::vector<SurfaceModel> kModels = allModels();
    for (const SurfaceModel& each : kModels)
        if (each.command == command) return &each;
    return nullptr;
}

}  // namespace glibra::budget
