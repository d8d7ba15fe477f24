#include "base/utf8.h"

#include <gtest/gtest.h>

#include <random>

namespace glibra::base {
namespace {

TEST(Utf8, KnowsWhatRfc3629Allows) {
    for (const char* good : {"a", "\xc2\x80", "\xdf\xbf", "\xe0\xa0\x80", "\xed\x9f\xbf", "\xee\x80\x80",
                             "\xf0\x90\x80\x80", "\xf4\x8f\xbf\xbf"})
        EXPECT_TRUE(isUtf8(good)) << good;
    for (const char* bad :
         {"\x80", "\xc0\xaf", "\xc1\xbf", "\xe0\x9f\xbf", "\xed\xa0\x80", "\xf0\x8f\xbf\xbf",
          "\xf4\x90\x80\x80", "\xf5\x80\x80\x80", "\xe2\x82", "\xc3\x61"})
        EXPECT_FALSE(isUtf8(bad));
}

TEST(PrintableText, WhatATerminalObeysIsWrittenOut) {
    EXPECT_EQ(printableText("\x1b]0;title\x07 a\x7f"), "\\x1b]0;title\\x07 a\\x7f");
    EXPECT_EQ(printableText("\xc2\x9b"
                            "31m"),
              "\\u009b31m")
        << "C1 control as UTF-8";
    EXPECT_EQ(printableText("\x9b"
                            "31m"),
              "\\x9b31m")
        << "C1 control as a byte";
    EXPECT_EQ(printableText("a\r\b"), "a\\x0d\\x08");
    EXPECT_EQ(printableText("\xe2\x80\xae"
                            "gnp.exe"),
              "\\u202egnp.exe");
    EXPECT_EQ(printableText("\xf3\xa0\x80\x81"), "\\U000e0001");
    EXPECT_EQ(printableText(std::string_view("\0", 1)), "\\x00");
}

TEST(PrintableText, OtherTextStaysAsItIs) {
    for (const std::string_view each : {"Größe 300 × 200", "C:\\scenes\\a.glib", "日本語", "😀", "a\\x1b"})
        EXPECT_EQ(printableText(each), each);
}

TEST(PrintableText, LineEndsAreKeptOnlyWhereTheyAreWanted) {
    EXPECT_EQ(printableText("a\tb\nc"), "a b c");
    EXPECT_EQ(printableText("a\tb\nc", true), "a b\nc");
}

TEST(PrintableText, NoBytesGiveAControlCharacter) {
    std::mt19937 random(7);
    for (int round = 0; round < 20'000; ++round) {
        std::string text(random() % 12, ' ');
        for (char& each : text) each = static_cast<char>(random());
        const std::string shown = printableText(text);
        EXPECT_TRUE(isUtf8(shown));
        EXPECT_EQ(printableText(shown), shown) << "the shown form is not final";
        for (std::string_view rest = shown; !rest.empty();) {
            const Character next = firstCharacter(rest);
            ASSERT_TRUE(next.code >= 0x20 && (next.code < 0x7F || next.code > 0x9F)) << next.code;
            rest.remove_prefix(next.bytes);
        }
    }
}

}  // namespace
}  // namespace glibra::base
