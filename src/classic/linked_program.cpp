#include "classic/linked_program.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/matrix.hpp>
#include <mutex>
#include <utility>

#include "base/matrices.h"
#include "base/suggest.h"
#include "base/text.h"
#include "gpu/format/gl_names.h"

namespace glibra::classic {
namespace {

struct Registry {
    std::mutex mutex;
    std::map<std::pair<void*, GLuint>, std::shared_ptr<const LinkedProgram>> programs;
    std::uint64_t last = 0;
};

Registry& registry() {
    static Registry all;
    return all;
}

}  // namespace

void remember(void* context, GLuint program, LinkedProgram facts) {
    Registry& all = registry();
    const std::lock_guard<std::mutex> lock(all.mutex);
    facts.serial = ++all.last;
    all.programs[{context, program}] = std::make_shared<const LinkedProgram>(std::move(facts));
}

void forget(void* context, GLuint program) {
    Registry& all = registry();
    const std::lock_guard<std::mutex> lock(all.mutex);
    all.programs.erase({context, program});
}

std::shared_ptr<const LinkedProgram> linkedProgram(void* context, GLuint program) {
    Registry& all = registry();
    const std::lock_guard<std::mutex> lock(all.mutex);
    const auto found = all.programs.find({context, program});
    return found != all.programs.end() ? found->second : nullptr;
}

std::string bookName(std::string_view emitted) {
    constexpr std::string_view kOwn = "glibra_";
    constexpr std::string_view kTexCoord = "glibra_MultiTexCoord";
    if (emitted.starts_with(kTexCoord)) return "aTexCoord" + std::string(emitted.substr(kTexCoord.size()));
    for (const std::string_view each : {"Vertex", "Normal", "Color"})
        if (emitted.starts_with(kOwn) && emitted.substr(kOwn.size()) == each) return "a" + std::string(each);
    return std::string(emitted);
}

namespace {

using base::BaseType;
using glsl::Builtin;

bool isTextureMatrix(Builtin value) {
    return value >= Builtin::textureMatrix && value <= Builtin::textureMatrixInverseTranspose;
}

/// A matrix of gstap.h, and the names of what is computed from it.
struct MatrixNames {
    glm::dmat4 matrix;
    Builtin plain, inverse, transpose, inverseTranspose;
};

/// What gstap.h computes from the two matrices; nothing for names that have other values.
std::optional<glm::dmat4> derived(Builtin value, const glm::dmat4& modelView, const glm::dmat4& projection) {
    if (isTextureMatrix(value)) return glm::dmat4(1);
    if (value == Builtin::normalMatrix)
        return glm::dmat4(glm::transpose(base::inverseOrZero(glm::dmat3(modelView))));
    for (const MatrixNames& each :
         {MatrixNames{modelView, Builtin::modelView, Builtin::modelViewInverse, Builtin::modelViewTranspose,
                      Builtin::modelViewInverseTranspose},
          MatrixNames{projection, Builtin::projection, Builtin::projectionInverse,
                      Builtin::projectionTranspose, Builtin::projectionInverseTranspose},
          MatrixNames{projection * modelView, Builtin::modelViewProjection,
                      Builtin::modelViewProjectionInverse, Builtin::modelViewProjectionTranspose,
                      Builtin::modelViewProjectionInverseTranspose}}) {
        if (value == each.plain) return each.matrix;
        if (value == each.inverse) return base::inverseOrZero(each.matrix);
        if (value == each.transpose) return glm::transpose(each.matrix);
        if (value == each.inverseTranspose) return glm::transpose(base::inverseOrZero(each.matrix));
    }
    return std::nullopt;
}

/// True for integers of 32 bits, signed or not.
bool isInteger(double value) {
    return value >= -2147483648.0 && value <= 4294967295.0 && value == std::floor(value);
}

/// Such a number as an integer; 0 for others.
std::int64_t integerOf(double value) {
    return isInteger(value) ? static_cast<std::int64_t>(value) : 0;
}

/// What follows "did you mean": the nearest name. Names begin with the same letter, so that of short ones
/// only a letter too many or too few is a mistake: uKs is another name than uKd, but uCc is uC.
std::string hintAt(std::string_view name, std::vector<std::string_view> names, char first) {
    std::string hint = base::suggestion(name, names, name.starts_with(first) ? 1 : 0);
    if (!hint.empty()) return hint;
    std::erase_if(names, [&](std::string_view each) { return each.size() == name.size(); });
    return base::suggestion(name, names);
}

/// What the driver lists: how many there are, and how long their names may be.
struct ListOf {
    GLenum count, longest;
};
/// Calls use(name, type, number of elements) for each of them.
void forEachActive(const Gl& gl, GLuint program, ListOf list, auto ask, const auto& use) {
    GLint count = 0;
    GLint longest = 0;
    gl.GetProgramiv(program, list.count, &count);
    gl.GetProgramiv(program, list.longest, &longest);
    std::string text(static_cast<std::size_t>(std::max(longest, 1)), '\0');
    for (GLint i = 0; i < count; ++i) {
        GLsizei length = 0;
        GLint size = 0;
        GLenum type = 0;
        ask(program, static_cast<GLuint>(i), longest, &length, &size, &type, text.data());
        use(text.substr(0, static_cast<std::size_t>(length)), type, size);
    }
}

std::string withoutSubscript(std::string name) {
    if (name.ends_with("[0]")) name.resize(name.size() - 3);
    return name;
}

}  // namespace

ProgramValues::ProgramValues(const Gl& gl, GLuint program, const glsl::TranslatedProgram& translated,
                             bool isGstap)
    : gl_(gl), program_(program), who_("GLSLProgram " + translated.name) {
    for (const auto& [emitted, user] : translated.userNames) emittedNames_[user] = emitted;
    findUniforms(translated, isGstap);
    findInputs(translated);
    deriveMatrices();
    for (auto& [name, slot] : uniforms_) {
        if (const auto unit = translated.textureBindings.find(name); unit != translated.textureBindings.end())
            upload(slot, std::array{static_cast<double>(unit->second)});
        if (slot.builtin == nullptr) continue;
        const Builtin value = slot.builtin->value;
        // As for scenes, the noise textures have units 2 and 3; here the program binds them.
        if (value == Builtin::noise2 || value == Builtin::noise3)
            upload(slot, std::array{value == Builtin::noise2 ? 2.0 : 3.0});
        if (value == Builtin::currentColor) upload(slot, std::array{1.0, 1.0, 1.0, 1.0});
        if (value == Builtin::pointSize) upload(slot, std::array{1.0});
        if (isTextureMatrix(value))  // an array: the others are identities as well
            for (int i = 1; i < slot.size; ++i) {
                Slot element = slot;
                element.location += i;
                upload(element, glm::dmat4(1));
            }
    }
}

void ProgramValues::findUniforms(const glsl::TranslatedProgram& translated, bool isGstap) {
    const auto add = [&](const std::string& listed, GLenum type, GLint size) {
        const std::string emitted = withoutSubscript(listed);
        Slot slot;
        slot.size = size;
        slot.location = gl_.GetUniformLocation(program_, emitted.c_str());
        if (slot.location < 0) return;  // in a block
        slot.type = gpu::valueType(type);
        const glsl::BuiltinUniform* builtin = glsl::findBuiltinUniform(emitted);
        if (isGstap && builtin != nullptr && builtin->type == slot.type.word) slot.builtin = builtin;
        const auto renamed = translated.userNames.find(emitted);
        uniforms_.emplace(renamed != translated.userNames.end() ? renamed->second : emitted, slot);
    };
    forEachActive(gl_, program_, {GL_ACTIVE_UNIFORMS, GL_ACTIVE_UNIFORM_MAX_LENGTH}, gl_.GetActiveUniform,
                  add);
}

void ProgramValues::findInputs(const glsl::TranslatedProgram& translated) {
    const auto add = [&](const std::string& emitted, GLenum type, GLint) {
        const GLint location = gl_.GetAttribLocation(program_, emitted.c_str());
        if (location < 0) return;  // gl_VertexID and its kin
        const auto renamed = translated.userNames.find(emitted);
        const std::string name = renamed != translated.userNames.end() && !renamed->second.starts_with("gl_")
                                     ? renamed->second
                                     : bookName(emitted);
        inputs_[name] = {static_cast<GLuint>(location), type};
        if (name == "aColor") constants_[name] = {1, 1, 1, 1};
        if (name == "aNormal") constants_[name] = {0, 0, 1, 1};
    };
    forEachActive(gl_, program_, {GL_ACTIVE_ATTRIBUTES, GL_ACTIVE_ATTRIBUTE_MAX_LENGTH}, gl_.GetActiveAttrib,
                  add);
}

void ProgramValues::once(std::string_view about, const std::string& text) {
    if (reported_.emplace(about).second) complainOf(who_, text);
}

ProgramValues::Slot* ProgramValues::slotOf(std::string_view name, std::string_view call) {
    if (const auto found = uniforms_.find(name); found != uniforms_.end()) return &found->second;
    if (name.starts_with("gl_"))
        if (const auto found = uniforms_.find(glsl::emittedName(name)); found != uniforms_.end())
            return &found->second;
    // An element of an array, which becomes known by its own name.
    if (const std::size_t bracket = name.rfind('['); bracket != name.npos && name.ends_with(']')) {
        const auto array = uniforms_.find(name.substr(0, bracket));
        if (array != uniforms_.end()) {
            const auto renamed = emittedNames_.find(array->first);
            const std::string emitted = (renamed != emittedNames_.end() ? renamed->second : array->first) +
                                        std::string(name.substr(bracket));
            Slot element = array->second;
            element.size += element.location;
            element.location = gl_.GetUniformLocation(program_, emitted.c_str());
            element.size -= element.location;
            if (element.location >= 0)
                return &uniforms_.emplace(std::string(name), std::move(element)).first->second;
        }
    }
    // A name of gstap.h that the shaders do not use is no mistake.
    if (glsl::findBuiltinUniform(name) != nullptr) return nullptr;
    std::vector<std::string_view> names;
    for (const auto& [each, slot] : uniforms_) names.push_back(each);
    std::sort(names.begin(), names.end());
    once(name, fmt::format("{}: the program uses no uniform '{}'{}", call, name,
                           hintAt(name, std::move(names), 'u')));
    return nullptr;
}

void ProgramValues::upload(const Slot& slot, std::span<const double> values) const {
    const auto count = static_cast<GLsizei>(values.size()) / slot.type.components();
    const int rows = slot.type.rows;
    if (slot.type.base == BaseType::floating) {
        std::array<float, 16> few;  // most values need no memory
        std::vector<float> many(values.size() > few.size() ? values.size() : 0);
        float* const f = many.empty() ? few.data() : many.data();
        std::transform(values.begin(), values.end(), f, [](double each) { return static_cast<float>(each); });
        if (slot.type.columns > 1) {
            if (slot.type.columns == 2)
                gl_.ProgramUniformMatrix2fv(program_, slot.location, count, GL_FALSE, f);
            if (slot.type.columns == 3)
                gl_.ProgramUniformMatrix3fv(program_, slot.location, count, GL_FALSE, f);
            if (slot.type.columns == 4)
                gl_.ProgramUniformMatrix4fv(program_, slot.location, count, GL_FALSE, f);
            return;
        }
        const std::array set{gl_.ProgramUniform1fv, gl_.ProgramUniform2fv, gl_.ProgramUniform3fv,
                             gl_.ProgramUniform4fv};
        set[static_cast<std::size_t>(rows - 1)](program_, slot.location, count, f);
    } else if (slot.type.base == BaseType::unsignedInteger) {
        std::vector<GLuint> u;
        for (const double each : values) u.push_back(static_cast<GLuint>(integerOf(each)));
        const std::array set{gl_.ProgramUniform1uiv, gl_.ProgramUniform2uiv, gl_.ProgramUniform3uiv,
                             gl_.ProgramUniform4uiv};
        set[static_cast<std::size_t>(rows - 1)](program_, slot.location, count, u.data());
    } else {
        std::vector<GLint> i;
        for (const double each : values) i.push_back(static_cast<GLint>(integerOf(each)));
        const std::array set{gl_.ProgramUniform1iv, gl_.ProgramUniform2iv, gl_.ProgramUniform3iv,
                             gl_.ProgramUniform4iv};
        set[static_cast<std::size_t>(rows - 1)](program_, slot.location, count, i.data());
    }
}

void ProgramValues::upload(const Slot& slot, const glm::dmat4& matrix) const {
    std::vector<double> values;
    for (int column = 0; column < slot.type.columns; ++column)
        for (int row = 0; row < slot.type.rows; ++row) values.push_back(matrix[column][row]);
    upload(slot, values);
}

void ProgramValues::deriveMatrices() {
    for (auto& [name, slot] : uniforms_)
        if (slot.builtin != nullptr && !slot.isGiven)
            if (const auto value = derived(slot.builtin->value, modelView_, projection_))
                upload(slot, *value);
}

bool ProgramValues::takes(const base::ValueType& type, std::string_view name, std::string_view call,
                          std::span<const double> values) {
    if (type.base == BaseType::floating || type.base == BaseType::doublePrecision) return true;
    const auto wrong = std::find_if_not(values.begin(), values.end(), isInteger);
    if (wrong == values.end()) return true;
    once(name, fmt::format("{}: '{}' has the type {} and was given {:g}, which is no integer of 32 bits",
                           call, name, type.word, *wrong));
    return false;
}

void ProgramValues::set(std::string_view name, std::span<const double> values) {
    Slot* slot = slotOf(name, "SetUniform");
    if (slot == nullptr || !takes(slot->type, name, "SetUniform", values)) return;
    const int needed = slot->type.columns > 1 ? 0 : slot->type.rows;
    const auto given = static_cast<int>(values.size());
    if (given == needed) {
        upload(*slot, values);
    } else if (given == 3 && needed == 4) {
        upload(*slot, std::array{values[0], values[1], values[2], 1.0});
    } else {
        once(name, fmt::format("SetUniform: '{}' is a {} and was given {}", name, slot->type.word,
                               base::counted(given, "number")));
    }
}

void ProgramValues::set(std::string_view name, const float* values) {
    Slot* slot = slotOf(name, "SetUniform");
    if (slot == nullptr) return;
    const std::span<const float> given(values,
                                       static_cast<std::size_t>(slot->type.components() * slot->size));
    const std::vector<double> all(given.begin(), given.end());
    if (takes(slot->type, name, "SetUniform", all)) upload(*slot, all);
}

void ProgramValues::set(std::string_view name, const glm::dmat4& matrix) {
    const glsl::BuiltinUniform* builtin = glsl::findBuiltinUniform(name);
    Slot* slot = slotOf(name, "SetUniform");
    if (slot != nullptr && slot->type.columns == 1) {
        once(name, fmt::format("SetUniform: '{}' is a {} and was given a matrix", name, slot->type.word));
        return;
    }
    if (slot != nullptr && slot->builtin == nullptr) {
        upload(*slot, matrix);
        return;
    }
    if (builtin == nullptr) return;
    const bool isModelView = builtin->value == Builtin::modelView;
    if (isModelView || builtin->value == Builtin::projection) {
        (isModelView ? modelView_ : projection_) = matrix;
        deriveMatrices();
        return;
    }
    for (auto& [each, other] : uniforms_)
        if (other.builtin != nullptr && other.builtin->value == builtin->value) {
            other.isGiven = true;
            upload(other, matrix);
        }
}

const ProgramInput* ProgramValues::inputOf(std::string_view name) {
    const std::string book = bookName(glsl::emittedName(name));
    if (const auto found = inputs_.find(book); found != inputs_.end()) return &found->second;
    if (glsl::findBuiltinInput(name) != nullptr) return nullptr;
    std::vector<std::string_view> names;
    for (const auto& [each, input] : inputs_) names.push_back(each);
    once(name, fmt::format("SetAttribute: the program uses no attribute '{}'{}", name,
                           hintAt(name, std::move(names), 'a')));
    return nullptr;
}

void ProgramValues::setInput(std::string_view name, std::span<const double> values) {
    const ProgramInput* input = inputOf(name);
    if (input == nullptr) return;
    const base::ValueType type = gpu::valueType(input->type);
    const auto given = static_cast<int>(values.size());
    if (type.columns > 1 || (given != type.rows && !(given == 3 && type.rows == 4))) {
        once(name, fmt::format("SetAttribute: '{}' is a {} and was given {}", name, type.word,
                               base::counted(given, "number")));
        return;
    }
    if (!takes(type, name, "SetAttribute", values)) return;
    auto& constant = constants_[bookName(glsl::emittedName(name))];
    constant = {0, 0, 0, 1};
    std::copy(values.begin(), values.end(), constant.begin());
    if (gl_.number(GL_CURRENT_PROGRAM) == static_cast<GLint>(program_)) use();
}

void ProgramValues::setInput(std::string_view name, const float* values) {
    const ProgramInput* input = inputOf(name);
    if (input == nullptr) return;
    const std::span<const float> given(values, static_cast<std::size_t>(gpu::valueType(input->type).rows));
    setInput(name, std::vector<double>(given.begin(), given.end()));
}

void ProgramValues::use() const {
    for (const auto& [name, value] : constants_) {
        const ProgramInput& input = inputs_.find(name)->second;
        if (gpu::valueType(input.type).isInteger()) {
            std::array<GLint, 4> i{};
            std::transform(value.begin(), value.end(), i.begin(),
                           [](double each) { return static_cast<GLint>(integerOf(each)); });
            gl_.VertexAttribI4iv(input.location, i.data());
        } else {
            std::array<GLfloat, 4> f{};
            std::transform(value.begin(), value.end(), f.begin(),
                           [](double each) { return static_cast<GLfloat>(each); });
            gl_.VertexAttrib4fv(input.location, f.data());
        }
    }
}

std::string ProgramValues::list() const {
    std::map<std::string_view, const Slot*> sorted;
    for (const auto& [name, slot] : uniforms_) sorted.emplace(name, &slot);
    std::string text;
    for (const auto& [name, slot] : sorted)
        text += fmt::format("glibra: {}: uniform {} {} at {}\n", who_, slot->type.word, name, slot->location);
    for (const auto& [name, input] : inputs_)
        text += fmt::format("glibra: {}: attribute {} {} at {}\n", who_, gpu::valueType(input.type).word,
                            name, input.location);
    return text;
}

}  // namespace glibra::classic
