#include "gpu/object/buffer.h"

#include <array>
#include <set>

#include "fixture.h"

namespace glibra::gpu {
namespace {

class BufferTest : public test::GpuTest {};

// What is made of a buffer's content, such as the edges of indices, is made again when the number changes.
TEST_F(BufferTest, EachContentHasANumberOfItsOwn) {
    const std::array<std::byte, 16> bytes{};
    Result<Buffer> one = Buffer::create(bytes), other = Buffer::create(bytes);
    ASSERT_TRUE(one && other);
    std::set<std::uint64_t> seen{one->content(), other->content()};
    one->update(4, std::span(bytes).first(4));
    seen.insert(one->content());
    one->copyFrom(*other);
    seen.insert(one->content());
    one->clear(driver());
    seen.insert(one->content());
    EXPECT_EQ(seen.size(), 5U);
    const std::uint64_t before = one->content();
    one->update(16, bytes);  // outside
    EXPECT_EQ(one->content(), before);
}

}  // namespace
}  // namespace glibra::gpu
