#include "aktina/render/catalogue.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <set>

#include "aktina/base/error.h"

namespace aktina {
namespace {

TEST(Catalogue, RowsAreWellFormed) {
  std::set<std::string_view> family_ids;
  for (const Family& family : families()) {
    EXPECT_TRUE(family_ids.insert(family.id).second) << family.id << " is there twice";
    EXPECT_FALSE(family.methods.empty()) << family.id;
    std::set<std::string_view> ids;
    for (const MethodInfo* method : family.methods) {
      EXPECT_TRUE(ids.insert(method->id).second) << method->id << " is there twice";
      EXPECT_THAT(std::string(method->id), testing::MatchesRegex("[a-z][a-z0-9_]*"));
      EXPECT_FALSE(method->title.empty() || method->cite.empty()) << method->id;
      EXPECT_THAT(std::string(method->summary), testing::EndsWith(".")) << method->id;
      ParamSet params(*method);
      for (const Param& p : method->params) {
        EXPECT_NO_THROW(params.set(p.id, p.value)) << method->id << "." << p.id << ": the default must be accepted";
        EXPECT_FALSE(p.unit.empty() || p.help.empty()) << method->id << "." << p.id;
      }
    }
  }
}

TEST(Catalogue, UnknownNamesListTheKnown) {
  EXPECT_THROW(find_family("shadng"), Error);
  try {
    find_method(find_family("light"), "pont");
    ADD_FAILURE();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), Code::no_such_method);
    EXPECT_THAT(error.what(), testing::HasSubstr("point, spot"));
  }
}

TEST(Catalogue, JsonHoldsEveryMethod) {
  const auto json = nlohmann::json::parse(catalogue_json());
  ASSERT_EQ(json["families"].size(), families().size());
  for (size_t i = 0; i < families().size(); ++i)
    EXPECT_EQ(json["families"][i]["methods"].size(), families()[i].methods.size());
  EXPECT_EQ(nlohmann::json::parse(catalogue_json("light"))["families"].size(), 1u);
}

}  // namespace
}  // namespace aktina
