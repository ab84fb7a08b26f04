#include "aktina/render/validate.h"

#include <gtest/gtest.h>

#include <cmath>

#include "aktina/base/error.h"

namespace aktina {
namespace {

TEST(Validate, TheShippedSuitePasses) {
  Progress progress;
  for (const ValidationResult& result : validate("", progress))
    EXPECT_TRUE(result.passed()) << result.test->name << ": " << result.value << ", reference "
                                 << result.test->reference << " " << result.failure;
}

TEST(Validate, WrongAndMissingValuesFail) {
  ValidationCase test{"group", "name", "1", 1.0, 0.1, "", {}};
  EXPECT_TRUE((ValidationResult{&test, 1.05, 0, {}}.passed()));
  EXPECT_FALSE((ValidationResult{&test, 1.2, 0, {}}.passed()));
  EXPECT_FALSE((ValidationResult{&test, 0.8, 0, {}}.passed()));
  EXPECT_FALSE((ValidationResult{&test, NAN, 0, {}}.passed()));
}

TEST(Validate, UnknownGroup) {
  Progress progress;
  EXPECT_THROW(validate("no such group", progress), Error);
}

}  // namespace
}  // namespace aktina
