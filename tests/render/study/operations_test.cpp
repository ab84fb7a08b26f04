// Counts against what papers state per pixel and channel.
#include "aktina/render/study/operations.h"

#include <gtest/gtest.h>

#include <set>

#include "aktina/illumination/model.h"

namespace aktina {
namespace {

ShadingPlan plan_of(const char* method) {
  const Illuminator light(make_method(illumination_models(), "illumination", "phong"), Surface(), {}, Rgb(0), Viewer());
  return make_method(shading_methods(), "shading", method)->plan(light);
}

TEST(StudyOperations, GouraudIsOneAdditionAPixelAndChannel) {
  const Operations o = *operations_per_pixel("gouraud", plan_of("gouraud"), 2);
  EXPECT_EQ(o, (Operations{.additions = 3}));
  EXPECT_EQ(operations_per_triangle("gouraud", plan_of("gouraud"))->evaluations, 3);
}

TEST(StudyOperations, QuadraticIsTwoAdditionsAndCubicThree) {
  EXPECT_EQ(operations_per_pixel("quadratic", plan_of("quadratic"), 2)->additions, 2 * 3);
  EXPECT_EQ(operations_per_pixel("cubic", plan_of("cubic"), 2)->additions, 3 * 3);
  EXPECT_EQ(operations_per_triangle("quadratic", plan_of("quadratic"))->evaluations, 6);
  EXPECT_EQ(operations_per_triangle("cubic", plan_of("cubic"))->evaluations, 10);
}

TEST(StudyOperations, PhongIsThreeAdditionsADivisionARootAndAnEvaluation) {
  const Operations o = *operations_per_pixel("phong", plan_of("phong:perspective=0"), 2);
  EXPECT_EQ(o.additions, 3 + 2 + 3) << "normal, its square, diffuse and specular light";
  EXPECT_EQ(o.divisions, 1);
  EXPECT_EQ(o.square_roots, 1);
  EXPECT_EQ(o.evaluations, 1);
  EXPECT_EQ(o.powers, 2);
  EXPECT_EQ(operations_per_pixel("phong", plan_of("phong"), 2)->divisions, 2) << "one more in perspective";
}

TEST(StudyOperations, QuadraticNormalsNeedNoRoot) {
  EXPECT_EQ(operations_per_pixel("quadratic_normals", plan_of("quadratic_normals"), 2)->square_roots, 0);
}

TEST(StudyOperations, FastPhongAddsTwiceACosine) {
  const ShadingPlan plan = plan_of("fast_phong");
  const Operations one = *operations_per_pixel("fast_phong", plan, 1),
                   two = *operations_per_pixel("fast_phong", plan, 2);
  EXPECT_EQ(two.additions - one.additions, 2 + 2 + 3 + 3) << "two cosines, each of them in three channels";
  EXPECT_EQ(one.powers, 1) << "or a reading of a table";
  EXPECT_EQ(one.divisions + one.square_roots, 0);
}

TEST(StudyOperations, TheMostEconomicAngularFormHasNoPower) {
  const ShadingPlan plan = plan_of("angular_power");
  EXPECT_EQ(operations_per_pixel("angular_power", plan, 3)->powers, 0);
  EXPECT_LT(operations_per_pixel("angular_power", plan, 3)->multiplications,
            operations_per_pixel("angular", plan, 3)->multiplications);
}

TEST(StudyOperations, EveryShadingMethodHasCountsUnlessTheyDependOnTheTriangle) {
  const std::set<std::string_view> depend = {"h_test", "lai_tai", "tai_hsu"};
  for (const ShadingRow* row : shading_methods()) {
    const std::string id(row->info.id);
    EXPECT_EQ(operations_per_pixel(id, plan_of(id.c_str()), 2).has_value(), !depend.contains(id)) << id;
  }
}

}  // namespace
}  // namespace aktina
