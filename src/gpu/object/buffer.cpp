#include "gpu/object/buffer.h"

#include <algorithm>
#include <atomic>
#include <limits>
#include <new>
#include <vector>

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

}  // namespace glibra::gpu
