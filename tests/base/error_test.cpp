#include "aktina/base/error.h"

#include <gtest/gtest.h>

namespace aktina {
namespace {

TEST(Error, TextIsPlaceWhatAndHint) {
  const Error error(Code::bad_param, "hemicube.rate", "got 0 px", "accepted 8 .. 1024");
  EXPECT_STREQ(error.what(), "hemicube.rate: got 0 px (accepted 8 .. 1024)");
  EXPECT_STREQ(Error(Code::io, "", "disk full").what(), "disk full");
}

TEST(Error, OneLineOfValidText) {
  EXPECT_EQ(one_line("two\nlines\x1b[31m\x7f"), "two lines [31m ");
  EXPECT_EQ(one_line("φως 光 🌞"), "φως 光 🌞");
  EXPECT_EQ(one_line("\xff\xfe"), "\uFFFD\uFFFD");
  EXPECT_EQ(one_line("\xe5\x85"), "\uFFFD\uFFFD") << "cut off in a character";
  EXPECT_EQ(one_line("\xc0\xaf"), "\uFFFD\uFFFD") << "an overlong form";
  EXPECT_EQ(one_line("\xed\xa0\x80"), "\uFFFD\uFFFD\uFFFD") << "a surrogate";
  EXPECT_EQ(one_line("\xc2\x9b"
                     "31m"),
            " 31m")
      << "C1 controls are controls";
  const std::string cut = one_line(std::string(10000, 'x'));
  EXPECT_LT(cut.size(), 700u);
  EXPECT_TRUE(cut.ends_with("..."));
}

TEST(Error, EveryCodeHasAStatus) {
  EXPECT_EQ(info(Code::usage).exit_status, 2);
  EXPECT_EQ(info(Code::bad_input).exit_status, 3);
  EXPECT_EQ(info(Code::limit).exit_status, 4);
  EXPECT_EQ(info(Code::check_failed).exit_status, 5);
  EXPECT_EQ(info(Code::cancelled).exit_status, 130);
}

}  // namespace
}  // namespace aktina
