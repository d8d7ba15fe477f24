#include "scene/actions.h"

#include <vector>

#include "geometry/shapes/primitive.h"
#include "scene/classic/classic.h"
#include "scene/modern/modern.h"

namespace glibra::scene {

std::span<const CommandAction> allActions() {
    static const std::vector<CommandAction> kActions = [] {
        const auto first = static_cast<std::size_t>(CommandId::firstPrimitive);
        std::vector<CommandAction> all(first);
        all.resize(first + geometry::primitives().size(), {.handler = doPrimitive, .draws = true});
        for (const auto& some :
             {viewActions(), drawActions(), passActions(), textureActions(), programActions()})
            for (const CommandAction& each : some) all.at(static_cast<std::size_t>(each.id)) = each;
        for (const auto& some : {structureActions(), variableActions(), tagActions(), cameraActions(),
                                 objectActions(), targetActions(), stateActions(), vertexActions(),
                                 bufferActions(), blockActions(), checkActions()})
            for (const CommandAction& each : some) {
                all.at(static_cast<std::size_t>(each.id)) = each;
                all.at(static_cast<std::size_t>(each.id)).isModern = true;
            }
        return all;
    }();
    return kActions;
}

}  // namespace glibra::scene
