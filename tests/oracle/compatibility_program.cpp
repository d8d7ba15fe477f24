#include "compatibility_program.h"

#include <algorithm>
#include <array>
#include <stdexcept>

namespace glibra::oracle {
namespace {

GLenum glStage(glsl::Stage stage) {
    switch (stage) {
        case glsl::Stage::vertex:
            return GL_VERTEX_SHADER;
        case glsl::Stage::tessControl:
            return GL_TESS_CONTROL_SHADER;
        case glsl::Stage::tessEvaluation:
            return GL_TESS_EVALUATION_SHADER;
        case glsl::Stage::geometry:
            return GL_GEOMETRY_SHADER;
        case glsl::Stage::compute:
            return GL_COMPUTE_SHADER;
        case glsl::Stage::fragment:
            break;
    }
    return GL_FRAGMENT_SHADER;
}

/// The name of an array as in tags, without its subscript.
std::string withoutSubscript(std::string name) {
    if (name.ends_with("[0]")) name.resize(name.size() - 3);
    return name;
}

template <class M>
std::vector<double> numbers(const M& matrix) {
    std::vector<double> values;
    for (glm::length_t column = 0; column < M::length(); ++column)
        for (glm::length_t row = 0; row < M::col_type::length(); ++row) values.push_back(matrix[column][row]);
    return values;
}

/// The shape of a type: its component type, its columns, and the components per column.
struct TypeShape {
    enum class Base { floating, integer, unsignedInteger } base = Base::floating;
    int columns = 1, rows = 1;
};
TypeShape shapeOf(GLenum type) {
    using enum TypeShape::Base;
    switch (type) {
        case GL_FLOAT:
            return {floating, 1, 1};
        case GL_FLOAT_VEC2:
            return {floating, 1, 2};
        case GL_FLOAT_VEC3:
            return {floating, 1, 3};
        case GL_FLOAT_VEC4:
            return {floating, 1, 4};
        case GL_INT:
        case GL_BOOL:
            return {integer, 1, 1};
        case GL_INT_VEC2:
        case GL_BOOL_VEC2:
            return {integer, 1, 2};
        case GL_INT_VEC3:
        case GL_BOOL_VEC3:
            return {integer, 1, 3};
        case GL_INT_VEC4:
        case GL_BOOL_VEC4:
            return {integer, 1, 4};
        case GL_UNSIGNED_INT:
            return {unsignedInteger, 1, 1};
        case GL_FLOAT_MAT2:
            return {floating, 2, 2};
        case GL_FLOAT_MAT3:
            return {floating, 3, 3};
        case GL_FLOAT_MAT4:
            return {floating, 4, 4};
        case GL_FLOAT_MAT2x3:
            return {floating, 2, 3};
        default:
            throw std::runtime_error("the oracle does not know uniform type " + std::to_string(type));
    }
}

/// The numbers that a tag gives to a uniform of that shape (language, 5.2 and 5.3).
std::vector<double> valuesOf(const glib::UniformSpec& tag, const TypeShape& shape) {
    std::vector<double> values = tag.values;
    if (tag.form == glib::UniformForm::range)
        values = {tag.values.size() > 2 ? tag.values[1] : tag.values.front()};
    if (tag.form == glib::UniformForm::color && values.size() == 3) values.push_back(1);
    const auto components = static_cast<std::size_t>(shape.rows);
    if (values.size() == 1 && shape.columns == 1) values.resize(components, values.front());
    if (tag.form == glib::UniformForm::color) values.resize(components);
    return values;
}

bool isSampler(GLenum type) {
    return type == GL_SAMPLER_1D || type == GL_SAMPLER_2D || type == GL_SAMPLER_3D || type == GL_SAMPLER_CUBE;
}

scene::TextureTarget targetOf(GLenum type) {
    switch (type) {
        case GL_SAMPLER_1D:
            return scene::TextureTarget::texture1D;
        case GL_SAMPLER_3D:
            return scene::TextureTarget::texture3D;
        case GL_SAMPLER_CUBE:
            return scene::TextureTarget::cube;
        default:
            return scene::TextureTarget::texture2D;
    }
}

/// The mesh attribute for a vertex input with one of the names in language, 6.
std::string_view meshAttributeOf(std::string_view name) {
    static constexpr std::array<std::array<std::string_view, 2>, 8> kNames{
        {{"aVertex", geometry::kPosition},
         {"aNormal", geometry::kNormal},
         {"aColor", geometry::kColor},
         {"aTexCoord0", geometry::kTexCoord},
         {"Tangent", geometry::kTangent},
         {"aTangent", geometry::kTangent},
         {"FaceIndex", geometry::kFaceIndex},
         {"aFaceIndex", geometry::kFaceIndex}}};
    for (const auto& [input, attribute] : kNames)
        if (input == name) return attribute;
    return {};
}

}  // namespace

CompatibilityProgram::CompatibilityProgram(const GladGLContext& gl, const std::vector<Source>& sources)
    : gl_(gl), id_(gl.CreateProgram()) {
    std::string log(16384, '\0');
    for (const Source& source : sources) {
        stages_.push_back(source.stage);
        const GLuint shader = gl.CreateShader(glStage(source.stage));
        const GLchar* text = source.text.c_str();
        gl.ShaderSource(shader, 1, &text, nullptr);
        gl.CompileShader(shader);
        gl.AttachShader(id_, shader);
        GLint good = 0;
        gl.GetShaderiv(shader, GL_COMPILE_STATUS, &good);
        if (!good) gl.GetShaderInfoLog(shader, static_cast<GLsizei>(log.size()), nullptr, log.data());
        gl.DeleteShader(shader);
        if (!good)
            throw std::runtime_error("the oracle's driver does not compile\n" + source.text + "\n" +
                                     log.c_str());
    }
    gl.LinkProgram(id_);
    GLint good = 0;
    gl.GetProgramiv(id_, GL_LINK_STATUS, &good);
    if (!good) {
        gl.GetProgramInfoLog(id_, static_cast<GLsizei>(log.size()), nullptr, log.data());
        throw std::runtime_error(std::string("the oracle's driver does not link: ") + log.c_str());
    }
    GLint blocks = 0;
    gl.GetProgramiv(id_, GL_ACTIVE_UNIFORM_BLOCKS, &blocks);
    blocks_.resize(static_cast<std::size_t>(blocks));
    gl.GenBuffers(blocks, blocks_.data());
    for (GLuint i = 0; i < blocks_.size(); ++i) {
        GLint bytes = 0;
        gl.GetActiveUniformBlockiv(id_, i, GL_UNIFORM_BLOCK_DATA_SIZE, &bytes);
        gl.UniformBlockBinding(id_, i, i);
        gl.BindBufferBase(GL_UNIFORM_BUFFER, i, blocks_[i]);
        const std::vector<std::byte> zeros(static_cast<std::size_t>(bytes));
        gl.BufferData(GL_UNIFORM_BUFFER, bytes, zeros.data(), GL_STATIC_DRAW);
    }
    for (const Uniform& uniform : uniforms())
        if (isSampler(uniform.type))
            for (GLint at = uniform.location; at < uniform.location + uniform.size; ++at)
                gl.GetUniformiv(id_, at, &declaredUnits_[at]);
}

CompatibilityProgram::~CompatibilityProgram() {
    gl_.UseProgram(0);
    gl_.DeleteBuffers(static_cast<GLsizei>(blocks_.size()), blocks_.data());
    gl_.DeleteProgram(id_);
}

void CompatibilityProgram::use() const {
    gl_.UseProgram(id_);
}

bool CompatibilityProgram::hasStage(glsl::Stage stage) const {
    return std::find(stages_.begin(), stages_.end(), stage) != stages_.end();
}

std::vector<CompatibilityProgram::Uniform> CompatibilityProgram::uniforms() const {
    GLint count = 0;
    gl_.GetProgramiv(id_, GL_ACTIVE_UNIFORMS, &count);
    std::vector<Uniform> all;
    for (GLuint i = 0; i < static_cast<GLuint>(count); ++i) {
        std::array<GLchar, 256> name{};
        Uniform each;
        gl_.GetActiveUniform(id_, i, static_cast<GLsizei>(name.size()), nullptr, &each.size, &each.type,
                             name.data());
        each.name = withoutSubscript(name.data());
        if (each.name.starts_with("gl_")) continue;
        each.location = gl_.GetUniformLocation(id_, name.data());
        gl_.GetActiveUniformsiv(id_, 1, &i, GL_UNIFORM_BLOCK_INDEX, &each.block);
        gl_.GetActiveUniformsiv(id_, 1, &i, GL_UNIFORM_OFFSET, &each.offset);
        gl_.GetActiveUniformsiv(id_, 1, &i, GL_UNIFORM_ARRAY_STRIDE, &each.arrayStride);
        gl_.GetActiveUniformsiv(id_, 1, &i, GL_UNIFORM_MATRIX_STRIDE, &each.matrixStride);
        all.push_back(std::move(each));
    }
    return all;
}

void CompatibilityProgram::setUniform(const Uniform& uniform, const std::vector<double>& values) const {
    const TypeShape shape = shapeOf(uniform.type);
    const auto perElement = static_cast<std::size_t>(shape.columns) * static_cast<std::size_t>(shape.rows);
    const auto count = std::min(uniform.size, static_cast<GLsizei>(values.size() / perElement));
    const std::vector<GLfloat> floats(values.begin(), values.end());
    const std::vector<GLint> integers(values.begin(), values.end());
    const GLint at = uniform.location;
    if (shape.base == TypeShape::Base::unsignedInteger) {
        gl_.Uniform1ui(at, static_cast<GLuint>(values.front()));
    } else if (shape.base == TypeShape::Base::integer) {
        const std::array set{gl_.Uniform1iv, gl_.Uniform2iv, gl_.Uniform3iv, gl_.Uniform4iv};
        set[static_cast<std::size_t>(shape.rows - 1)](at, count, integers.data());
    } else if (shape.columns == 1) {
        const std::array set{gl_.Uniform1fv, gl_.Uniform2fv, gl_.Uniform3fv, gl_.Uniform4fv};
        set[static_cast<std::size_t>(shape.rows - 1)](at, count, floats.data());
    } else {
        const auto set = uniform.type == GL_FLOAT_MAT2x3 ? gl_.UniformMatrix2x3fv
                         : shape.columns == 2            ? gl_.UniformMatrix2fv
                         : shape.columns == 3            ? gl_.UniformMatrix3fv
                                                         : gl_.UniformMatrix4fv;
        set(at, count, GL_FALSE, floats.data());
    }
}

void CompatibilityProgram::writeToBlock(const Uniform& uniform, const std::vector<double>& values) {
    const TypeShape shape = shapeOf(uniform.type);
    gl_.BindBuffer(GL_UNIFORM_BUFFER, blocks_[static_cast<std::size_t>(uniform.block)]);
    for (std::size_t i = 0; i < values.size(); ++i) {
        const auto row = static_cast<GLint>(i) % shape.rows;
        const auto column = static_cast<GLint>(i) / shape.rows % shape.columns;
        const auto element = static_cast<GLint>(i) / (shape.rows * shape.columns);
        const GLintptr at =
            uniform.offset + element * uniform.arrayStride + column * uniform.matrixStride + 4 * row;
        const auto asFloat = static_cast<GLfloat>(values[i]);
        const auto asInteger = static_cast<GLint>(values[i]);
        const void* data =
            shape.base == TypeShape::Base::floating ? static_cast<const void*>(&asFloat) : &asInteger;
        gl_.BufferSubData(GL_UNIFORM_BUFFER, at, 4, data);
    }
}

bool CompatibilityProgram::matches(const std::string& tag, const Uniform& uniform) const {
    if (tag == uniform.name) return true;
    if (uniform.block < 0) return false;
    // Tags name a member of a block as `member` or `Block.member`. The driver knows it by one of these names.
    std::array<GLchar, 256> block{};
    gl_.GetActiveUniformBlockName(id_, static_cast<GLuint>(uniform.block), static_cast<GLsizei>(block.size()),
                                  nullptr, block.data());
    const std::string prefix = std::string(block.data()) + ".";
    return tag == prefix + uniform.name || uniform.name == prefix + tag;
}

void CompatibilityProgram::setTags(const std::vector<glib::UniformSpec>& tags) {
    for (const Uniform& uniform : uniforms()) {
        if (isSampler(uniform.type)) continue;
        for (const glib::UniformSpec& tag : tags) {
            if (!matches(tag.tag, uniform)) continue;
            const std::vector<double> values = valuesOf(tag, shapeOf(uniform.type));
            if (uniform.block >= 0)
                writeToBlock(uniform, values);
            else
                setUniform(uniform, values);
        }
    }
}

void CompatibilityProgram::setRuntimeValues(const glm::dmat4& modelView, const glm::dmat4& projection,
                                            double timer) const {
    for (const Uniform& uniform : uniforms()) {
        if (uniform.name == "uModelViewMatrix")
            setUniform(uniform, numbers(modelView));
        else if (uniform.name == "uProjectionMatrix")
            setUniform(uniform, numbers(projection));
        else if (uniform.name == "uModelViewProjectionMatrix")
            setUniform(uniform, numbers(projection * modelView));
        else if (uniform.name == "uModelViewMatrixInverse")
            setUniform(uniform, numbers(scene::inverseOrZero(modelView)));
        else if (uniform.name == "uNormalMatrix")
            setUniform(uniform, numbers(scene::normalMatrix(modelView)));
        else if (uniform.name == "Timer")
            setUniform(uniform, {timer});
    }
}

std::vector<CompatibilityProgram::Sampler> CompatibilityProgram::samplers(
    const std::vector<glib::UniformSpec>& tags) const {
    std::vector<Sampler> found;
    for (const Uniform& uniform : uniforms()) {
        if (!isSampler(uniform.type)) continue;
        for (GLint element = 0; element < uniform.size; ++element) {
            int unit = declaredUnits_.at(uniform.location + element);
            if (uniform.name == "Noise2") unit = 2;
            if (uniform.name == "Noise3") unit = 3;
            for (const glib::UniformSpec& tag : tags)
                if (tag.tag == uniform.name)
                    unit = static_cast<int>(tag.values.at(static_cast<std::size_t>(element)));
            found.push_back({uniform.location + element, unit, targetOf(uniform.type)});
        }
    }
    return found;
}

void CompatibilityProgram::bindAttributes(const geometry::Mesh& mesh, const glm::dvec4& color) const {
    const auto bindArray = [&](std::string_view name, GLenum array, const auto& set) {
        const geometry::Attribute* attribute = mesh.attribute(name);
        if (!attribute) return;
        gl_.EnableClientState(array);
        set(attribute->components, attribute->values.data());
    };
    gl_.Color4d(color.r, color.g, color.b, color.a);
    gl_.Normal3d(0, 0, 1);
    gl_.ClientActiveTexture(GL_TEXTURE0);
    bindArray(geometry::kPosition, GL_VERTEX_ARRAY,
              [&](GLint n, const float* data) { gl_.VertexPointer(n, GL_FLOAT, 0, data); });
    bindArray(geometry::kNormal, GL_NORMAL_ARRAY,
              [&](GLint, const float* data) { gl_.NormalPointer(GL_FLOAT, 0, data); });
    bindArray(geometry::kColor, GL_COLOR_ARRAY,
              [&](GLint n, const float* data) { gl_.ColorPointer(n, GL_FLOAT, 0, data); });
    bindArray(geometry::kTexCoord, GL_TEXTURE_COORD_ARRAY,
              [&](GLint n, const float* data) { gl_.TexCoordPointer(n, GL_FLOAT, 0, data); });

    GLint count = 0;
    gl_.GetProgramiv(id_, GL_ACTIVE_ATTRIBUTES, &count);
    for (GLuint i = 0; i < static_cast<GLuint>(count); ++i) {
        std::array<GLchar, 256> name{};
        GLint size = 0;
        GLenum type = 0;
        gl_.GetActiveAttrib(id_, i, static_cast<GLsizei>(name.size()), nullptr, &size, &type, name.data());
        const GLint location = gl_.GetAttribLocation(id_, name.data());
        if (location < 0) continue;
        const auto at = static_cast<GLuint>(location);
        const geometry::Attribute* attribute = mesh.attribute(meshAttributeOf(name.data()));
        if (attribute) {
            gl_.EnableVertexAttribArray(at);
            gl_.VertexAttribPointer(at, attribute->components, GL_FLOAT, GL_FALSE, 0,
                                    attribute->values.data());
        } else if (meshAttributeOf(name.data()) == geometry::kColor) {
            gl_.VertexAttrib4d(at, color.r, color.g, color.b, color.a);
        } else {
            gl_.VertexAttrib4d(at, 0, 0, 0, 1);
        }
    }
}

void CompatibilityProgram::unbindAttributes() const {
    for (const int array : {GL_VERTEX_ARRAY, GL_NORMAL_ARRAY, GL_COLOR_ARRAY, GL_TEXTURE_COORD_ARRAY})
        gl_.DisableClientState(static_cast<GLenum>(array));
    for (GLuint i = 0; i < 16; ++i) gl_.DisableVertexAttribArray(i);
}

}  // namespace glibra::oracle
