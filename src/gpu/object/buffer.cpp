#include "gpu/object/buffer.h"

#include <algorithm>
#include <atomic>
#include <bit>
#include <limits>
#include <new>
#include <numeric>
#include <utility>

#include "base/number.h"
#include "base/text.h"
#include "gpu/context/errors.h"

namespace glibra::gpu {
namespace {

// Uploads use a binding point that no other state depends on; GL_ELEMENT_ARRAY_BUFFER, for one, belongs to
// the bound vertex array.
constexpr GLenum kUploadTarget = GL_COPY_WRITE_BUFFER;

}  // namespace

Result<Buffer> Buffer::allocate(const std::byte* content, std::size_t bytes, GLenum usage) {
    if (bytes > static_cast<std::size_t>(std::numeric_limits<GLsizeiptr>::max()))
        return allocationError(GL_OUT_OF_MEMORY, "a buffer of " + base::readableBytes(bytes));
    Buffer buffer;
    buffer.name_ = Name<glDeleteBuffers>(glGenBuffers);
    buffer.size_ = bytes;
    clearErrors();
    buffer.bind(kUploadTarget);
    glBufferData(kUploadTarget, static_cast<GLsizeiptr>(bytes), content, usage);
    if (const GLenum code = takeError(); code != GL_NO_ERROR)
        return allocationError(code, "a buffer of " + base::readableBytes(bytes));
    return buffer;
}

Result<Buffer> Buffer::create(std::span<const std::byte> content, GLenum usage) {
    return allocate(content.data(), content.size(), usage);
}

Result<Buffer> Buffer::create(std::size_t bytes, GLenum usage) {
    return allocate(nullptr, bytes, usage);
}

std::uint64_t Buffer::nextContent() {
    static std::atomic<std::uint64_t> last = 0;
    return ++last;
}

void Buffer::update(std::size_t offset, std::span<const std::byte> content) {
    if (offset >= size_ || content.empty()) return;
    content_ = nextContent();
    const std::size_t bytes = std::min(content.size(), size_ - offset);
    glBindBuffer(kUploadTarget, id());
    glBufferSubData(kUploadTarget, static_cast<GLintptr>(offset), static_cast<GLsizeiptr>(bytes),
                    content.data());
}

void Buffer::clear(const Capabilities& capabilities) {
    content_ = nextContent();
    if (size_ == 0) return;
    if (!capabilities.atLeast(4, 3)) return update(0, std::vector<std::byte>(size_));
    glBindBuffer(kUploadTarget, id());
    // Words are what devices fill memory with; Mesa on the processor is faster with bytes.
    const std::size_t words = capabilities.isSoftware ? 0 : size_ / sizeof(GLuint) * sizeof(GLuint);
    const auto clear = [](std::size_t from, std::size_t bytes, GLenum format, GLenum type) {
        if (bytes > 0)
            glClearBufferSubData(kUploadTarget, format, static_cast<GLintptr>(from),
                                 static_cast<GLsizeiptr>(bytes), GL_RED_INTEGER, type, nullptr);
    };
    clear(0, words, GL_R32UI, GL_UNSIGNED_INT);
    clear(words, size_ - words, GL_R8UI, GL_UNSIGNED_BYTE);
}

void Buffer::copyFrom(const Buffer& other) {
    copyFrom(other, 0, 0, size_);
}

void Buffer::copyFrom(const Buffer& other, std::size_t from, std::size_t to, std::size_t bytes) {
    if (from >= other.size_ || to >= size_) return;
    content_ = nextContent();
    bytes = std::min({bytes, other.size_ - from, size_ - to});
    glBindBuffer(GL_COPY_READ_BUFFER, other.id());
    glBindBuffer(kUploadTarget, id());
    glCopyBufferSubData(GL_COPY_READ_BUFFER, kUploadTarget, static_cast<GLintptr>(from),
                        static_cast<GLintptr>(to), static_cast<GLsizeiptr>(bytes));
}

void Buffer::read(std::size_t offset, std::span<std::byte> content) const {
    if (offset >= size_) return;
    clearErrors();
    glBindBuffer(GL_COPY_READ_BUFFER, id());
    glGetBufferSubData(GL_COPY_READ_BUFFER, static_cast<GLintptr>(offset),
                       static_cast<GLsizeiptr>(std::min(content.size(), size_ - offset)), content.data());
    if (takeError() == GL_OUT_OF_MEMORY) throw std::bad_alloc();
}

void BufferTexture::bind(int unit, const Buffer& buffer, TexelFormat format) const {
    glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
    glBindTexture(GL_TEXTURE_BUFFER, name_.get());
    glTexBuffer(GL_TEXTURE_BUFFER, internalFormat(format), buffer.id());
}

void BufferTexture::bindImage(int unit, const Buffer& buffer, TexelFormat format, TexelFormat as) const {
    // Samplers keep what they read on unit 0.
    GLint sampled = 0;
    glActiveTexture(GL_TEXTURE0);
    glGetIntegerv(GL_TEXTURE_BINDING_BUFFER, &sampled);
    bind(0, buffer, format);
    glBindTexture(GL_TEXTURE_BUFFER, static_cast<GLuint>(sampled));
    glBindImageTexture(static_cast<GLuint>(unit), name_.get(), 0, GL_FALSE, 0, GL_READ_WRITE,
                       internalFormat(as));
}

namespace {

const void* byteOffset(std::size_t offset) {
    // GL takes the offset as a pointer.
    return reinterpret_cast<const void*>(offset);  // NOLINT(performance-no-int-to-ptr)
}

void connect(const AttributeSource& source) {
    using Type = AttributeSource::Type;
    source.buffer->bind(GL_ARRAY_BUFFER);
    const auto stride = static_cast<GLsizei>(source.stride);
    const bool isUnsigned = source.type == Type::unsignedInteger || source.type == Type::unsignedAsFloat;
    const GLenum memory = source.type == Type::floating ? GL_FLOAT : isUnsigned ? GL_UNSIGNED_INT : GL_INT;
    if (source.type == Type::integer || source.type == Type::unsignedInteger)
        glVertexAttribIPointer(source.location, source.components, memory, stride, byteOffset(source.offset));
    else
        glVertexAttribPointer(source.location, source.components, memory, GL_FALSE, stride,
                              byteOffset(source.offset));
    glEnableVertexAttribArray(source.location);
    if (source.divisor != 0) glVertexAttribDivisor(source.location, source.divisor);
}

}  // namespace

VertexArray::VertexArray(std::span<const AttributeSource> sources, const Buffer* indices) {
    bind();
    for (const AttributeSource& each : sources)
        if (each.buffer) connect(each);
    if (indices) indices->bind(GL_ELEMENT_ARRAY_BUFFER);
    glBindVertexArray(0);
}

void setConstantAttribute(GLuint location, const base::ValueType& type, const std::array<double, 4>& value) {
    for (GLuint column = 0; column < static_cast<GLuint>(type.columns); ++column) {
        const GLuint at = location + column;
        switch (type.base) {
            case base::BaseType::integer:
                glVertexAttribI4i(at, base::toInt(value[0]), base::toInt(value[1]), base::toInt(value[2]),
                                  base::toInt(value[3]));
                break;
            case base::BaseType::unsignedInteger:
                glVertexAttribI4ui(at, base::toUnsigned(value[0]), base::toUnsigned(value[1]),
                                   base::toUnsigned(value[2]), base::toUnsigned(value[3]));
                break;
            case base::BaseType::doublePrecision:
                glVertexAttribL4dv(at, value.data());
                break;
            default:
                glVertexAttrib4f(at, static_cast<float>(value[0]), static_cast<float>(value[1]),
                                 static_cast<float>(value[2]), static_cast<float>(value[3]));
                break;
        }
    }
}

std::vector<std::uint32_t> edgesOf(std::span<const std::uint32_t> indices, GLenum mode) {
    constexpr std::uint32_t kRestart = std::numeric_limits<std::uint32_t>::max();
    std::vector<std::uint32_t> edges;
    const auto triangle = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        edges.insert(edges.end(), {a, b, b, c, c, a});
    };
    const bool areLines = mode == GL_LINES || mode == GL_LINE_STRIP || mode == GL_LINE_LOOP;
    std::size_t first = 0;
    const auto close = [&](std::size_t end) {
        if (mode == GL_LINE_LOOP && end > first + 1)
            edges.insert(edges.end(), {indices[end - 1], indices[first]});
    };
    for (std::size_t i = 0; i < indices.size(); ++i) {
        if (indices[i] == kRestart) {
            close(i);
            first = i + 1;
            continue;
        }
        const std::size_t place = i - first;
        if (areLines) {
            if (place > 0 && (mode != GL_LINES || place % 2 == 1))
                edges.insert(edges.end(), {indices[i - 1], indices[i]});
            continue;
        }
        if (place < 2 || (mode == GL_TRIANGLES && place % 3 != 2)) continue;
        triangle(mode == GL_TRIANGLE_FAN ? indices[first] : indices[i - 2], indices[i - 1], indices[i]);
    }
    close(indices.size());
    return edges;
}

void EdgeBuffers::draw(const Buffer* indices, std::size_t offset, int count, GLenum mode, int instances) {
    // Those of fewer triangles are the first of those of more.
    const bool isPart = indices == nullptr && mode == GL_TRIANGLES;
    const std::uint32_t all = static_cast<std::uint32_t>(count);
    const Key key{indices != nullptr ? indices->id() : 0, offset, isPart ? std::bit_ceil(all) : all, mode};
    auto known = made_.find(key);
    const std::uint64_t content = indices != nullptr ? indices->content() : 0;
    if (known == made_.end() || known->second.content != content) {
        std::vector<std::uint32_t> read(std::get<2>(key));
        if (indices != nullptr)
            indices->read(offset, std::as_writable_bytes(std::span(read)));
        else
            std::iota(read.begin(), read.end(), 0U);
        const std::vector<std::uint32_t> edges = edgesOf(read, mode);
        Result<Buffer> buffer = Buffer::create(std::as_bytes(std::span(edges)));
        if (!buffer) return;
        known =
            made_.insert_or_assign(key, Edges{std::move(*buffer), static_cast<int>(edges.size()), content})
                .first;
    }
    // The buffer of indices is a part of the vertex array.
    known->second.buffer.bind(GL_ELEMENT_ARRAY_BUFFER);
    glDrawElementsInstanced(GL_LINES, isPart ? count / 3 * 6 : known->second.count, GL_UNSIGNED_INT, nullptr,
                            instances);
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices != nullptr ? indices->id() : 0);
}

}  // namespace glibra::gpu
