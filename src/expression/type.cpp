#include "expression/type.h"

#include <fmt/format.h>

#include <glm/gtc/type_ptr.hpp>

namespace glibra::expression {

std::string name(const Type& type) {
    switch (type.kind) {
        case Kind::word:
            return "word";
        case Kind::record:
            return "record";
        case Kind::boolean:
            return type.rows == 1 ? "bool" : fmt::format("bvec{}", type.rows);
        case Kind::number:
            break;
    }
    if (type.columns > 1) return fmt::format("mat{}", type.columns);
    return type.rows == 1 ? "number" : fmt::format("vec{}", type.rows);
}

glm::dmat4 Value::mat4() const {
    return glm::make_mat4(components.data());
}

}  // namespace glibra::expression
