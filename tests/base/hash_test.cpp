#include "base/hash.h"

#include <gtest/gtest.h>

#include <span>
#include <string_view>

namespace glibra::base {
namespace {

std::span<const std::byte> bytesOf(std::string_view text) {
    return std::as_bytes(std::span(text.data(), text.size()));
}

// From the pages of their authors.
TEST(Hashes, HaveThePublishedValues) {
    EXPECT_EQ(fnv1a(""), 0xcbf29ce484222325U);
    EXPECT_EQ(fnv1a("foobar"), 0x85944171f73967e8U);
    EXPECT_EQ(fnv1a("bar", fnv1a("foo")), fnv1a("foobar"));
    EXPECT_EQ(splitMixed(kGolden), 0xe220a8397b1dcdafU) << "the first number of splitmix64 from state 0";
    EXPECT_EQ(murmurMixed(1), 0xb456bcfc34c2cb2cU);
    EXPECT_EQ(hashOf({}), (Hash{0x99aa06d3014798d8U, 0x6001c324468d497fU}));
}

TEST(Hashes, OfPartsAreThoseOfTheWhole) {
    EXPECT_EQ(hashOf({bytesOf("foo"), bytesOf("bar")}), hashOf({bytesOf("foobar")}));
    EXPECT_FALSE(hashOf({bytesOf("foo")}) == hashOf({bytesOf("bar")}));
}

}  // namespace
}  // namespace glibra::base
