#include "aktina/base/method.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "aktina/base/error.h"

namespace aktina {
namespace {

using testing::HasSubstr;

constexpr Param kParams[] = {{"resolution", "px", "cells along an edge", 64, 8, 1024, true},
                             {"weight", "1", "share", 0.5, 0, 1}};
constexpr MethodInfo kHemicube = {"hemicube", "Hemicube", "cohen1985", "A test row.", kParams};
constexpr Method<double> kRow = {kHemicube, [](const ParamSet& p) { return p["resolution"] * p["weight"]; }};
constexpr const Method<double>* kTable[] = {&kRow};

template <class F>
std::string error_of(F&& f) {
  try {
    f();
  } catch (const Error& error) {
    return error.what();
  }
  return "no error";
}

double make(const char* choice) { return make_method<double>(kTable, "formfactor", choice); }

TEST(Method, DefaultsAndChoices) {
  EXPECT_EQ(make("hemicube"), 32);
  EXPECT_EQ(make("hemicube:resolution=256"), 128);
  EXPECT_EQ(make("hemicube:resolution=16,weight=0.25"), 4);
}

TEST(Method, EveryMistakeIsOneLineThatNamesTheChoices) {
  EXPECT_THAT(error_of([] { make("hemisphere"); }), HasSubstr("there are: hemicube"));
  EXPECT_THAT(error_of([] { make("hemicube:size=3"); }), HasSubstr("it has: resolution, weight"));
  EXPECT_THAT(error_of([] { make("hemicube:resolution=4"); }), HasSubstr("accepted 8 .. 1024"));
  EXPECT_THAT(error_of([] { make("hemicube:resolution=8.5"); }), HasSubstr("whole"));
  EXPECT_THAT(error_of([] { make("hemicube:weight=nan"); }), HasSubstr("got nan"));
  EXPECT_THAT(error_of([] { make("hemicube:resolution=16,resolution=32"); }), HasSubstr("given twice"));
  for (const char* broken : {"", ":", "hemicube:", "hemicube:weight", "hemicube:weight=", "hemicube:weight=1x",
                             "hemicube:weight=1,", "hemicube:=1"})
    EXPECT_NE(error_of([&] { make(broken); }), "no error") << broken;
}

TEST(Error, StaysOnOneLine) {
  const Error error(Code::bad_input, "a\nb.gltf", "line\r\nbreak\tand \x1b[31m colour", "do\nthis");
  EXPECT_EQ(std::string(error.what()).find_first_of("\n\r\t\x1b"), std::string::npos);
  EXPECT_EQ(info(error.code()).exit_status, 3);
}

}  // namespace
}  // namespace aktina
