#include "base/packed.h"

#include <gtest/gtest.h>

namespace glibra::base::test {
enum class Color { red, green, blue };

struct Leaf {
    int number = 0;
    Color color = Color::red;
    friend bool operator==(const Leaf&, const Leaf&) = default;
};
struct Tree {
    std::string name;
    std::filesystem::path file;
    std::optional<double> height;
    std::vector<Leaf> leaves;
    std::vector<bool> flags;
    std::map<std::pair<std::string, int>, std::string> notes;
    friend bool operator==(const Tree&, const Tree&) = default;
};
void eachMember(auto& packed, Is<Leaf> auto& of) {
    packed(of.number);
    packed.upTo(Color::blue, of.color);
}
void eachMember(auto& packed, Is<Tree> auto& of) {
    packed(of.name, of.file, of.height, of.leaves, of.flags, of.notes);
}

namespace {

Tree tree() {
    return {std::string("a\0\xe9", 3), "b/c.glib",    1.5,
            {{-7, Color::blue}, {}},   {true, false}, {{{"x", 3}, "three"}, {{"y", -1}, ""}}};
}

TEST(Packed, ValuesComeBackAsTheyWere) {
    EXPECT_EQ(unpacked<Tree>(packed(tree())), tree());
    EXPECT_EQ(unpacked<Tree>(packed(Tree())), Tree());
}

TEST(Packed, OtherBytesAreNothing) {
    const std::string right = packed(tree());
    for (std::size_t length = 0; length < right.size(); ++length)
        EXPECT_FALSE(unpacked<Tree>(right.substr(0, length))) << length;
    EXPECT_FALSE(unpacked<Tree>(right + '\0'));
    EXPECT_FALSE(unpacked<std::vector<Leaf>>(std::string(8, '\x7f'))) << "more than there is";
    std::string beyond = packed(Leaf());
    EXPECT_TRUE(unpacked<Leaf>(beyond));
    beyond[sizeof(int)] = 3;
    EXPECT_FALSE(unpacked<Leaf>(beyond)) << "there is no such colour";
}

TEST(Packed, TextsCanBeMadeUtf8) {
    EXPECT_EQ(unpacked<Tree>(packed(tree(), PackedText::utf8)).value_or(Tree()).name,
              std::string("a\0\xef\xbf\xbd", 5));
}

}  // namespace
}  // namespace glibra::base::test
