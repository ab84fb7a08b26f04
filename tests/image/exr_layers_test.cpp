#include "aktina/image/exr_layers.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace aktina {
namespace {

using testing::ElementsAre;

std::vector<std::string> described(const std::vector<std::string>& channels) {
  std::vector<std::string> lines;
  for (const ExrLayer& layer : group_exr_channels(channels)) {
    lines.push_back(layer.name + ":");
    for (const std::string& channel : layer.channels) lines.back() += " " + channel;
  }
  return lines;
}

TEST(ExrLayers, ColoursBeforeAlphaWhateverTheirOrderInTheFile) {
  EXPECT_THAT(described({"A", "B", "G", "R"}), ElementsAre(": R G B A"));
  EXPECT_THAT(described({"BY", "RY", "Y"}), ElementsAre(": Y RY BY"));
  EXPECT_THAT(described({"A", "Y"}), ElementsAre(": Y A"));
}

TEST(ExrLayers, NamedLayersAndDepth) {
  EXPECT_THAT(described({"B", "G", "N.X", "N.Y", "N.Z", "R", "Z", "albedo.B", "albedo.G", "albedo.R"}),
              ElementsAre(": R G B", "N: N.X N.Y N.Z", "albedo: albedo.R albedo.G albedo.B", "Z: Z"));
}

TEST(ExrLayers, WithoutAPictureTheFirstColoursStandForIt) {
  EXPECT_THAT(
      described({"View.Depth.Z", "View.Combined.B", "View.Combined.G", "View.Combined.R"}),
      ElementsAre("View.Combined: View.Combined.R View.Combined.G View.Combined.B", "View.Depth.Z: View.Depth.Z"));
  EXPECT_THAT(described({"G", "R"}), ElementsAre("G: G", "R: R"));
}

TEST(ExrLayers, WrittenNamesAreReadAsTheSameLayers) {
  std::vector<std::string> channels;
  for (const auto& [layer, count] : {std::pair("", 4), {"N", 3}, {"P", 3}, {"Z", 1}, {"albedo", 3}, {"illuminance", 1}})
    for (const std::string& name : exr_channel_names(layer, count)) channels.push_back(name);
  std::vector<std::string> names;
  for (const ExrLayer& layer : group_exr_channels(channels)) names.push_back(layer.name);
  EXPECT_THAT(names, ElementsAre("", "N", "P", "albedo", "illuminance", "Z"));
}

}  // namespace
}  // namespace aktina
